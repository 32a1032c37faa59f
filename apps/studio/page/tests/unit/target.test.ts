// SPDX-License-Identifier: GPL-3.0-or-later
// Targets: which nodes go where, how far they are from there, and curves that are drawn.
import { describe, expect, it } from 'vitest';
import { placeAlong, targetOfCurve, type SideNode } from '../../src/document/curve';
import { commonWish, errorOf, followed, goalsOf, movedBy, targetNodes, withEntry, type TargetEntry } from '../../src/document/target';
import type { Point } from '../../src/protocol/messages';

const LIFTED: TargetEntry = { nodes: [3, 4], wanted: [[null, null, 0.01], [0, null, 0.02]] };

describe('a target', () => {
  it('takes nodes from those before, which go when they have none left', () => {
    const next = withEntry([LIFTED], { nodes: [4], wanted: [[null, null, 0.5]] });
    expect(next).toEqual([{ nodes: [3], wanted: [[null, null, 0.01]] }, { nodes: [4], wanted: [[null, null, 0.5]] }]);
    expect(withEntry([LIFTED], { ...LIFTED, nodes: [4, 3] })).toHaveLength(1);
  });
  it('that is moved keeps its free components free', () => {
    expect(movedBy(LIFTED, [1, 2, 3]).wanted).toEqual([[null, null, 3.01], [1, null, 3.02]]);
  });
  it('has a common displacement only where all nodes have the same', () => {
    expect(commonWish(LIFTED)).toBeNull();
    expect(commonWish({ nodes: [1, 2], wanted: [[null, 0, 1], [null, 0, 1]] })).toEqual([null, 0, 1]);
  });
  it('is sent as goals of nodes with their displacements', () => {
    expect(goalsOf([LIFTED])).toEqual({ goals: [{ nodes: [3, 4], displacements: LIFTED.wanted }] });
  });
  it('where it is free, the wanted place follows the present one', () => {
    expect(followed([null, 0.5, null], [1, 2, 3])).toEqual([1, 0.5, 3]);
  });
});

describe('the distance to a target', () => {
  const displacement = new Float32Array(15).fill(0.03);
  it('is over the components that are wanted', () => {
    const [first, second] = targetNodes([LIFTED], displacement);
    expect(first.distance).toBeCloseTo(0.02, 7);
    expect(second.distance).toBeCloseTo(Math.hypot(0.03, 0.01), 7);
  });
  it('without a solution is that of the surface at rest', () => {
    expect(targetNodes([LIFTED], null).map(({ distance }) => distance)).toEqual([0.01, 0.02]);
  });
  it('has a mean, a largest one, and the largest displacement wanted', () => {
    const error = errorOf(targetNodes([LIFTED], null));
    expect(error).toEqual({ mean: 0.015, largest: 0.02, wanted: 0.02 });
    expect(errorOf([])).toBeNull();
  });
});

/** Nodes 0 to 4, 10 mm apart, flat. */
const FLAT: SideNode[] = [0, 1, 2, 3, 4].map((node) => ({ node, rest: 0.01 * node, now: [0.01 * node, 0] }));

describe('a curve', () => {
  it('is measured along itself', () => {
    const corner: Point[] = [[0, 0], [3, 0], [3, 4]];
    expect(placeAlong(corner, 0)).toEqual([0, 0]);
    expect(placeAlong(corner, 5)).toEqual([3, 2]);
    expect(placeAlong(corner, 7.1)).toBeNull();
  });
  it('wants nodes as far along it as they lie along the surface: a straight slope only turns it', () => {
    const angle = 0.5;
    const entry = targetOfCurve([[0, 0], [0.1 * Math.cos(angle), 0.1 * Math.sin(angle)]], FLAT, 0)!;
    expect(entry.nodes).toEqual([0, 1, 2, 3, 4]);
    entry.wanted.forEach(([x, y, z], i) => {
      expect((x ?? NaN) + 0.01 * i).toBeCloseTo(0.01 * i * Math.cos(angle), 12);
      expect(y).toBeNull();
      expect(z).toBeCloseTo(0.01 * i * Math.sin(angle), 12);
    });
  });
  it('begins at the nearest node, and goes either way', () => {
    const entry = targetOfCurve([[0.031, 0.002], [0.01, 0.01]], FLAT, 0)!;
    expect(entry.nodes).toEqual([1, 2, 3]);
    expect(entry.wanted[2]).toEqual([0, null, 0]);
  });
  it('seen from the side wants y and leaves x free', () => {
    expect(targetOfCurve([[0, 0], [0.02, 0]], FLAT, 1)!.wanted[1]).toEqual([null, 0, 0]);
  });
  it('that is a point, or of no nodes, is no target', () => {
    expect(targetOfCurve([[0, 0]], FLAT, 0)).toBeNull();
    expect(targetOfCurve([[0, 0], [1, 0]], [], 0)).toBeNull();
  });
});
