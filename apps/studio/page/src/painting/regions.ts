// SPDX-License-Identifier: GPL-3.0-or-later
// Which tiles a tool means.

import type { Circle, Point } from '../protocol/messages';
import { inside } from '../document/surface';

/** The tiles within some rings of neighbours around one. */
export function ringsAround(tile: number, rings: number, neighbours: readonly number[][]): number[] {
  const found = new Set([tile]);
  let edge = [tile];
  for (let ring = 0; ring < rings; ++ring) {
    edge = edge.flatMap((one) => neighbours[one] ?? []).filter((one) => !found.has(one) && found.add(one));
  }
  return [...found];
}

/** The connected tiles around one that have its pattern. */
export function sameRegion(tile: number, patternOf: (tile: number) => string, neighbours: readonly number[][]): number[] {
  const wanted = patternOf(tile);
  const found = new Set([tile]);
  const todo = [tile];
  while (todo.length) {
    for (const next of neighbours[todo.pop() as number] ?? []) {
      if (found.has(next) || patternOf(next) !== wanted) continue;
      found.add(next);
      todo.push(next);
    }
  }
  return [...found];
}

export const allWith = (pattern: string, patterns: readonly string[]): number[] =>
  patterns.flatMap((one, tile) => (one === pattern ? [tile] : []));

export const within = (places: readonly Point[], lasso: readonly Point[]): number[] =>
  places.flatMap((place, index) => (inside(lasso, place) ? [index] : []));

export function inBox(places: readonly Point[], a: Point, b: Point): number[] {
  const [x0, x1] = [Math.min(a[0], b[0]), Math.max(a[0], b[0])];
  const [y0, y1] = [Math.min(a[1], b[1]), Math.max(a[1], b[1])];
  return places.flatMap(([x, y], index) => (x >= x0 && x <= x1 && y >= y0 && y <= y1 ? [index] : []));
}

/** The square roots are those of the program, so that both find the same places. */
export const inCircle = (places: readonly Point[], { center, radius }: Circle): number[] =>
  places.flatMap(([x, y], index) => (Math.sqrt((x - center[0]) * (x - center[0]) + (y - center[1]) * (y - center[1])) <= radius ? [index] : []));
