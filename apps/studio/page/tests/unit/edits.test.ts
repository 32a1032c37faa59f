// SPDX-License-Identifier: GPL-3.0-or-later
// The requests that each action of a person sends.
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { documentNow } from '../../src/document/store';
import { pending, selectedTiles } from '../../src/document/ui';
import type { Load, Support } from '../../src/protocol/messages';
import { documentWith } from './document_of_tests';

const asked = vi.hoisted(() => vi.fn());
vi.mock('../../src/document/studio', () => ({ ask: asked, tryAsk: asked }));
const told = vi.hoisted(() => vi.fn());
vi.mock('../../src/document/tell', () => ({ tell: told }));
const edits = await import('../../src/document/edits');

const FIXED: Support = { nodes: [0, 1], fixed: ['ux', 'uy', 'uz'] };
const PUSH: Load = { nodes: [4], force: [0, 0, -1] };

beforeEach(() => {
  asked.mockReset().mockResolvedValue({});
  pending.value = new Map();
  selectedTiles.value = new Set();
  documentNow.value = documentWith({ name: 'push', supports: [FIXED], loads: [PUSH] });
});

const lastLoadCase = () => asked.mock.calls.at(-1)![1].load_case;

describe('load cases', () => {
  it('are sent without what the program has worked out of them, and without what does not change', () => {
    edits.addLoad({ side: 'top', per_length: [0, 0, 2] });
    expect(asked).toHaveBeenCalledWith('set_load_case', {
      index: 0,
      load_case: { name: 'push', supports: [FIXED], loads: [PUSH, { side: 'top', per_length: [0, 0, 2] }] },
      merge: undefined,
    });
  });
  it('a first edit makes the first one', () => {
    documentNow.value = documentWith();
    edits.addLoad(PUSH);
    expect(asked.mock.calls[0]![1]).toMatchObject({ index: 0, load_case: { name: 'load case 1', loads: [PUSH], supports: [] } });
  });
  it('new ones have names that are free, and come last', () => {
    documentNow.value = documentWith({ name: 'push' }, { name: 'load case 3' });
    edits.addLoadCase();
    expect(asked.mock.calls[0]![1]).toMatchObject({ index: 2, load_case: { name: 'load case 4' } });
  });
  it('entries are replaced and removed in their place', () => {
    const pull: Load = { nodes: [3], force: [0, 0, 1] };
    documentNow.value = documentWith({ name: 'both', loads: [PUSH, pull] });
    edits.replaceLoad(1, { ...pull, nodes: [2] });
    expect(lastLoadCase().loads).toEqual([PUSH, { ...pull, nodes: [2] }]);
    edits.removeLoad(0);
    expect(lastLoadCase().loads).toEqual([pull]);
    edits.addPrescribed({ nodes: [1], uz: 0.1 });
    expect(lastLoadCase().prescribed).toEqual([{ nodes: [1], uz: 0.1 }]);
  });
  it('a combination names each other load case once, and none with the factor 0', () => {
    documentNow.value = documentWith({ name: 'sum', combines: [{ load_case: 'snow', factor: 1 }] });
    edits.combine('snow', 1.5);
    expect(lastLoadCase().combines).toEqual([{ load_case: 'snow', factor: 1.5 }]);
    edits.combine('snow', 0);
    expect(lastLoadCase().combines).toEqual([]);
  });
});

it('remarks on a painting are told', async () => {
  asked.mockResolvedValue({ remarks: ['the project does not keep large.png'] });
  edits.paintBy({ patterns: 'image:', palette: [] });
  await vi.waitFor(() => expect(told).toHaveBeenCalledWith('the project does not keep large.png', 'warning'));
});

it('a slide of the section sends the newest value, as one step of undo', async () => {
  const { setting } = documentNow.value!;
  asked.mockResolvedValue({ unchanged: true });
  for (const tile_side of [0.02, 0.03, 0.04]) edits.dragSetting({ ...setting, tile_side }, 'bar-1');
  await vi.waitFor(() => expect(asked).toHaveBeenCalledTimes(2));
  expect(asked.mock.calls.map((call) => [call[0], call[1].setting.tile_side, call[1].merge])).toEqual([['set_setting', 0.02, 'bar-1'], ['set_setting', 0.04, 'bar-1']]);
});

