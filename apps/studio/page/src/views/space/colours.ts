// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps that people with any colour vision can read: viridis for sizes, blue to orange through grey for signed values.

export type ColourMap = 'sizes' | 'signed';

const STOPS: Record<ColourMap, string[]> = {
  sizes: ['#440154', '#482878', '#3e4a89', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6dcd59', '#b4de2c', '#fde725'],
  signed: ['#0b4f9e', '#3f7fc1', '#80abd6', '#a9bfd6', '#b9b9b4', '#d9b78d', '#e3a25f', '#d37a25', '#9c4f06'],
};

const channel = (hex: string, at: number): number => parseInt(hex.slice(1 + 2 * at, 3 + 2 * at), 16);

/** Colour at 0 to 1, as red, green and blue from 0 to 255. */
export function colourAt(map: ColourMap, share: number): [number, number, number] {
  const stops = STOPS[map];
  const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const low = Math.min(Math.floor(at), stops.length - 2);
  const blend = at - low;
  return [0, 1, 2].map((c) => Math.round((1 - blend) * channel(stops[low], c) + blend * channel(stops[low + 1], c))) as [number, number, number];
}

export const TABLE_SIZE = 256;

export function colourTable(map: ColourMap): Uint8Array {
  const table = new Uint8Array(4 * TABLE_SIZE);
  for (let i = 0; i < TABLE_SIZE; ++i) table.set([...colourAt(map, i / (TABLE_SIZE - 1)), 255], 4 * i);
  return table;
}

export const gradientCss = (map: ColourMap): string => `linear-gradient(to right, ${STOPS[map].join(', ')})`;
