// SPDX-License-Identifier: GPL-3.0-or-later
// An outline before it is tiled: how large it is, how large it shall be, and tiles that suit it.

import { computed, signal } from '@preact/signals';
import { base64 } from '../document/files';
import { hello } from '../document/store';
import { ask } from '../document/studio';
import type { Measured, SentOutline, TilesWanted } from '../protocol/requests';
import { DEFAULT_SIDE, fittingSide, HEXAGON } from '../document/fitting_side';

export const LARGEST = 'largest';
export const ALL = 'all';

export const outline = signal<File | null>(null);
export const measured = signal<Measured | null>(null);
/** Which part of the drawing is tiled: LARGEST, ALL, or a number as text, 1 the largest. */
export const part = signal<string>(LARGEST);
/** How wide the surface shall be; null: as drawn. */
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
  return Math.round((now.area * scale * scale) / (HEXAGON * tileSize.value ** 2));
});

export function setWidth(next: number): void {
  wantedWidth.value = next;
  suggestSide();
}

function suggestSide(): void {
  const now = measured.value;
  if (!now) return;
  const scale = width.value / now.size[0];
  tileSize.value = fittingSide(now.area * scale * scale);
}

/** Shows how a file is read before anything is made of it. */
export async function takeOutline(file: File): Promise<void> {
  outline.value = file;
  keepsFaces.value = false;
  measured.value = null;
  await choosePart(LARGEST);
}

/** A drawing may have several parts; the chosen one is measured as it is drawn. */
export async function choosePart(which: string): Promise<void> {
  const file = outline.value;
  if (!file) return;
  part.value = which;
  wantedWidth.value = outlineTrouble.value = null;
  // Servers that do not say what they export do not measure either.
  if (!hello.value?.exports) return;
  const isLatest = (): boolean => outline.value === file && part.value === which;
  try {
    const answer = await ask('measure', { outline: { name: file.name, text_base64: await base64(file), part: which } });
    if (!isLatest()) return;
    measured.value = answer;
    if (Math.max(...answer.size) < TOO_SMALL) wantedWidth.value = COMFORTABLE;
    suggestSide();
  } catch (error) {
    if (isLatest()) outlineTrouble.value = (error as Error).message;
  }
}

/** Where the tiles come from, as a request for a new document says it. */
export function tilesRequest(): TilesWanted {
  return isMesh.value && keepsFaces.value ? { tiles: 'faces' } : { tile_size: tileSize.value };
}

export async function outlineRequest(file: File): Promise<SentOutline> {
  const request = { name: file.name, text_base64: await base64(file), part: part.value };
  return wantedWidth.value === null ? request : { ...request, width: wantedWidth.value };
}
