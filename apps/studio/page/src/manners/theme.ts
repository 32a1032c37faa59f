// SPDX-License-Identifier: GPL-3.0-or-later
// Light or dark: as the system says, until a person chooses.

import { effect, signal } from '@preact/signals';

export type Theme = 'light' | 'dark';
const KEY = 'fretwork.theme';
const system = matchMedia('(prefers-color-scheme: dark)');
const kept = localStorage.getItem(KEY);

export const theme = signal<Theme>(kept === 'dark' || kept === 'light' ? kept : system.matches ? 'dark' : 'light');
system.addEventListener('change', () => {
  if (!localStorage.getItem(KEY)) theme.value = system.matches ? 'dark' : 'light';
});

export function switchTheme(): void {
  theme.value = theme.value === 'light' ? 'dark' : 'light';
  localStorage.setItem(KEY, theme.value);
}

const colours = new Map<string, string>();
effect(() => {
  document.documentElement.dataset.theme = theme.value;
  colours.clear();
});

/** A colour of the style sheet, for what is drawn by hand. */
export function themeColour(name: string): string {
  let colour = colours.get(name);
  if (colour === undefined) {
    colour = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    colours.set(name, colour);
  }
  return colour;
}
