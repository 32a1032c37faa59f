// SPDX-License-Identifier: GPL-3.0-or-later
// One finger works, two move and zoom the view.
import { beforeEach, expect, it, vi } from 'vitest';
import { documentWith } from './document_of_tests';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
const { documentNow } = await import('../../src/document/store');
const { Fingers } = await import('../../src/views/plane/fingers');
const { toPlane, viewport } = await import('../../src/views/plane/viewport');

const touch = (id: number, x: number, y: number, type = 'pointermove'): PointerEvent => ({ pointerId: id, offsetX: x, offsetY: y, type }) as PointerEvent;

beforeEach(() => {
  const hexagon: [number, number][] = [[0, 0], [1, 0], [1, 1], [0, 1]];
  documentNow.value = { ...documentWith(), vertices: hexagon, tiles: [{ vertices: [0, 1, 2, 3], interface: [0, 1, 2, 3] }] };
  viewport.value = { zoom: 300, center: [0.5, 0.5], width: 400, height: 400 };
});

it('a tap is one press where it began', () => {
  const fingers = new Fingers();
  const first = touch(1, 100, 100, 'pointerdown');
  expect(fingers.press(first)).toBe(true);
  expect(fingers.move(touch(1, 103, 100))).toBe('view');
  expect(fingers.release(touch(1, 103, 100, 'pointerup'))).toBe(first);
});

it('a finger that moves begins where it was put, and goes on', () => {
  const fingers = new Fingers();
  const first = touch(1, 100, 100, 'pointerdown');
  fingers.press(first);
  expect(fingers.move(touch(1, 120, 100))).toBe(first);
  expect(fingers.move(touch(1, 140, 100))).toBeNull();
  expect(fingers.release(touch(1, 140, 100, 'pointerup'))).toBeNull();
});

it('two fingers that part zoom, and what lies between them stays', () => {
  const fingers = new Fingers();
  fingers.press(touch(1, 150, 200, 'pointerdown'));
  fingers.press(touch(2, 250, 200, 'pointerdown'));
  const before = toPlane(viewport.value, [200, 200]);
  expect(fingers.move(touch(1, 100, 200))).toBe('view');
  expect(fingers.move(touch(2, 300, 200))).toBe('view');
  expect(viewport.value.zoom).toBeCloseTo(600, 9);
  const after = toPlane(viewport.value, [200, 200]);
  expect(after[0]).toBeCloseTo(before[0], 9);
  expect(after[1]).toBeCloseTo(before[1], 9);
  expect(fingers.release(touch(2, 300, 200, 'pointerup'))).toBeNull();
  expect(fingers.move(touch(1, 50, 50)), 'the one that is left does not paint').toBe('view');
});

it('two fingers that move together move the view', () => {
  const fingers = new Fingers();
  fingers.press(touch(1, 150, 200, 'pointerdown'));
  fingers.press(touch(2, 250, 200, 'pointerdown'));
  const below = toPlane(viewport.value, [150, 200]);
  fingers.move(touch(1, 170, 230));
  fingers.move(touch(2, 270, 230));
  const now = toPlane(viewport.value, [170, 230]);
  expect(now[0]).toBeCloseTo(below[0], 1);
  expect(now[1]).toBeCloseTo(below[1], 1);
});

it('a second finger takes no stroke over, and does not end it', () => {
  const fingers = new Fingers();
  const first = touch(1, 100, 100, 'pointerdown');
  fingers.press(first);
  expect(fingers.move(touch(1, 120, 100))).toBe(first);
  fingers.press(touch(2, 300, 300, 'pointerdown'));
  const zoom = viewport.value.zoom;
  expect(fingers.move(touch(2, 340, 300))).toBe('view');
  expect(viewport.value.zoom, 'nor does it zoom').toBe(zoom);
  expect(fingers.move(touch(1, 140, 100)), 'the stroke goes on').toBeNull();
  expect(fingers.release(touch(2, 340, 300, 'pointerup'))).toBe('view');
  expect(fingers.move(touch(1, 150, 100))).toBeNull();
  expect(fingers.release(touch(1, 150, 100, 'pointerup')), 'its own finger ends it').toBeNull();
});

it('after a stroke, a finger that still rests does not begin another', () => {
  const fingers = new Fingers();
  fingers.press(touch(1, 100, 100, 'pointerdown'));
  fingers.move(touch(1, 120, 100));
  fingers.press(touch(2, 300, 300, 'pointerdown'));
  expect(fingers.release(touch(1, 120, 100, 'pointerup'))).toBeNull();
  expect(fingers.move(touch(2, 340, 300))).toBe('view');
  expect(fingers.release(touch(2, 340, 300, 'pointerup'))).toBe('view');
  const next = touch(3, 50, 50, 'pointerdown');
  fingers.press(next);
  expect(fingers.release(touch(3, 50, 50, 'pointerup'))).toBe(next);
});
