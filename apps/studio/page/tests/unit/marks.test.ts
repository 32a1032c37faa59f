// SPDX-License-Identifier: GPL-3.0-or-later
import { beforeEach, describe, expect, it } from 'vitest';
import { hasGravity, heldNodes, holdKind, isHeld, isLoaded, loadKinds, loadMarks, prescribedMarks } from '../../src/document/marks';
import { documentNow } from '../../src/document/store';
import type { Marks } from '../../src/protocol/messages';
import { documentWith } from './document_of_tests';

const share = (force: [number, number, number]): Marks['loads'][0] => ({ nodes: [3, 4], shares: [0.5, 0.5], force, moment: [0, 0, 0], extent: 2 });

beforeEach(() => (documentNow.value = null));

describe('what is held', () => {
  it('has a kind by what is fixed', () => {
    expect(holdKind(['ux', 'uy', 'uz', 'rx', 'ry', 'rz'])).toBe('fixed');
    expect(holdKind(['uz', 'ux', 'uy'])).toBe('pinned');
    expect(holdKind(['ux', 'uy', 'uz', 'rx'])).toBe('partly');
    expect(holdKind(['rx'])).toBe('partly');
  });
  it('is each node once, with all that holds it, also of load cases that act together', () => {
    documentNow.value = documentWith(
      { name: 'sum', supports: [{ side: 'left', fixed: ['uz'] }, { nodes: [1], fixed: ['ux'] }], combines: [{ load_case: 'other', factor: 1 }],
        marks: { supports: [[0, 1], [1]], loads: [], prescribed: [] } },
      { name: 'other', supports: [{ nodes: [1], fixed: ['uy'] }], marks: { supports: [[1]], loads: [], prescribed: [] } },
      { name: 'alone', supports: [{ nodes: [4], fixed: ['uy'] }], marks: { supports: [[4]], loads: [], prescribed: [] } },
    );
    expect(heldNodes.value).toEqual([
      { node: 0, kind: 'partly', fixed: ['uz'] },
      { node: 1, kind: 'pinned', fixed: ['ux', 'uy', 'uz'] },
    ]);
    expect(isHeld.value).toBe(true);
  });
});

describe('what acts', () => {
  it('is what the program has worked out, whatever the load says', () => {
    documentNow.value = documentWith({ name: 'line', loads: [{ side: 'top', per_length: [0, 0, -2] }], marks: { supports: [], loads: [share([0, 0, -4])], prescribed: [] } });
    expect(loadMarks.value).toEqual([{ index: 0, load: { side: 'top', per_length: [0, 0, -2] }, ...share([0, 0, -4]) }]);
    expect(isLoaded.value).toBe(true);
  });
  it('is nothing where all forces are zero', () => {
    documentNow.value = documentWith({ name: 'none', loads: [{ nodes: [3], force: [0, 0, 0] }], gravity: [0, 0, 0], marks: { supports: [], loads: [share([0, 0, 0])], prescribed: [] } });
    expect(isLoaded.value).toBe(false);
    expect(hasGravity.value).toBe(false);
  });
  it('may be a force, a moment, or both', () => {
    expect([loadKinds({ force: [0, 0, 1], moment: [0, 0, 0] }), loadKinds({ force: [0, 0, 0], moment: [0, 2, 0] })]).toEqual([['force'], ['moment']]);
    expect(loadKinds({ force: [1, 0, 0], moment: [0, 2, 0] })).toEqual(['force', 'moment']);
    documentNow.value = documentWith({ name: 'turn', loads: [{ nodes: [3], moment: [0, 2, 0] }], marks: { supports: [], loads: [{ ...share([0, 0, 0]), moment: [0, 2, 0] }], prescribed: [] } });
    expect(isLoaded.value).toBe(true);
  });
  it('may be a weight, another load case, or a displacement', () => {
    documentNow.value = documentWith({ name: 'weight', gravity: [0, 0, -9.81] });
    expect([hasGravity.value, isLoaded.value]).toEqual([true, true]);
    documentNow.value = documentWith({ name: 'sum', combines: [{ load_case: 'other', factor: 2 }] });
    expect(isLoaded.value).toBe(true);
    documentNow.value = documentWith({ name: 'moved', prescribed: [{ nodes: [2], ry: 0.5 }], marks: { supports: [], loads: [], prescribed: [[2]] } });
    expect(prescribedMarks.value).toMatchObject([{ nodes: [2], dof: 'ry', value: 0.5 }]);
    expect(isLoaded.value).toBe(true);
  });
});
