// SPDX-License-Identifier: GPL-3.0-or-later

import type { Vector } from '../../protocol/messages';

const CLOSE = Math.cos((14 * Math.PI) / 180);

/** A vector that nearly runs along an axis is put onto the axis, and its size gets two significant digits. */
export function snapped(vector: Vector): Vector {
  const size = Math.hypot(...vector);
  if (size === 0) return vector;
  const along = vector.findIndex((value) => Math.abs(value) > CLOSE * size);
  if (along < 0) return vector;
  const result: Vector = [0, 0, 0];
  result[along] = rounded(vector[along]);
  return result;
}

export function rounded(value: number): number {
  if (value === 0) return 0;
  return Number(value.toPrecision(2));
}
