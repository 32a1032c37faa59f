// SPDX-License-Identifier: GPL-3.0-or-later
// Which answers the views and the pictures draw.
import { beforeEach, expect, it, vi } from 'vitest';
import type { Beams, Solution } from '../../src/protocol/binary';
import type { SolvedModel } from '../../src/document/store';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
const store = await import('../../src/document/store');
const { showFull } = await import('../../src/document/look');
const { fullUnderneath, shown, shownOfBars } = await import('../../src/document/shown');

const bars = (nodes: number): Beams => ({ kind: 'beams', revision: 1, nodes, beams: 0, place: new Float32Array(), ends: new Uint32Array(), tile: new Uint32Array(), axis3: new Float32Array() });
const solved = (model: string, nodes: number): SolvedModel => ({
  info: { model, converged: true, fields: [] as string[] } as SolvedModel['info'],
  solution: { kind: 'solution', nodes } as Solution,
  beams: bars(nodes),
});

beforeEach(() => {
  store.beams.value = bars(3);
  store.live.value = solved('corotational', 3);
  store.others.value = new Map([['full', solved('full', 3)]]);
  store.shapes.value = null;
  showFull.value = true;
});

it('the full model lies under the live one', () => {
  expect(fullUnderneath.value).toBe(store.others.value.get('full')?.solution);
  expect(shownOfBars.value).toBe(shown.value);
});

it.each([
  ['that is the full model itself', (): void => void (store.live.value = solved('full', 3))],
  ['where it is not wanted', (): void => void (showFull.value = false)],
  ['beside a load path', (): void => void (store.shapes.value = { kind: 'path', values: [], fields: [], shapes: [], expected: 2 })],
  ['of other bars', (): void => void (store.beams.value = bars(4))],
] as const)('but not under a live one %s', (_, change) => {
  change();
  expect(fullUnderneath.value).toBeNull();
});

it('a solution of other bars is not drawn with these', () => {
  store.beams.value = bars(4);
  expect(shown.value).not.toBeNull();
  expect(shownOfBars.value).toBeNull();
});
