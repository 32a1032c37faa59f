// SPDX-License-Identifier: GPL-3.0-or-later
// The target of a design: the wanted place of each node, coloured by the node's distance from it, with a line
// to the node.

import { CylinderGeometry, Group, OctahedronGeometry, Quaternion, SphereGeometry, Vector3 } from 'three';
import { designed } from '../../document/design';
import { displacementOf, followed, liveError, liveTarget, target, type TargetEntry } from '../../document/target';
import { shown } from '../../document/shown';
import { themeColour } from '../../manners/theme';
import type { FreeVector } from '../../protocol/messages';
import { colourAt } from './colours';
import { Crowd } from './crowd';
import { nodePlace, restPlace } from './placed';

const UP = new Vector3(0, 1, 0);
const NO_TURN = new Quaternion();

/** Where a node is wanted in the picture. */
export function wantedPlace(node: number, wanted: FreeVector): Vector3 {
  const now = shown.peek();
  const [x, y, z] = followed(wanted, displacementOf(now?.solution.displacement ?? null, node));
  return restPlace(node).addScaledVector(new Vector3(x, y, z), now?.factor ?? 1);
}

/** The middle of the wanted places: where an entry is taken to be dragged. */
export function entryPlace({ nodes, wanted }: TargetEntry): Vector3 {
  const sum = new Vector3();
  nodes.forEach((node, i) => sum.add(wantedPlace(node, wanted[i])));
  return sum.divideScalar(nodes.length || 1);
}

const hex = ([r, g, b]: [number, number, number]): string => `rgb(${r}, ${g}, ${b})`;

export class TargetView {
  readonly group = new Group();
  private readonly points = new Crowd(new SphereGeometry(1, 16, 12), this.group);
  private readonly lines = new Crowd(new CylinderGeometry(1, 1, 1, 8).translate(0, 0.5, 0), this.group, false);
  private readonly handles = new Crowd(new OctahedronGeometry(1), this.group);

  /** `side`: the tiles' mean side, which sets how large marks are. */
  update(side: number): void {
    const nodes = liveTarget.peek();
    const most = liveError.peek()?.largest ?? 0;
    void designed.peek();
    this.points.begin(nodes.length);
    this.lines.begin(nodes.length);
    for (const { node, wanted, distance } of nodes) {
      const place = wantedPlace(node, wanted);
      this.points.add(place, NO_TURN, new Vector3().setScalar(0.15 * side), hex(colourAt('sizes', most > 0 ? distance / most : 0)));
      this.line(nodePlace(node), place, 0.025 * side);
    }
    this.points.end();
    this.lines.end();
    this.handles.begin(target.peek().length);
    for (const entry of target.peek()) this.handles.add(entryPlace(entry), NO_TURN, new Vector3().setScalar(0.4 * side), themeColour('--target'));
    this.handles.end();
  }

  private line(from: Vector3, to: Vector3, thick: number): void {
    const along = to.clone().sub(from);
    const length = along.length();
    if (length === 0) return;
    const turn = new Quaternion().setFromUnitVectors(UP, along.divideScalar(length));
    this.lines.add(from, turn, new Vector3(thick, length, thick), themeColour('--target'));
  }
}
