// SPDX-License-Identifier: GPL-3.0-or-later
// Whether tiles of the wanted size suit the outline, before anything is made.

import { computed, signal } from '@preact/signals';
import { digits, shown } from '../document/units';
import { HEXAGON } from '../document/fitting_side';
import { measured, tilesAbout, tileSize, width } from './outline';
import { W } from '../words';

/** The program takes no more tiles. */
const MOST_TILES = 100_000;
/** With up to this many tiles, edits are followed without waiting. */
const QUICK_TILES = 3000;
/** Whether fewer can be made depends on the shape, and only the program can decide. */
const FEWEST_TILES = 3;

/** Fields whose text is no length, by name. */
export const unreadable = signal<ReadonlySet<string>>(new Set());
export function setReadable(name: string, isReadable: boolean): void {
  if (unreadable.peek().has(name) !== isReadable) return;
  const next = new Set(unreadable.peek());
  if (isReadable) next.delete(name);
  else next.add(name);
  unreadable.value = next;
}

export interface SizeAdvice {
  words: string;
  isPossible: boolean;
}

/** The side for this many tiles, rounded by `round` to two digits. */
function sideFor(tiles: number, round = Math.round): number {
  const now = measured.peek();
  if (!now) return 0;
  const scale = width.value / now.size[0];
  const exact = Math.sqrt((now.area * scale * scale) / (HEXAGON * tiles));
  const lastDigit = 10 ** (Math.floor(Math.log10(exact)) - 1);
  return Number((round(exact / lastDigit) * lastDigit).toPrecision(2));
}

export const sizeAdvice = computed<SizeAdvice | null>(() => {
  const tiles = tilesAbout.value;
  if (tiles === null) return null;
  if (tiles > MOST_TILES) {
    return { words: W.tileSize.thisMakesTilesThe(digits(tiles), MOST_TILES, shown(sideFor(MOST_TILES, Math.ceil), 'length')), isPossible: false };
  }
  if (tiles < FEWEST_TILES) {
    return { words: W.tileSize.isLargeForThis(shown(tileSize.value, 'length'), shown(sideFor(10 * FEWEST_TILES), 'length'), 10 * FEWEST_TILES), isPossible: true };
  }
  if (tiles > QUICK_TILES) return { words: W.tileSize.editsWillTakeSeconds(shown(sideFor(QUICK_TILES / 3), 'length')), isPossible: true };
  return null;
});
