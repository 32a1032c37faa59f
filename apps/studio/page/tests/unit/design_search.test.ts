// SPDX-License-Identifier: GPL-3.0-or-later
// The request that a design sends.
import { beforeEach, expect, it, vi } from 'vitest';
import { designing } from '../../src/document/design';
import { documentNow } from '../../src/document/store';
import { target } from '../../src/document/target';
import { selectedTiles } from '../../src/document/ui';
import { documentWith } from './document_of_tests';

const asked = vi.hoisted(() => vi.fn());
vi.mock('../../src/document/studio', () => ({ ask: asked, tryAsk: asked }));
const { designRequest, runDesign, wish } = await import('../../src/document/design_search');

const GOALS = { goals: [{ nodes: [1], displacements: [[null, null, 0.02]] }] };

beforeEach(() => {
  asked.mockReset().mockResolvedValue({});
  documentNow.value = documentWith({ name: 'push' });
  target.value = [{ nodes: [1], wanted: [[null, null, 0.02]] }];
  [wish.palette.value, wish.mostPatterns.value, wish.freeFactor.value, wish.tiles.value] = ['sample:64', undefined, false, 'all'];
});

it('names only what differs from a search of everything', () => {
  expect(designRequest()).toEqual({ target: GOALS, palette: 'sample:64' });
});

it('names the tiles that may change, the patterns at most, and the factor', () => {
  [wish.palette.value, wish.mostPatterns.value, wish.freeFactor.value, wish.tiles.value] = ['document', 3, true, 'selected'];
  selectedTiles.value = new Set([1, 0]);
  expect(designRequest()).toEqual({ target: GOALS, palette: 'a,b', max_patterns: 3, free: ['factor'], tiles: [0, 1] });
});

it('that is refused is not at work', async () => {
  asked.mockResolvedValue(null);
  await runDesign();
  expect(designing.value).toBeNull();
  asked.mockResolvedValue({});
  await runDesign();
  expect(designing.value).not.toBeNull();
});
