// SPDX-License-Identifier: GPL-3.0-or-later
// All loads of the selected load case times one factor: forces, moments, weight, prescribed displacements, and the
// factors of load cases that act as well. The loads at a factor of 1 are kept: they come back after 0.

import { computed, signal } from '@preact/signals';
import { DOFS, type Load, type LoadCase, type Prescribed, type Vector } from '../protocol/messages';
import { dragLoadCase, editLoadCase } from './edits';
import { loadCase } from './store';

type Loads = Pick<LoadCase, 'loads' | 'prescribed' | 'gravity' | 'combines'>;

export const MOST_FACTOR = 2;
/** A relative difference of numbers below this is rounding: they may have been scaled and scaled back. */
const ROUNDING = 1e-12;

/** Never -0. */
const times = (vector: Vector | undefined, factor: number): Vector | undefined => vector?.map((one) => one * factor + 0) as Vector | undefined;
const given = <T extends object>(entry: T): T => Object.fromEntries(Object.entries(entry).filter(([, value]) => value !== undefined)) as T;

const scaledLoad = (load: Load, factor: number): Load =>
  given({ ...load, force: times(load.force, factor), moment: times(load.moment, factor), per_area: times(load.per_area, factor), per_length: times(load.per_length, factor) });

function scaledPrescribed(entry: Prescribed, factor: number): Prescribed {
  const scaled = { ...entry };
  for (const dof of DOFS) if (scaled[dof] !== undefined) scaled[dof] *= factor;
  return scaled;
}

export const scaledLoads = ({ loads = [], prescribed = [], gravity = [0, 0, 0], combines = [] }: Loads, factor: number): Required<Loads> => ({
  loads: loads.map((load) => scaledLoad(load, factor)),
  prescribed: prescribed.map((entry) => scaledPrescribed(entry, factor)),
  gravity: times(gravity, factor) as Vector,
  combines: combines.map(({ load_case, factor: own }) => ({ load_case, factor: own * factor })),
});

function isAlike(a: unknown, b: unknown): boolean {
  if (typeof a === 'number' && typeof b === 'number') return Math.abs(a - b) <= ROUNDING * Math.max(Math.abs(a), Math.abs(b));
  if (typeof a !== 'object' || typeof b !== 'object' || !a || !b) return a === b;
  const [one, other] = [given(a), given(b)] as Record<string, unknown>[];
  const keys = new Set([...Object.keys(one), ...Object.keys(other)]);
  return [...keys].every((key) => isAlike(one[key], other[key]) || isNothing(one[key], other[key]));
}
/** The program leaves vectors of zeros out. */
const isNothing = (a: unknown, b: unknown): boolean => [a, b].every((one) => one === undefined || (Array.isArray(one) && one.every((part) => part === 0)));

/** The loads at a factor of 1. */
const base = signal<{ name: string; loads: Required<Loads> } | null>(null);

const numbersOf = (value: unknown): number[] =>
  typeof value === 'number' ? [value] : typeof value === 'object' && value ? Object.values(value).flatMap(numbersOf) : [];

/** The factor by which the present loads are a multiple of `loads`; null: they are no multiple. */
function factorOf(present: Required<Loads>, loads: Required<Loads>): number | null {
  const sizes = (one: Required<Loads>): number[] => [...one.loads.flatMap(({ force, moment, per_area, per_length }) => numbersOf([force, moment, per_area, per_length])),
    ...one.prescribed.flatMap((entry) => DOFS.flatMap((dof) => numbersOf(entry[dof]))), ...one.gravity, ...one.combines.map(({ factor }) => factor)];
  const [now, first] = [sizes(present), sizes(loads)];
  const at = first.findIndex((one) => one !== 0);
  if (at < 0 || now.length !== first.length) return null;
  const factor = now[at] / first[at] + 0;
  return isAlike(present, scaledLoads(loads, factor)) ? factor : null;
}

function knownFactor(now: LoadCase | null): number | null {
  const known = base.value;
  return now && known && now.name === known.name ? factorOf(scaledLoads(now, 1), known.loads) : null;
}

/** The present loads as a multiple of the remembered ones; 1 if they are none. */
export const loadFactor = computed<number>(() => knownFactor(loadCase.value) ?? 1);

/** Remembers the loads before the factor changes, unless they are known. */
export function beginFactor(): void {
  const now = loadCase.peek();
  if (now && knownFactor(now) === null) base.value = { name: now.name, loads: scaledLoads(now, 1) };
}

/** Sets the factor while it is slid; one slide is one step of undo. */
export function slideFactor(factor: number, merge: string): void {
  const loads = base.peek()?.loads;
  if (loads) dragLoadCase(() => scaledLoads(loads, factor), merge);
}

/** Sets the factor that was typed. */
export function setFactor(factor: number): void {
  beginFactor();
  const loads = base.peek()?.loads;
  if (loads) void editLoadCase(() => scaledLoads(loads, factor));
}
