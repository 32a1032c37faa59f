// SPDX-License-Identifier: GPL-3.0-or-later

import type { ReadonlySignal } from '@preact/signals';
import { answered, positioned } from './store';

const LONGEST_WAIT_MS = 1000;

/** Resolves to true when a revision has grown, or to false if it has not grown within a second. */
function grown(revision: ReadonlySignal<number>): Promise<boolean> {
  const before = revision.peek();
  return new Promise((resolve) => {
    let stop: (() => void) | null = null;
    const timer = setTimeout(() => end(false), LONGEST_WAIT_MS);
    function end(hasGrown: boolean): void {
      clearTimeout(timer);
      stop?.();
      resolve(hasGrown);
    }
    stop = revision.subscribe((now) => now > before && end(true));
  });
}

/** When the live model has answered a newer revision, with a solution or an error. */
export const settled = (): Promise<boolean> => grown(answered);
/** When newer positions are shown, also provisional ones. */
export const shownAnew = (): Promise<boolean> => grown(positioned);
