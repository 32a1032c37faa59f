// SPDX-License-Identifier: GPL-3.0-or-later
// Short messages to the user, for what has no better place on the page.

import { signal } from '@preact/signals';
import { inShownUnits } from './units';

export interface Note {
  id: number;
  text: string;
  tone: 'plain' | 'warning' | 'error';
}
export const notes = signal<Note[]>([]);

const SHOWN_MS = { plain: 3500, warning: 9000, error: 9000 };
let next = 1;

export function tell(text: string, tone: Note['tone'] = 'plain'): void {
  const note = { id: next++, text: inShownUnits(text), tone };
  notes.value = [...notes.value.filter((other) => other.text !== note.text), note];
  setTimeout(() => dismiss(note.id), SHOWN_MS[tone]);
}

export function dismiss(id: number): void {
  notes.value = notes.value.filter((note) => note.id !== id);
}
