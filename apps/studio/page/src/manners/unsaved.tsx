// SPDX-License-Identifier: GPL-3.0-or-later
// Asks about unsaved changes before another document takes their place.

import { signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { save } from '../document/save';
import { documentNow } from '../document/store';
import type { Discarding } from '../protocol/requests';
import { Button } from '../widgets/widgets';
import { W } from '../words';

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
        <h1 id="unsaved-title">{W.unsaved.title(documentNow.value?.name || W.unsaved.untitled)}</h1>
        <p id="unsaved-words">{W.unsaved.itHasUnsavedChanges}</p>
        <div class="row">
          <Button id="unsaved-save" kind="main" title={W.unsaved.saveThenContinue} label={W.unsaved.save} onPress={() => answer('save')} />
          <Button id="unsaved-discard" title={W.unsaved.discardTheChangesFor} label={W.unsaved.discard} onPress={() => answer('discard')} />
          <Button id="unsaved-stay" title={W.unsaved.keepWorkingOnThis} label={W.unsaved.cancel} onPress={() => answer('stay')} />
        </div>
      </div>
    </div>
  );
}
