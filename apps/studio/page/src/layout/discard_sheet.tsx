// SPDX-License-Identifier: GPL-3.0-or-later

import { useEffect, useRef } from 'preact/hooks';
import { Button } from '../widgets/widgets';
import { W } from '../words';
import { draft } from './draft';
import { discardAsked } from './save';

/** Asks before another layout takes the place of one with changes. */
export function DiscardSheet() {
  const host = useRef<HTMLDivElement>(null);
  const answer = discardAsked.value;
  useEffect(() => {
    if (answer) host.current?.querySelector('button')?.focus();
  }, [answer]);
  if (!answer) return null;
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Escape') answer(false);
    event.stopPropagation();
  };
  return (
    <div class="veil ask" onKeyDown={keys}>
      <div class="sheet question" role="alertdialog" aria-modal="true" aria-labelledby="discard-title" aria-describedby="discard-words" ref={host}>
        <h1 id="discard-title">{W.layouts.unsavedTitle(draft.value?.layout.name ?? '')}</h1>
        <p id="discard-words">{W.layouts.unsaved}</p>
        <div class="row">
          <Button id="discard-stay" kind="main" title={W.layouts.stayTip} label={W.layouts.stay} onPress={() => answer(false)} />
          <Button id="discard-replace" title={W.layouts.replaceTip} label={W.layouts.replace} onPress={() => answer(true)} />
        </div>
      </div>
    </div>
  );
}
