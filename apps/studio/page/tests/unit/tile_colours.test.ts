// SPDX-License-Identifier: GPL-3.0-or-later
// What tiles are coloured by.
import { beforeEach, expect, it, vi } from 'vitest';
import { documentWith } from './document_of_tests';
import type { PatternRow } from '../../src/protocol/messages';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
const { documentNow, patternTable } = await import('../../src/document/store');
const { patternColour, patternLegend, propertyColour, propertyLegend, tileColour, tileFills } = await import('../../src/document/tile_colours');

const row = (id: string, mass: number | null): PatternRow => ({ id, edges: 1, mass, membrane: null, bending: { young: 2 * (mass ?? 0), shear: 1, poisson: 0 }, symmetry: null, error: null });

beforeEach(() => {
  documentNow.value = { ...documentWith(), painting: [0, 1] };
  patternTable.value = { patterns: [row('a', 1), row('b', 3)], nodes: [] };
  tileColour.value = 'none';
});

it('nothing is filled at first', () => expect(tileFills.value).toBeNull());

it('each pattern has its colour, and the legend counts its tiles', () => {
  tileColour.value = 'pattern';
  expect(tileFills.value).toEqual([patternColour(0), patternColour(1)]);
  expect(patternLegend.value.map(({ pattern, tiles }) => [pattern, tiles])).toEqual([['a', 1], ['b', 1]]);
  expect(new Set(Array.from({ length: 30 }, (_, i) => patternColour(i))).size).toBe(30);
});

it('a property is coloured from its least to its largest value', () => {
  tileColour.value = 'mass';
  expect(propertyLegend.value).toMatchObject({ low: 1, high: 3, quantity: 'area_mass' });
  expect(tileFills.value).toEqual([propertyColour(0), propertyColour(1)]);
  tileColour.value = 'bending';
  expect(propertyLegend.value).toMatchObject({ low: 2, high: 6 });
});

it('tiles without a pattern, and patterns without the property, stay plain', () => {
  documentNow.value = { ...documentWith(), painting: [-1, 0] };
  tileColour.value = 'membrane';
  expect(tileFills.value).toEqual([null, null]);
  expect(propertyLegend.value).toBeNull();
  tileColour.value = 'pattern';
  expect(tileFills.value).toEqual([null, patternColour(0)]);
});

it('dark bars are seen on every colour', () => {
  const lightness = (colour: string): number => {
    const [r, g, b] = /^#/.test(colour) ? [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)) : colour.match(/\d+/g)!.map(Number);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  for (let i = 0; i < 9; ++i) expect(lightness(patternColour(i))).toBeGreaterThan(120);
  for (let i = 0; i <= 10; ++i) expect(lightness(propertyColour(i / 10))).toBeGreaterThan(115);
});
