// SPDX-License-Identifier: GPL-3.0-or-later
// The flat surface of the document as the views need it: polygons, centres, what lies under a point.

import { computed } from '@preact/signals';
import type { Point, StudioDocument, Tile, Vector } from '../protocol/messages';
import { centroid } from '../pattern/fan';
import { documentNow, patternTable } from './store';

export interface Box {
  min: Point;
  max: Point;
}
export interface Surface {
  polygons: Point[][];
  centers: Point[];
  nodes: Point[];
  tiles: Tile[];
  rim: number[][];
  onRim: Set<number>;
  box: Box;
  /** Mean side of the tiles, in metres. */
  side: number;
  layoutNodes: Vector[];
}

const tessellation = computed(() => documentNow.value?.tiles);
const vertices = computed(() => documentNow.value?.vertices);

/** Replaced when the tessellation changes, not with each edit of the document. */
export const surface = computed<Surface | null>(() => {
  if (!tessellation.value || !vertices.value) return null;
  return makeSurface(documentNow.peek() as StudioDocument);
});

export function makeSurface(document: StudioDocument): Surface {
  const polygons = document.tiles.map((tile) => tile.vertices.map((vertex) => document.vertices[vertex]));
  return {
    polygons,
    centers: polygons.map(centroid),
    nodes: document.interface_nodes,
    tiles: document.tiles,
    rim: document.rim,
    onRim: new Set(document.rim.flat()),
    box: boxOf(document.vertices),
    side: meanSide(polygons),
    layoutNodes: document.layout_nodes ?? patternTable.value?.nodes ?? [],
  };
}

export function boxOf(points: readonly Point[]): Box {
  const box: Box = { min: [Infinity, Infinity], max: [-Infinity, -Infinity] };
  for (const [x, y] of points) {
    box.min = [Math.min(box.min[0], x), Math.min(box.min[1], y)];
    box.max = [Math.max(box.max[0], x), Math.max(box.max[1], y)];
  }
  return box;
}

function meanSide(polygons: Point[][]): number {
  let [sum, count] = [0, 0];
  for (const polygon of polygons) {
    polygon.forEach((a, i) => {
      const b = polygon[(i + 1) % polygon.length];
      sum += Math.hypot(b[0] - a[0], b[1] - a[1]);
      ++count;
    });
  }
  return count ? sum / count : 1;
}

export function areaOf(polygon: readonly Point[]): number {
  let twice = 0;
  polygon.forEach(([x, y], i) => {
    const [u, v] = polygon[(i + 1) % polygon.length];
    twice += x * v - u * y;
  });
  return Math.abs(twice) / 2;
}

export function inside(polygon: readonly Point[], [x, y]: Point): boolean {
  let within = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const [xi, yi] = polygon[i];
    const [xj, yj] = polygon[j];
    if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) within = !within;
  }
  return within;
}

export function tileAt({ polygons, centers, side }: Surface, point: Point): number {
  const reach = 3 * side;
  for (let tile = 0; tile < polygons.length; ++tile) {
    if (Math.abs(centers[tile][0] - point[0]) > reach || Math.abs(centers[tile][1] - point[1]) > reach) continue;
    if (inside(polygons[tile], point)) return tile;
  }
  return -1;
}

/** Tiles that share a side with a tile. */
export const neighbours = computed<number[][]>(() => {
  const now = surface.value;
  if (!now) return [];
  const owners = new Map<number, number[]>();
  now.tiles.forEach((tile, index) => tile.interface.forEach((node) => owners.set(node, [...(owners.get(node) ?? []), index])));
  return now.tiles.map((tile, index) => [
    ...new Set(tile.interface.flatMap((node) => owners.get(node) ?? []).filter((other) => other !== index)),
  ]);
});

export function nearestNode(nodes: readonly Point[], [x, y]: Point, reach = Infinity): number {
  let [best, distance] = [-1, reach];
  nodes.forEach((node, index) => {
    const away = Math.hypot(node[0] - x, node[1] - y);
    if (away < distance) [best, distance] = [index, away];
  });
  return best;
}
