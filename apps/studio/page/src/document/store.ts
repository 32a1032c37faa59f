// SPDX-License-Identifier: GPL-3.0-or-later
// The page's state. The server owns the document; these signals are its copy, and the views read them.

import { computed, signal } from '@preact/signals';
import type { Beams, Solution } from '../protocol/binary';
import type { CountSoFar, EstimatedError, Hello, Making, PatternTable, Recoverable, SentLoadCase, Solved, StudioDocument } from '../protocol/messages';
import type { LineState } from '../protocol/connection';
import { sizeOf } from './section';
import { W } from '../words';

export interface SolvedModel {
  info: Solved;
  solution: Solution;
  /** The bars of the painting that it solves, with their revision. */
  beams: Beams;
}

export const line = signal<LineState>('connecting');
export const hello = signal<Hello | null>(null);
/** Documents with changes that were not saved, the newest first. */
export const recoverable = signal<Recoverable[]>([]);
export const documentNow = signal<StudioDocument | null>(null);
export const revision = signal(0);
export const beams = signal<Beams | null>(null);

/** The newest solution of the live model; stays while a newer one is computed, and goes when that fails. */
export const live = signal<SolvedModel | null>(null);
/** The newest revision of the document that the live model has answered, with a solution or in words. */
export const answered = signal(0);
/** The newest revision whose positions are shown, also provisional ones. */
export const positioned = signal(0);
/** Why the live model has no newer solution, in words; null when it has. */
export const problem = signal<string | null>(null);
/** Why the drawn shape is not the result of the supports and loads; null when it is. */
export const notTheAnswer = computed<string | null>(() => {
  if (problem.value) return problem.value;
  const info = live.value?.info;
  return info && !info.converged && !info.provisional ? (info.warnings[0] ?? W.store.noEquilibriumWasFound) : null;
});
/** The last solution of other models, by name: the full model on demand. */
export const others = signal<ReadonlyMap<string, SolvedModel>>(new Map());
/** Long work: which model, and how much of it is done (0 to 1). */
export const working = signal<{ model: string; share: number; background: boolean } | null>(null);
/** The error of the live model against another one, on the nodes. */
export const compared = signal<{ mean: number; largest: number; relative: number; solution: Solution | null } | null>(null);

export interface Shape {
  kind: 'path' | 'vibration' | 'buckling';
  values: number[];
  /** Names of the beam fields that each shape has. */
  fields: readonly string[];
  shapes: Solution[];
  /** How many there will be. */
  expected: number;
}
/** The steps of a load path, or the modes, that are played back. */
export const shapes = signal<Shape | null>(null);

/** How far the live solution is from the full model's, as estimated; null: not known, or not doubtful. */
export const estimated = signal<EstimatedError | null>(null);

/** Whether the present painting can be made; null while this is checked. */
export const making = signal<Making | null>(null);

/** The newest message of a count of a layout's patterns. */
export const countSoFar = signal<CountSoFar | null>(null);

export const patternTable = signal<PatternTable | null>(null);

export const loadCase = computed<SentLoadCase | null>(() => {
  const now = documentNow.value;
  return now?.load_cases[now.selected_load_case] ?? null;
});

export const setting = computed(() => documentNow.value?.setting ?? null);
/** Strength of the material, N/m2; null where the document does not say it. */
export const strength = computed<number | null>(() => setting.value?.material.strength ?? null);
/** The section of the bars, in metres: across in the plane, and out of it. */
export const barSection = computed(() => (setting.value ? sizeOf(setting.value.section) : { width: 0.002, height: 0.002 }));
