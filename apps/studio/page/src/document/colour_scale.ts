// SPDX-License-Identifier: GPL-3.0-or-later
// Colours at equal distances, interpolated linearly between them.

export type Rgb = [number, number, number];

const channel = (hex: string, at: number): number => parseInt(hex.slice(1 + 2 * at, 3 + 2 * at), 16);

/** The colour of a scale of at least two colours at a share from 0 to 1: red, green, blue, each 0 to 255. */
export function onScale(colours: readonly string[], share: number): Rgb {
  const at = Math.min(Math.max(share, 0), 1) * (colours.length - 1);
  const low = Math.min(Math.floor(at), colours.length - 2);
  const blend = at - low;
  return [0, 1, 2].map((c) => Math.round((1 - blend) * channel(colours[low], c) + blend * channel(colours[low + 1], c))) as Rgb;
}

export const gradientOf = (colours: readonly string[]): string => `linear-gradient(to right, ${colours.join(', ')})`;
