// SPDX-License-Identifier: GPL-3.0-or-later
// Folders on the server's machine, for opening and saving projects there.

import { signal } from '@preact/signals';
import type { FolderListing } from '../protocol/requests';
import { ask } from './studio';

export const PROJECT = 'project';

/** What is chosen: a file to open, or a name to save to. */
export interface FolderQuestion {
  purpose: 'open' | 'save';
  /** Of the file, for people: "project". */
  kind: string;
  /** The name that is suggested. */
  name?: string;
  /** The folder that is shown first; left out: the document's. */
  folder?: string;
}
/** The open panel, and the function that takes its path; null: none is open. */
export const folderAsked = signal<(FolderQuestion & { answer: (path: string | null) => void }) | null>(null);
/** What the panel shows; null while it loads. */
export const folderNow = signal<FolderListing | null>(null);
export const folderTrouble = signal<string | null>(null);

const ENDINGS = ['.json'];

let latest = 0;
/**
 * Shows a folder; a later call overtakes an earlier one. If the folder cannot be read, the present one stays,
 * and the reason is shown.
 */
export async function goTo(path?: string): Promise<void> {
  const mine = ++latest;
  folderTrouble.value = null;
  try {
    const listing = await ask('folder', { endings: ENDINGS, ...(path ? { path } : {}) });
    if (mine === latest) folderNow.value = listing;
  } catch (error) {
    if (mine === latest) folderTrouble.value = (error as Error).message;
  }
}

export async function askForPath(question: FolderQuestion): Promise<string | null> {
  folderNow.value = null;
  void goTo(question.folder);
  const path = await new Promise<string | null>((answer) => (folderAsked.value = { ...question, answer }));
  folderAsked.value = null;
  return path;
}

/** The path of a typed name in a folder: an absolute path stays as it is, and .json is added if missing. */
export function pathOf(typed: string, folder: string | undefined): string | null {
  const name = typed.trim();
  if (!name) return null;
  const whole = /^(\/|[A-Za-z]:[\\/])/.test(name) || !folder ? name : `${folder.replace(/\/$/, '')}/${name}`;
  return /\.json$/i.test(whole) ? whole : `${whole}.json`;
}
