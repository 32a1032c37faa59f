// SPDX-License-Identifier: GPL-3.0-or-later
// The tour waits, goes on when something was done, and ends at any time.
import { beforeEach, expect, it, vi } from 'vitest';
import { documentWith } from './document_of_tests';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
vi.stubGlobal('matchMedia', () => ({ matches: false, addEventListener: () => undefined }));
vi.stubGlobal('document', { documentElement: { dataset: {} } });
vi.stubGlobal('location', { protocol: 'http:', host: '', search: '' });
vi.mock('../../src/document/studio', () => ({ ask: () => Promise.resolve({}), tryAsk: () => Promise.resolve(null) }));
const store = await import('../../src/document/store');
const { mode } = await import('../../src/document/ui');
const { exportOpen } = await import('../../src/panels/export_menu');
const { leaveTour, nextStep, pointers, startTour, startTourAfter, step, stepDone, STEPS, tourStep } = await import('../../src/tour/tour');

const CASE = { name: 'a', supports: [], loads: [] };
const change = (more: object): void => {
  store.documentNow.value = { ...(store.documentNow.value as ReturnType<typeof documentWith>), ...more };
};

beforeEach(() => {
  store.others.value = new Map();
  exportOpen.value = false;
  leaveTour();
  mode.value = 'paint';
  store.documentNow.value = documentWith(CASE);
});

it('has six steps, each with words', () => {
  expect(STEPS.length).toBe(6);
  for (const { title, words, at } of STEPS) expect([title.length > 3, words.length > 20, at.length > 0]).toEqual([true, true, true]);
});
it('waits for what the step is about, and for nothing else', () => {
  startTour();
  nextStep();
  expect([tourStep.value, stepDone.value]).toEqual([0, false]);
  change({ saved: false });
  expect(stepDone.value).toBe(false);
  change({ painting: [1, 0] });
  expect(stepDone.value).toBe(true);
  nextStep();
  expect([tourStep.value, stepDone.value]).toEqual([1, false]);
});
it('goes to the end by doing', () => {
  startTour();
  const does = [
    () => change({ painting: [1, 1] }),
    () => change(documentWith({ ...CASE, supports: [{ side: 'right', fixed: ['uz'] }] })),
    () => change(documentWith({ ...CASE, loads: [{ side: 'right', force: [0, 0, 1] }] })),
    () => change({ interface_nodes: [[0, 0]] }),
    () => (store.others.value = new Map([['full', {} as never]])),
    () => (exportOpen.value = true),
  ];
  for (const [i, act] of does.entries()) {
    expect([tourStep.value, stepDone.value], `${i}`).toEqual([i, false]);
    act();
    expect(stepDone.value, `${i}`).toBe(true);
    nextStep();
  }
  expect(step.value).toBeNull();
});
it('does not wait for what is done already', () => {
  startTour();
  store.others.value = new Map([['full', {} as never]]);
  for (let i = 0; i < 4; ++i) {
    stepDone.value = true;
    nextStep();
  }
  expect([tourStep.value, step.value?.title, stepDone.value]).toEqual([4, STEPS[4].title, true]);
});
it('points at the way to a step first, and at nothing once it is done', () => {
  startTour();
  expect(pointers.value).toContain('#plane');
  mode.value = 'look';
  expect(pointers.value).toEqual(['[data-value=paint]']);
  change({ painting: [1, 0] });
  expect(pointers.value).toEqual([]);
});
it('begins when another surface is shown, and once', () => {
  const before = store.documentNow.value;
  startTourAfter(before);
  change({ saved: false });
  expect(tourStep.value).toBeNull();
  store.documentNow.value = documentWith(CASE);
  expect([tourStep.value, stepDone.value]).toEqual([0, false]);
});
it('is left at any time', () => {
  startTour();
  leaveTour();
  expect([tourStep.value, step.value, stepDone.value]).toEqual([null, null, false]);
});
