// SPDX-License-Identifier: GPL-3.0-or-later

import { describe, expect, it } from 'vitest';
import type { Point } from '../../src/protocol/messages';
import { areaOf } from '../../src/document/surface';
import { fittingSide } from '../../src/document/fitting_side';

const square = (side: number): Point[] => [[0, 0], [side, 0], [side, side], [0, side]];

describe('areas', () => {
  it('do not depend on which way around a polygon is given', () => {
    expect(areaOf(square(2))).toBe(4);
    expect(areaOf([...square(2)].reverse())).toBe(4);
  });
});

describe('the suggested side of tiles', () => {
  it('is the usual one where that gives neither few nor many tiles', () => {
    expect(fittingSide(0.2)).toBe(0.026);
  });
  it('gives about the wanted number where it does not', () => {
    for (const area of [1e-4, 10]) {
      const tiles = area / (1.5 * Math.sqrt(3) * fittingSide(area) ** 2);
      expect(tiles).toBeGreaterThan(100);
      expect(tiles).toBeLessThan(145);
    }
  });
});
