// SPDX-License-Identifier: GPL-3.0-or-later

import { beforeAll, expect, test, vi } from 'vitest';

const kept = new Map<string, string>();
beforeAll(() => void vi.stubGlobal('localStorage', { getItem: (key: string) => kept.get(key) ?? null, setItem: (key: string, value: string) => void kept.set(key, value) }));
const units = () => import('../../src/document/units');

test('lengths in a text of the program are written in the units of the page', async () => {
  const { inShownUnits, unitSystem } = await units();
  unitSystem.value = 'mm';
  expect(inShownUnits('choose sides of 0.000878 m or more').replace(/\s/g, ' ')).toBe('choose sides of 0.878 mm or more');
  expect(inShownUnits('near (0.133166, 0.125676): no tile').replace(/\s/g, ' ')).toBe('near (133 mm, 126 mm): no tile');
  unitSystem.value = 'SI';
  expect(inShownUnits('0.5 m wide').replace(/\s/g, ' ')).toBe('0.500 m wide');
  expect(inShownUnits('wants uz = -20 mm of node 3').replace(/\s/g, ' ')).toBe('wants uz = -0.0200 m of node 3');
});

test('values of a text are written in the units of the page', async () => {
  const { withShownValues, unitSystem } = await units();
  const values = [{ value: -0.02, quantity: 'length' }, { value: Math.PI / 4, quantity: 'angle' }] as const;
  unitSystem.value = 'mm';
  expect(withShownValues('uz = {0}, ry = {1}; {2}', [...values]).replace(/\s/g, ' ')).toBe('uz = -20.0 mm, ry = 45.0°; {2}');
  unitSystem.value = 'SI';
  expect(withShownValues('uz = {0}, ry = {1}', [...values]).replace(/\s/g, ' ')).toBe('uz = -0.0200 m, ry = 0.785 rad');
});

test('what is no length stays as it is', async () => {
  const { inShownUnits, unitSystem } = await units();
  unitSystem.value = 'mm';
  for (const text of ['5 N m at most', '3 m² of it', '12 mm wide', 'part 1 of 2 taken, the largest', '2 m/s']) expect(inShownUnits(text)).toBe(text);
});

test('numbers are read with a comma, and with a unit', async () => {
  const { typed } = await units();
  expect(typed('12,5', 'length', 'mm')).toBeCloseTo(0.0125, 12);
  expect(typed('0.3 m', 'length', 'mm')).toBeCloseTo(0.3, 12);
  expect(typed('wide', 'length', 'mm')).toBeNull();
});

test('own weight begins with the standard gravity of the program', async () => {
  const { STANDARD_GRAVITY } = await units();
  expect(STANDARD_GRAVITY).toBe(9.80665); // exact by definition; mechanics/standard_gravity.hpp
});
