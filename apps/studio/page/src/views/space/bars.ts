// SPDX-License-Identifier: GPL-3.0-or-later
// All bars of a surface as one drawn object: their section is real, and a new solution is a few thousand numbers.

import { Color, InstancedBufferAttribute, InstancedBufferGeometry, BufferAttribute, Mesh, type ColorRepresentation, type MeshStandardMaterial } from 'three';
import type { Beams, Solution } from '../../protocol/binary';
import { barMaterial, barShadow } from './bar_shader';
import { barUniforms, colourTexture, nodeTexture, writeScalars, writeVectors } from './bar_uniforms';
import type { ColourMap } from './colours';
import type { Values } from './fields';
import { drawsInSoftware } from './software';

/** The corners of a section, and which way its four faces look. */
const FACES = [
  { normal: [0, 1, 0], corners: [[0.5, -0.5], [0.5, 0.5]] },
  { normal: [0, 0, 1], corners: [[0.5, 0.5], [-0.5, 0.5]] },
  { normal: [0, -1, 0], corners: [[-0.5, 0.5], [-0.5, -0.5]] },
  { normal: [0, 0, -1], corners: [[-0.5, -0.5], [0.5, -0.5]] },
];
const MANY_BARS = 6000;

function barGeometry(pieces: number): InstancedBufferGeometry {
  const [positions, normals, index]: number[][] = [[], [], []];
  for (const { normal, corners } of FACES) {
    const first = positions.length / 3;
    for (let piece = 0; piece <= pieces; ++piece) {
      for (const [y, z] of corners) {
        positions.push(piece / pieces, y, z);
        normals.push(...normal);
      }
      if (piece === pieces) continue;
      const at = first + 2 * piece;
      index.push(at, at + 2, at + 1, at + 1, at + 2, at + 3);
    }
  }
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(normals), 3));
  geometry.setIndex(index);
  return geometry;
}

export interface BarLook {
  colour: ColorRepresentation;
  opacity: number;
}

export class Bars {
  readonly mesh: Mesh<InstancedBufferGeometry, MeshStandardMaterial>;
  private readonly uniforms = barUniforms();
  private beams: Beams | null = null;

  constructor(look: BarLook) {
    this.mesh = new Mesh(barGeometry(1), barMaterial(this.uniforms, look));
    this.mesh.material.color = new Color(look.colour);
    this.mesh.frustumCulled = false;
    this.mesh.customDepthMaterial = barShadow(this.uniforms);
    this.mesh.castShadow = this.mesh.receiveShadow = look.opacity === 1;
    this.mesh.visible = false;
  }

  set colour(colour: ColorRepresentation) {
    this.mesh.material.color.set(colour);
  }
  set factor(factor: number) {
    this.uniforms.factor.value = factor;
  }
  get factor(): number {
    return this.uniforms.factor.value;
  }

  /** Other bars: a tile was painted. Displacements are zero until a solution is set. */
  setBeams(beams: Beams, section: { width: number; height: number }): void {
    this.uniforms.section.value.set(section.width, section.height);
    if (beams === this.beams) return;
    this.beams = beams;
    this.mesh.geometry.dispose();
    const geometry = barGeometry(beams.beams > MANY_BARS || drawsInSoftware ? 2 : 5);
    geometry.setAttribute('ends', new InstancedBufferAttribute(Float32Array.from(beams.ends), 2));
    geometry.setAttribute('axis3', new InstancedBufferAttribute(beams.axis3, 3));
    geometry.setAttribute('endValues', new InstancedBufferAttribute(new Float32Array(2 * beams.beams), 2));
    geometry.instanceCount = beams.beams;
    this.mesh.geometry = geometry;
    for (const key of ['places', 'moves', 'turns'] as const) {
      this.uniforms[key].value.dispose();
      this.uniforms[key].value = nodeTexture(beams.nodes);
    }
    writeVectors(this.uniforms.places.value, beams.place);
  }

  /** Where everything moved. Nothing is allocated. */
  setSolution(solution: Solution): void {
    writeVectors(this.uniforms.moves.value, solution.displacement);
    writeVectors(this.uniforms.turns.value, solution.rotation);
  }

  setColours(values: Values | null, map: ColourMap): void {
    this.uniforms.colourOn.value = values ? 1 : 0;
    if (!values) return;
    this.uniforms.valuesOnBars.value = values.on === 'bars' ? 1 : 0;
    this.uniforms.valueRange.value.set(values.low, values.high);
    this.uniforms.colours.value = colourTexture(map);
    if (values.on === 'nodes') writeScalars(this.uniforms.moves.value, values.values);
    else {
      const attribute = this.mesh.geometry.getAttribute('endValues') as InstancedBufferAttribute;
      (attribute.array as Float32Array).set(values.values);
      attribute.needsUpdate = true;
    }
  }
}
