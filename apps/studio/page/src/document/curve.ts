// SPDX-License-Identifier: GPL-3.0-or-later
// From a curve that is drawn over the side view to a target. A surface bends far more than it stretches, so a
// node at some length along the surface is wanted at that length along the curve.

import type { FreeVector, Point } from '../protocol/messages';
import type { TargetEntry } from './target';

/** The horizontal axis of the side view: x or y. */
export type SideAxis = 0 | 1;

/** A node in the side view. */
export interface SideNode {
  node: number;
  /** Its place along the axis at rest. */
  rest: number;
  /** Where it is now: along the axis, and up. */
  now: Point;
}

/** The place at some length along a curve; null beyond its end. */
export function placeAlong(curve: readonly Point[], length: number): Point | null {
  let left = length;
  for (let i = 1; i < curve.length; ++i) {
    const [a, b] = [curve[i - 1], curve[i]];
    const step = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (left <= step) {
      const share = step > 0 ? left / step : 0;
      return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
    }
    left -= step;
  }
  return null;
}

const nearest = (nodes: readonly SideNode[], [x, z]: Point): SideNode =>
  nodes.reduce((best, one) => (Math.hypot(one.now[0] - x, one.now[1] - z) < Math.hypot(best.now[0] - x, best.now[1] - z) ? one : best));

/** The target of the nodes along the curve, from the node nearest to its start; null if it reaches none. */
export function targetOfCurve(drawn: readonly Point[], nodes: readonly SideNode[], axis: SideAxis): TargetEntry | null {
  if (drawn.length < 2 || nodes.length === 0) return null;
  const first = nearest(nodes, drawn[0]);
  const curve = [first.now, ...drawn.slice(1)];
  const way = Math.sign(curve[curve.length - 1][0] - first.now[0]) || 1;
  const entry: TargetEntry = { nodes: [], wanted: [] };
  for (const { node, rest } of nodes) {
    const along = way * (rest - first.rest);
    const place = along < -1e-9 ? null : placeAlong(curve, Math.max(along, 0));
    if (!place) continue;
    const wanted: FreeVector = [null, null, place[1]];
    wanted[axis] = place[0] - rest;
    entry.nodes.push(node);
    entry.wanted.push(wanted);
  }
  return entry.nodes.length > 0 ? entry : null;
}
