// SPDX-License-Identifier: GPL-3.0-or-later
// The selected load case as things to draw: which nodes are held and how, what acts where.

import { computed } from '@preact/signals';
import { DOFS, type Dof, type Load, type LoadShares, type Prescribed, type SentLoadCase, type Vector } from '../protocol/messages';
import { documentNow, loadCase } from './store';

export type HoldKind = 'fixed' | 'pinned' | 'partly';
export interface HeldNode {
  node: number;
  kind: HoldKind;
  fixed: Dof[];
}
export interface LoadMark extends LoadShares {
  index: number;
  load: Load;
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

/** The nodes of each support of the selected load case. */
export const supportNodes = computed<number[][]>(() => loadCase.value?.marks.supports ?? []);

/** The supports of a load case, and of those that act together with it. */
const supports = computed<{ nodes: number[]; fixed: Dof[] }[]>(() => {
  const together = new Set(loadCase.value?.combines?.map(({ load_case }) => load_case));
  const others = documentNow.value?.load_cases.filter(({ name }) => together.has(name)) ?? [];
  return [loadCase.value, ...others].flatMap((one) => one?.supports?.map(({ fixed }, i) => ({ nodes: one.marks.supports[i], fixed })) ?? []);
});

/** Each held node once, with all components that are fixed. */
export const heldNodes = computed<HeldNode[]>(() => {
  const all = new Map<number, Set<Dof>>();
  for (const support of supports.value) {
    for (const node of support.nodes) {
      const fixed = all.get(node) ?? new Set<Dof>();
      support.fixed.forEach((dof) => fixed.add(dof));
      all.set(node, fixed);
    }
  }
  return [...all].map(([node, set]) => ({ node, kind: holdKind([...set]), fixed: DOFS.filter((dof) => set.has(dof)) }));
});

export const loadMarks = computed<LoadMark[]>(() =>
  (loadCase.value?.loads ?? []).map((load, index) => ({ index, load, ...(loadCase.value as SentLoadCase).marks.loads[index] })),
);

export const prescribedMarks = computed<PrescribedMark[]>(() =>
  (loadCase.value?.prescribed ?? []).map((entry, index) => {
    const dof = prescribedDof(entry) ?? 'uz';
    return { index, entry, nodes: loadCase.value?.marks.prescribed[index] ?? [], dof, value: entry[dof] ?? 0 };
  }),
);

export const size = ([x, y, z]: Vector): number => Math.hypot(x, y, z);
/** Whether a load has a force, a moment or both; the colours have the same names. */
export const loadKinds = (mark: Pick<LoadMark, 'force' | 'moment'>): ('force' | 'moment')[] => (['force', 'moment'] as const).filter((kind) => size(mark[kind]) > 0);
export const hasGravity = computed(() => size(loadCase.value?.gravity ?? [0, 0, 0]) > 0);
export const isHeld = computed(() => heldNodes.value.length > 0);
export const isLoaded = computed(
  () =>
    hasGravity.value ||
    (loadCase.value?.combines ?? []).length > 0 ||
    loadMarks.value.some((mark) => loadKinds(mark).length > 0) ||
    prescribedMarks.value.some(({ value }) => value !== 0),
);
