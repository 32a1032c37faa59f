// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page after each message of the server.
import { beforeEach, describe, expect, it, vi } from 'vitest';
import * as store from '../../src/document/store';
import { pending, selectedNodes, selectedTiles } from '../../src/document/ui';
import type { Beams, Solution } from '../../src/protocol/binary';
import type { Solved } from '../../src/protocol/messages';
import { documentWith } from './document_of_tests';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
const { forgetAwaited, takeBinary, takeEvent } = await import('../../src/document/events');
const { designed, designing } = await import('../../src/document/design');
const { addTarget, target } = await import('../../src/document/target');
const { notes } = await import('../../src/document/tell');

const BEAMS: Beams = { kind: 'beams', revision: 1, nodes: 0, beams: 0, place: new Float32Array(), ends: new Uint32Array(), tile: new Uint32Array(), axis3: new Float32Array() };
const solution = (of = 1): Solution => ({ kind: 'solution', revision: 2, of, nodes: 0, beams: 0, displacement: new Float32Array(), rotation: new Float32Array(), nodeFields: [], beamFields: [] });
const solved = (more: Partial<Solved> = {}): Solved => ({
  event: 'solved', revision: 2, model: 'corotational', seconds: 0.1, residual: 0, stable: true, load_factor: 1, converged: true, warnings: [], largest_displacement: 0.1, fields: [], doubtful: null, ...more,
});

beforeEach(() => {
  forgetAwaited();
  store.revision.value = 0;
  takeEvent({ event: 'document', revision: 1, ...documentWith({ name: 'push' }) });
  takeBinary(BEAMS);
});

describe('a solution', () => {
  it('is shown when its numbers are here', () => {
    takeEvent(solved());
    expect(store.live.value).toBeNull();
    takeBinary(solution());
    expect(store.live.value?.info.largest_displacement).toBe(0.1);
    expect(store.answered.value).toBe(2);
  });
  it('of other bars is not shown', () => {
    takeEvent(solved());
    takeBinary(solution(7));
    expect(store.live.value).toBeNull();
  });
  it('that the line has lost is not waited for', () => {
    takeEvent(solved());
    forgetAwaited();
    takeBinary(solution());
    expect(store.live.value).toBeNull();
  });
  it('that is provisional keeps the reactions and is no answer', () => {
    takeEvent(solved({ reactions: [{ node: 1, force: [0, 0, 1], moment: [0, 0, 0] }] }));
    takeBinary(solution());
    takeEvent(solved({ revision: 3, provisional: true, largest_displacement: 0.2 }));
    takeBinary(solution());
    expect(store.live.value?.info).toMatchObject({ largest_displacement: 0.2, reactions: [{ node: 1 }] });
    expect([store.answered.value, store.positioned.value]).toEqual([2, 3]);
  });
  it('in the background stands beside the live one, until something is edited', () => {
    takeEvent(solved({ model: 'full', background: true }));
    takeBinary(solution());
    expect([...store.others.value.keys()]).toEqual(['full']);
    expect(store.live.value).toBeNull();
    takeEvent({ event: 'changed', revision: 4, saved: false });
    expect(store.others.value.size).toBe(1);
    takeEvent({ event: 'changed', revision: 5, turns: [1, 0] });
    expect(store.others.value.size).toBe(0);
  });
  it('reactions in rows are read', () => {
    const rows = [[3, 1, 2, 3, 4, 5, 6]] as unknown as Solved['reactions'];
    takeEvent(solved({ reactions: rows }));
    takeBinary(solution());
    expect(store.live.value?.info.reactions).toEqual([{ node: 3, force: [1, 2, 3], moment: [4, 5, 6] }]);
  });
});

describe('failures', () => {
  it('of the live model take its solution away and stay as a reason', () => {
    takeEvent(solved());
    takeBinary(solution());
    takeEvent({ event: 'failed', revision: 3, model: 'corotational', error: 'nothing holds it' });
    expect([store.live.value, store.notTheAnswer.value]).toEqual([null, 'nothing holds it']);
  });
  it('of work in the background are shown and leave the solution', () => {
    takeEvent(solved());
    takeBinary(solution());
    takeEvent({ event: 'failed', revision: 3, model: 'full', error: 'too soft', background: true });
    expect(store.live.value).not.toBeNull();
    expect(notes.value.map(({ text }) => text)).toContain('too soft');
  });
});

describe('shapes', () => {
  it('a load path grows step by step and ends the work', () => {
    store.working.value = { model: 'full', share: 0, background: true };
    for (const step of [1, 2]) {
      takeEvent(solved({ step, steps: 2, load_factor: 0.5 * step, background: true }));
      takeBinary(solution());
    }
    expect(store.shapes.value).toMatchObject({ kind: 'path', values: [0.5, 1], expected: 2 });
    expect(store.shapes.value?.shapes.length).toBe(2);
    expect(store.working.value).toBeNull();
  });
  it('modes come one after the other', () => {
    takeEvent({ event: 'modes', revision: 2, values: [3, 5], kind: 'buckling' });
    takeBinary(solution());
    takeBinary(solution());
    expect(store.shapes.value).toMatchObject({ kind: 'buckling', values: [3, 5], shapes: [{}, {}] });
  });
});

