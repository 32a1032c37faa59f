// SPDX-License-Identifier: GPL-3.0-or-later
// The time from an input event to the new positions that it causes. If it is short, the studio feels instant.
// The browser test reads these times.
// Inputs of a drag that newer ones overtook are never answered and do not count.

const KEPT = 500;
let newest: number | null = null;
const samples: number[] = [];

/** Note that a person moved or pressed something; `when` is the event's own time stamp. */
export function markInput(when: number): void {
  newest = when;
}

/** The newest input is sent now; `shown` resolves to true when its positions are here, to false if they do not come. */
export function timeUntil(shown: Promise<boolean>): void {
  const input = newest;
  newest = null;
  void shown.then((isShown) => {
    if (input === null || !isShown) return;
    samples.push(performance.now() - input);
    if (samples.length > KEPT) samples.shift();
  });
}

export function takeLatencies(): number[] {
  newest = null;
  return samples.splice(0);
}
