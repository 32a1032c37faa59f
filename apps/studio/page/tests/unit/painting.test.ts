// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest';
import { alongLine } from '../../src/painting/gradient';
import { allWith, inBox, inCircle, ringsAround, sameRegion, within } from '../../src/painting/regions';

// Five tiles in a row.
const ROW = [[1], [0, 2], [1, 3], [2, 4], [3]];

describe('regions', () => {
  it('a brush of one ring reaches the neighbours and no further', () => {
    expect(ringsAround(2, 1, ROW).sort()).toEqual([1, 2, 3]);
  });
  it('fill stops at other patterns', () => {
    const patterns = ['a', 'a', 'b', 'a', 'a'];
    expect(sameRegion(0, (tile) => patterns[tile], ROW).sort()).toEqual([0, 1]);
    expect(allWith('a', patterns)).toEqual([0, 1, 3, 4]);
  });
  it('a box takes what lies in it, whichever corner is first, and a circle, with its line; a lasso what it encloses', () => {
    const places: [number, number][] = [[0, 0], [1, 1], [3, 3]];
    expect(inBox(places, [2, 2], [-1, -1])).toEqual([0, 1]);
    expect(inCircle(places, { center: [1, 0], radius: 1 })).toEqual([0, 1]);
    expect(inCircle(places, { center: [1, 0], radius: 0.999 })).toEqual([]);
    expect(within(places, [[0.5, 0.5], [2, 0.5], [2, 2], [0.5, 2]])).toEqual([1]);
  });
});

describe('a gradient', () => {
  it('is a field that is 0 where its line begins and 1 where it ends, whatever lies beside the line', () => {
    const text = alongLine([-0.01, 0.02], [0.03, 0.05]);
    expect(text).toMatch(/^field:/);
    const field = new Function('x', 'y', `return ${text.slice('field:'.length)}`) as (x: number, y: number) => number;
    expect(field(-0.01, 0.02)).toBe(0);
    expect(field(0.03, 0.05)).toBeCloseTo(1, 12);
    expect(field(0.01 + 0.03, 0.035 - 0.04)).toBeCloseTo(0.5, 12);
  });
});
