// SPDX-License-Identifier: GPL-3.0-or-later

import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';

interface QuestionProps {
  /** The ids of its parts begin with it. */
  id: string;
  title: string;
  words: string;
  /** The answer that changes nothing. */
  onEscape: () => void;
  /** The buttons that answer it. */
  children: ComponentChildren;
}

/** A question over everything else. The first answer has the focus. */
export function Question({ id, title, words, onEscape, children }: QuestionProps) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => host.current?.querySelector('button')?.focus(), []);
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Escape') onEscape();
    event.stopPropagation();
  };
  return (
    <div class="veil ask" onKeyDown={keys}>
      <div class="sheet question" role="alertdialog" aria-modal="true" aria-labelledby={`${id}-title`} aria-describedby={`${id}-words`} ref={host}>
        <h1 id={`${id}-title`}>{title}</h1>
        <p id={`${id}-words`}>{words}</p>
        <div class="row">{children}</div>
      </div>
    </div>
  );
}
