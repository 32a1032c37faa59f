// SPDX-License-Identifier: GPL-3.0-or-later

import { computed } from '@preact/signals';
import { documentNow, patternTable } from '../document/store';
import { patternEdges } from '../pattern/pattern_id';
import { startingPalette } from './starting_palette';
import type { PatternRow } from '../protocol/messages';

export const rowsById = computed<ReadonlyMap<string, PatternRow>>(
  () => new Map((patternTable.value?.patterns ?? []).map((row) => [row.id, row])),
);

const softness = (id: string): number => rowsById.value.get(id)?.bending?.young ?? patternEdges(id).length * 1e-6;

const SPREAD = 12;

/** The patterns for chance, gradients and images, soft to stiff: the document's palette, or a spread of all patterns where that has only one. */
export const orderedPalette = computed<string[]>(() => {
  const own = documentNow.value?.palette ?? [];
  const rows = patternTable.value?.patterns ?? [];
  const palette = own.length > 1 || rows.length === 0 ? own : startingPalette(rows, SPREAD);
  return [...palette].sort((a, b) => softness(a) - softness(b));
});
