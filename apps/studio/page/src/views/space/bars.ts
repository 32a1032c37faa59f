// SPDX-License-Identifier: GPL-3.0-or-later
// All bars of a surface as two drawn objects, bars and joints: their section is real, and a new solution is a few thousand numbers.

import { Color, Group, InstancedBufferAttribute, Mesh, type ColorRepresentation, type InstancedBufferGeometry, type MeshStandardMaterial } from 'three';
import type { Beams, Solution } from '../../protocol/binary';
import { barGeometry, jointGeometry } from './bar_geometry';
import { barMaterial, barShadow, type Part } from './bar_shader';
import { barUniforms, colourTexture, nodeTexture, writeScalars, writeVectors } from './bar_uniforms';
import type { ColourMap } from './colours';
import type { Values } from './fields';
import { drawsInSoftware } from './software';
import type { Quality } from './stage';

const MANY_BARS = 6000;
const JOINT_SIDES = drawsInSoftware ? 6 : 10;

export interface BarLook {
  colour: ColorRepresentation;
  opacity: number;
}
type Drawn = Mesh<InstancedBufferGeometry, MeshStandardMaterial>;

export class Bars {
  readonly group = new Group();
  private readonly uniforms = barUniforms();
  private readonly bars: Drawn;
  private readonly joints: Drawn;
  private quickBars = barGeometry(1);
  private fineBars = this.quickBars;
  private beams: Beams | null = null;
  private room = 0;

  constructor(private readonly look: BarLook) {
    this.bars = this.make('bar', this.quickBars);
    this.joints = this.make('joint', jointGeometry(JOINT_SIDES));
    this.group.visible = false;
    this.colour = look.colour;
  }

  private make(part: Part, geometry: InstancedBufferGeometry): Drawn {
    const thing = { part, uniforms: this.uniforms };
    const mesh = new Mesh(geometry, barMaterial(thing, this.look));
    mesh.frustumCulled = false;
    mesh.customDepthMaterial = barShadow(thing);
    mesh.castShadow = mesh.receiveShadow = this.look.opacity === 1;
    this.group.add(mesh);
    return mesh;
  }

  set colour(colour: ColorRepresentation) {
    for (const mesh of [this.bars, this.joints]) mesh.material.color = new Color(colour);
  }
  set factor(factor: number) {
    this.uniforms.factor.value = factor;
  }
  get factor(): number {
    return this.uniforms.factor.value;
  }
  /**
   * A quick picture without a graphics card has straight bars and no joints. Transparent bars never have
   * joints; without a graphics card, a surface of many bars has none, either.
   */
  set quality(quality: Quality) {
    const fine = quality === 'fine' || !drawsInSoftware;
    const isLight = !drawsInSoftware || (this.beams?.beams ?? 0) < MANY_BARS;
    this.joints.visible = this.look.opacity === 1 && fine && isLight;
    this.bars.geometry = fine ? this.fineBars : this.quickBars;
  }

  /** Other bars: a tile was painted. Displacements are zero until a solution is set. */
  setBeams(beams: Beams, section: { width: number; height: number }): void {
    this.uniforms.section.value.set(section.width, section.height);
    if (beams === this.beams) return;
    this.beams = beams;
    this.replaceBars(beams);
    this.replaceJoints(beams);
    this.writePlaces(beams);
  }

  private replaceBars(beams: Beams): void {
    const shared = {
      ends: new InstancedBufferAttribute(new Float32Array(beams.ends), 2),
      axis3: new InstancedBufferAttribute(beams.axis3, 3),
      endValues: new InstancedBufferAttribute(new Float32Array(2 * beams.beams), 2),
    };
    this.quickBars.dispose();
    this.fineBars.dispose();
    this.quickBars = instanced(barGeometry(1), shared, beams.beams);
    this.fineBars = instanced(barGeometry(pieces(beams.beams)), shared, beams.beams);
    this.bars.geometry = drawsInSoftware ? this.quickBars : this.fineBars;
  }

  private replaceJoints(beams: Beams): void {
    this.joints.geometry.dispose();
    this.joints.geometry = instanced(
      jointGeometry(JOINT_SIDES),
      {
        node: new InstancedBufferAttribute(numbered(beams.nodes), 1),
        axis3: new InstancedBufferAttribute(jointAxes(beams), 3),
        endValues: new InstancedBufferAttribute(new Float32Array(2 * beams.nodes), 2),
      },
      beams.nodes,
    );
  }

  private writePlaces(beams: Beams): void {
    for (const key of ['places', 'moves', 'turns'] as const) {
      if (beams.nodes <= this.room) {
        if (key !== 'places') writeVectors(this.uniforms[key].value, new Float32Array(3 * beams.nodes));
        continue;
      }
      this.uniforms[key].value.dispose();
      this.uniforms[key].value = nodeTexture(beams.nodes);
    }
    this.room = Math.max(this.room, beams.nodes);
    writeVectors(this.uniforms.places.value, beams.place);
  }

  /** Sets where everything moved, and allocates nothing. */
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
    else this.writeEndValues(values.values);
  }

  /** A joint has the value of the last bar that ends there. */
  private writeEndValues(values: Float32Array): void {
    const ends = this.beams?.ends ?? new Uint32Array(0);
    const [bars, joints] = [this.bars, this.joints].map((mesh) => mesh.geometry.getAttribute('endValues') as InstancedBufferAttribute);
    (bars.array as Float32Array).set(values);
    for (let end = 0; end < ends.length; ++end) joints.array[2 * ends[end]] = values[end];
    bars.needsUpdate = joints.needsUpdate = true;
  }
}

function instanced(geometry: InstancedBufferGeometry, attributes: Record<string, InstancedBufferAttribute>, count: number): InstancedBufferGeometry {
  for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
  geometry.instanceCount = count;
  return geometry;
}

function pieces(bars: number): number {
  if (drawsInSoftware) return bars > MANY_BARS ? 1 : 2;
  return bars > MANY_BARS ? 2 : 5;
}

/** A joint lies as one of its bars does. */
function jointAxes({ nodes, ends, axis3 }: Beams): Float32Array {
  const axes = new Float32Array(3 * nodes);
  for (let end = 0; end < ends.length; ++end) axes.set(axis3.subarray(3 * (end >> 1), 3 * (end >> 1) + 3), 3 * ends[end]);
  return axes;
}

function numbered(count: number): Float32Array {
  const numbers = new Float32Array(count);
  for (let i = 0; i < count; ++i) numbers[i] = i;
  return numbers;
}
