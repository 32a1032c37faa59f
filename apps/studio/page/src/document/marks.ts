// SPDX-License-Identifier: GPL-3.0-or-later
// The selected load case as things to draw: which nodes are held and how, what acts where.

import { computed } from '@preact/signals';
import { DOFS, type Dof, type Load, type Prescribed, type Support, type Vector } from '../protocol/messages';
import { selectedNodes } from './selected_nodes';
import { documentNow, loadCase } from './store';
import { areaOf, nodeAreas, surface } from './surface';

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
  /** All of it that acts, in N and N m. */
  force: Vector;
  moment: Vector;
  /** Of a load on an area: how large it is, in m2. */
  area: number | null;
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

/** The supports of a load case, and of those that act together with it. */
const supports = computed<Support[]>(() => {
  const together = new Set(loadCase.value?.combines?.map(({ load_case }) => load_case));
  const others = documentNow.value?.load_cases.filter(({ name }) => together.has(name)) ?? [];
  return [loadCase.value, ...others].flatMap((one) => one?.supports ?? []);
});

/** Each held node once, with all that holds it. */
export const heldNodes = computed<HeldNode[]>(() => {
  const all = new Map<number, Set<Dof>>();
  for (const support of supports.value) {
    for (const node of nodesOf(support)) {
      const fixed = all.get(node) ?? new Set<Dof>();
      support.fixed.forEach((dof) => fixed.add(dof));
      all.set(node, fixed);
    }
  }
  return [...all].map(([node, set]) => ({ node, kind: holdKind([...set]), fixed: DOFS.filter((dof) => set.has(dof)) }));
});

export const loadMarks = computed<LoadMark[]>(() => (loadCase.value?.loads ?? []).map(loadMark));

function loadMark(load: Load, index: number): LoadMark {
  const nodes = nodesOf(load);
  const area = load.per_area ? loadedArea(load, nodes) : null;
  const force = load.per_area && area !== null ? (load.per_area.map((value) => value * area) as Vector) : (load.force ?? [0, 0, 0]);
  return { index, load, nodes, force, moment: load.moment ?? [0, 0, 0], area };
}

function loadedArea({ tiles }: Load, nodes: readonly number[]): number {
  if (tiles) return tiles.reduce((sum, tile) => sum + areaOf(surface.value?.polygons[tile] ?? []), 0);
  return nodes.reduce((sum, node) => sum + (nodeAreas.value[node] ?? 0), 0);
}

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
    (loadCase.value?.combines ?? []).length > 0 ||
    loadMarks.value.some(({ force, moment }) => size(force) > 0 || size(moment) > 0) ||
    prescribedMarks.value.some(({ value }) => value !== 0),
);
