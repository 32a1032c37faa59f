// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest';
import { rimStretch, selectedNodes } from '../../src/document/selected_nodes';
import { inside, type Surface } from '../../src/document/surface';
import { snapped } from '../../src/views/space/snap';

const surface: Surface = {
  polygons: [],
  centers: [],
  nodes: [[0, 0], [1, 0], [2, 0], [1, 1]],
  tiles: [],
  rim: [[0, 1, 2]],
  onRim: new Set([0, 1, 2]),
  box: { min: [0, 0], max: [2, 1] },
  side: 0.5,
  layoutNodes: [],
};

describe('which nodes an entry is on', () => {
  it('by number, each once', () => expect(selectedNodes({ nodes: [3, 1, 3] }, surface)).toEqual([1, 3]));
  it('in a box, its rim included', () => expect(selectedNodes({ box: [1, 0, 2, 1] }, surface)).toEqual([1, 2, 3]));
  it('nearest to points', () => expect(selectedNodes({ nearest: [[1.9, 0.1]] }, surface)).toEqual([2]));
  it('at a side: rim nodes in a strip of one tile side', () => expect(selectedNodes({ side: 'right' }, surface)).toEqual([2]));
});

it('a stretch of the rim goes the shorter way', () => {
  expect(rimStretch([[10, 11, 12, 13, 14]], 10, 13)).toEqual([10, 14, 13]);
});
it('a point is in a polygon or not', () => {
  const square: [number, number][] = [[0, 0], [1, 0], [1, 1], [0, 1]];
  expect(inside(square, [0.5, 0.5])).toBe(true);
  expect(inside(square, [1.5, 0.5])).toBe(false);
});
it('a force that nearly runs along an axis runs along it', () => {
  expect(snapped([0.001, 0.002, -0.1234])).toEqual([0, 0, -0.12]);
  expect(snapped([1, 1, 0])).toEqual([1, 1, 0]);
});
