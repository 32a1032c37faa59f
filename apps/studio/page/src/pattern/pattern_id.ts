// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern's id lists its edges between numbered nodes of the base triangle: 0-1+1-6.

export type Edge = [number, number];

const cache = new Map<string, Edge[]>();

export function patternEdges(id: string): Edge[] {
  const known = cache.get(id);
  if (known) return known;
  const edges = id
    .slice(id.indexOf(':') + 1)
    .split('+')
    .map((edge) => edge.split('-').map(Number) as Edge);
  cache.set(id, edges);
  return edges;
}

/** Edges that one of two patterns has and the other lacks, as a share of all that either has: 0 is the same drawing, 1 nothing in common. */
export function drawingDistance(a: string, b: string): number {
  const first = new Set(patternEdges(a).map((edge) => edge.join('-')));
  const second = new Set(patternEdges(b).map((edge) => edge.join('-')));
  let shared = 0;
  for (const edge of first) if (second.has(edge)) ++shared;
  const all = first.size + second.size - shared;
  return all === 0 ? 0 : 1 - shared / all;
}
