// SPDX-License-Identifier: GPL-3.0-or-later
// The project files that were open in this browser, the newest first. The browser keeps the list.

import { effect, signal } from '@preact/signals';
import { documentNow } from './store';

const KEY = 'fretwork.recent';
const MOST = 6;

function kept(): string[] {
  try {
    const list: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]');
    return Array.isArray(list) ? list.filter((path): path is string => typeof path === 'string').slice(0, MOST) : [];
  } catch {
    return [];
  }
}

export const recent = signal<readonly string[]>(kept());

export const withRecent = (list: readonly string[], path: string): string[] => [path, ...list.filter((other) => other !== path)].slice(0, MOST);

function keep(list: readonly string[]): void {
  recent.value = list;
  localStorage.setItem(KEY, JSON.stringify(list));
}

/** For a file that can no longer be opened. */
export const forgetRecent = (path: string): void => keep(recent.peek().filter((other) => other !== path));

effect(() => {
  const path = documentNow.value?.path;
  if (path && recent.peek()[0] !== path) keep(withRecent(recent.peek(), path));
});
