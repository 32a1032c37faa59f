// SPDX-License-Identifier: GPL-3.0-or-later
// The base triangle on the page: places, and where nodes go by keys.
import { expect, it } from 'vitest';
import { drawsLayouts, firstLayout, pageAddress } from '../../src/layout/address';
import { CORNERS, HEIGHT, kindAt, placeByKey, SIDE, toPlace, toPlane } from '../../src/layout/triangle';
import type { Vector } from '../../src/protocol/messages';
import type { LayoutNode, NodeKind } from '../../src/protocol/requests';

const node = (kind: NodeKind, place: Vector): LayoutNode => ({ kind, place, exact: ['', '', ''], twins: [] });
const KEYS = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'];

it('the triangle is regular, as in a hexagon', () => {
  const [a, b, c] = CORNERS;
  for (const [p, q] of [[a, b], [b, c], [c, a]]) expect(Math.hypot(p[0] - q[0], p[1] - q[1])).toBeCloseTo(SIDE, 9);
});

it('places go to the drawing and back, also beside the triangle', () => {
  for (const place of [[1, 0, 0], [0, 1, 0], [0.3, 0.45, 0.25], [-0.2, 0.9, 0.3], [1.4, -0.1, -0.3]] as Vector[]) {
    toPlace(toPlane(place)).forEach((share, i) => expect(share).toBeCloseTo(place[i], 12));
  }
  expect(toPlane([1 / 3, 1 / 3, 1 / 3])[1]).toBeCloseTo((2 / 3) * HEIGHT, 9);
});

it('a node that is added belongs to the side that it is beside', () => {
  expect(kindAt([0.99, 0.005, 0.005])).toBe('center');
  expect(kindAt([0.5, 0.48, 0.02])).toBe('radial');
  expect(kindAt([0.5, 0.02, 0.48])).toBe('radial');
  expect(kindAt([0.02, 0.5, 0.48])).toBe('interface');
  expect(kindAt([0.4, 0.3, 0.3])).toBe('face');
});

it('a key moves a node by one step, in its own direction', () => {
  const ways: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const nodes = [node('radial', [0.5, 0.5, 0]), node('radial', [0.5, 0, 0.5]), node('face', [0.4, 0.3, 0.3]), node('interface', [0, 0.75, 0.25])];
  for (const one of nodes) {
    for (const key of KEYS) {
      const to = placeByKey(one, key, 20);
      if (!to) continue;
      expect(to[0] + to[1] + to[2]).toBeCloseTo(1, 12);
      const [before, after] = [toPlane(one.place), toPlane(to)];
      expect((after[0] - before[0]) * ways[key][0] + (after[1] - before[1]) * ways[key][1], `${one.kind} ${key}`).toBeGreaterThan(0);
      for (const share of to) expect(share * 20).toBeCloseTo(Math.round(share * 20), 9);
    }
  }
});

it('a node on a side stays on it, one at the center stays there, and other keys do nothing', () => {
  for (const key of KEYS) {
    expect(placeByKey(node('radial', [0.5, 0.5, 0]), key, 20)?.[2]).toBe(0);
    expect(placeByKey(node('interface', [0, 0.75, 0.25]), key, 20)?.[0] ?? 0).toBe(0);
    expect(placeByKey(node('center', [1, 0, 0]), key, 20)).toBeNull();
  }
  expect(placeByKey(node('interface', [0, 0.75, 0.25]), 'ArrowUp', 20)).toBeNull();
  expect(placeByKey(node('face', [0.4, 0.3, 0.3]), 'a', 20)).toBeNull();
});

it('addresses name the page, and keep the token', () => {
  expect(pageAddress('layout', '?token=7&draw=fine')).toBe('/?token=7&draw=fine&page=layout');
  expect(pageAddress(null, '?token=7&page=layout&layout=%2Fa.json')).toBe('/?token=7');
  expect([drawsLayouts('?token=7'), drawsLayouts('?token=7&page=layout')]).toEqual([false, true]);
  expect([firstLayout('?page=layout'), firstLayout('?page=layout&layout=%2Fa%20b.json')]).toEqual(['paper7', '/a b.json']);
});
