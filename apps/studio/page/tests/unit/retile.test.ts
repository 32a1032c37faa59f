// SPDX-License-Identifier: GPL-3.0-or-later
// What is said before tiles are replaced, and of which tiles.
import { beforeEach, expect, it, vi } from 'vitest';
import type { Retiled } from '../../src/protocol/requests';
import { documentWith } from './document_of_tests';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
vi.mock('../../src/document/studio', () => ({ ask: () => Promise.resolve({}), tryAsk: () => Promise.resolve(null) }));
const store = await import('../../src/document/store');
const { comes, droppedWords, isOtherLayout, paintingWords, patterns, preview, request, retileOpen, side, tilesAbout, toggleRetile, wantedAngle, wantedLayout, wantedSide } = await import(
  '../../src/tiles/retile'
);

const TILES: Retiled = {
  tiles: 10, interface_nodes: 40, side: { mean: 1, deviation: 0.1, smallest: 0.8, largest: 1.2 }, smallest_angle: 1, hexagon_share: 0.5, refined_share: 0,
  dropped: { supports: 0, loads: 0, prescribed: 0 }, painted_again: {}, unpainted: 0, remarks: [],
};
/** Two unit squares. */
const squares = () => ({
  ...documentWith(),
  vertices: [[0, 0], [1, 0], [1, 1], [0, 1], [2, 0], [2, 1]] as [number, number][],
  tiles: [{ vertices: [0, 1, 2, 3], interface: [0, 1, 2] }, { vertices: [1, 4, 5, 2], interface: [2, 3, 4] }],
});

beforeEach(() => {
  store.documentNow.value = squares();
});

it('what was selected by hand is counted before it goes, and nothing is said of nothing', () => {
  expect(droppedWords({ supports: 0, loads: 0, prescribed: 0 })).toBeNull();
  expect(droppedWords({ supports: 1, loads: 0, prescribed: 0 })).toMatch(/^1 support is on nodes selected by hand and will be removed\./);
  expect(droppedWords({ supports: 2, loads: 1, prescribed: 3 })).toMatch(/^2 supports, 1 load and 3 prescribed displacements are on nodes/);
});
it('names the paintings that are made again, and all that goes', () => {
  expect(paintingWords(TILES, 'made:one')).toEqual(['All tiles get one pattern.']);
  expect(paintingWords(TILES, 'keep')).toEqual(['10 tiles take the pattern of the nearest old tile.']);
  const words = paintingWords({ ...TILES, painted_again: { field: 6, image: 1 } }, 'keep');
  expect(words.slice(0, 3)).toEqual([
    'The gradient is painted again on 6 tiles.', 'The image is painted again on 1 tile.', '3 tiles take the pattern of the nearest old tile.',
  ]);
  expect(words[3]).toMatch(/^The project keeps them/);
  expect(paintingWords({ ...TILES, painted_again: { field: 10 } }, 'keep').join()).not.toMatch(/nearest/);
});
it('the side is that of the tiles until another is wanted', () => {
  expect([side.value, tilesAbout.value]).toEqual([1, null]);
  wantedSide.value = 0.5;
  expect(request.value).toEqual({ tile_size: 0.5, patterns: 'keep' });
  expect(tilesAbout.value).toBe(8);
});
it('a preview is of one request alone', () => {
  preview.value = { of: request.value, tiles: TILES };
  expect(comes.value).toBe(TILES);
  wantedAngle.value = 0.1;
  expect(comes.value).toBeNull();
});
it('patterns of another layout cannot be kept', () => {
  wantedLayout.value = 'paper7';
  expect([isOtherLayout.value, patterns.value]).toEqual([false, 'keep']);
  wantedLayout.value = 'paper8';
  expect(request.value).toMatchObject({ layout: 'paper8', patterns: 'made:one' });
});
it('other tiles end what was wanted of the last ones, other edits do not', () => {
  wantedSide.value = 0.5;
  preview.value = { of: request.value, tiles: TILES };
  store.documentNow.value = { ...(store.documentNow.value as ReturnType<typeof squares>), saved: false };
  expect([wantedSide.value, comes.value]).toEqual([0.5, TILES]);
  store.documentNow.value = squares();
  expect([wantedSide.value, comes.value]).toEqual([null, null]);
});
it('opens and closes', () => {
  toggleRetile();
  expect(retileOpen.value).toBe(true);
  toggleRetile();
  expect(retileOpen.value).toBe(false);
});
