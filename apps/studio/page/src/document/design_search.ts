// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a design.

import { signal } from '@preact/signals';
import type { DesignRequest } from '../protocol/requests';
import { designed, designing, misfits } from './design';
import { documentNow } from './store';
import { ask, tryAsk } from './studio';
import { goalsOf, target } from './target';
import { activeEntry, selectedTiles } from './ui';

export type PaletteChoice = 'sample:64' | 'document' | 'library';

/** What the search may do. */
export const wish = {
  palette: signal<PaletteChoice>('sample:64'),
  mostPatterns: signal<number | undefined>(undefined),
  freeFactor: signal(false),
  tiles: signal<'all' | 'selected'>('all'),
};

export function designRequest(): DesignRequest {
  const request: DesignRequest = { target: goalsOf(target.peek()) };
  const palette = wish.palette.peek();
  request.palette = palette === 'document' ? (documentNow.peek()?.palette.join(',') ?? '') : palette;
  const most = wish.mostPatterns.peek();
  if (most !== undefined) request.max_patterns = Math.max(1, Math.round(most));
  if (wish.freeFactor.peek()) request.free = ['factor'];
  if (wish.tiles.peek() === 'selected') request.tiles = [...selectedTiles.peek()].sort((a, b) => a - b);
  return request;
}

export async function runDesign(): Promise<void> {
  activeEntry.value = null;
  designed.value = null;
  misfits.value = [];
  designing.value = { solutions: 0, most: 0, seconds: 0, misfit: null };
  if (!(await tryAsk('design', designRequest()))) designing.value = null;
}

/** Stops it; the best painting so far stays. */
export const stopDesign = (): void => void ask('stop_design').catch(() => undefined);
