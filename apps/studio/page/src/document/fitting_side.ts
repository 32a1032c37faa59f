// SPDX-License-Identifier: GPL-3.0-or-later
// A suitable side for the tiles of an outline.

/** The paper's tile side, m. */
export const DEFAULT_SIDE = 0.026;
const [FEWEST_TILES, WANTED_TILES, MOST_TILES] = [40, 120, 600];
/** Area of a hexagon with sides of 1. */
export const HEXAGON = 1.5 * Math.sqrt(3);

/** The usual side if it gives neither few nor many tiles; else one that gives a good number. */
export function fittingSide(area: number): number {
  const tiles = (side: number): number => area / (HEXAGON * side * side);
  if (tiles(DEFAULT_SIDE) >= FEWEST_TILES && tiles(DEFAULT_SIDE) <= MOST_TILES) return DEFAULT_SIDE;
  return Number(Math.sqrt(area / (HEXAGON * WANTED_TILES)).toPrecision(2));
}
