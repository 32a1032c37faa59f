// SPDX-License-Identifier: GPL-3.0-or-later

import { answered } from './store';

const LONGEST_WAIT_MS = 1000;

/** Resolves when the live model has answered something newer than it has now, be it in words; after a second in any case. */
export function settled(): Promise<void> {
  const before = answered.peek();
  return new Promise((resolve) => {
    let stop: (() => void) | null = null;
    const timer = setTimeout(end, LONGEST_WAIT_MS);
    function end(): void {
      clearTimeout(timer);
      stop?.();
      resolve();
    }
    stop = answered.subscribe((revision) => revision > before && end());
  });
}
