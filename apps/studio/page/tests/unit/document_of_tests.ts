// SPDX-License-Identifier: GPL-3.0-or-later
// A document of two tiles for tests.
import type { LoadCase, Marks, StudioDocument } from '../../src/protocol/messages';

const NO_MARKS: Marks = { supports: [], loads: [], prescribed: [] };

export const documentWith = (...cases: (LoadCase & { marks?: Marks })[]): StudioDocument => ({
  name: 'two tiles',
  path: null,
  saved: true,
  layout: 'paper7',
  vertices: [],
  tiles: [{ vertices: [], interface: [0, 1, 2] }, { vertices: [], interface: [2, 3, 4] }],
  interface_nodes: [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0]],
  rim: [],
  sides: { left: [], right: [], bottom: [], top: [] },
  palette: ['a', 'b'],
  painting: [0, 0],
  turns: [0, 0],
  tile_models: ['', ''],
  setting: { material: { young_modulus: 1e9, poisson_ratio: 0.3, density: 1 }, section: { area: 1, I2: 1, I3: 1, J: 1 }, tile_side: 0.01 },
  load_cases: cases.map((one) => ({ marks: NO_MARKS, ...one })),
  selected_load_case: 0,
  model: 'corotational',
  history: { undo: null, redo: null },
});
