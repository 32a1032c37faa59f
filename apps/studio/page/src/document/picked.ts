// SPDX-License-Identifier: GPL-3.0-or-later
// How the selected nodes were picked. A side, a box or a circle goes into a load case as such, so that it means the right nodes
// on other tiles, too; nodes that were clicked go into it by their numbers.

import { computed, signal } from '@preact/signals';
import type { Circle, Point, Selection } from '../protocol/messages';
import { surface } from './surface';
import { selectedNodes } from './ui';

/** The last rule, and the very set that it selected: another set is another selection. */
const last = signal<{ nodes: ReadonlySet<number>; where: Selection } | null>(null);

/** Select nodes, and remember the rule that means them. */
export function selectBy(where: Selection, nodes: readonly number[]): void {
  const chosen = new Set(nodes);
  last.value = { nodes: chosen, where };
  selectedNodes.value = chosen;
}

/** The rule that the selection follows; null if the nodes were picked one by one. */
export const pickedBy = computed<Selection | null>(() =>
  last.value !== null && last.value.nodes === selectedNodes.value ? last.value.where : null,
);

export const chosenNodes = (): number[] => [...selectedNodes.peek()].sort((a, b) => a - b);

/** The selection as an entry of a load case has it. */
export const whereChosen = (): Selection => pickedBy.peek() ?? { nodes: chosenNodes() };

/** Select what an entry of a load case is on, by its rule if it has one that selects nodes. */
export function selectAgain({ box, circle, nearest, side, between }: Selection, nodes: readonly number[]): void {
  if (side && !between) selectBy({ side }, nodes);
  else if (box) selectBy({ box }, nodes);
  else if (circle) selectBy({ circle }, nodes);
  else if (nearest) selectBy({ nearest }, nodes);
  else selectedNodes.value = new Set(nodes);
}

export const isRule = ({ nodes }: Selection): boolean => nodes === undefined;

const MICROMETRES = 1e6;
const down = (value: number): number => Math.floor(value * MICROMETRES) / MICROMETRES;
const up = (value: number): number => Math.ceil(value * MICROMETRES) / MICROMETRES;

/** The box between two corners, rounded outwards to whole micrometres, because people read the files. */
export function boxBetween([x, y]: Point, [u, v]: Point): [number, number, number, number] {
  return [down(Math.min(x, u)), down(Math.min(y, v)), up(Math.max(x, u)), up(Math.max(y, v))];
}

const near = (value: number): number => Math.round(value * MICROMETRES) / MICROMETRES;

/** The circle around a point through another one, in whole micrometres, its radius rounded up. */
export function circleThrough([x, y]: Point, [u, v]: Point): Circle {
  const center: Point = [near(x), near(y)];
  return { center, radius: up(Math.hypot(u - center[0], v - center[1])) };
}

/** A box around the whole surface, with room for tiles of another size. */
export function boxOfAll(): [number, number, number, number] | null {
  const now = surface.peek();
  if (!now) return null;
  const { min, max } = now.box;
  return boxBetween([min[0] - now.side, min[1] - now.side], [max[0] + now.side, max[1] + now.side]);
}
