// SPDX-License-Identifier: GPL-3.0-or-later
// What the tiles of the plane are filled with: nothing, a colour for each pattern, or a property of their patterns.

import { computed, signal } from '@preact/signals';
import type { PatternRow } from '../protocol/messages';
import { gradientOf, onScale } from './colour_scale';
import type { Quantity } from './units';
import { tilePatterns } from './patterns_now';
import { documentNow, patternTable } from './store';

export type TileColour = 'none' | 'pattern' | 'bending' | 'membrane' | 'mass';
export const TILE_COLOURS: readonly TileColour[] = ['none', 'pattern', 'bending', 'membrane', 'mass'];
export const tileColour = signal<TileColour>('none');

type PropertyColour = Exclude<TileColour, 'none' | 'pattern'>;
const VALUES: Record<PropertyColour, { of: (row: PatternRow) => number | null; quantity: Quantity }> = {
  bending: { of: (row) => row.bending?.young ?? null, quantity: 'bending' },
  membrane: { of: (row) => row.membrane?.young ?? null, quantity: 'membrane' },
  mass: { of: (row) => row.mass, quantity: 'area_mass' },
};
export const isProperty = (colour: TileColour): colour is PropertyColour => colour in VALUES;

/** The "light" scheme of Paul Tol (2021): areas under dark lines, also for people who do not see all colours. After these, hues that are far from each other. */
const FIRST = ['#77aadd', '#eedd88', '#44bb99', '#ffaabb', '#bbcc33', '#ee8866', '#99ddff', '#aaaa00', '#dddddd'];
const GOLDEN_TURN = 0.3819660112501051;
export function patternColour(index: number): string {
  if (index < FIRST.length) return FIRST[index];
  const hue = Math.round(360 * ((GOLDEN_TURN * index) % 1));
  return `hsl(${hue} 55% ${[78, 70, 63][index % 3]}%)`;
}

/** Light enough for dark bars to be seen: from yellow, the softest, to blue. */
const SOFT_TO_STIFF = ['#fdf3b0', '#c8e29b', '#86cbb0', '#5aa7c9', '#5f80c0'];
export const propertyColour = (share: number): string => `rgb(${onScale(SOFT_TO_STIFF, share).join(', ')})`;
export const propertyGradient = gradientOf(SOFT_TO_STIFF);

const rowsById = computed(() => new Map((patternTable.value?.patterns ?? []).map((row) => [row.id, row])));

export interface PropertyLegend {
  low: number;
  high: number;
  quantity: Quantity;
}

/** The values of the tiles' patterns; null where there is none, or none is known. */
const tileValues = computed<(number | null)[] | null>(() => {
  const colour = tileColour.value;
  if (!isProperty(colour)) return null;
  const rows = rowsById.value;
  return tilePatterns.value.map((pattern) => {
    const row = rows.get(pattern);
    return row ? VALUES[colour].of(row) : null;
  });
});

/** The bounds of the colours; null if no tile has a value. */
export const propertyLegend = computed<PropertyLegend | null>(() => {
  const colour = tileColour.value;
  const known = tileValues.value?.filter((value) => value !== null) ?? [];
  if (!isProperty(colour) || known.length === 0) return null;
  const [low, high] = known.reduce(([least, most], value) => [Math.min(least, value), Math.max(most, value)], [Infinity, -Infinity]);
  return { low, high, quantity: VALUES[colour].quantity };
});

export interface PatternEntry {
  pattern: string;
  colour: string;
  tiles: number;
}
/** The patterns in use with their colours, those with the most tiles first. */
export const patternLegend = computed<PatternEntry[]>(() => {
  if (tileColour.value !== 'pattern') return [];
  const counts = new Map<string, number>();
  for (const pattern of tilePatterns.value) if (pattern) counts.set(pattern, (counts.get(pattern) ?? 0) + 1);
  const palette = documentNow.value?.palette ?? [];
  return [...counts].map(([pattern, tiles]) => ({ pattern, colour: patternColour(Math.max(0, palette.indexOf(pattern))), tiles })).sort((a, b) => b.tiles - a.tiles);
});

/** The colour of each tile; null: the plain one. */
export const tileFills = computed<readonly (string | null)[] | null>(() => {
  if (tileColour.value === 'none') return null;
  if (tileColour.value === 'pattern') {
    const colours = new Map(patternLegend.value.map(({ pattern, colour }) => [pattern, colour]));
    return tilePatterns.value.map((pattern) => colours.get(pattern) ?? null);
  }
  const range = propertyLegend.value;
  const spread = range ? range.high - range.low : 0;
  return (tileValues.value ?? []).map((value) => (value === null || !range ? null : propertyColour(spread > 0 ? (value - range.low) / spread : 0.5)));
});
