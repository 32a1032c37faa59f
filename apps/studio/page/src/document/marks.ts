// SPDX-License-Identifier: GPL-3.0-or-later
// The selected load case as things to draw: which nodes are held and how, what acts where.

import { computed } from '@preact/signals';
import { DOFS, type Dof, type Load, type Prescribed, type Support, type Vector } from '../protocol/messages';
import { selectedNodes } from './selected_nodes';
import { loadCase } from './store';
import { surface } from './surface';

export type HoldKind = 'fixed' | 'pinned' | 'partly';
export interface HeldNode {
  node: number;
  kind: HoldKind;
  fixed: Dof[];
}
export interface LoadMark {
  index: number;
  load: Load;
  nodes: number[];
  force: Vector;
  moment: Vector;
}
export interface PrescribedMark {
  index: number;
  entry: Prescribed;
  nodes: number[];
  dof: Dof;
  value: number;
}

export function holdKind(fixed: readonly Dof[]): HoldKind {
  const translations = ['ux', 'uy', 'uz'].every((dof) => fixed.includes(dof as Dof));
  if (translations && fixed.length === 6) return 'fixed';
  return translations && fixed.length === 3 ? 'pinned' : 'partly';
}
export const HOLD_COLOURS: Record<HoldKind, string> = { fixed: '--fixed', pinned: '--pinned', partly: '--partly' };

export const prescribedDof = (entry: Prescribed): Dof | undefined => DOFS.find((dof) => entry[dof] !== undefined);

export const nodesOf = (entry: Support | Load | Prescribed): number[] => (surface.value ? selectedNodes(entry, surface.value) : []);

/** Each held node once, with all that holds it. */
export const heldNodes = computed<HeldNode[]>(() => {
  const all = new Map<number, Set<Dof>>();
  for (const support of loadCase.value?.supports ?? []) {
    for (const node of nodesOf(support)) {
      const fixed = all.get(node) ?? new Set<Dof>();
      support.fixed.forEach((dof) => fixed.add(dof));
      all.set(node, fixed);
    }
  }
  return [...all].map(([node, set]) => ({ node, kind: holdKind([...set]), fixed: DOFS.filter((dof) => set.has(dof)) }));
});

export const loadMarks = computed<LoadMark[]>(() =>
  (loadCase.value?.loads ?? []).map((load, index) => ({
    index,
    load,
    nodes: nodesOf(load),
    force: load.force ?? [0, 0, 0],
    moment: load.moment ?? [0, 0, 0],
  })),
);

export const prescribedMarks = computed<PrescribedMark[]>(() =>
  (loadCase.value?.prescribed ?? []).map((entry, index) => {
    const dof = prescribedDof(entry) ?? 'uz';
    return { index, entry, nodes: nodesOf(entry), dof, value: entry[dof] ?? 0 };
  }),
);

export const size = ([x, y, z]: Vector): number => Math.hypot(x, y, z);
export const hasGravity = computed(() => size(loadCase.value?.gravity ?? [0, 0, 0]) > 0);
export const isHeld = computed(() => heldNodes.value.length > 0);
export const isLoaded = computed(
  () =>
    hasGravity.value ||
    loadMarks.value.some(({ force, moment }) => size(force) > 0 || size(moment) > 0) ||
    prescribedMarks.value.some(({ value }) => value !== 0),
);
