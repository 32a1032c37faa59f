// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns that relate to one: like it, stiffer, softer, or of the same behaviour and another look.

import { drawingDistance } from '../pattern/pattern_id';
import type { PatternRow } from '../protocol/messages';
import { extent, onScale, propertyRow, type PropertyName } from './properties';
import { W } from '../words';

export type Relation = 'like' | 'stiffer' | 'softer' | 'other_look';
export const RELATIONS: { relation: Relation; title: string; tip: string }[] = [
  { relation: 'like', title: W.similar.similar, tip: W.similar.similarStiffnessAndGeometry },
  { relation: 'stiffer', title: W.similar.stiffer, tip: W.similar.stifferInBendingClosest },
  { relation: 'softer', title: W.similar.softer, tip: W.similar.softerInBendingClosest },
  { relation: 'other_look', title: W.similar.otherGeometry, tip: W.similar.similarStiffnessDifferentGeometry },
];

const BEHAVIOUR: PropertyName[] = ['bending_young', 'bending_poisson', 'bending_shear', 'membrane_young', 'membrane_poisson'];
const NOTABLY = 0.06;

/** How differently two patterns behave: the mean difference of their properties, each as a share of the range that all span. */
export function behaviourDistance(rows: readonly PatternRow[]): (a: PatternRow, b: PatternRow) => number {
  const axes = BEHAVIOUR.flatMap((name) => {
    const property = propertyRow(name);
    const range = extent(property, rows);
    return range && range[1] > range[0] ? [{ property, width: range[1] - range[0] }] : [];
  });
  return (a, b) => {
    let [sum, count] = [0, 0];
    for (const { property, width } of axes) {
      const [x, y] = [onScale(property, a), onScale(property, b)];
      if (x === null || y === null) continue;
      sum += Math.abs(x - y) / width;
      ++count;
    }
    return count ? sum / count : Math.abs(a.edges - b.edges) / 10;
  };
}

function stiffness(row: PatternRow): number {
  return onScale(propertyRow('bending_young'), row) ?? row.edges / 10;
}

/** All patterns that are in a relation to one, the best first. */
export function related(to: PatternRow, rows: readonly PatternRow[], relation: Relation): PatternRow[] {
  const apart = behaviourDistance(rows);
  const score = (row: PatternRow): number => {
    switch (relation) {
      case 'like':
        return apart(to, row) + 0.35 * drawingDistance(to.id, row.id);
      case 'other_look':
        return apart(to, row) - 0.12 * drawingDistance(to.id, row.id);
      default:
        return apart(to, row);
    }
  };
  const fits = (row: PatternRow): boolean => {
    if (row.id === to.id) return false;
    if (relation === 'stiffer') return stiffness(row) > stiffness(to) + NOTABLY;
    if (relation === 'softer') return stiffness(row) < stiffness(to) - NOTABLY;
    if (relation === 'other_look') return drawingDistance(to.id, row.id) > 0.6;
    return true;
  };
  return rows
    .filter(fits)
    .map((row) => ({ row, score: score(row) }))
    .sort((a, b) => a.score - b.score)
    .map(({ row }) => row);
}
