// SPDX-License-Identifier: GPL-3.0-or-later

import { computed } from '@preact/signals';
import { documentNow, patternTable } from '../document/store';
import { patternEdges } from '../pattern/pattern_id';
import type { PatternRow } from '../protocol/messages';

export const rowsById = computed<ReadonlyMap<string, PatternRow>>(
  () => new Map((patternTable.value?.patterns ?? []).map((row) => [row.id, row])),
);

const softness = (id: string): number => rowsById.value.get(id)?.bending?.young ?? patternEdges(id).length * 1e-6;

/** The document's palette from soft to stiff: what gradients and images run through. */
export const orderedPalette = computed<string[]>(() => [...(documentNow.value?.palette ?? [])].sort((a, b) => softness(a) - softness(b)));
