// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest';
import { startingPalette } from '../../src/gallery/starting_palette';
import { related } from '../../src/gallery/similar';
import { centroid, fanSegments } from '../../src/pattern/fan';
import { drawingDistance, patternEdges } from '../../src/pattern/pattern_id';
import type { PatternRow, Point, Vector } from '../../src/protocol/messages';

const SQUARE: Point[] = [[0, 0], [2, 0], [2, 2], [0, 2]];
// v0, and the middle of the side.
const NODES: Vector[] = [[1, 0, 0], [0, 0.5, 0.5]];

const row = (id: string, young: number, poisson = 0): PatternRow => ({
  id,
  edges: patternEdges(id).length,
  mass: 1,
  membrane: { young: 1000, shear: 1, poisson },
  bending: { young, shear: 0.01, poisson: 0 },
  symmetry: 'none',
  error: null,
});

describe('patterns', () => {
  it('an id lists edges, with or without its layout', () => {
    expect(patternEdges('0-1+1-6')).toEqual([[0, 1], [1, 6]]);
    expect(patternEdges('paper7:0-1')).toEqual([[0, 1]]);
  });
  it('a drawing is at no distance from itself, and at distance one from one that shares no edge', () => {
    expect(drawingDistance('0-1+1-6', '0-1+1-6')).toBe(0);
    expect(drawingDistance('0-1', '1-6')).toBe(1);
  });
  it('the centroid is that of the area, not of the vertices', () => {
    const [x, y] = centroid([[0, 0], [1, 0], [2, 0], [2, 2], [0, 2]]);
    expect([x, y]).toEqual([1, 1]);
  });
  it('a fan has a copy of the pattern for each side, from the centroid to the middle of that side', () => {
    const segments = fanSegments('0-1', SQUARE, NODES);
    expect([...segments.slice(0, 4)]).toEqual([1, 1, 1, 0]);
    expect(segments.length).toBe(16);
  });
});

describe('relations', () => {
  const rows = [row('0-1', 0.02), row('0-2', 0.021), row('0-3', 0.1), row('0-4', 0.004)];
  it('a stiffer one is stiffer, a softer one softer, and none is itself', () => {
    expect(related(rows[0], rows, 'stiffer').map(({ id }) => id)).toEqual(['0-3']);
    expect(related(rows[0], rows, 'softer').map(({ id }) => id)).toEqual(['0-4']);
    expect(related(rows[0], rows, 'like')[0].id).toBe('0-2');
  });
  it('of the same behaviour, the one that looks different', () => {
    const twins = [row('0-1+1-2', 0.02), row('0-1+1-3', 0.0201), row('3-4+4-5', 0.0201)];
    expect(related(twins[0], twins, 'other_look')[0].id).toBe('3-4+4-5');
  });
  it('a palette to begin with is spread over all', () => {
    expect(startingPalette(rows, 2)).toEqual(['0-2', '0-4']);
    expect(startingPalette(rows, 9).length).toBe(4);
  });
});
