// SPDX-License-Identifier: GPL-3.0-or-later
// Names of files: of the one that is shown, and of those that are made of it.

import { documentNow } from './store';
import { W } from '../words';

/** The last part of a path of the server's machine. */
export const nameOf = (path: string): string => path.split(/[\\/]/).at(-1) ?? path;

/** The document's name without the ending of a project. */
export const stem = (): string => (documentNow.peek()?.name || W.saveAs.name).replace(/\.json$/i, '');

/** The name that a project is saved by at first. */
export function projectName(): string {
  const path = documentNow.peek()?.path;
  return path ? nameOf(path) : `${stem()}.json`;
}
