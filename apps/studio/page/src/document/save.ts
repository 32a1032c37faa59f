// SPDX-License-Identifier: GPL-3.0-or-later
// Saves a document to its file. A file that somebody else has changed is replaced only on request.

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
async function askAboutConflict(conflict: SaveConflict, kind: string): Promise<ConflictChoice> {
  const choice = await new Promise<ConflictChoice>((answer) => (conflictAsked.value = { conflict, kind, answer }));
  conflictAsked.value = null;
  return choice;
}

/** Where a file is written. */
interface Place {
  /** Left out: the document's own file. */
  path?: string;
  /** The hash of the file that it may replace. */
  replaces?: string;
}
/** How files of one kind are saved. */
export interface Saver {
  /** For people: "project". */
  kind: string;
  /** Fails with a Refusal that has the conflict if a file would be lost. */
  write(place: Place): Promise<unknown>;
  elsewhere(): Promise<boolean>;
  /** Opens the file, and gives up the changes. */
  reload(path: string): Promise<boolean>;
}

/** Saves, and asks before it replaces a file that nobody here has seen. Resolves to true if it is saved. */
export async function saveBy(saver: Saver, place: Place): Promise<boolean> {
  try {
    await saver.write(place);
    tell(W.saveAs.saved);
    return true;
  } catch (error) {
    if (error instanceof Refusal && error.conflict) return settle(saver, error.conflict);
    tell((error as Error).message, 'error');
    return false;
  }
}

async function settle(saver: Saver, conflict: SaveConflict): Promise<boolean> {
  const choice = await askAboutConflict(conflict, saver.kind);
  if (choice === 'mine') return saveBy(saver, { path: conflict.path, replaces: conflict.hash });
  if (choice === 'elsewhere') return saver.elsewhere();
  return choice === 'theirs' ? saver.reload(conflict.path) : false;
}

const PROJECTS: Saver = {
  kind: PROJECT,
  write: (place) => ask('save', place),
  elsewhere: saveElsewhere,
  reload: async (path) => (await tryAsk('open', { path, discard: true })) !== null,
};

/** Saves to the document's file; asks for one if there is none. Resolves to true if it is saved. */
export async function save(): Promise<boolean> {
  return documentNow.peek()?.path ? saveBy(PROJECTS, {}) : saveElsewhere();
}

/** Saves to another file, which is the document's from then on. */
export async function saveElsewhere(): Promise<boolean> {
  const path = await askForPath({ purpose: 'save', kind: PROJECT, name: projectName() });
  return path ? saveBy(PROJECTS, { path }) : false;
}
