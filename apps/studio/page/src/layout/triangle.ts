// SPDX-License-Identifier: GPL-3.0-or-later
// The base triangle as it is drawn: regular, as in a hexagon, v0 on top, and the side that tiles share below.

import type { LayoutNode, NodeKind } from '../protocol/requests';
import type { Point, Vector } from '../protocol/messages';

export const SIDE = 100;
export const HEIGHT = (SIDE * Math.sqrt(3)) / 2;
/** The places of v0, v1 and v2, y downwards. */
export const CORNERS: readonly Point[] = [[SIDE / 2, 0], [0, HEIGHT], [SIDE, HEIGHT]];

export const toPlane = (place: Vector): Point => [0, 1].map((c) => place.reduce((sum, share, i) => sum + share * CORNERS[i][c], 0)) as Point;

/** Barycentric coordinates, also of places outside. */
export function toPlace([x, y]: Point): Vector {
  const first = 1 - y / HEIGHT;
  const third = (x - 0.5 * SIDE * first) / SIDE;
  return [first, 1 - first - third, third];
}

/** A node that is added nearer to a side than this (a coordinate) lies on the side. */
const BESIDE = 0.06;
/** The kind of node that is meant by a double-click at a place. */
export function kindAt([first, second, third]: Vector): NodeKind {
  if (first > 1 - BESIDE) return 'center';
  if (first < BESIDE) return 'interface';
  return Math.min(second, third) < BESIDE ? 'radial' : 'face';
}

/** The two ends of the side on which a radial or an interface node lies; null for other nodes. */
function sideOf({ kind, place }: LayoutNode): [number, number] | null {
  if (kind === 'interface') return [1, 2];
  if (kind === 'radial') return place[2] === 0 ? [0, 1] : [0, 2];
  return null;
}

/** The way of an arrow key, y downwards. */
const WAYS: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
/** The coordinates by which a face node goes one step. */
const FACE_STEPS: Record<string, Vector> = { ArrowLeft: [0, 1, -1], ArrowRight: [0, -1, 1], ArrowUp: [2, -1, -1], ArrowDown: [-2, 1, 1] };

/** The place to which a key moves a node, in steps of 1 / grid; null: it does not move. */
export function placeByKey(node: LayoutNode, key: string, grid: number): Vector | null {
  const way = WAYS[key];
  if (!way || node.kind === 'center') return null;
  const side = sideOf(node);
  if (!side) return node.place.map((one, i) => one + FACE_STEPS[key][i] / grid) as Vector;
  const [from, to] = side;
  const along = [0, 1].map((c) => CORNERS[to][c] - CORNERS[from][c]);
  const sign = Math.sign(along[0] * way[0] + along[1] * way[1]);
  if (sign === 0) return null;
  const place: Vector = [...node.place];
  place[to] += sign / grid;
  place[from] -= sign / grid;
  return place;
}
