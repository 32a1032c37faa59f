// SPDX-License-Identifier: GPL-3.0-or-later
// Supports as spheres (fixed red, pinned green, single directions amber), forces and moments as arrows, prescribed displacements as diamonds.

import { ConeGeometry, CylinderGeometry, Group, OctahedronGeometry, Quaternion, SphereGeometry, Vector3 } from 'three';
import { HOLD_COLOURS, heldNodes, loadMarks, prescribedMarks, size, type LoadMark } from '../../document/marks';
import { activeEntry, selectedNodes } from '../../document/ui';
import { themeColour } from '../../manners/theme';
import { Crowd } from './crowd';
import { middle, nodePlace } from './placed';

const MOST_SMALL_ARROWS = 24;
const UP = new Vector3(0, 1, 0);
const NO_TURN = new Quaternion();

/** How long arrows are: metres in the picture for each newton (or newton metre) that the largest of them has. */
export interface ArrowScale {
  force: number;
  moment: number;
}
export const ARROW_SHARE = 0.2;

export function arrowScale(marks: readonly LoadMark[], reach: number): ArrowScale {
  const force = Math.max(0, ...marks.map((mark) => size(mark.force)));
  const moment = Math.max(0, ...marks.map((mark) => size(mark.moment)));
  return { force: (ARROW_SHARE * reach) / (force || 0.1), moment: (ARROW_SHARE * reach) / (moment || 0.01) };
}

type Vector3Numbers = readonly [number, number, number];

/** While an arrow is dragged it stays as it was taken, also through the surface. */
export const takenAs = { pushes: null as boolean | null };
/** Arrows that press down and arrows that pull up both stand on the surface, so that they are seen. */
export const pushes = (vector: Vector3Numbers): boolean => takenAs.pushes ?? vector[2] < 0;
/** The vector from a load's nodes to the end of its arrow that is dragged. */
export const reachOf = (vector: Vector3Numbers, scale: number): Vector3 => new Vector3(...vector).multiplyScalar(pushes(vector) ? -scale : scale);

export class MarksView {
  readonly group = new Group();
  private readonly spheres = new Crowd(new SphereGeometry(1, 24, 16), this.group);
  private readonly shafts = new Crowd(new CylinderGeometry(1, 1, 1, 16).translate(0, 0.5, 0), this.group, false);
  private readonly heads = new Crowd(new ConeGeometry(1, 1, 24).translate(0, -0.5, 0), this.group, false);
  private readonly diamonds = new Crowd(new OctahedronGeometry(1), this.group);

  /** `side`: the tiles' mean side, which sets how large marks are. */
  update(side: number, scale: ArrowScale): void {
    this.supports(side);
    this.arrows(side, scale);
    this.prescribed(side);
  }

  private supports(side: number): void {
    const held = heldNodes.peek();
    const chosen = selectedNodes.peek();
    this.spheres.begin(held.length + chosen.size);
    const place = new Vector3();
    const extent = new Vector3();
    for (const { node, kind } of held) {
      this.spheres.add(nodePlace(node, place), NO_TURN, extent.setScalar(kind === 'partly' ? 0.13 * side : 0.17 * side), themeColour(HOLD_COLOURS[kind]));
    }
    for (const node of chosen) this.spheres.add(nodePlace(node, place), NO_TURN, extent.setScalar(0.21 * side), themeColour('--accent'));
    this.spheres.end();
  }

  private arrows(side: number, scale: ArrowScale): void {
    const marks = loadMarks.peek();
    const room = marks.reduce((sum, mark) => sum + mark.nodes.length + 4, 1);
    this.shafts.begin(room);
    this.heads.begin(2 * room);
    const active = activeEntry.peek();
    for (const mark of marks) {
      const thick = active?.kind === 'load' && active.index === mark.index ? 1.35 : 1;
      const from = middle(mark.nodes);
      this.arrow(from, mark.force, scale.force, { thick: 0.075 * side * thick, colour: themeColour('--force'), heads: 1 });
      this.arrow(from, mark.moment, scale.moment, { thick: 0.075 * side * thick, colour: themeColour('--moment'), heads: 2 });
      if (mark.nodes.length < 2) continue;
      const every = Math.ceil(mark.nodes.length / MOST_SMALL_ARROWS);
      for (const node of mark.nodes.filter((_, i) => i % every === 0)) {
        this.arrow(nodePlace(node), mark.force, 0.2 * scale.force, { thick: 0.024 * side, colour: themeColour('--force'), heads: 1 });
      }
    }
    this.shafts.end();
    this.heads.end();
  }

  private arrow(at: Vector3, vector: Vector3Numbers, scale: number, see: { thick: number; colour: string; heads: number }): void {
    const along = new Vector3(...vector).multiplyScalar(scale);
    const length = along.length();
    if (length === 0) return;
    const from = pushes(vector) ? at.clone().sub(along) : at;
    const turn = new Quaternion().setFromUnitVectors(UP, along.clone().normalize());
    const head = Math.min(5 * see.thick, 0.6 * length);
    this.shafts.add(from, turn, new Vector3(see.thick, length - 0.9 * head, see.thick), see.colour);
    for (let i = 0; i < see.heads; ++i) {
      const tip = from.clone().addScaledVector(along, 1 - (0.7 * i * head) / length);
      this.heads.add(tip, turn, new Vector3(2.4 * see.thick, head, 2.4 * see.thick), see.colour);
    }
  }

  private prescribed(side: number): void {
    const marks = prescribedMarks.peek();
    this.diamonds.begin(marks.reduce((sum, mark) => sum + mark.nodes.length + 1, 1));
    for (const mark of marks) {
      const colour = themeColour('--move');
      this.diamonds.add(middle(mark.nodes), NO_TURN, new Vector3().setScalar(0.4 * side), colour);
      for (const node of mark.nodes) this.diamonds.add(nodePlace(node), NO_TURN, new Vector3().setScalar(0.16 * side), colour);
    }
    this.diamonds.end();
  }
}
