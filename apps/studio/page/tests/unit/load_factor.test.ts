// SPDX-License-Identifier: GPL-3.0-or-later
// One factor on all loads of a load case.
import { beforeEach, expect, it, vi } from 'vitest';
import type { LoadCase } from '../../src/protocol/messages';
import { documentWith } from './document_of_tests';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
const sent: LoadCase[] = [];
vi.mock('../../src/document/studio', () => ({
  ask: () => Promise.resolve({}),
  tryAsk: (_: string, { load_case }: { load_case: LoadCase }) => {
    sent.push(load_case);
    return Promise.resolve({ unchanged: true });
  },
}));
const store = await import('../../src/document/store');
const { beginFactor, loadFactor, scaledLoads, setFactor, slideFactor } = await import('../../src/document/load_factor');

const CASE: LoadCase = {
  name: 'all kinds',
  supports: [{ side: 'left', fixed: ['uz'] }],
  loads: [{ side: 'right', force: [0, 0, -3], amount: 'total' }, { nodes: [1], moment: [0, 0.3, 0] }, { box: [0, 0, 1, 1], per_area: [0, 0, -2] }, { side: 'top', per_length: [1, 0, 0] }],
  prescribed: [{ nodes: [2], uz: 0.01 }],
  gravity: [0, 0, -9.81],
  combines: [{ load_case: 'other', factor: 0.5 }],
};
const show = (one: LoadCase): void => {
  store.documentNow.value = documentWith(one);
};
/** As the program sends a load case back: with all digits, and without vectors of zeros. */
const sentBack = (one: LoadCase): LoadCase => JSON.parse(JSON.stringify(one)) as LoadCase;

beforeEach(() => {
  sent.length = 0;
  show({ ...CASE, name: `${Math.random()}` });
});

it('is on all kinds of loads, and on no support', () => {
  const doubled = scaledLoads(CASE, 2);
  expect(doubled.loads.map(({ force, moment, per_area, per_length }) => force ?? moment ?? per_area ?? per_length)).toEqual([[0, 0, -6], [0, 0.6, 0], [0, 0, -4], [2, 0, 0]]);
  expect(doubled).toMatchObject({ prescribed: [{ nodes: [2], uz: 0.02 }], gravity: [0, 0, -19.62], combines: [{ load_case: 'other', factor: 1 }] });
  expect(doubled.loads[0]).toEqual({ side: 'right', force: [0, 0, -6], amount: 'total' });
  expect(doubled).not.toHaveProperty('supports');
});
it('goes back from 0 to the loads that were there', () => {
  const first = store.loadCase.value as LoadCase;
  setFactor(0);
  show(sentBack(sent[0]));
  expect(loadFactor.value).toBe(0);
  expect(store.loadCase.value?.loads?.[0].force?.every((part) => part === 0)).toBe(true);
  setFactor(1);
  expect(sent[1]).toMatchObject({ loads: first.loads, gravity: first.gravity, combines: first.combines });
});
it('is of the loads at first, however often it is slid', () => {
  beginFactor();
  slideFactor(1.5, 'a');
  show(sentBack(sent.at(-1) as LoadCase));
  expect(loadFactor.value).toBe(1.5);
  setFactor(0.7);
  expect(sent.at(-1)?.loads?.[0].force?.[2]).toBeCloseTo(-2.1, 12);
});
it('begins at 1 again when the loads are edited otherwise, or another load case is looked at', () => {
  setFactor(1.5);
  show(sentBack(sent[0]));
  expect(loadFactor.value).toBe(1.5);
  show({ ...sentBack(sent[0]), gravity: [0, 0, -1] });
  expect(loadFactor.value).toBe(1);
  show({ ...sentBack(sent[0]), name: 'another' });
  expect(loadFactor.value).toBe(1);
});
