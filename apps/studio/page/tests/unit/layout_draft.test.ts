// SPDX-License-Identifier: GPL-3.0-or-later
// The layout that is drawn: changes in their order, undo, counts that are overtaken, and what is not lost.
import { beforeEach, expect, it, vi } from 'vitest';
import type { LayoutFile, LayoutLook } from '../../src/protocol/requests';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
vi.stubGlobal('window', { addEventListener: () => undefined });

const file = (radial: string[], name = 'mine'): LayoutFile => ({ format: 'fretwork/layout/1', name, center: true, corners: false, radial, face: [], interface: ['1/2'] });
const look = (layout: LayoutFile): LayoutLook => ({ layout, nodes: [], edges: [] });

/** A server that takes a radial node to wherever it is moved, and counts when the test lets it. */
const asked: string[] = [];
const counts: { key: number; done: (patterns: number) => void; fail: (why: string) => void }[] = [];
const served = {
  refuses: '',
  /** What sends the answers that wait; null: none has to wait. */
  waiting: null as (() => void)[] | null,
  held: <T>(answer: T): Promise<T> => new Promise((done) => (served.waiting ? served.waiting.push(() => done(answer)) : done(answer))),
  ask(what: string, says: Record<string, never>): Promise<unknown> {
    asked.push(what);
    if (what === 'count_layout')
      return new Promise((done, fail) => counts.push({ key: says.key, done: (patterns) => done({ patterns, complete: true, samples: [] }), fail: (why) => fail(new Error(why)) }));
    if (what === 'open_layout') return served.held({ ...look(file(['1/2'], says.from)), path: `/a/${says.from}.json`, hash: 'h1' });
    if (what === 'save_layout') return served.held({ path: says.path, hash: 'h2' });
    if (served.refuses) return Promise.reject(new Error(served.refuses));
    const { layout, change } = says as unknown as { layout: LayoutFile; change?: { to?: number[]; remove?: number } };
    if (!change) return Promise.resolve({ ...look(layout), node: null });
    return Promise.resolve({ ...look(file(change.to ? [`${change.to[1]}`] : [])), node: change.to ? 1 : null });
  },
};
vi.mock('../../src/document/studio', () => ({ ask: (what: string, says: never) => served.ask(what, says), tryAsk: () => Promise.resolve(null) }));
const store = await import('../../src/document/store');
const { canRedo, canUndo, draft, isUnsaved, moveNode, openLayout, redo, removeNode, rename, selectedNode, trouble, undo } = await import('../../src/layout/draft');
const { counted, countTrouble, foundNow, isCounting } = await import('../../src/layout/count');
const { saveLayout } = await import('../../src/layout/save');

const settled = (): Promise<void> => new Promise((done) => setTimeout(done, 0));
const radial = (): string[] => draft.value?.layout.radial ?? [];
const moved = async (share: number, stroke: string): Promise<void> => {
  moveNode(1, [1 - share, share, 0], stroke);
  await settled();
};

store.hello.value = {} as NonNullable<typeof store.hello.value>;

/** Sends the answers that wait, the newest first. */
async function answerAll(): Promise<void> {
  for (await settled(); served.waiting?.length; await settled()) served.waiting.pop()?.();
}

beforeEach(async () => {
  [served.refuses, served.waiting] = ['', null];
  draft.value = null;
  await openLayout('mine');
});

it('a drag is one step of undo, and the next is another', async () => {
  for (const share of [0.6, 0.7, 0.8]) await moved(share, 'first');
  await moved(0.9, 'second');
  await undo();
  expect(radial()).toEqual(['0.8']);
  await undo();
  expect([radial(), canUndo.value, isUnsaved.value]).toEqual([['1/2'], false, false]);
  await redo();
  await redo();
  expect([radial(), canRedo.value]).toEqual([['0.9'], false]);
});

it('undo and redo ask the program nothing', async () => {
  await moved(0.7, 'drag');
  asked.length = 0;
  await undo();
  await redo();
  expect([radial(), asked.filter((what) => what === 'draw_layout')]).toEqual([['0.7'], []]);
});

