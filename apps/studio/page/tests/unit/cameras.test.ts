// SPDX-License-Identifier: GPL-3.0-or-later
// What both cameras see.
import { Vector3 } from 'three';
import { expect, it } from 'vitest';
import { Cameras, type Projection } from '../../src/views/space/cameras';

const PLACES = [new Vector3(0, 0, 0), new Vector3(0.4, 0, 0), new Vector3(0.4, 0.3, 0.1), new Vector3(0, 0.3, -0.05)];

function looking(projection: Projection): { cameras: Cameras; center: Vector3 } {
  const cameras = new Cameras();
  cameras.aspect = 1.5;
  cameras.switchTo(projection, new Vector3());
  const direction = new Vector3(-0.45, -1, 0.62).normalize();
  cameras.now.position.copy(direction);
  cameras.now.lookAt(0, 0, 0);
  const seen = cameras.seeing(PLACES, 0.9);
  cameras.place({ ...seen, direction });
  cameras.now.updateMatrixWorld();
  return { cameras, center: seen.center };
}

it.each(['perspective', 'parallel'] as const)('%s: all places are seen, and touch the edge of the picture', (projection) => {
  const { cameras } = looking(projection);
  const seen = PLACES.map((place) => place.clone().project(cameras.now));
  const most = Math.max(...seen.map(({ x, y }) => Math.max(Math.abs(x), Math.abs(y) / 0.9)));
  expect(most).toBeLessThanOrEqual(1 + 1e-9);
  expect(most).toBeGreaterThan(0.8);
  for (const { z } of seen) expect(Math.abs(z)).toBeLessThan(1);
});

it('parallel lines stay parallel, and in perspective they do not', () => {
  const across = (projection: Projection) => {
    const { cameras } = looking(projection);
    const length = (a: Vector3, b: Vector3) => a.clone().project(cameras.now).sub(b.clone().project(cameras.now)).setZ(0).length();
    return length(new Vector3(0, 0, 0), new Vector3(0.4, 0, 0)) / length(new Vector3(0, 0.3, 0), new Vector3(0.4, 0.3, 0));
  };
  expect(across('parallel')).toBeCloseTo(1, 9);
  expect(Math.abs(across('perspective') - 1)).toBeGreaterThan(0.02);
});

it('switching there and back keeps the size of what is looked at', () => {
  const { cameras, center } = looking('perspective');
  const before = cameras.now.position.clone();
  const half = cameras.halfHeightAt(center);
  cameras.switchTo('parallel', center);
  expect(cameras.halfHeightAt(center)).toBeCloseTo(half, 12);
  cameras.switchTo('perspective', center);
  expect(cameras.now.position.distanceTo(before)).toBeLessThan(1e-12);
});
