// SPDX-License-Identifier: GPL-3.0-or-later

import type { PatternRow } from '../protocol/messages';

/** Patterns to begin with where no library offers calibrated ones: spread evenly over all, from few edges to many. */
export function startingPalette(rows: readonly PatternRow[], count: number): string[] {
  const ordered = [...rows].sort((a, b) => a.edges - b.edges || (a.id < b.id ? -1 : 1));
  if (ordered.length <= count) return ordered.map(({ id }) => id);
  return Array.from({ length: count }, (_, i) => ordered[Math.floor(((i + 0.5) * ordered.length) / count)].id);
}
