// SPDX-License-Identifier: GPL-3.0-or-later
// Binary messages: a header of eight numbers, then arrays. The arrays are views into the message; nothing is copied.

const MAGIC = 0x46575254;
const HEADER_BYTES = 32;

/** The bars of the painted surface at rest. Interface nodes come first, then the nodes inside of tiles. */
export interface Beams {
  kind: 'beams';
  revision: number;
  nodes: number;
  beams: number;
  place: Float32Array;
  ends: Uint32Array;
  tile: Uint32Array;
  axis3: Float32Array;
}

/** A solution for the same nodes and bars. */
export interface Solution {
  kind: 'solution';
  revision: number;
  /** The revision of the bars that it is about. */
  of: number;
  nodes: number;
  beams: number;
  displacement: Float32Array;
  rotation: Float32Array;
  nodeFields: Float32Array[];
  beamFields: Float32Array[];
}

export function decode(message: ArrayBuffer): Beams | Solution {
  const header = new DataView(message);
  if (message.byteLength < HEADER_BYTES || header.getUint32(0, true) !== MAGIC) {
    throw new Error('the server sent a binary message that is not of this protocol');
  }
  const [kind, revision, a, b, c, d, of] = [4, 8, 12, 16, 20, 24, 28].map((at) => header.getUint32(at, true));
  const expected = 4 * (kind === 1 ? 3 * a + 6 * b : 6 * a + c * a + 2 * b * d);
  if (message.byteLength - HEADER_BYTES !== expected) {
    throw new Error(`a binary message of kind ${kind} has ${message.byteLength - HEADER_BYTES} bytes, not ${expected}`);
  }
  let at = HEADER_BYTES;
  const floats = (count: number): Float32Array => {
    const array = new Float32Array(message, at, count);
    at += 4 * count;
    return array;
  };
  const whole = (count: number): Uint32Array => {
    const array = new Uint32Array(message, at, count);
    at += 4 * count;
    return array;
  };
  if (kind === 1) {
    return { kind: 'beams', revision, nodes: a, beams: b, place: floats(3 * a), ends: whole(2 * b), tile: whole(b), axis3: floats(3 * b) };
  }
  if (kind !== 2) throw new Error(`the server sent a binary message of the unknown kind ${kind}`);
  const displacement = floats(3 * a);
  const rotation = floats(3 * a);
  const nodeFields = Array.from({ length: c }, () => floats(a));
  const beamFields = Array.from({ length: d }, () => floats(2 * b));
  return { kind: 'solution', revision, of, nodes: a, beams: b, displacement, rotation, nodeFields, beamFields };
}
