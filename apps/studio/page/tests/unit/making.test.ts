// SPDX-License-Identifier: GPL-3.0-or-later

import { expect, test } from 'vitest';
import { makingQuery } from '../../src/document/making';

test('numbers are millimetres, and each file is asked for with what it looks at', () => {
  const written = { fillet: ' 0,5', kerf: '0.2', bed: '600 × 400', frame: '', bolts: '3mm' };
  expect(makingQuery('cut', written)).toEqual({ fillet: '0.5mm', kerf: '0.2mm', bed: '600x400', bolts: '3mm' });
  expect(makingQuery('solid', written)).toEqual({ fillet: '0.5mm', bolts: '3mm' });
  expect(makingQuery('cut', {})).toEqual({});
});

test('what is no number is left to the server to refuse', () => {
  expect(makingQuery('solid', { fillet: 'wide' })).toEqual({ fillet: 'wide' });
});