describe('supports', () => {
  it('take nodes from what held them before', () => {
    edits.hold({ where: { nodes: [1, 2] }, nodes: [1, 2] }, ['uz'], [[0, 1]]);
    expect(lastLoadCase().supports).toEqual([{ nodes: [0], fixed: FIXED.fixed }, { nodes: [1, 2], fixed: ['uz'] }]);
  });
  it('that lose no node stay as they were written', () => {
    const side: Support = { side: 'left', fixed: ['uz'] };
    documentNow.value = documentWith({ name: 'side', supports: [side] });
    edits.hold({ where: { nodes: [4] }, nodes: [4] }, ['ux'], [[0]]);
    expect(lastLoadCase().supports).toEqual([side, { nodes: [4], fixed: ['ux'] }]);
  });
  it('on a side go into the load case as the side', () => {
    edits.hold({ where: { side: 'bottom' }, nodes: [3, 4] }, ['uz'], [[0, 1]]);
    expect(lastLoadCase().supports).toEqual([FIXED, { side: 'bottom', fixed: ['uz'] }]);
  });
  it('on a side stay on the side where they share nodes with a support that fixes as much, and only there', () => {
    const left: Support = { side: 'left', fixed: ['ux', 'uz'] };
    documentNow.value = documentWith({ name: 'corner', supports: [left] });
    edits.hold({ where: { side: 'bottom' }, nodes: [1, 2] }, ['ux', 'uy', 'uz'], [[0, 1]]);
    expect(lastLoadCase().supports).toEqual([left, { side: 'bottom', fixed: ['ux', 'uy', 'uz'] }]);
    edits.hold({ where: { side: 'bottom' }, nodes: [1, 2] }, ['uz'], [[0, 1]]);
    expect(lastLoadCase().supports).toEqual([{ nodes: [0], fixed: ['ux', 'uz'] }, { side: 'bottom', fixed: ['uz'] }]);
    edits.hold({ where: { side: 'bottom' }, nodes: [1, 2] }, [], [[0, 1]]);
    expect(lastLoadCase().supports).toEqual([{ nodes: [0], fixed: ['ux', 'uz'] }]);
  });
  it('that lose all nodes go; nothing fixed lets the nodes go', () => {
    edits.hold({ where: { nodes: [0, 1] }, nodes: [0, 1] }, [], [[0, 1]]);
    expect(lastLoadCase().supports).toEqual([]);
  });
});

describe('painting', () => {
  it('by a choice is of the selected tiles, or of all', () => {
    edits.paintBy({ patterns: 'random:1', palette: ['a', 'b'] });
    expect(asked).toHaveBeenLastCalledWith('paint', { tiles: undefined, patterns: 'random:1', palette: 'a,b', file: undefined });
    selectedTiles.value = new Set([1]);
    edits.paintBy({ patterns: 'random:1', palette: [] });
    expect(asked.mock.calls.at(-1)![1]).toMatchObject({ tiles: [1] });
  });
  it('that is refused or changes nothing takes back what the page has shown ahead', async () => {
    pending.value = new Map([[0, 'b']]);
    asked.mockResolvedValue(null);
    edits.paint([0], 'b');
    await vi.waitFor(() => expect(pending.value.size).toBe(0));
  });
  it('a stroke sends what waits, a request for each pattern', async () => {
    const gesture = edits.newGesture('stroke');
    asked.mockResolvedValue({ unchanged: true });
    edits.strokeTo([0], 'a', gesture);
    edits.strokeTo([1], 'b', gesture);
    await vi.waitFor(() => expect(asked).toHaveBeenCalledTimes(2));
    expect(asked.mock.calls.map((call) => call[1])).toEqual([
      { tiles: [0], pattern: 'a', merge: gesture },
      { tiles: [1], pattern: 'b', merge: gesture },
    ]);
    expect(edits.newGesture('stroke')).not.toBe(gesture);
  });
});
