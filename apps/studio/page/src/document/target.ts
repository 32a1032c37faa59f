// SPDX-License-Identifier: GPL-3.0-or-later
// The target of a design: where nodes should go. It belongs to the page; the request for a design has it.

import { computed, signal } from '@preact/signals';
import type { FreeVector, TargetGoals, Vector } from '../protocol/messages';
import { live } from './store';

/** Nodes that are moved together, each with the displacement that is wanted of it. */
export interface TargetEntry {
  nodes: number[];
  wanted: FreeVector[];
}

export const target = signal<readonly TargetEntry[]>([]);

/** Each node has one target: a new one replaces the old one. */
export function withEntry(entries: readonly TargetEntry[], added: TargetEntry): TargetEntry[] {
  const taken = new Set(added.nodes);
  const rest = entries.map(({ nodes, wanted }) => {
    const kept = nodes.flatMap((node, i) => (taken.has(node) ? [] : [i]));
    return { nodes: kept.map((i) => nodes[i]), wanted: kept.map((i) => wanted[i]) };
  });
  return [...rest.filter(({ nodes }) => nodes.length > 0), added];
}

export const addTarget = (added: TargetEntry): void => void (target.value = withEntry(target.peek(), added));
export const replaceTarget = (index: number, entry: TargetEntry): void =>
  void (target.value = target.peek().map((old, i) => (i === index ? entry : old)));
export const removeTarget = (index: number): void => void (target.value = target.peek().filter((_, i) => i !== index));

/** Components that are free stay free. */
export const movedBy = ({ nodes, wanted }: TargetEntry, by: Vector): TargetEntry => ({
  nodes,
  wanted: wanted.map((one) => one.map((value, c) => (value === null ? null : value + by[c])) as FreeVector),
});

/** The displacement that all nodes of an entry have in common; null if they differ. */
export function commonWish({ wanted }: TargetEntry): FreeVector | null {
  const same = wanted.every((one) => one.every((value, c) => value === wanted[0][c]));
  return same ? wanted[0] : null;
}

export const goalsOf = (entries: readonly TargetEntry[]): TargetGoals => ({
  goals: entries.map(({ nodes, wanted }) => ({ nodes, displacements: wanted })),
});

/** The wanted displacement of a node, with its present values where components are free. */
export const followed = (wanted: FreeVector, present: Vector): Vector => wanted.map((value, c) => value ?? present[c]) as Vector;

export interface TargetNode {
  node: number;
  wanted: FreeVector;
  /** m, over the components that are wanted. */
  distance: number;
}

export const displacementOf = (displacement: Float32Array | null, node: number): Vector =>
  displacement && 3 * node + 2 < displacement.length ? [displacement[3 * node], displacement[3 * node + 1], displacement[3 * node + 2]] : [0, 0, 0];

export function targetNodes(entries: readonly TargetEntry[], displacement: Float32Array | null): TargetNode[] {
  return entries.flatMap(({ nodes, wanted }) =>
    nodes.map((node, i) => {
      const present = displacementOf(displacement, node);
      const off = wanted[i].map((value, c) => (value === null ? 0 : present[c] - value));
      return { node, wanted: wanted[i], distance: Math.hypot(...off) };
    }),
  );
}

export interface TargetError {
  /** m. */
  mean: number;
  largest: number;
  /** The largest displacement wanted, m. */
  wanted: number;
}

export function errorOf(nodes: readonly TargetNode[]): TargetError | null {
  if (nodes.length === 0) return null;
  return {
    mean: nodes.reduce((sum, { distance }) => sum + distance, 0) / nodes.length,
    largest: Math.max(...nodes.map(({ distance }) => distance)),
    wanted: Math.max(...nodes.map(({ wanted }) => Math.hypot(...wanted.map((value) => value ?? 0)))),
  };
}

/** The distances of the live shape from the target. */
export const liveTarget = computed<TargetNode[]>(() => targetNodes(target.value, live.value?.solution.displacement ?? null));
export const liveError = computed(() => errorOf(liveTarget.value));