it('of two layouts that are opened the one asked for last is shown', async () => {
  served.waiting = [];
  const opening = [openLayout('first'), openLayout('second')];
  await answerAll();
  await Promise.all(opening);
  expect(draft.value?.layout.name).toBe('second');
});

it('a change of one layout is not made to the next', async () => {
  served.waiting = [];
  const opening = openLayout('other');
  void removeNode(1);
  await answerAll();
  await opening;
  expect([draft.value?.layout.name, radial()]).toEqual(['other', ['1/2']]);
});

it('a layout that is opened while another is saved keeps its own file', async () => {
  await moved(0.7, 'drag');
  served.waiting = [];
  const saving = saveLayout();
  await settled();
  const both = [saving, openLayout('other')];
  await answerAll();
  await Promise.all(both);
  expect([draft.value?.path, draft.value?.hash, isUnsaved.value]).toEqual(['/a/other.json', 'h1', false]);
});

it('of many moves the newest is asked for', async () => {
  asked.length = 0;
  for (let i = 1; i <= 50; ++i) moveNode(1, [1 - i / 100, i / 100, 0], 'drag');
  await settled();
  expect(radial()).toEqual(['0.5']);
  expect(asked.filter((what) => what === 'draw_layout')).toHaveLength(2);
});

it('a node that is removed while it is dragged stays away', async () => {
  for (let i = 1; i <= 3; ++i) moveNode(1, [1 - i / 100, i / 100, 0], 'drag');
  await removeNode(1);
  await settled();
  expect([radial(), selectedNode.value]).toEqual([[], null]);
});

it('a change that is refused leaves the layout, with the reason', async () => {
  served.refuses = 'node n5 lies where node n6 already is';
  await moved(0.7, 'drag');
  expect([radial(), trouble.value, canUndo.value]).toEqual([['1/2'], 'node n5 lies where node n6 already is', false]);
  served.refuses = '';
  await moved(0.7, 'drag');
  expect([radial(), trouble.value]).toEqual([['0.7'], null]);
});

it('is saved to its file, and is unsaved after the next change', async () => {
  await moved(0.7, 'drag');
  expect(isUnsaved.value).toBe(true);
  expect(await saveLayout()).toBe(true);
  expect([isUnsaved.value, draft.value?.hash]).toEqual([false, 'h2']);
  await rename('other');
  expect([isUnsaved.value, draft.value?.layout.name]).toEqual([true, 'other']);
});

it('the newest count is shown, whatever comes late', async () => {
  counts.length = 0;
  await moved(0.6, 'a');
  await moved(0.7, 'b');
  const [old, newest] = counts.slice(-2);
  expect(newest.key).toBeGreaterThan(old.key);
  store.countSoFar.value = { key: old.key, patterns: 5 };
  expect(foundNow.value, 'of the old count').toBeNull();
  store.countSoFar.value = { key: newest.key, patterns: 6 };
  expect(foundNow.value).toBe(6);
  old.fail('cancelled');
  await settled();
  expect(isCounting.value).toBe(true);
  newest.done(1824);
  await settled();
  expect([isCounting.value, counted.value?.patterns]).toEqual([false, 1824]);
});

it('is counted again after the line was cut', async () => {
  await moved(0.6, 'a');
  counts.at(-1)?.fail('the line was cut');
  await settled();
  expect([isCounting.value, countTrouble.value]).toEqual([false, 'the line was cut']);
  store.hello.value = { ...(store.hello.value as NonNullable<typeof store.hello.value>) };
  expect(isCounting.value).toBe(true);
  counts.at(-1)?.done(7);
  await settled();
  expect([countTrouble.value, counted.value?.patterns]).toEqual([null, 7]);
});

it('another name is counted as little as nothing', async () => {
  const before = counts.length;
  await rename('renamed');
  expect(counts.length).toBe(before);
});
