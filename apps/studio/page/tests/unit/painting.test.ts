// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest';
import { alongLine, atShare, byChance, byImage } from '../../src/painting/assign';
import { allWith, inBox, ringsAround, sameRegion, within } from '../../src/painting/regions';

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
  it('a box takes what lies in it, whichever corner is first; a lasso what it encloses', () => {
    const places: [number, number][] = [[0, 0], [1, 1], [3, 3]];
    expect(inBox(places, [2, 2], [-1, -1])).toEqual([0, 1]);
    expect(within(places, [[0.5, 0.5], [2, 0.5], [2, 2], [0.5, 2]])).toEqual([1]);
  });
});

describe('assignment', () => {
  it('the same seed gives the same painting', () => {
    const tiles = [...Array(50).keys()];
    expect(byChance(tiles, ['a', 'b', 'c'], 7)).toEqual(byChance(tiles, ['a', 'b', 'c'], 7));
    expect(new Set(byChance(tiles, ['a', 'b', 'c'], 7)).size).toBe(3);
  });
  it('shares outside of 0 to 1 get the first and the last pattern', () => {
    expect(atShare(['a', 'b'], -1)).toBe('a');
    expect(atShare(['a', 'b'], 1)).toBe('b');
  });
  it('a gradient runs from the first pattern to the last along its line', () => {
    expect(alongLine([[0, 5], [1, 0], [2, -3]], ['soft', 'middle', 'stiff'], [0, 0], [2, 0])).toEqual(['soft', 'middle', 'stiff']);
  });
  it('dark places of an image get the last patterns, and its upper row is the upper part of the surface', () => {
    const image = { width: 1, height: 2, grey: new Float32Array([0, 1]) };
    expect(byImage([[0, 1], [0, 0]], ['soft', 'stiff'], image, { min: [0, 0], max: [1, 1] })).toEqual(['stiff', 'soft']);
  });
});
