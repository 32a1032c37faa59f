// SPDX-License-Identifier: GPL-3.0-or-later
// A layout whose changes were not saved, when the page is loaded again.
import { beforeEach, expect, it, vi } from 'vitest';
import type { LayoutFile, LayoutLook } from '../../src/protocol/requests';

const tab = new Map<string, string>();
vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
vi.stubGlobal('sessionStorage', {
  getItem: (key: string) => tab.get(key) ?? null,
  setItem: (key: string, text: string) => tab.set(key, text),
  removeItem: (key: string) => tab.delete(key),
});
vi.stubGlobal('window', { addEventListener: () => undefined });
vi.stubGlobal('location', { search: '?token=1&page=layout' });

const file = (name: string): LayoutFile => ({ format: 'fretwork/layout/1', name, center: true, corners: false, radial: ['1/2'], face: [], interface: ['1/2'] });
const look = (layout: LayoutFile): LayoutLook => ({ layout, nodes: [], edges: [] });
const program = { refuses: false };
vi.mock('../../src/document/studio', () => ({
  ask: (what: string, says: { from: string; layout: LayoutFile; path: string }): Promise<unknown> => {
    if (what === 'open_layout') return Promise.resolve({ ...look(file(says.from)), path: `/a/${says.from}.json`, hash: 'h1' });
    if (what === 'save_layout') return Promise.resolve({ path: says.path, hash: 'h2' });
    return program.refuses ? Promise.reject(new Error('no such format')) : Promise.resolve({ ...look(says.layout), node: null });
  },
  tryAsk: () => Promise.resolve(null),
}));

/** The page as it is when it has been loaded. */
async function load() {
  vi.resetModules();
  const page = { ...(await import('../../src/layout/draft')), ...(await import('../../src/layout/kept')), ...(await import('../../src/layout/save')), ...(await import('../../src/document/tell')) };
  page.keepUnsaved();
  await page.openFirst();
  return page;
}

beforeEach(() => {
  tab.clear();
  program.refuses = false;
  vi.stubGlobal('location', { search: '?token=1&page=layout' });
});

it('has its changes again, and undo gives back what was saved', async () => {
  const before = await load();
  await before.rename('drawn');
  const after = await load();
  expect([after.draft.value?.layout.name, after.draft.value?.path, after.isUnsaved.value]).toEqual(['drawn', '/a/paper7.json', true]);
  expect(after.notes.value.at(-1)?.text).toMatch(/restored/);
  await after.undo();
  expect([after.draft.value?.layout.name, after.isUnsaved.value]).toEqual(['paper7', false]);
});

it('is not kept once it is saved', async () => {
  const before = await load();
  await before.rename('drawn');
  await before.saveLayout();
  const after = await load();
  expect([after.draft.value?.layout.name, after.notes.value]).toEqual(['paper7', []]);
});

it('waits for its own address while the page has another', async () => {
  await (await load()).rename('drawn');
  vi.stubGlobal('location', { search: '?token=2&page=layout&layout=doors6' });
  expect((await load()).draft.value?.layout.name).toBe('doors6');
  vi.stubGlobal('location', { search: '?token=3&page=layout' });
  expect((await load()).draft.value?.layout.name).toBe('drawn');
});

it('gives way to the layout of the address if the program refuses it, or nobody can read it', async () => {
  await (await load()).rename('drawn');
  program.refuses = true;
  expect((await load()).draft.value?.layout.name).toBe('paper7');
  tab.set('fretwork.layout paper7', '{"lay');
  expect((await load()).draft.value?.layout.name).toBe('paper7');
});
