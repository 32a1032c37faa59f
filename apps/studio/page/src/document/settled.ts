// SPDX-License-Identifier: GPL-3.0-or-later

import { live, problem } from './store';

const LONGEST_WAIT_MS = 1000;

/** Resolves when the live model has a new answer, or says why it has none; after a second in any case. */
export function settled(): Promise<void> {
  const [before, said] = [live.peek(), problem.peek()];
  return new Promise((resolve) => {
    const stops: (() => void)[] = [];
    const timer = setTimeout(end, LONGEST_WAIT_MS);
    function end(): void {
      clearTimeout(timer);
      stops.forEach((stop) => stop());
      resolve();
    }
    stops.push(live.subscribe((value) => value !== before && end()));
    stops.push(problem.subscribe((value) => value !== said && end()));
  });
}
