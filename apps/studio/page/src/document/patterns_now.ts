// SPDX-License-Identifier: GPL-3.0-or-later

import { computed } from '@preact/signals';
import { documentNow } from './store';
import { pending } from './ui';

/** The pattern of each tile, '' where it has none; with what was just painted here and is on its way. */
export const tilePatterns = computed<string[]>(() => {
  const now = documentNow.value;
  if (!now) return [];
  const ahead = pending.value;
  return now.painting.map((index, tile) => ahead.get(tile) ?? now.palette[index] ?? '');
});

export const usedPatterns = computed<string[]>(() => {
  const used = new Set(tilePatterns.value);
  return (documentNow.value?.palette ?? []).filter((pattern) => used.has(pattern));
});
