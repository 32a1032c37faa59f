// SPDX-License-Identifier: GPL-3.0-or-later
// Where nodes are in the picture: at rest plus their displacement times the drawing's scale.

import { Vector3, type Camera } from 'three';
import { beams } from '../../document/store';
import { shown } from '../../document/shown';
import { surface } from '../../document/surface';

export function nodePlace(node: number, into = new Vector3()): Vector3 {
  const bars = beams.peek();
  const rest = surface.peek()?.nodes[node];
  if (bars && node < bars.nodes) into.fromArray(bars.place, 3 * node);
  else into.set(rest?.[0] ?? 0, rest?.[1] ?? 0, 0);
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
