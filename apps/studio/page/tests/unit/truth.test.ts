// SPDX-License-Identifier: GPL-3.0-or-later
// The problems that the status line counts.
import { beforeEach, expect, it, vi } from 'vitest';
import { documentNow, live, beams, making } from '../../src/document/store';
import type { Beams, Solution } from '../../src/protocol/binary';
import type { Point, Solved, StudioDocument } from '../../src/protocol/messages';
import { documentWith } from './document_of_tests';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
const { lookedAt, nextPlace, overstressed, placeLookedAt, problemCount, problems } = await import('../../src/document/truth');
const { beamFields } = await import('../../src/document/look');

/** Two bars in a row, from 0 to 2. */
const BARS: Beams = { kind: 'beams', revision: 1, nodes: 3, beams: 2, place: Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0]), ends: Uint32Array.from([0, 1, 1, 2]), tile: Uint32Array.from([0, 1]), axis3: new Float32Array(6) };
const INFO = { event: 'solved', revision: 1, model: 'corotational', seconds: 0, residual: 0, stable: true, load_factor: 1, converged: true, warnings: [], largest_displacement: 0, doubtful: null, fields: ['von_mises'] } as Solved;
const stressed = (...values: number[]): Solution => ({ kind: 'solution', revision: 1, of: 1, nodes: 3, beams: 2, displacement: new Float32Array(9), rotation: new Float32Array(9), nodeFields: [], beamFields: [Float32Array.from(values)] });

/** Two triangles, of which the left one has its centre at (1, 1). */
function triangles(): StudioDocument {
  const interface_nodes = documentWith().interface_nodes;
  const vertices: Point[] = [[0, 0], [3, 0], [0, 3], [3, 3]];
  const tiles = [{ vertices: [0, 1, 2], interface: [0, 1, 2] }, { vertices: [1, 3, 2], interface: [2, 3, 4] }];
  return { ...documentWith({ name: 'push' }), vertices, tiles, interface_nodes };
}

function withStrength(strength: number | undefined): void {
  const document = triangles();
  document.setting.material.strength = strength;
  documentNow.value = document;
}

beforeEach(() => {
  withStrength(undefined);
  beams.value = BARS;
  live.value = { info: INFO, solution: stressed(1, 5, 6, 2), beams: BARS };
  making.value = null;
  lookedAt.value = null;
});

it('none is counted where nothing is wrong', () => {
  expect([problems.value, problemCount.value]).toEqual([[], 0]);
});

it('bars above the strength are counted at their worst end, the worst bar first; without a strength none is', () => {
  expect(overstressed.value).toEqual([]);
  withStrength(4);
  expect(overstressed.value).toEqual([1, 0]);
  expect(problems.value).toEqual([{ kind: 'stress', count: 2, places: [[1.5, 0], [0.5, 0]] }]);
  withStrength(5);
  expect(overstressed.value).toEqual([1]);
});

it('with a strength the stress of bars is asked for', () => {
  expect(beamFields.value).toEqual([]);
  withStrength(4);
  expect(beamFields.value).toEqual(['von_mises']);
});

it('tiles without a pattern are counted', () => {
  documentNow.value = { ...triangles(), painting: [-1, 0] };
  expect(problems.value).toEqual([{ kind: 'unpainted', count: 1, places: [[1, 1]] }]);
});

it('overlaps are counted beyond those whose places are listed, and a press leads from place to place and around', () => {
  making.value = { words: ['ninety'], counts: { overlap: 90, gap: 1, opening: 0 }, places: [{ kind: 'overlap', place: [1, 1], width: -1 }, { kind: 'overlap', place: [2, 2], width: -0.5 }, { kind: 'gap', place: [3, 3], width: 0 }] };
  expect(problemCount.value).toBe(91);
  expect([nextPlace('overlap'), nextPlace('overlap'), nextPlace('overlap'), nextPlace('gap')]).toEqual([[1, 1], [2, 2], [1, 1], [3, 3]]);
  expect(placeLookedAt.value).toEqual([3, 3]);
  expect(nextPlace('opening')).toBeNull();
});