describe('the document', () => {
  it('a painting confirms what was shown ahead of it, and no more', () => {
    pending.value = new Map([[0, 'b'], [1, 'b']]);
    takeEvent({ event: 'changed', revision: 2, painting: [1, 0] });
    expect([...pending.value]).toEqual([[1, 'b']]);
  });
  it('another one takes all of the first away', () => {
    takeEvent(solved());
    takeBinary(solution());
    pending.value = new Map([[0, 'b']]);
    takeEvent({ event: 'making', revision: 2, words: ['narrow'], counts: { overlap: 0, gap: 1, opening: 0 }, places: [] });
    takeEvent({ event: 'document', revision: 3, ...documentWith() });
    expect([store.live.value, store.making.value, pending.value.size, store.revision.value]).toEqual([null, null, 0, 3]);
  });
});

describe('a message about no document', () => {
  it('is shown, and leaves the revision', () => {
    takeEvent({ event: 'warning', revision: 1, text: 'the disk is full' });
    expect(notes.value.at(-1)).toMatchObject({ text: 'the disk is full', tone: 'warning' });
    takeEvent({ event: 'layout_count', revision: 0, key: 7, patterns: 5 });
    expect([store.countSoFar.value?.patterns, store.revision.value]).toEqual([5, 1]);
  });
});

describe('other tiles', () => {
  it('take the solution and all numbers of nodes and tiles away', () => {
    takeEvent(solved());
    takeBinary(solution());
    [selectedTiles.value, selectedNodes.value] = [new Set([1]), new Set([3])];
    const { tiles, interface_nodes, vertices, rim, sides, painting, turns, tile_models } = documentWith();
    takeEvent({ event: 'changed', revision: 3, tiles: [...tiles], interface_nodes: interface_nodes.slice(0, 3), vertices, rim, sides, painting, turns, tile_models });
    expect([store.live.value, selectedTiles.value.size, selectedNodes.value.size]).toEqual([null, 0, 0]);
    expect(store.documentNow.value?.interface_nodes.length).toBe(3);
  });
});

describe('a design', () => {
  const RESULT = {
    sketch: false, error_mean: 0.1, error_largest: 0.2, stable: true, error_best_uniform: 0.4, best_uniform_pattern: 'a', uniform_tried: 2, share_closed: 0.75, is_better: true,
    patterns: ['a'], load_cases: [], factors: [], warnings: [], warning_parts: [], words: 'the solutions were spent', seconds: 1, solutions: 3, full_solutions: 2,
  };
  it('is at work until its answer is here; its sketch is shown before', () => {
    takeEvent({ event: 'designing', revision: 1, solutions: 2, most: 60, seconds: 0.1, misfit: 0.5 });
    takeEvent({ event: 'designed', revision: 1, ...RESULT, sketch: true });
    expect([designing.value?.solutions, designed.value?.sketch]).toEqual([2, true]);
    takeEvent({ event: 'changed', revision: 2, painting: [1, 1] });
    takeEvent({ event: 'designed', revision: 1, ...RESULT });
    expect([designing.value, designed.value?.share_closed]).toEqual([null, 0.75]);
  });
  it('is told until the painting is another one, and also when it is saved', () => {
    takeEvent({ event: 'designed', revision: 1, ...RESULT });
    takeEvent({ event: 'changed', revision: 2, saved: true, selected_load_case: 0 });
    expect(designed.value).not.toBeNull();
  });
  it('is no longer told of another painting', () => {
    takeEvent({ event: 'designed', revision: 1, ...RESULT });
    takeEvent({ event: 'changed', revision: 2, painting: [1, 1] });
    expect(designed.value).toBeNull();
  });
  it('that failed is over, and the live solution stays', () => {
    takeEvent(solved());
    takeBinary(solution());
    takeEvent({ event: 'designing', revision: 1, solutions: 2, most: 60, seconds: 0.1, misfit: 0.5 });
    takeEvent({ event: 'failed', revision: 1, model: 'design', background: true, error: 'the palette is empty' });
    expect([designing.value, store.live.value?.info.model]).toEqual([null, 'corotational']);
    expect(notes.value.at(-1)?.text).toBe('the palette is empty');
  });
  it('keeps its target when the line is mended, and loses it with the surface', () => {
    addTarget({ nodes: [4], wanted: [[null, null, 0.01]] });
    takeEvent({ event: 'document', revision: 3, ...documentWith({ name: 'push' }) });
    expect(target.value.length).toBe(1);
    takeEvent({ event: 'document', revision: 4, ...documentWith(), interface_nodes: [[0, 0]] });
    expect(target.value.length).toBe(0);
  });
});

describe('the estimate of the error', () => {
  it('goes when what it was of is edited', () => {
    takeEvent({ event: 'model_error', revision: 1, model: 'corotational', mean: 0.01, largest: 0.02, largest_stress: null, is_warned: false });
    expect(store.estimated.value?.largest).toBe(0.02);
    takeEvent({ event: 'changed', revision: 2, model: 'full' });
    expect(store.estimated.value).toBeNull();
  });
});
