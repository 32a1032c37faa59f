// SPDX-License-Identifier: GPL-3.0-or-later
// Which patterns the gallery shows, and in which order.

import { computed, signal } from '@preact/signals';
import { documentNow, patternTable } from '../document/store';
import type { PatternRow } from '../protocol/messages';
import { rowsById } from './order';
import { onScale, propertyRow, type PropertyName } from './properties';
import { related, type Relation } from './similar';

export type Range = [number, number];

/** On the property's own scale (powers of ten where it is logarithmic). */
export const ranges = signal<ReadonlyMap<PropertyName, Range>>(new Map());
export const search = signal('');
export const symmetricOnly = signal(false);
export const scope = signal<'all' | 'palette' | 'calibrated'>('all');
export const sortBy = signal<PropertyName>('edges');
export const descending = signal(false);
export const relation = signal<{ to: string; relation: Relation } | null>(null);

export function setRange(name: PropertyName, range: Range | null): void {
  const next = new Map(ranges.value);
  if (range) next.set(name, range);
  else next.delete(name);
  ranges.value = next;
}

export function clearFilters(): void {
  ranges.value = new Map();
  search.value = '';
  symmetricOnly.value = false;
  scope.value = 'all';
  relation.value = null;
}

export const filtering = computed(
  () => ranges.value.size > 0 || search.value !== '' || symmetricOnly.value || scope.value !== 'all' || relation.value !== null,
);

function matches(row: PatternRow): boolean {
  if (search.value && !row.id.includes(search.value.trim())) return false;
  if (symmetricOnly.value && row.symmetry !== 'mirror') return false;
  if (scope.value === 'calibrated' && row.error === null) return false;
  if (scope.value === 'palette' && !documentNow.value?.palette.includes(row.id)) return false;
  for (const [name, [low, high]] of ranges.value) {
    const value = onScale(propertyRow(name), row);
    if (value === null || value < low || value > high) return false;
  }
  return true;
}

export const shownPatterns = computed<PatternRow[]>(() => {
  const rows = patternTable.value?.patterns ?? [];
  const from = relation.value && rowsById.value.get(relation.value.to);
  if (from && relation.value) return related(from, rows, relation.value.relation).filter(matches).slice(0, 200);
  const property = propertyRow(sortBy.value);
  const sign = descending.value ? -1 : 1;
  const value = (row: PatternRow): number => property.of(row) ?? sign * Infinity;
  return rows.filter(matches).sort((a, b) => sign * (value(a) - value(b)) || a.edges - b.edges);
});
