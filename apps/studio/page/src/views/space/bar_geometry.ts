// SPDX-License-Identifier: GPL-3.0-or-later
// One bar and one joint, drawn many times.

import { BufferAttribute, InstancedBufferGeometry } from 'three';

/** The corners of a section, and which way its four faces look. */
const FACES = [
  { normal: [0, 1, 0], corners: [[0.5, -0.5], [0.5, 0.5]] },
  { normal: [0, 0, 1], corners: [[0.5, 0.5], [-0.5, 0.5]] },
  { normal: [0, -1, 0], corners: [[-0.5, 0.5], [-0.5, -0.5]] },
  { normal: [0, 0, -1], corners: [[-0.5, -0.5], [0.5, -0.5]] },
];

class Shape {
  private readonly positions: number[] = [];
  private readonly normals: number[] = [];
  readonly index: number[] = [];

  get corners(): number {
    return this.positions.length / 3;
  }
  corner(position: number[], normal: number[]): void {
    this.positions.push(...position);
    this.normals.push(...normal);
  }
  geometry(): InstancedBufferGeometry {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(this.positions), 3));
    geometry.setAttribute('normal', new BufferAttribute(new Float32Array(this.normals), 3));
    geometry.setIndex(this.index);
    return geometry;
  }
}

/** A bar along x from 0 to 1, with y and z across its section, which is 1 wide. */
export function barGeometry(pieces: number): InstancedBufferGeometry {
  const shape = new Shape();
  for (const { normal, corners } of FACES) {
    const first = shape.corners;
    for (let piece = 0; piece <= pieces; ++piece) {
      for (const [y, z] of corners) shape.corner([piece / pieces, y, z], normal);
      if (piece === pieces) continue;
      const at = first + 2 * piece;
      shape.index.push(at, at + 1, at + 2, at + 1, at + 3, at + 2);
    }
  }
  return shape.geometry();
}

/** A disc of radius 1, one high. */
export function jointGeometry(sides: number): InstancedBufferGeometry {
  const shape = new Shape();
  const around = Array.from({ length: sides }, (_, i) => [Math.cos((2 * Math.PI * i) / sides), Math.sin((2 * Math.PI * i) / sides)]);
  for (const z of [0.5, -0.5]) {
    const first = shape.corners;
    for (const [x, y] of around) shape.corner([x, y, z], [0, 0, 2 * z]);
    for (let i = 1; i + 1 < sides; ++i) shape.index.push(first, ...(z > 0 ? [first + i, first + i + 1] : [first + i + 1, first + i]));
  }
  const first = shape.corners;
  for (const [x, y] of [...around, around[0]]) for (const z of [0.5, -0.5]) shape.corner([x, y, z], [x, y, 0]);
  for (let i = 0; i < sides; ++i) shape.index.push(first + 2 * i, first + 2 * i + 1, first + 2 * i + 2, first + 2 * i + 2, first + 2 * i + 1, first + 2 * i + 3);
  return shape.geometry();
}
