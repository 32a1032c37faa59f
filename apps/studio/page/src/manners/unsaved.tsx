// SPDX-License-Identifier: GPL-3.0-or-later
// Asks about unsaved changes before another document takes their place.

import { signal } from '@preact/signals';
import { save } from '../document/save';
import { documentNow } from '../document/store';
import type { Discarding } from '../protocol/requests';
import { Question } from '../widgets/question';
import { Button } from '../widgets/widgets';
import { W } from '../words';

type Choice = 'save' | 'discard' | 'stay';
const asked = signal<((choice: Choice) => void) | null>(null);

/** Whether the document has changes that lie in no file. */
export const isUnsaved = (): boolean => documentNow.peek()?.saved === false;

/** The keys by which a request for another document gives up the present one; null: it stays. */
export async function leave(): Promise<Discarding | null> {
  if (!isUnsaved()) return {};
  const choice = await new Promise<Choice>((answer) => (asked.value = answer));
  asked.value = null;
  if (choice === 'save') return (await save()) ? {} : null;
  return choice === 'discard' ? { discard: true } : null;
}

export function UnsavedSheet() {
  const answer = asked.value;
  if (!answer) return null;
  return (
    <Question id="unsaved" title={W.unsaved.title(documentNow.value?.name || W.unsaved.untitled)} words={W.unsaved.itHasUnsavedChanges} onEscape={() => answer('stay')}>
      <Button id="unsaved-save" kind="main" title={W.unsaved.saveThenContinue} label={W.unsaved.save} onPress={() => answer('save')} />
      <Button id="unsaved-discard" title={W.unsaved.discardTheChangesFor} label={W.unsaved.discard} onPress={() => answer('discard')} />
      <Button id="unsaved-stay" title={W.unsaved.keepWorkingOnThis} label={W.unsaved.cancel} onPress={() => answer('stay')} />
    </Question>
  );
}
