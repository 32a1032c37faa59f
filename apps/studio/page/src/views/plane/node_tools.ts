// SPDX-License-Identifier: GPL-3.0-or-later

import { nearestNode, surface } from '../../document/surface';
import { selectBy } from '../../document/picked';
import { mode, nodeTool, probed, selectedNodes } from '../../document/ui';
import { areaGesture, areaOf } from './area_gesture';
import type { PlanePointer, Tool } from './gesture';
import { hoveredNode, hoveredNodes } from './overlay_state';
import { rimStretch } from './rim_stretch';

const nodeUnder = (pointer: PlanePointer): number => nearestNode(surface.peek()?.nodes ?? [], pointer.at, pointer.reach);

/** The nearest rim node, however far. */
function rimNodeUnder(pointer: PlanePointer): number {
  const now = surface.peek();
  if (!now) return -1;
  const rim = [...now.onRim];
  return rim[nearestNode(rim.map((node) => now.nodes[node]), pointer.at)] ?? -1;
}

function rimGesture(start: PlanePointer) {
  const from = rimNodeUnder(start);
  const stretch = (pointer: PlanePointer): number[] => rimStretch(surface.peek()?.rim ?? [], from, rimNodeUnder(pointer));
  return {
    move: (pointer: PlanePointer) => void (hoveredNodes.value = stretch(pointer)),
    end(pointer: PlanePointer) {
      hoveredNodes.value = [];
      selectedNodes.value = new Set([...(start.more ? selectedNodes.peek() : []), ...stretch(pointer)]);
    },
  };
}

export const nodesTool: Tool = {
  hover(pointer) {
    hoveredNode.value = !pointer ? -1 : nodeTool.peek() === 'rim' ? rimNodeUnder(pointer) : nodeUnder(pointer);
  },
  press(pointer) {
    if (mode.peek() === 'look') {
      const node = nodeUnder(pointer);
      probed.value = node < 0 ? null : { kind: 'node', index: node };
      return null;
    }
    if (nodeTool.peek() === 'rim') return rimGesture(pointer);
    return areaGesture(pointer, areaOf(nodeTool.peek()), {
      places: surface.peek()?.nodes ?? [],
      under: nodeUnder,
      chosen: selectedNodes,
      takeBy: selectBy,
    });
  },
};
