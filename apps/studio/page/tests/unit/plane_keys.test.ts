// SPDX-License-Identifier: GPL-3.0-or-later
// Arrow keys go from place to place.
import { expect, it, vi } from 'vitest';
import type { Point } from '../../src/protocol/messages';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
const { nextPlace } = await import('../../src/views/plane/plane_keys');

/** Columns of hexagons, every second half a step higher. */
const PLACES: Point[] = Array.from({ length: 30 }, (_, i) => [1.5 * (i % 6), 1.732 * (Math.floor(i / 6) + ((i % 6) % 2) / 2)]);
const DIRECTIONS: Point[] = [[1, 0], [-1, 0], [0, 1], [0, -1]];

it('every place is reached from every other', () => {
  const seen = new Set<Point>([PLACES[0]]);
  for (const place of seen) {
    for (const direction of DIRECTIONS) {
      const next = nextPlace(PLACES, place, direction);
      if (next) seen.add(next);
    }
  }
  expect(seen.size).toBe(PLACES.length);
});

it('a step goes the way of its key, and ends at the edge', () => {
  for (const direction of DIRECTIONS) {
    let place: Point | null = PLACES[14];
    for (let steps = 0; place && steps < 20; ++steps) {
      const next: Point | null = nextPlace(PLACES, place, direction);
      if (next) expect((next[0] - place[0]) * direction[0] + (next[1] - place[1]) * direction[1]).toBeGreaterThan(0);
      place = next;
    }
    expect(place).toBeNull();
  }
});
