// SPDX-License-Identifier: GPL-3.0-or-later
// Bars are bent on the graphics card: a solution is written into two small textures, and each bar looks up its two ends.
// Between them runs the cubic that meets places and tangents at both ends; the section turns along with it. Where bars meet, a round
// joint as thick as they are closes the corner.

import { MeshDepthMaterial, MeshStandardMaterial, RGBADepthPacking, type Material, type WebGLProgramParametersWithUniforms } from 'three';
import type { BarUniforms } from './bar_uniforms';

const DECLARATIONS = /* glsl */ `
attribute vec3 axis3;
attribute vec2 endValues;
uniform highp sampler2D places;
uniform highp sampler2D moves;
uniform highp sampler2D turns;
uniform float factor;
uniform vec2 section;
uniform float valuesOnBars;
varying float shownValue;

vec4 nodeTexel(highp sampler2D table, float node) {
  int width = textureSize(table, 0).x;
  int i = int(node + 0.5);
  return texelFetch(table, ivec2(i % width, i / width), 0);
}
vec3 turned(vec3 turn, vec3 v) {
  float angle = length(turn);
  if (angle < 1e-6) return v + cross(turn, v);
  vec3 k = turn / angle;
  return v * cos(angle) + cross(k, v) * sin(angle) + k * dot(k, v) * (1.0 - cos(angle));
}
`;

const BAR = /* glsl */ `
attribute vec2 ends;
void bent(out vec3 place, out vec3 facing) {
  vec3 x0 = nodeTexel(places, ends.x).xyz;
  vec3 x1 = nodeTexel(places, ends.y).xyz;
  vec4 m0 = nodeTexel(moves, ends.x);
  vec4 m1 = nodeTexel(moves, ends.y);
  vec3 r0 = factor * nodeTexel(turns, ends.x).xyz;
  vec3 r1 = factor * nodeTexel(turns, ends.y).xyz;
  vec3 p0 = x0 + factor * m0.xyz;
  vec3 p1 = x1 + factor * m1.xyz;
  vec3 along = normalize(x1 - x0);
  float reach = distance(p0, p1);
  vec3 t0 = reach * turned(r0, along);
  vec3 t1 = reach * turned(r1, along);
  float s = position.x;
  float s2 = s * s;
  float s3 = s2 * s;
  vec3 middle = (2.0 * s3 - 3.0 * s2 + 1.0) * p0 + (s3 - 2.0 * s2 + s) * t0 + (3.0 * s2 - 2.0 * s3) * p1 + (s3 - s2) * t1;
  vec3 tangent = normalize(6.0 * (s2 - s) * (p0 - p1) + (3.0 * s2 - 4.0 * s + 1.0) * t0 + (3.0 * s2 - 2.0 * s) * t1 + 1e-9 * along);
  vec3 up = mix(turned(r0, axis3), turned(r1, axis3), s);
  vec3 across = normalize(cross(up, tangent));
  up = cross(tangent, across);
  place = middle + across * position.y * section.x + up * position.z * section.y;
  facing = normal.x * tangent + normal.y * across + normal.z * up;
  shownValue = mix(mix(m0.w, m1.w, s), mix(endValues.x, endValues.y, s), valuesOnBars);
}
`;

/** A little thinner than the bars, so that their colours are seen where both are. */
const JOINT = /* glsl */ `
attribute float node;
void bent(out vec3 place, out vec3 facing) {
  vec4 m = nodeTexel(moves, node);
  vec3 r = factor * nodeTexel(turns, node).xyz;
  vec3 up = turned(r, axis3);
  vec3 across = turned(r, normalize(cross(axis3, abs(axis3.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0))));
  vec3 third = cross(up, across);
  place = nodeTexel(places, node).xyz + factor * m.xyz + 0.5 * section.x * (position.x * across + position.y * third) + 0.98 * position.z * section.y * up;
  facing = normal.x * across + normal.y * third + normal.z * up;
  shownValue = mix(m.w, endValues.x, valuesOnBars);
}
`;

type Pass = 'picture' | 'shadow';
export type Part = 'bar' | 'joint';
const SHAPES: Record<Part, string> = { bar: BAR, joint: JOINT };

export interface BentThing {
  part: Part;
  uniforms: BarUniforms;
}

function bend(shader: WebGLProgramParametersWithUniforms, { part, uniforms }: BentThing, pass: Pass): void {
  Object.assign(shader.uniforms, uniforms);
  shader.vertexShader = shader.vertexShader.replace('#include <common>', `#include <common>\n${DECLARATIONS}${SHAPES[part]}`);
  if (pass === 'shadow') {
    shader.vertexShader = shader.vertexShader.replace('#include <begin_vertex>', 'vec3 transformed, unusedFacing;\nbent(transformed, unusedFacing);');
    return;
  }
  shader.vertexShader = shader.vertexShader
    .replace('#include <beginnormal_vertex>', 'vec3 barPlace, barFacing;\nbent(barPlace, barFacing);\nvec3 objectNormal = barFacing;')
    .replace('#include <begin_vertex>', 'vec3 transformed = barPlace;');
}

const COLOUR = /* glsl */ `
#include <color_fragment>
if (colourOn > 0.5) {
  float share = clamp((shownValue - valueRange.x) / max(valueRange.y - valueRange.x, 1e-30), 0.0, 1.0);
  vec3 shown = texture2D(colours, vec2(share * 0.996 + 0.002, 0.5)).rgb;
  diffuseColor.rgb = pow(shown, vec3(2.2));
}
`;

/** Colours that mean something glow a little, so that shade does not change what they say. */
const GLOW = /* glsl */ `
#include <emissivemap_fragment>
if (colourOn > 0.5) {
  totalEmissiveRadiance += 0.38 * diffuseColor.rgb;
  diffuseColor.rgb *= 0.62;
}
`;

export function barMaterial(thing: BentThing, see: { opacity: number }): MeshStandardMaterial {
  const material = new MeshStandardMaterial({
    roughness: 0.62,
    metalness: 0.02,
    transparent: see.opacity < 1,
    opacity: see.opacity,
    depthWrite: see.opacity === 1,
  });
  material.customProgramCacheKey = () => thing.part;
  material.onBeforeCompile = (shader) => {
    bend(shader, thing, 'picture');
    shader.fragmentShader = shader.fragmentShader
      .replace(
        '#include <common>',
        '#include <common>\nuniform sampler2D colours;\nuniform vec2 valueRange;\nuniform float colourOn;\nvarying float shownValue;',
      )
      .replace('#include <color_fragment>', COLOUR)
      .replace('#include <emissivemap_fragment>', GLOW);
  };
  return material;
}

/** The same bars as seen from the light, for their shadow. */
export function barShadow(thing: BentThing): Material {
  const material = new MeshDepthMaterial({ depthPacking: RGBADepthPacking });
  material.customProgramCacheKey = () => thing.part;
  material.onBeforeCompile = (shader) => bend(shader, thing, 'shadow');
  return material;
}
