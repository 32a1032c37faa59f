// SPDX-License-Identifier: GPL-3.0-or-later
// The values that bars are coloured by.

import type { FieldName } from '../../document/look';
import type { Quantity } from '../../document/units';
import type { Solution } from '../../protocol/binary';
import type { ColourMap } from './colours';
import { W } from '../../words';

export interface FieldRow {
  name: FieldName;
  title: string;
  quantity: Quantity;
  map: ColourMap;
  /** A value for each node, or one for each end of each bar that the solution brings under this name. */
  on: 'nodes' | 'bars' | 'none';
}

export const FIELDS: FieldRow[] = [
  { name: 'plain', title: W.fields.noColour, quantity: 'plain', map: 'sizes', on: 'none' },
  { name: 'displacement', title: W.fields.displacement, quantity: 'length', map: 'sizes', on: 'nodes' },
  { name: 'uz', title: W.fields.deflectionZ, quantity: 'length', map: 'signed', on: 'nodes' },
  { name: 'rotation', title: W.fields.rotation, quantity: 'angle', map: 'sizes', on: 'nodes' },
  { name: 'N', title: W.fields.axialForce, quantity: 'force', map: 'signed', on: 'bars' },
  { name: 'M2', title: W.fields.bendingMomentOutOf, quantity: 'moment', map: 'signed', on: 'bars' },
  { name: 'M3', title: W.fields.bendingMomentInPlane, quantity: 'moment', map: 'signed', on: 'bars' },
  { name: 'T', title: W.fields.torsion, quantity: 'moment', map: 'signed', on: 'bars' },
  { name: 'V2', title: W.fields.shearForceInPlane, quantity: 'force', map: 'signed', on: 'bars' },
  { name: 'V3', title: W.fields.shearForceOutOf, quantity: 'force', map: 'signed', on: 'bars' },
  { name: 'von_mises', title: W.fields.vonMisesStress, quantity: 'stress', map: 'sizes', on: 'bars' },
  { name: 'stress', title: W.fields.normalStress, quantity: 'stress', map: 'sizes', on: 'bars' },
  { name: 'utilization', title: W.fields.utilization, quantity: 'share', map: 'sizes', on: 'bars' },
  { name: 'error', title: W.fields.errorToTheFull, quantity: 'length', map: 'sizes', on: 'nodes' },
];
/** How far nodes of a mode move, against the one that moves most: a mode has no size. */
export const MODE_ROW: FieldRow = { name: 'displacement', title: W.fields.modeShapeNormalized, quantity: 'plain', map: 'sizes', on: 'nodes' };
export const fieldRow = (name: FieldName): FieldRow => FIELDS.find((row) => row.name === name) as FieldRow;

/** Whether there is something to show: what bars bear comes when it is asked for. */
export const available = (row: FieldRow, hasError: boolean): boolean => row.name !== 'error' || hasError;

export interface Values {
  on: 'nodes' | 'bars';
  values: Float32Array;
  low: number;
  high: number;
  /** Whether some values lie beyond these bounds. */
  isCut: boolean;
}

function lengths(vectors: Float32Array, into: Float32Array): void {
  for (let i = 0, at = 0; i < into.length; ++i, at += 3) into[i] = Math.hypot(vectors[at], vectors[at + 1], vectors[at + 2]);
}

/** The utilization at both ends of each bar; null if the stress or the strength is not known. */
export function utilization(solution: Solution, names: readonly string[], strength: number | null): Float32Array | null {
  const stress = solution.beamFields[names.indexOf('von_mises')];
  return stress && strength !== null ? stress.map((value) => Math.abs(value) / strength) : null;
}

/** Room that is used again and again, so that a frame makes no garbage. */
export class FieldValues {
  private room = new Float32Array(0);

  take(row: FieldRow, solution: Solution, names: readonly string[], extra: { error: Float32Array | null; strength: number | null }): Values | null {
    if (row.on === 'none') return null;
    if (row.on === 'bars') return this.bars(row, solution, names, extra.strength);
    if (this.room.length !== solution.nodes) this.room = new Float32Array(solution.nodes);
    const room = this.room;
    if (row.name === 'displacement') lengths(solution.displacement, room);
    else if (row.name === 'rotation') lengths(solution.rotation, room);
    else if (row.name === 'uz') for (let i = 0; i < room.length; ++i) room[i] = solution.displacement[3 * i + 2];
    else if (extra.error && extra.error.length === room.length) room.set(extra.error);
    else return null;
    return range('nodes', room, row.map);
  }

  private bars(row: FieldRow, solution: Solution, names: readonly string[], strength: number | null): Values | null {
    if (row.name === 'utilization') {
      const shares = utilization(solution, names, strength);
      return shares && range('bars', shares, row.map);
    }
    const values = solution.beamFields[names.indexOf(row.name)];
    return values ? withoutPeaks(range('bars', values, row.map)) : null;
  }
}

function range(on: Values['on'], values: Float32Array, map: ColourMap): Values {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) [low, high] = [0, 0];
  const size = Math.max(Math.abs(low), Math.abs(high));
  return { on, values, low: map === 'signed' ? -size : Math.min(0, low), high: map === 'signed' ? size : high, isCut: false };
}

const BINS = 256;
/** Forces of bars peak at few places, next to supports and loads: the colours distinguish the others. */
const TOLD_APART = 0.98;
const WORTH_IT = 1.5;

function withoutPeaks(all: Values): Values {
  const most = Math.max(-all.low, all.high);
  if (!(most > 0)) return all;
  const counts = new Uint32Array(BINS + 1);
  let known = 0;
  for (const value of all.values) {
    if (Number.isNaN(value)) continue;
    ++counts[Math.floor((BINS * Math.abs(value)) / most)];
    ++known;
  }
  let [bin, below] = [0, counts[0]];
  while (below < TOLD_APART * known) below += counts[++bin];
  const reach = (most * (bin + 1)) / BINS;
  if (reach * WORTH_IT > most) return all;
  return { ...all, low: all.low < 0 ? -reach : all.low, high: reach, isCut: true };
}
