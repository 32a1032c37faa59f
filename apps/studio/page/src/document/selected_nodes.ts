// SPDX-License-Identifier: GPL-3.0-or-later
// Which interface nodes an entry of a load case is on. The same rules as the program's, so that the page shows what is computed.

import type { Selection } from '../protocol/messages';
import { nearestNode, type Surface } from './surface';

export function selectedNodes(selection: Selection, surface: Surface): number[] {
  const { nodes } = surface;
  if (selection.nodes) return [...new Set(selection.nodes)].sort((a, b) => a - b);
  if (selection.box) {
    const [xmin, ymin, xmax, ymax] = selection.box;
    return where(nodes.length, (i) => nodes[i][0] >= xmin && nodes[i][0] <= xmax && nodes[i][1] >= ymin && nodes[i][1] <= ymax);
  }
  if (selection.nearest) return [...new Set(selection.nearest.map((point) => nearestNode(nodes, point)))].sort((a, b) => a - b);
  if (selection.tiles) return [...new Set(selection.tiles.flatMap((tile) => surface.tiles[tile]?.interface ?? []))].sort((a, b) => a - b);
  if (selection.side) return atSide(selection.side, surface);
  return [];
}

function where(count: number, holds: (index: number) => boolean): number[] {
  return Array.from({ length: count }, (_, i) => i).filter(holds);
}

/** The rim nodes in a strip of one mean tile side along a side of the bounding box. */
function atSide(side: NonNullable<Selection['side']>, { nodes, onRim, side: strip }: Surface): number[] {
  const axis = side === 'left' || side === 'right' ? 0 : 1;
  const sign = side === 'left' || side === 'bottom' ? 1 : -1;
  const lowest = Math.min(...nodes.map((node) => sign * node[axis]));
  return where(nodes.length, (i) => onRim.has(i) && sign * nodes[i][axis] <= lowest + strip);
}

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

export function selectionWords(selection: Selection, count: number): string {
  if (selection.side) return `${selection.side} side, ${count} nodes`;
  if (selection.tiles) return `${selection.tiles.length} tile${selection.tiles.length === 1 ? '' : 's'}`;
  if (count === 1 && selection.nodes) return `node ${selection.nodes[0]}`;
  return `${count} node${count === 1 ? '' : 's'}`;
}
