// SPDX-License-Identifier: GPL-3.0-or-later

import { computed } from '@preact/signals';
import { documentNow } from './store';
import { pending } from './ui';

const painting = computed(() => documentNow.value?.painting);
const palette = computed(() => documentNow.value?.palette ?? []);

/** The pattern of each tile, '' where it has none, including paint that is on its way to the server. */
export const tilePatterns = computed<string[]>(() => {
  const ahead = pending.value;
  const ids = palette.value;
  return (painting.value ?? []).map((index, tile) => ahead.get(tile) ?? ids[index] ?? '');
});

/** The tiles that have none. */
export const patternless = computed<number[]>(() => tilePatterns.value.flatMap((pattern, tile) => (pattern === '' ? [tile] : [])));
