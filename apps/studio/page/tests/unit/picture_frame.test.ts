// SPDX-License-Identifier: GPL-3.0-or-later
// What stands around a saved picture, and bars as lines.
import { PerspectiveCamera, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { framed, roundLength, type Frame } from '../../src/views/pictures/picture_frame';
import { bentLine, Projector, vectorBars } from '../../src/views/pictures/vector_bars';
import type { Beams, Solution } from '../../src/protocol/binary';

const FRAME: Frame = {
  title: 'chair <1> & "2"',
  caption: 'bridge',
  legend: { title: 'Displacement', colours: ['#000000', '#ffffff'], values: ['0', '5 mm', '10 mm'] },
  scaleBar: { length: 100, words: '50 mm' },
  ink: '#111',
  halo: '#fff',
};

it('a scale bar has a round length', () => {
  expect([0.13, 0.09, 0.5, 0.021, 1].map(roundLength)).toEqual([0.1, 0.05, 0.5, 0.02, 1]);
  for (let i = 1; i < 50; ++i) {
    const length = roundLength(i / 7);
    expect(length).toBeLessThanOrEqual(i / 7);
    expect(length).toBeGreaterThan(i / 7 / 2.6);
  }
});

it('a frame says what it is given, and names cannot break it', () => {
  const { text, width, height } = framed('<g id="drawing"/>', { width: 800, height: 400 }, FRAME);
  for (const words of ['Displacement', '10 mm', '50 mm', 'bridge', 'chair &#60;1&#62; &#38; &#34;2&#34;']) expect(text).toContain(words);
  expect(width).toBeGreaterThan(800);
  expect(height).toBeGreaterThan(400);
  expect(framed('', { width: 10, height: 10 }, { ...FRAME, scaleBar: null, legend: null }).text).not.toContain('linearGradient');
});

const BEAMS: Beams = {
  kind: 'beams', revision: 1, nodes: 3, beams: 2,
  place: new Float32Array([0, 0, 0, 1, 0, 0, 2, 0, 0.5]),
  ends: new Uint32Array([0, 1, 1, 2]), tile: new Uint32Array([0, 0]), axis3: new Float32Array([0, 0, 1, 0, 0, 1]),
};
const solution = (displacement: number[], rotation: number[]): Solution => ({
  kind: 'solution', revision: 1, of: 1, nodes: 3, beams: 2, displacement: new Float32Array(displacement), rotation: new Float32Array(rotation), nodeFields: [], beamFields: [],
});

it('a bar that moves as a whole stays straight', () => {
  const angle = 0.7;
  const end = [Math.cos(angle) - 1, Math.sin(angle), 0];
  const line = bentLine({ beams: BEAMS, solution: solution([0, 0, 0, ...end, 0, 0, 0], [0, 0, angle, 0, 0, angle, 0, 0, 0]), factor: 1 }, 0);
  expect(line[0].toArray()).toEqual([0, 0, 0]);
  for (const place of line) expect(Math.abs(place.x * Math.sin(angle) - place.y * Math.cos(angle))).toBeLessThan(1e-6);
  expect(line.at(-1)!.distanceTo(new Vector3(Math.cos(angle), Math.sin(angle), 0))).toBeLessThan(1e-6);
});

it('a bar whose ends turn is bent, and begins as its end does', () => {
  const line = bentLine({ beams: BEAMS, solution: solution(Array(9).fill(0), [0, -0.4, 0, 0, 0.4, 0, 0, 0, 0]), factor: 1 }, 0);
  const middle = line[Math.floor(line.length / 2)];
  expect(middle.z).toBeCloseTo(2 * 0.125 * Math.sin(0.4), 6);
  expect(bentLine({ beams: BEAMS, solution: null, factor: 1 }, 0)).toHaveLength(2);
});

it('nearer bars are drawn after those behind them', () => {
  const camera = new PerspectiveCamera(30, 1, 0.1, 100);
  camera.position.set(1, 0, 5);
  camera.updateProjectionMatrix();
  const layer = { beams: BEAMS, solution: null, factor: 0, section: { width: 0.02, height: 0.02 }, colour: (bar: number) => ['#far', '#near'][bar], opacity: 1 };
  const text = vectorBars([layer], { camera, width: 100, height: 100 });
  expect(text.indexOf('#far')).toBeGreaterThan(0);
  expect(text.indexOf('#near')).toBeGreaterThan(text.indexOf('#far'));
});

it('bars behind the camera are not drawn, and those that pass it are cut there', () => {
  const camera = new PerspectiveCamera(30, 1, 0.1, 100);
  camera.up.set(0, 0, 1);
  camera.position.set(1.5, 0, 0);
  camera.lookAt(9, 0, 0);
  camera.updateMatrixWorld();
  const view = { camera, width: 100, height: 100 };
  const project = new Projector(view);
  expect(project.ahead(new Vector3(0, 0, 0), new Vector3(1, 0, 0))).toBeNull();
  const [from, to] = project.ahead(new Vector3(1, 0, 0), new Vector3(2, 0, 0.5)) as [Vector3, Vector3];
  expect(from.distanceTo(new Vector3(1.6, 0, 0.3)), 'on the near plane').toBeLessThan(1e-6);
  expect(to.toArray()).toEqual([2, 0, 0.5]);
  const layer = { beams: BEAMS, solution: null, factor: 0, section: { width: 0.02, height: 0.02 }, colour: (bar: number) => ['#behind', '#ahead'][bar], opacity: 1 };
  const text = vectorBars([layer], view);
  expect(text).not.toContain('#behind');
  expect(text).toContain('#ahead');
  expect(text).not.toContain('NaN');
});
