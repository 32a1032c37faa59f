// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest';
import { inside } from '../../src/document/surface';
import { rimStretch } from '../../src/views/plane/rim_stretch';
import { snapped } from '../../src/views/space/snap';

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
