// SPDX-License-Identifier: GPL-3.0-or-later

import type { Selection } from '../protocol/messages';

/** Where an entry of a load case is. */
export function selectionWords(selection: Selection, count: number): string {
  if (selection.between) return `along the rim, ${count} nodes`;
  if (selection.side) return `${selection.side} side, ${count} nodes`;
  if (selection.tiles) return `${selection.tiles.length} tile${selection.tiles.length === 1 ? '' : 's'}`;
  if (count === 1 && selection.nodes) return `node ${selection.nodes[0]}`;
  return `${count} node${count === 1 ? '' : 's'}`;
}
