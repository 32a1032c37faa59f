// SPDX-License-Identifier: GPL-3.0-or-later
// Where nodes are in the picture: at rest plus their displacement times the drawing's scale.

import { Vector3, type Camera } from 'three';
import { beams } from '../../document/store';
import { shown } from '../../document/shown';
import { surface } from '../../document/surface';

export function restPlace(node: number, into = new Vector3()): Vector3 {
  const bars = beams.peek();
  const rest = surface.peek()?.nodes[node];
  return bars && node < bars.nodes ? into.fromArray(bars.place, 3 * node) : into.set(rest?.[0] ?? 0, rest?.[1] ?? 0, 0);
}

export function nodePlace(node: number, into = new Vector3()): Vector3 {
  restPlace(node, into);
  const now = shown.peek();
  if (now && 3 * node + 2 < now.solution.displacement.length) {
    const d = now.solution.displacement;
    into.x += now.factor * d[3 * node];
    into.y += now.factor * d[3 * node + 1];
    into.z += now.factor * d[3 * node + 2];
  }
  return into;
}

export function middle(nodes: readonly number[]): Vector3 {
  const sum = new Vector3();
  const one = new Vector3();
  for (const node of nodes) sum.add(nodePlace(node, one));
  return nodes.length ? sum.divideScalar(nodes.length) : sum;
}

/** Where something that is pointed at is: a node, or the middle of a bar. */
export function probedPlace({ kind, index }: { kind: 'node' | 'beam'; index: number }): Vector3 {
  const bars = beams.peek();
  if (kind === 'node' || !bars || index >= bars.beams) return nodePlace(index);
  return middle([bars.ends[2 * index], bars.ends[2 * index + 1]]);
}

/** In pixels of the canvas, from its upper left corner; null behind the camera. */
export function onScreen(place: Vector3, camera: Camera, size: { width: number; height: number }): [number, number] | null {
  const seen = place.clone().project(camera);
  if (seen.z > 1) return null;
  return [(0.5 + 0.5 * seen.x) * size.width, (0.5 - 0.5 * seen.y) * size.height];
}

export function nearestOnScreen(
  count: number,
  pointer: [number, number],
  view: { camera: Camera; size: { width: number; height: number } },
  reach: number,
): number {
  const place = new Vector3();
  let [best, distance] = [-1, reach];
  for (let node = 0; node < count; ++node) {
    nodePlace(node, place).project(view.camera);
    if (place.z > 1) continue;
    const away = Math.hypot((0.5 + 0.5 * place.x) * view.size.width - pointer[0], (0.5 - 0.5 * place.y) * view.size.height - pointer[1]);
    if (away < distance) [best, distance] = [node, away];
  }
  return best;
}

/** The bar whose line passes nearest to the pointer, in its middle part: its ends are nodes. */
export function nearestBar(pointer: [number, number], view: { camera: Camera; size: { width: number; height: number } }, reach: number): number {
  const bars = beams.peek();
  if (!bars) return -1;
  const seen = Array.from({ length: bars.nodes }, (_, node) => onScreen(nodePlace(node), view.camera, view.size));
  let [best, distance] = [-1, reach];
  for (let bar = 0; bar < bars.beams; ++bar) {
    const [a, b] = [seen[bars.ends[2 * bar]], seen[bars.ends[2 * bar + 1]]];
    if (!a || !b) continue;
    const along = [b[0] - a[0], b[1] - a[1]];
    const squared = along[0] ** 2 + along[1] ** 2;
    const share = squared > 0 ? ((pointer[0] - a[0]) * along[0] + (pointer[1] - a[1]) * along[1]) / squared : -1;
    if (share < 0.2 || share > 0.8) continue;
    const away = Math.hypot(pointer[0] - a[0] - share * along[0], pointer[1] - a[1] - share * along[1]);
    if (away < distance) [best, distance] = [bar, away];
  }
  return best;
}
