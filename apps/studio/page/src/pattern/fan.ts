// SPDX-License-Identifier: GPL-3.0-or-later
// The fan: a pattern repeated around a polygon, one copy in every sector between the centroid and a side.

import type { Point, Vector } from '../protocol/messages';
import { patternEdges } from './pattern_id';

export function centroid(polygon: readonly Point[]): Point {
  let [area, x, y] = [0, 0, 0];
  const [ox, oy] = polygon[0];
  for (let i = 0; i < polygon.length; ++i) {
    const [ax, ay] = [polygon[i][0] - ox, polygon[i][1] - oy];
    const next = polygon[(i + 1) % polygon.length];
    const [bx, by] = [next[0] - ox, next[1] - oy];
    const cross = ax * by - bx * ay;
    area += cross;
    x += cross * (ax + bx);
    y += cross * (ay + by);
  }
  return [ox + x / (3 * area), oy + y / (3 * area)];
}

/** The bars of a fan as x1 y1 x2 y2 after one another; `nodes` are barycentric places on the base triangle. */
export function fanSegments(pattern: string, polygon: readonly Point[], nodes: readonly Vector[]): Float64Array {
  const edges = patternEdges(pattern);
  const center = centroid(polygon);
  const sides = polygon.length;
  const segments = new Float64Array(4 * sides * edges.length);
  let at = 0;
  for (let sector = 0; sector < sides; ++sector) {
    const a = polygon[sector];
    const b = polygon[(sector + 1) % sides];
    for (const edge of edges) {
      for (const end of edge) {
        const [w0, w1, w2] = nodes[end] ?? [1, 0, 0];
        segments[at++] = w0 * center[0] + w1 * a[0] + w2 * b[0];
        segments[at++] = w0 * center[1] + w1 * a[1] + w2 * b[1];
      }
    }
  }
  return segments;
}

const HEXAGON: Point[] = Array.from({ length: 6 }, (_, i) => {
  const angle = (Math.PI / 3) * i - Math.PI / 2 - Math.PI / 6;
  return [Math.cos(angle), Math.sin(angle)];
});

const drawings = new Map<string, string>();
let drawnFor: readonly Vector[] | null = null;

/** A pattern in a hexagon as an SVG path, y downwards, within -1..1. */
export function thumbnailPath(pattern: string, nodes: readonly Vector[]): string {
  if (nodes !== drawnFor) drawings.clear();
  drawnFor = nodes;
  const known = drawings.get(pattern);
  if (known) return known;
  const segments = fanSegments(pattern, HEXAGON, nodes);
  let path = '';
  for (let i = 0; i < segments.length; i += 4) {
    const [x1, y1, x2, y2] = [segments[i], segments[i + 1], segments[i + 2], segments[i + 3]].map((v) => v.toFixed(3));
    path += `M${x1} ${-Number(y1)}L${x2} ${-Number(y2)}`;
  }
  drawings.set(pattern, path);
  return path;
}

export const hexagonPath = `M${HEXAGON.map(([x, y]) => `${x.toFixed(3)} ${(-y).toFixed(3)}`).join('L')}Z`;
