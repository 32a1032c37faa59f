// SPDX-License-Identifier: GPL-3.0-or-later
// Asks about unsaved changes before another document takes their place.

import { signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { save } from '../document/save';
import { documentNow } from '../document/store';
import type { Discarding } from '../protocol/requests';
import { Button } from '../widgets/widgets';

type Choice = 'save' | 'discard' | 'stay';
const asked = signal<((choice: Choice) => void) | null>(null);

const isUnsaved = (): boolean => documentNow.peek()?.saved === false;

/** The keys by which a request for another document gives up the present one; null: it stays. */
export async function leave(): Promise<Discarding | null> {
  if (!isUnsaved()) return {};
  const choice = await new Promise<Choice>((answer) => (asked.value = answer));
  asked.value = null;
  if (choice === 'save') return (await save()) ? {} : null;
  return choice === 'discard' ? { discard: true } : null;
}

/** The browser asks in its own words before the tab is closed. */
export function watchClosing(): void {
  window.addEventListener('beforeunload', (event) => {
    if (!isUnsaved()) return;
    event.preventDefault();
    event.returnValue = true; // what browsers before 2023 look at
  });
}

export function UnsavedSheet() {
  const host = useRef<HTMLDivElement>(null);
  const answer = asked.value;
  useEffect(() => {
    if (answer) host.current?.querySelector('button')?.focus();
  }, [answer]);
  if (!answer) return null;
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Escape') answer('stay');
    event.stopPropagation();
  };
  return (
    <div class="veil ask" onKeyDown={keys}>
      <div class="sheet question" role="alertdialog" aria-modal="true" aria-labelledby="unsaved-title" aria-describedby="unsaved-words" ref={host}>
        <h1 id="unsaved-title">Save “{documentNow.value?.name || 'untitled'}” first?</h1>
        <p id="unsaved-words">It has changes that are in no file yet.</p>
        <div class="row">
          <Button id="unsaved-save" kind="main" title="To its file, then go on" label="Save" onPress={() => answer('save')} />
          <Button id="unsaved-discard" title="Give the changes up for good" label="Discard" onPress={() => answer('discard')} />
          <Button id="unsaved-stay" title="Stay with this surface" label="Cancel" onPress={() => answer('stay')} />
        </div>
      </div>
    </div>
  );
}
