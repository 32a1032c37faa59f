// SPDX-License-Identifier: GPL-3.0-or-later

import type { Selection } from '../protocol/messages';
import { W } from '../words';

/** Where an entry of a load case is. */
export function selectionWords(selection: Selection, count: number): string {
  if (selection.between) return W.selectionWords.alongTheEdgeNodes(count);
  if (selection.side) return W.selectionWords.sideNodes(selection.side, count);
  if (selection.tiles) return W.selectionWords.tiles(selection.tiles.length);
  if (selection.box) return W.selectionWords.inABox(count);
  if (selection.circle) return W.selectionWords.inACircle(count);
  if (count === 1 && selection.nodes) return W.selectionWords.node(selection.nodes[0]);
  return W.selectionWords.nodes(count);
}
