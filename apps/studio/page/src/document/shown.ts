// SPDX-License-Identifier: GPL-3.0-or-later
// Which shape the 3D view shows: the live solution, a step of a load path, or a mode that swings.

import { computed, effect, signal } from '@preact/signals';
import type { Solution } from '../protocol/binary';
import { playing, scale, shapeIndex, showFull } from './look';
import { beams, live, notTheAnswer, others, shapes } from './store';
import { surface } from './surface';

export interface Shown {
  solution: Solution;
  fields: readonly string[];
  factor: number;
}

/** 0 to 1 while a mode swings. */
export const phase = signal(0.25);
const MODE_SIZE = 0.12;

/** null: at rest, without colours, because there is no result, or it is not the answer. */
export const shown = computed<Shown | null>(() => {
  const now = shapes.value;
  if (!now || now.shapes.length === 0) {
    if (notTheAnswer.value) return null;
    return live.value && { solution: live.value.solution, fields: live.value.info.fields, factor: scale.value };
  }
  const solution = now.shapes[Math.min(shapeIndex.value, now.shapes.length - 1)];
  if (now.kind === 'path') return { solution, fields: now.fields, factor: scale.value };
  return { solution, fields: [], factor: swing(solution) };
});

/** The same; null if it belongs to other bars than the present ones. */
export const shownOfBars = computed<Shown | null>(() => {
  const now = shown.value;
  return now && now.solution.nodes === beams.value?.nodes ? now : null;
});

/** The full model's answer, laid under the live one; null: it is not wanted, not known, of other bars, or the live one itself. */
export const fullUnderneath = computed<Solution | null>(() => {
  const full = others.value.get('full')?.solution;
  if (!showFull.value || shapes.value || live.value?.info.model === 'full') return null;
  return full && full.nodes === beams.value?.nodes ? full : null;
});
/** Models laid under are a little thinner: where both are at one place, the live model is seen. */
export const UNDERNEATH = 0.9;

function swing(solution: Solution): number {
  const box = surface.value?.box;
  const reach = box ? Math.hypot(box.max[0] - box.min[0], box.max[1] - box.min[1]) : 1;
  return ((MODE_SIZE * reach) / (largest(solution) || 1)) * Math.sin(2 * Math.PI * phase.value);
}

const sizes = new WeakMap<Solution, number>();

export function largest(solution: Solution): number {
  const known = sizes.get(solution);
  if (known !== undefined) return known;
  let most = 0;
  const d = solution.displacement;
  for (let i = 0; i < d.length; i += 3) most = Math.max(most, Math.hypot(d[i], d[i + 1], d[i + 2]) || 0);
  sizes.set(solution, most);
  return most;
}

const SECONDS_PER_SWING = 1.6;
const SECONDS_PER_PATH = 2.5;
let started = 0;

/** Play until stop(). */
export function play(): void {
  playing.value = true;
  started = performance.now();
  requestAnimationFrame(tick);
}
export function stop(): void {
  playing.value = false;
}

function tick(when: number): void {
  const now = shapes.value;
  if (!playing.value || !now) return stop();
  const seconds = Math.max(0, when - started) / 1000;
  if (now.kind === 'path') {
    const there = (seconds / SECONDS_PER_PATH) % 2;
    shapeIndex.value = Math.round((there < 1 ? there : 2 - there) * Math.max(0, now.shapes.length - 1));
  } else {
    phase.value = (seconds / SECONDS_PER_SWING) % 1;
  }
  requestAnimationFrame(tick);
}

/** Plays once all shapes have come. */
effect(() => {
  const now = shapes.value;
  if (now && now.shapes.length === now.expected && !playing.peek()) play();
});
