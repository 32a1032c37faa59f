// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest';
import { decode } from '../../src/protocol/binary';
import { Latest } from '../../src/protocol/latest';

function message(kind: number, counts: number[], words: number): ArrayBuffer {
  const buffer = new ArrayBuffer(32 + 4 * words);
  const view = new DataView(buffer);
  [0x46575254, kind, 5, ...counts, 0, 0, 0, 0].slice(0, 7).forEach((value, i) => view.setUint32(4 * i, value, true));
  view.setUint32(28, 3, true);
  for (let i = 0; i < words; ++i) view.setFloat32(32 + 4 * i, i, true);
  return buffer;
}

describe('binary messages', () => {
  it('bars: places, ends, tiles, axes, in this order', () => {
    const beams = decode(message(1, [2, 1], 6 + 2 + 1 + 3));
    expect(beams).toMatchObject({ kind: 'beams', revision: 5, nodes: 2, beams: 1 });
    if (beams.kind === 'beams') expect([...beams.axis3]).toEqual([9, 10, 11]);
  });
  it('a solution: displacements, rotations, fields, and of which bars it is', () => {
    const solution = decode(message(2, [1, 1, 1, 1], 6 + 1 + 2));
    expect(solution).toMatchObject({ kind: 'solution', of: 3 });
    if (solution.kind === 'solution') {
      expect([...solution.rotation]).toEqual([3, 4, 5]);
      expect([...solution.nodeFields[0]]).toEqual([6]);
      expect([...solution.beamFields[0]]).toEqual([7, 8]);
    }
  });
  it('one that is cut short or of another kind is refused', () => {
    expect(() => decode(message(1, [2, 1], 5))).toThrow(/bytes/);
    expect(() => decode(new ArrayBuffer(8))).toThrow(/protocol/);
  });
});

describe('a stream of newest values', () => {
  it('sends the first at once, then only the newest, and never two at a time', async () => {
    const sent: number[] = [];
    let free: () => void = () => undefined;
    const stream = new Latest<number>((value) => {
      sent.push(value);
      return new Promise<void>((done) => (free = done));
    });
    [1, 2, 3].forEach((value) => stream.push(value));
    expect(sent).toEqual([1]);
    free();
    await Promise.resolve();
    await Promise.resolve();
    expect(sent).toEqual([1, 3]);
  });
  it('goes on after a failure', async () => {
    const sent: number[] = [];
    const stream = new Latest<number>((value) => {
      sent.push(value);
      return value === 1 ? Promise.reject(new Error('no')) : Promise.resolve();
    });
    stream.push(1);
    stream.push(2);
    await new Promise((done) => setTimeout(done, 0));
    expect(sent).toEqual([1, 2]);
  });
});
