// SPDX-License-Identifier: GPL-3.0-or-later
// The problems of the present surface, which the status line counts, and their places.

import { computed, signal } from '@preact/signals';
import { patternless } from './patterns_now';
import { beams, live, making, notTheAnswer, strength } from './store';
import { surface } from './surface';
import type { MakingPlace, Point } from '../protocol/messages';

export type ProblemKind = MakingPlace['kind'] | 'unpainted' | 'stress';

export interface Problem {
  kind: ProblemKind;
  count: number;
  /** In the plane, the worst first; may be fewer than `count`. */
  places: Point[];
}

/** The bars whose largest stress is above the strength, the worst first. */
export const overstressed = computed<number[]>(() => {
  const [now, most] = [live.value, strength.value];
  const stress = now?.solution.beamFields[now.info.fields.indexOf('von_mises')];
  if (!stress || most === null || notTheAnswer.value) return [];
  const worst = (bar: number): number => Math.max(Math.abs(stress[2 * bar]), Math.abs(stress[2 * bar + 1]));
  const bars = Array.from({ length: stress.length / 2 }, (_, bar) => bar).filter((bar) => worst(bar) > most);
  return bars.sort((a, b) => worst(b) - worst(a));
});

/** A bar's ends at rest. */
export function barEnds(bar: number): [Point, Point] | null {
  const now = beams.value;
  if (!now || bar >= now.beams) return null;
  const at = (end: number): Point => [now.place[3 * now.ends[end]], now.place[3 * now.ends[end] + 1]];
  return [at(2 * bar), at(2 * bar + 1)];
}

function middleOf(bar: number): Point[] {
  const ends = barEnds(bar);
  return ends ? [[(ends[0][0] + ends[1][0]) / 2, (ends[0][1] + ends[1][1]) / 2]] : [];
}

export const problems = computed<Problem[]>(() => {
  const found = making.value;
  const ofMaking = (['overlap', 'gap', 'opening'] as const).map((kind) => {
    const places = (found?.places ?? []).filter((one) => one.kind === kind).map(({ place }) => place);
    return { kind, count: found?.counts[kind] ?? places.length, places };
  });
  const bare = patternless.value;
  const centers = surface.value?.centers ?? [];
  return [
    { kind: 'unpainted' as const, count: bare.length, places: bare.map((tile) => centers[tile]) },
    ...ofMaking,
    { kind: 'stress' as const, count: overstressed.value.length, places: overstressed.value.flatMap(middleOf) },
  ].filter(({ count }) => count > 0);
});

export const problemCount = computed(() => problems.value.reduce((sum, { count }) => sum + count, 0));

/** The place that is looked at. */
export const lookedAt = signal<{ kind: ProblemKind; index: number } | null>(null);

/** The next place of a kind, from the worst on; null: none is known. */
export function nextPlace(kind: ProblemKind): Point | null {
  const places = problems.peek().find((one) => one.kind === kind)?.places ?? [];
  if (places.length === 0) return null;
  const before = lookedAt.peek();
  const index = before?.kind === kind ? (before.index + 1) % places.length : 0;
  lookedAt.value = { kind, index };
  return places[index];
}

export const placeLookedAt = computed<Point | null>(() => {
  const at = lookedAt.value;
  return at ? (problems.value.find(({ kind }) => kind === at.kind)?.places[at.index] ?? null) : null;
});
