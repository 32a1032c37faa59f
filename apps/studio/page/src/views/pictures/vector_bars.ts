// SPDX-License-Identifier: GPL-3.0-or-later
// Bars as lines of a drawing, the farthest first, so that nearer ones hide what is behind them.

import { Matrix4, Quaternion, Vector3, Vector4, type Camera } from 'three';
import type { Beams, Solution } from '../../protocol/binary';

export interface VectorView {
  camera: Camera;
  width: number;
  height: number;
}
export interface VectorBars {
  beams: Beams;
  /** null: at rest. */
  solution: Solution | null;
  factor: number;
  section: { width: number; height: number };
  /** The colour of a bar, at a share of the way from its first end. */
  colour(bar: number, share: number): string;
  opacity: number;
}

/** A straight piece in the picture. */
interface Piece {
  depth: number;
  text: string;
}
const PIECES = 4;
const digits = (value: number): string => value.toFixed(1);

/** Pixels, and how far away: `depth` is -1 on the near plane and 1 on the far plane of the camera. */
interface SeenPoint {
  x: number;
  y: number;
  depth: number;
  /** Pixels for a metre across the view. */
  perMetre: number;
}

export class Projector {
  private readonly matrix: Matrix4;
  private readonly stretch: number;
  constructor(private readonly view: VectorView) {
    const { camera } = view;
    camera.updateMatrixWorld();
    this.matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    this.stretch = 0.5 * view.height * camera.projectionMatrix.elements[5];
  }
  see(place: Vector3): SeenPoint {
    const seen = new Vector4(place.x, place.y, place.z, 1).applyMatrix4(this.matrix);
    return {
      x: (0.5 + (0.5 * seen.x) / seen.w) * this.view.width,
      y: (0.5 - (0.5 * seen.y) / seen.w) * this.view.height,
      depth: seen.z / seen.w,
      perMetre: this.stretch / seen.w,
    };
  }
  /** The part of a line that lies before the camera; null: nothing of it does. */
  ahead(from: Vector3, to: Vector3): [Vector3, Vector3] | null {
    const [a, b] = [this.beyondNear(from), this.beyondNear(to)];
    if (a < 0 && b < 0) return null;
    const cut = from.clone().lerp(to, a < 0 || b < 0 ? a / (a - b) : 0);
    return [a < 0 ? cut : from, b < 0 ? cut : to];
  }
  /** Not negative where the camera sees a place: it is linear in the place, and zero on the near plane. */
  private beyondNear(place: Vector3): number {
    const seen = new Vector4(place.x, place.y, place.z, 1).applyMatrix4(this.matrix);
    return seen.z + seen.w;
  }
  get facing(): Vector3 {
    return this.view.camera.getWorldDirection(new Vector3());
  }
}

const at = (array: Float32Array, index: number): Vector3 => new Vector3(array[3 * index], array[3 * index + 1], array[3 * index + 2]);

function turnOf(rotation: Vector3): Quaternion {
  const angle = rotation.length();
  return angle === 0 ? new Quaternion() : new Quaternion().setFromAxisAngle(rotation.clone().divideScalar(angle), angle);
}

/** Places along a bar whose ends move and turn, as the 3D view bends it. */
export function bentLine({ beams, solution, factor }: Pick<VectorBars, 'beams' | 'solution' | 'factor'>, bar: number): Vector3[] {
  const nodes = [beams.ends[2 * bar], beams.ends[2 * bar + 1]];
  const rest = nodes.map((node) => at(beams.place, node));
  if (!solution || factor === 0) return rest;
  const places = nodes.map((node, i) => rest[i].clone().addScaledVector(at(solution.displacement, node), factor));
  const along = rest[1].clone().sub(rest[0]).normalize();
  const length = places[0].distanceTo(places[1]);
  const tangents = nodes.map((node) => along.clone().applyQuaternion(turnOf(at(solution.rotation, node).multiplyScalar(factor))).multiplyScalar(length));
  return Array.from({ length: PIECES + 1 }, (_, i) => {
    const s = i / PIECES;
    const [s2, s3] = [s * s, s * s * s];
    return new Vector3()
      .addScaledVector(places[0], 2 * s3 - 3 * s2 + 1)
      .addScaledVector(places[1], 3 * s2 - 2 * s3)
      .addScaledVector(tangents[0], s3 - 2 * s2 + s)
      .addScaledVector(tangents[1], s3 - s2);
  });
}

/** How wide the bar is seen: its section, as it is turned at its first end. */
function apparentWidth({ beams, solution, factor, section }: VectorBars, bar: number, facing: Vector3): number {
  const axis = at(beams.axis3, bar);
  if (solution) axis.applyQuaternion(turnOf(at(solution.rotation, beams.ends[2 * bar]).multiplyScalar(factor)));
  const front = Math.abs(axis.dot(facing));
  return front * section.width + Math.sqrt(Math.max(0, 1 - front * front)) * section.height;
}

function piecesOf(bars: VectorBars, project: Projector, sink: Piece[]): void {
  const facing = project.facing;
  const faint = bars.opacity < 1 ? ` opacity="${bars.opacity}"` : '';
  for (let bar = 0; bar < bars.beams.beams; ++bar) {
    const width = apparentWidth(bars, bar, facing);
    const places = bentLine(bars, bar);
    for (let i = 0; i + 1 < places.length; ++i) {
      const ahead = project.ahead(places[i], places[i + 1]);
      if (!ahead) continue;
      const [a, b] = ahead.map((place) => project.see(place));
      const share = (i + 0.5) / (places.length - 1);
      sink.push({
        depth: (a.depth + b.depth) / 2,
        text: `<path d="M${digits(a.x)} ${digits(a.y)}L${digits(b.x)} ${digits(b.y)}" stroke="${bars.colour(bar, share)}" stroke-width="${((a.perMetre + b.perMetre) * 0.5 * width).toFixed(2)}"${faint}/>`,
      });
    }
  }
}

/** All bars as one group of an SVG. */
export function vectorBars(layers: readonly VectorBars[], view: VectorView): string {
  const project = new Projector(view);
  const pieces: Piece[] = [];
  for (const layer of layers) piecesOf(layer, project, pieces);
  pieces.sort((a, b) => b.depth - a.depth);
  return `<g fill="none" stroke-linecap="round">${pieces.map(({ text }) => text).join('')}</g>`;
}
