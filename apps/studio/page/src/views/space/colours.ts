// SPDX-License-Identifier: GPL-3.0-or-later
// The scales of drawings, as the server has sent them: one for sizes, one for values of both signs.

import { hello } from '../../document/store';

export type ColourMap = 'sizes' | 'signed';

/** At equal distances, straight between each other; grey before the server has answered. */
const stops = (map: ColourMap): string[] => hello.value?.colours[map] ?? ['#888888', '#888888'];

const channel = (hex: string, at: number): number => parseInt(hex.slice(1 + 2 * at, 3 + 2 * at), 16);

/** Colour at 0 to 1, as red, green and blue from 0 to 255. */
export function colourAt(map: ColourMap, share: number): [number, number, number] {
  const colours = stops(map);
  const at = Math.min(Math.max(share, 0), 1) * (colours.length - 1);
  const low = Math.min(Math.floor(at), colours.length - 2);
  const blend = at - low;
  return [0, 1, 2].map((c) => Math.round((1 - blend) * channel(colours[low], c) + blend * channel(colours[low + 1], c))) as [number, number, number];
}

export const TABLE_SIZE = 256;

export function colourTable(map: ColourMap): Uint8Array {
  const table = new Uint8Array(4 * TABLE_SIZE);
  for (let i = 0; i < TABLE_SIZE; ++i) table.set([...colourAt(map, i / (TABLE_SIZE - 1)), 255], 4 * i);
  return table;
}

export const gradientCss = (map: ColourMap): string => `linear-gradient(to right, ${stops(map).join(', ')})`;
