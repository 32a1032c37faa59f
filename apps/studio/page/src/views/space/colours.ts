// SPDX-License-Identifier: GPL-3.0-or-later
// The scales of drawings, as the server has sent them: one for sizes, one for values of both signs.

import { signal } from '@preact/signals';
import { gradientOf, onScale, type Rgb } from '../../document/colour_scale';
import { hello } from '../../document/store';

export type ColourMap = 'sizes' | 'signed';

export type ColourChoice = 'standard' | 'cividis' | 'grey';
const KEY = 'fretwork.colours';
const kept = localStorage.getItem(KEY);
/** The scale of sizes: that of drawings; cividis, for the colour-blind and even in lightness; or grey. */
export const colourChoice = signal<ColourChoice>(kept === 'cividis' || kept === 'grey' ? kept : 'standard');

export function chooseColours(choice: ColourChoice): void {
  colourChoice.value = choice;
  localStorage.setItem(KEY, choice);
}

/** Cividis (Nuñez, Anderton and Renslow, 2018), ten samples; grey from dark to light. */
const OWN: Record<Exclude<ColourChoice, 'standard'>, string[]> = {
  cividis: ['#00224e', '#123570', '#3b496c', '#575d6d', '#707173', '#8a8678', '#a59c74', '#c3b369', '#e1cc55', '#fee838'],
  grey: ['#2b2b2b', '#e6e6e6'],
};

/** Colours at equal distances, interpolated linearly; grey before the server has answered. */
function stops(map: ColourMap): string[] {
  const choice = colourChoice.value;
  if (map === 'sizes' && choice !== 'standard') return OWN[choice];
  return hello.value?.colours[map] ?? ['#888888', '#888888'];
}

/** Colour at 0 to 1, as red, green and blue from 0 to 255. */
export const colourAt = (map: ColourMap, share: number): Rgb => onScale(stops(map), share);

export const TABLE_SIZE = 256;

export function colourTable(map: ColourMap): Uint8Array {
  const table = new Uint8Array(4 * TABLE_SIZE);
  for (let i = 0; i < TABLE_SIZE; ++i) table.set([...colourAt(map, i / (TABLE_SIZE - 1)), 255], 4 * i);
  return table;
}

export const gradientCss = (map: ColourMap): string => gradientOf(stops(map));
