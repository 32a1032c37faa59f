// SPDX-License-Identifier: GPL-3.0-or-later
// How many valid patterns the drawn layout has. The program counts; a change of the layout ends the count before.

import { batch, computed, effect, signal } from '@preact/signals';
import { countSoFar, hello } from '../document/store';
import { ask } from '../document/studio';
import type { Vector } from '../protocol/messages';
import type { LayoutCount, LayoutFile } from '../protocol/requests';
import { draft, textOf } from './draft';

/** The last count that ended, with the places of the layout's nodes, between which its patterns are drawn. */
export const counted = signal<(LayoutCount & { places: readonly Vector[] }) | null>(null);
/** The count that is under way. */
const under = signal<number | null>(null);
export const isCounting = computed(() => under.value !== null);
/** How many the count under way has found; null: it has said nothing yet. */
export const foundNow = computed(() => (countSoFar.value?.key === under.value ? (countSoFar.value?.patterns ?? null) : null));
export const countTrouble = signal<string | null>(null);

let latest = 0;
async function count(layout: LayoutFile, places: readonly Vector[]): Promise<void> {
  const key = ++latest;
  under.value = key;
  countTrouble.value = null;
  try {
    const { patterns, complete, samples } = await ask('count_layout', { layout, key });
    if (key === latest) batch(() => ([counted.value, under.value] = [{ patterns, complete, samples, places }, null]));
  } catch (error) {
    if (key === latest) batch(() => ([countTrouble.value, under.value] = [(error as Error).message, null]));
  }
}

/** A name or a file changes no pattern. When the line was cut, the count is begun again. */
const shape = computed(() => draft.value && textOf({ ...draft.value.layout, name: '' }));
effect(() => {
  const now = hello.value && shape.value && draft.peek();
  if (now) void count(now.layout, now.nodes.map(({ place }) => place));
});
