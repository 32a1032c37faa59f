// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts to files of the server's machine, and from them.

import { signal } from '@preact/signals';
import { askForPath } from '../document/folders';
import { saveBy, type Saver } from '../document/save';
import { ask } from '../document/studio';
import { W } from '../words';
import { changesMade, draft, type Draft, inTurn, isUnsaved, openLayout, savedAs } from './draft';

const kind = W.layouts.kind;
const folderOf = (path: string | null): { folder?: string } => (path ? { folder: path.replace(/[\\/][^\\/]*$/, '') || '/' } : {});

/** The layout's own file, which is replaced only if it is as it was read or written last. */
function ownFile({ path, hash }: Draft): { path: string; replaces?: string } {
  if (path === null) throw new Error(W.layouts.noFile);
  return { path, ...(hash === null ? {} : { replaces: hash }) };
}

const LAYOUTS: Saver = {
  kind,
  write: ({ path, replaces }) =>
    inTurn(async () => {
      const now = draft.peek();
      if (!now) return;
      const place = path === undefined ? ownFile(now) : { path, ...(replaces === undefined ? {} : { replaces }) };
      savedAs(now.layout, await ask('save_layout', { layout: now.layout, ...place }));
    }),
  elsewhere: saveLayoutElsewhere,
  reload: openLayout,
};

/** Saves to the layout's file; asks for one if there is none. Resolves to true if it is saved. */
export async function saveLayout(): Promise<boolean> {
  await changesMade();
  return draft.peek()?.path ? saveBy(LAYOUTS, {}) : saveLayoutElsewhere();
}

export async function saveLayoutElsewhere(): Promise<boolean> {
  await changesMade();
  const now = draft.peek();
  if (!now) return false;
  const path = await askForPath({ purpose: 'save', kind, name: `${now.layout.name}.json`, ...folderOf(now.path) });
  return path ? saveBy(LAYOUTS, { path }) : false;
}

/** The question whether changes may go, and what takes its answer. */
export const discardAsked = signal<((may: boolean) => void) | null>(null);
async function mayGo(): Promise<boolean> {
  await changesMade();
  if (!isUnsaved.peek()) return true;
  const may = await new Promise<boolean>((answer) => (discardAsked.value = answer));
  discardAsked.value = null;
  return may;
}

/** Opens another layout by its name. */
export async function beginWith(name: string): Promise<void> {
  if (await mayGo()) await openLayout(name);
}

export async function openLayoutFile(): Promise<void> {
  if (!(await mayGo())) return;
  const path = await askForPath({ purpose: 'open', kind, ...folderOf(draft.peek()?.path ?? null) });
  if (path) await openLayout(path);
}
