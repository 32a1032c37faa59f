// SPDX-License-Identifier: GPL-3.0-or-later

import { expect, test } from 'vitest';
import type { Solution } from '../../src/protocol/binary';
import { fieldRow, FieldValues, utilization } from '../../src/views/space/fields';

const solution = (values: number[]): Solution => ({
  kind: 'solution', revision: 1, of: 1, nodes: 0, beams: values.length / 2,
  displacement: new Float32Array(), rotation: new Float32Array(), nodeFields: [], beamFields: [Float32Array.from(values)],
});
const taken = (values: number[]) => new FieldValues().take(fieldRow('stress'), solution(values), ['stress'], { error: null, strength: 1 });

test('utilization is the share of the strength at each end of a bar; without a strength there is none', () => {
  expect([...(utilization(solution([20e6, 10e6]), ['von_mises'], 40e6) ?? [])]).toEqual([0.5, 0.25]);
  expect(utilization(solution([1, 2]), ['von_mises'], null)).toBeNull();
  expect(utilization(solution([1, 2]), ['M2'], 40e6)).toBeNull();
});

test('a few peaks do not take the colours from all others', () => {
  const values = Array.from({ length: 1000 }, (_, i) => i / 1000);
  values[500] = 20;
  const range = taken(values);
  expect(range?.isCut).toBe(true);
  expect(range?.high).toBeGreaterThan(0.95);
  expect(range?.high).toBeLessThan(1.2);
});

test('without peaks the colours reach to the largest value', () => {
  const range = taken(Array.from({ length: 1000 }, (_, i) => i));
  expect(range?.isCut).toBe(false);
  expect(range?.high).toBe(999);
});
