// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts to files of the server's machine, and from them.

import { signal } from '@preact/signals';
import { askForPath } from '../document/folders';
import { askAboutConflict } from '../document/save';
import { ask } from '../document/studio';
import { tell } from '../document/tell';
import { Refusal } from '../protocol/connection';
import { W } from '../words';
import { draft, isUnsaved, openLayout, savedAs } from './draft';

const kind = W.layouts.kind;
const folderOf = (path: string | null): { folder?: string } => (path ? { folder: path.replace(/[\\/][^\\/]*$/, '') || '/' } : {});

/** To its file; a layout that has none asks for one. Resolves to whether it lies there now. */
export async function saveLayout(): Promise<boolean> {
  const now = draft.peek();
  if (!now) return false;
  return now.path ? write(now.path, now.hash ?? undefined) : saveLayoutElsewhere();
}

export async function saveLayoutElsewhere(): Promise<boolean> {
  const now = draft.peek();
  if (!now) return false;
  const path = await askForPath({ purpose: 'save', kind, name: `${now.layout.name}.json`, ...folderOf(now.path) });
  return path ? write(path) : false;
}

async function write(path: string, replaces?: string): Promise<boolean> {
  const layout = draft.peek()?.layout;
  if (!layout) return false;
  try {
    savedAs(layout, await ask('save_layout', { layout, path, ...(replaces === undefined ? {} : { replaces }) }));
    tell(W.saveAs.saved);
    return true;
  } catch (error) {
    if (error instanceof Refusal && error.conflict) return settle(error.conflict);
    tell((error as Error).message, 'error');
    return false;
  }
}

async function settle(conflict: NonNullable<Refusal['conflict']>): Promise<boolean> {
  const choice = await askAboutConflict(conflict, kind);
  if (choice === 'mine') return write(conflict.path, conflict.hash);
  if (choice === 'elsewhere') return saveLayoutElsewhere();
  return choice === 'theirs' ? openLayout(conflict.path) : false;
}

/** The question whether changes may go, and what takes its answer. */
export const discardAsked = signal<((may: boolean) => void) | null>(null);
async function mayGo(): Promise<boolean> {
  if (!isUnsaved.peek()) return true;
  const may = await new Promise<boolean>((answer) => (discardAsked.value = answer));
  discardAsked.value = null;
  return may;
}

/** Another layout by its name. */
export async function beginWith(name: string): Promise<void> {
  if (await mayGo()) await openLayout(name);
}

export async function openLayoutFile(): Promise<void> {
  if (!(await mayGo())) return;
  const path = await askForPath({ purpose: 'open', kind, ...folderOf(draft.peek()?.path ?? null) });
  if (path) await openLayout(path);
}

/** The browser asks in its own words before the tab is closed. */
export function watchLayoutClosing(): void {
  window.addEventListener('beforeunload', (event) => {
    if (!isUnsaved.peek()) return;
    event.preventDefault();
    event.returnValue = true;
  });
}
