// SPDX-License-Identifier: GPL-3.0-or-later
// From an input event to the new positions in the page: what makes the studio feel instant. The browser test reads these.

const KEPT = 500;
let input: number | null = null;
const samples: number[] = [];

/** Note that a person moved or pressed something; `when` is the event's own time stamp. The first since the last answer counts. */
export function markInput(when: number): void {
  if (input === null) input = when;
}

export function markPositions(): void {
  if (input === null) return;
  samples.push(performance.now() - input);
  if (samples.length > KEPT) samples.shift();
  input = null;
}

export function takeLatencies(): number[] {
  input = null;
  return samples.splice(0);
}
