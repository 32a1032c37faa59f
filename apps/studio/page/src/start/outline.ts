// SPDX-License-Identifier: GPL-3.0-or-later
// An outline before it is tiled: how large it is, how large it shall be, and tiles that suit it.

import { computed, signal } from '@preact/signals';
import { base64 } from '../document/files';
import { hello } from '../document/store';
import { ask } from '../document/studio';
import type { Point } from '../protocol/messages';
import { areaWithin, DEFAULT_SIDE, fittingSide, HEXAGON } from './fitting_side';

export interface Measured {
  /** Width and height as drawn, in metres. */
  size: Point;
  loops: Point[][];
  /** What was done to the drawing. */
  remarks?: string[];
}
export const outline = signal<File | null>(null);
export const measured = signal<Measured | null>(null);
/** How wide the surface shall be; null as drawn. */
export const wantedWidth = signal<number | null>(null);
/** Whether the faces of a mesh become the tiles, as they are. */
export const keepsFaces = signal(false);
export const isMesh = computed(() => /\.(obj|ply|off)$/i.test(outline.value?.name ?? ''));
export const tileSize = signal(DEFAULT_SIDE);
export const outlineTrouble = signal<string | null>(null);

const TOO_SMALL = 0.06;
const COMFORTABLE = 0.3;
export const width = computed(() => wantedWidth.value ?? measured.value?.size[0] ?? 0);
export const height = computed(() => {
  const size = measured.value?.size;
  return size ? (width.value * size[1]) / size[0] : 0;
});

export const tilesAbout = computed(() => {
  const now = measured.value;
  if (!now) return null;
  const scale = width.value / now.size[0];
  return Math.round((areaWithin(now.loops) * scale * scale) / (HEXAGON * tileSize.value ** 2));
});

export function setWidth(next: number): void {
  wantedWidth.value = next;
  suggestSide();
}

function suggestSide(): void {
  const now = measured.value;
  if (!now) return;
  const scale = width.value / now.size[0];
  tileSize.value = fittingSide(areaWithin(now.loops) * scale * scale);
}

/** What is read of a file is shown before anything is made of it. */
export async function takeOutline(file: File): Promise<void> {
  outline.value = file;
  measured.value = wantedWidth.value = outlineTrouble.value = null;
  keepsFaces.value = false;
  // Servers that do not say what they export do not measure either.
  if (!hello.value?.exports) return;
  try {
    const answer = await ask<Measured>('measure', { outline: { name: file.name, text_base64: await base64(file) } });
    if (outline.value !== file) return;
    measured.value = answer;
    if (Math.max(...answer.size) < TOO_SMALL) wantedWidth.value = COMFORTABLE;
    suggestSide();
  } catch (error) {
    if (outline.value === file) outlineTrouble.value = (error as Error).message;
  }
}

/** Where the tiles come from, as a request for a new document says it. */
export function tilesRequest(): object {
  return isMesh.value && keepsFaces.value ? { tiles: 'faces' } : { tile_size: tileSize.value };
}

export async function outlineRequest(file: File): Promise<object> {
  const request = { name: file.name, text_base64: await base64(file) };
  return wantedWidth.value === null ? request : { ...request, width: wantedWidth.value };
}
