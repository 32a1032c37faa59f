// SPDX-License-Identifier: GPL-3.0-or-later

/** The rim nodes from one to another along their loop, the shorter way. */
export function rimStretch(rim: readonly number[][], from: number, to: number): number[] {
  const loop = rim.find((nodes) => nodes.includes(from) && nodes.includes(to));
  if (!loop) return [to];
  const [a, b] = [loop.indexOf(from), loop.indexOf(to)];
  const forward = (b - a + loop.length) % loop.length;
  const backward = loop.length - forward;
  const step = forward <= backward ? 1 : -1;
  return Array.from({ length: Math.min(forward, backward) + 1 }, (_, i) => loop[(a + step * i + loop.length) % loop.length]);
}
