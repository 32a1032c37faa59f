// SPDX-License-Identifier: GPL-3.0-or-later
// Other tiles for the surface: what is wanted, what would come, and what it would cost.

import { computed, effect, signal } from '@preact/signals';
import { DEFAULT_SIDE, HEXAGON } from '../document/fitting_side';
import { Latest } from '../protocol/latest';
import type { Retiled, RetileRequest } from '../protocol/requests';
import { documentNow } from '../document/store';
import { ask } from '../document/studio';
import { areaOf, surface } from '../document/surface';
import { brushOrFirst } from '../document/ui';
import { W } from '../words';

const [FEWEST, MOST] = [12, 2400];

export type Patterns = 'keep' | 'brush' | 'made:one';

export const retileOpen = signal(false);
/** m; null: as they are. */
export const wantedSide = signal<number | null>(null);
/** rad; null: the best. */
export const wantedAngle = signal<number | null>(null);
/** null: the document's. */
export const wantedLayout = signal<string | null>(null);
export const wantedPatterns = signal<Patterns>('keep');

/** The tiles that a request would give; null: not known yet. */
export const preview = signal<{ of: RetileRequest; tiles: Retiled } | null>(null);
export const retileTrouble = signal<string | null>(null);
/** Whether the server is at work on tiles. */
export const retiling = signal(false);

const area = computed(() => (surface.value?.polygons ?? []).reduce((sum, polygon) => sum + areaOf(polygon), 0));
export const side = computed(() => wantedSide.value ?? Number((surface.value?.side ?? DEFAULT_SIDE).toPrecision(3)));
/** By the present number of tiles, because tiles at the edge are smaller than hexagons. */
export const tilesAbout = computed(() => {
  const now = surface.value;
  return now && wantedSide.value !== null ? Math.round(now.tiles.length * (now.side / side.value) ** 2) : null;
});
const sideOf = (tiles: number): number => Math.sqrt(area.value / (HEXAGON * tiles));
/** Sides that give a number of tiles that one can work with. */
export const sideRange = computed(() => ({ least: Math.min(sideOf(MOST), side.value), most: Math.max(sideOf(FEWEST), side.value) }));

/** With another layout, no pattern can be kept. */
export const isOtherLayout = computed(() => wantedLayout.value !== null && wantedLayout.value !== documentNow.value?.layout);
export const patterns = computed<Patterns>(() => (isOtherLayout.value ? 'made:one' : wantedPatterns.value));

export const request = computed<RetileRequest>(() => ({
  tile_size: side.value,
  ...(wantedAngle.value === null ? {} : { angle: wantedAngle.value }),
  ...(isOtherLayout.value ? { layout: wantedLayout.value as string } : {}),
  patterns: patterns.value === 'brush' ? (brushOrFirst.value ?? 'keep') : patterns.value,
}));
const isSame = (a: RetileRequest, b: RetileRequest): boolean => JSON.stringify(a) === JSON.stringify(b);
/** The tiles that would be made if the request were applied now; null: not known yet. */
export const comes = computed(() => (preview.value && isSame(preview.value.of, request.value) ? preview.value.tiles : null));

const previews = new Latest<RetileRequest>(async (of) => {
  retiling.value = true;
  try {
    const tiles = await ask('retile', { ...of, preview: true });
    [preview.value, retileTrouble.value] = [{ of, tiles }, null];
  } catch (error) {
    [preview.value, retileTrouble.value] = [null, (error as Error).message];
  }
  retiling.value = false;
});
/** Asks for a preview: a slider was let go, a number typed, or a choice made. */
export function lookAhead(): void {
  retileTrouble.value = null;
  previews.push(request.peek());
}

export async function applyTiles(): Promise<void> {
  retiling.value = true;
  try {
    await ask('retile', request.peek());
    retileTrouble.value = null;
  } catch (error) {
    retileTrouble.value = (error as Error).message;
  }
  retiling.value = false;
}

function begin(): void {
  [wantedSide.value, wantedAngle.value, wantedLayout.value] = [null, null, null];
  [preview.value, retileTrouble.value] = [null, null];
}
export function toggleRetile(): void {
  begin();
  retileOpen.value = !retileOpen.value;
}

/** Sentences about supports and loads that go; null: none does. */
export function droppedWords({ supports, loads, prescribed }: Retiled['dropped']): string | null {
  const parts = [
    ...(supports ? [W.retile.supports(supports)] : []),
    ...(loads ? [W.retile.loads(loads)] : []),
    ...(prescribed ? [W.retile.prescribed(prescribed)] : []),
  ];
  if (parts.length === 0) return null;
  const last = parts.pop() as string;
  const what = parts.length ? parts.join(', ') + W.retile.and + last : last;
  return W.retile.dropped(what, supports + loads + prescribed);
}

/** How the new tiles get their patterns. */
export function paintingWords(tiles: Retiled, chosen: Patterns): string[] {
  if (chosen !== 'keep') return [W.retile.oneForAll];
  const kinds = Object.entries(tiles.painted_again);
  const again = kinds.reduce((sum, [, count]) => sum + count, 0);
  const rest = tiles.tiles - again;
  return [
    ...kinds.map(([kind, count]) => W.retile.paintedAgain(W.retile.again[kind] ?? kind, count)),
    ...(rest ? [W.retile.rest(rest)] : []),
    ...(kinds.length ? [W.retile.remembered] : []),
  ];
}

/** A preview is of one document, and of its tiles. */
let tilesSeen: unknown = null;
effect(() => {
  const tiles = documentNow.value?.tiles;
  if (tiles === tilesSeen) return;
  tilesSeen = tiles;
  begin();
});
