// SPDX-License-Identifier: GPL-3.0-or-later
// Which pattern each of some tiles gets: by chance, along a line, or by how dark an image is there.

import type { Point } from '../protocol/messages';
import type { Box } from '../document/surface';

/** Small, seeded, and the same everywhere (mulberry32). */
export function randomNumbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

export function byChance(tiles: readonly number[], palette: readonly string[], seed: number): string[] {
  const next = randomNumbers(seed);
  return tiles.map(() => palette[Math.floor(next() * palette.length)]);
}

/** The pattern at a share (0 to 1) of an ordered palette. */
export const atShare = (palette: readonly string[], share: number): string =>
  palette[Math.min(Math.floor(Math.min(Math.max(share, 0), 1) * palette.length), palette.length - 1)];

/** From the first pattern of the palette at `from` to the last at `to`, by the tiles' centres. */
export function alongLine(centers: readonly Point[], palette: readonly string[], from: Point, to: Point): string[] {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length2 = dx * dx + dy * dy || 1;
  return centers.map(([x, y]) => atShare(palette, ((x - from[0]) * dx + (y - from[1]) * dy) / length2));
}

export interface GreyImage {
  width: number;
  height: number;
  /** 0 black to 1 white, row by row from the top. */
  grey: Float32Array;
}

/** The image is laid over the surface's box; dark places get the last patterns of the palette, the stiffest. */
export function byImage(centers: readonly Point[], palette: readonly string[], image: GreyImage, box: Box): string[] {
  const [width, height] = [box.max[0] - box.min[0] || 1, box.max[1] - box.min[1] || 1];
  return centers.map(([x, y]) => {
    const column = Math.min(Math.floor(((x - box.min[0]) / width) * image.width), image.width - 1);
    const row = Math.min(Math.floor(((box.max[1] - y) / height) * image.height), image.height - 1);
    return atShare(palette, 1 - image.grey[row * image.width + column]);
  });
}
