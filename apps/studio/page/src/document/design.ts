// SPDX-License-Identifier: GPL-3.0-or-later
// How a design is doing, and what it has come to.

import { signal } from '@preact/signals';
import type { Designed, Designing } from '../protocol/messages';

/** The newest message of the search that is under way; null: none is. */
export const designing = signal<Designing | null>(null);
/** The misfit after each better painting, from the first to the best so far. */
export const misfits = signal<readonly number[]>([]);
/** The result of the painting that is shown; null once another painting is shown. */
export const designed = signal<Designed | null>(null);

export function takeDesigning(message: Designing): void {
  designing.value = message;
  const best = misfits.peek().at(-1) ?? Infinity;
  if (message.misfit !== null && message.misfit < best) misfits.value = [...misfits.peek(), message.misfit];
}

export function takeDesigned(message: Designed): void {
  designed.value = message;
  if (!message.sketch) designing.value = null;
}
