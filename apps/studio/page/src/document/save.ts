// SPDX-License-Identifier: GPL-3.0-or-later
// A document goes to its file. A file that somebody else has changed is replaced only by who wants that.

import { signal } from '@preact/signals';
import { Refusal } from '../protocol/connection';
import type { SaveConflict } from '../protocol/messages';
import { askForPath, PROJECT } from './folders';
import { projectName } from './names';
import { ask, tryAsk } from './studio';
import { documentNow } from './store';
import { tell } from './tell';
import { W } from '../words';

export type ConflictChoice = 'theirs' | 'mine' | 'elsewhere' | 'stay';
/** The question that is open, and what takes its answer. */
export const conflictAsked = signal<{ conflict: SaveConflict; kind: string; answer: (choice: ConflictChoice) => void } | null>(null);

/** @param kind  of the file: "project" */
export async function askAboutConflict(conflict: SaveConflict, kind: string): Promise<ConflictChoice> {
  const choice = await new Promise<ConflictChoice>((answer) => (conflictAsked.value = { conflict, kind, answer }));
  conflictAsked.value = null;
  return choice;
}

/** To its file; a document that has none asks for one. Resolves to whether it lies there now. */
export async function save(): Promise<boolean> {
  if (documentNow.peek()?.path) return write({});
  return saveElsewhere();
}

/** To another file, which is the document's from then on. */
export async function saveElsewhere(): Promise<boolean> {
  const path = await askForPath({ purpose: 'save', kind: PROJECT, name: projectName() });
  return path ? write({ path }) : false;
}

async function write(where: { path?: string; replaces?: string }): Promise<boolean> {
  try {
    await ask('save', where);
    tell(W.saveAs.saved);
    return true;
  } catch (error) {
    if (error instanceof Refusal && error.conflict) return settle(error.conflict);
    tell((error as Error).message, 'error');
    return false;
  }
}

async function settle(conflict: SaveConflict): Promise<boolean> {
  const choice = await askAboutConflict(conflict, PROJECT);
  if (choice === 'mine') return write({ path: conflict.path, replaces: conflict.hash });
  if (choice === 'elsewhere') return saveElsewhere();
  if (choice === 'theirs') return (await tryAsk('open', { path: conflict.path, discard: true })) !== null;
  return false;
}
