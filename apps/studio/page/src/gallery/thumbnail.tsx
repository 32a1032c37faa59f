// SPDX-License-Identifier: GPL-3.0-or-later

import { documentNow, patternTable } from '../document/store';
import type { Vector } from '../protocol/messages';
import { hexagonPath, thumbnailPath } from '../pattern/fan';

/** A pattern in a hexagon, with bars in ink. `of`: node places of another layout than the document's. */
export function Thumbnail({ id, size, bar = 0.075, of }: { id: string; size: number; bar?: number; of?: readonly Vector[] }) {
  const nodes = of ?? patternTable.value?.nodes ?? documentNow.value?.layout_nodes;
  return (
    <svg class="thumbnail" width={size} height={size} viewBox="-1.08 -1.08 2.16 2.16" aria-hidden="true">
      <path d={hexagonPath} class="thumbnail-rim" />
      {nodes && <path d={thumbnailPath(id, nodes)} class="thumbnail-bars" stroke-width={bar} />}
    </svg>
  );
}
