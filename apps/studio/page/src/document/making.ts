// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface is to be cut or printed, as people type it: options of `fretwork export`.

import { signal } from '@preact/signals';
import { W } from '../words';

/** The purpose of a made file: each uses some of the entries. */
export type Made = 'cut' | 'solid' | 'facts';

export interface MakingEntry {
  name: string;
  title: string;
  words: string;
  of: readonly Made[];
  /** Shown in an empty field. */
  example: string;
  unit: string;
}
export const MAKING: readonly MakingEntry[] = [
  { name: 'fillet', title: W.making.fillets, words: W.making.radiusAtInnerCorners, of: ['cut', 'solid', 'facts'], example: '0', unit: 'mm' },
  { name: 'frame', title: W.making.frame, words: W.making.widthOfTheEdge, of: ['cut', 'solid', 'facts'], example: '0', unit: 'mm' },
  { name: 'bolts', title: W.making.bolts, words: W.making.holeDiameterAtSupports, of: ['cut', 'solid', 'facts'], example: 'none', unit: 'mm' },
  { name: 'kerf', title: W.making.kerf, words: W.making.widthOfTheCut, of: ['cut'], example: '0', unit: 'mm' },
  { name: 'bed', title: W.making.sheets, words: W.making.widthXHeightLarger, of: ['cut'], example: '600x400', unit: 'mm' },
];

/** By the entries' names; empty or missing: not given. */
export const making = signal<Readonly<Record<string, string>>>({});

/** The entries as the server takes them: bare numbers are millimetres. */
export function makingQuery(made: Made, written = making.peek()): Record<string, string> {
  const given = MAKING.filter(({ name, of }) => of.includes(made) && written[name]?.trim());
  return Object.fromEntries(
    given.map(({ name }) => {
      const text = written[name].trim().replace(',', '.').replace('×', 'x').replace(/\s/g, '');
      return [name, /^[\d.]+$/.test(text) ? `${text}mm` : text];
    }),
  );
}
