// SPDX-License-Identifier: GPL-3.0-or-later
// Choose things by click, box or lasso; with Shift they are added to what is chosen, and taken away if they all are.

import type { Point } from '../../protocol/messages';
import { boxBetween } from '../../document/picked';
import { inBox, within } from '../../painting/regions';
import type { Gesture, PlanePointer } from './gesture';
import { drawing } from './overlay_state';

interface Choosable {
  places: readonly Point[];
  /** The one that a click means, or -1. */
  under(pointer: PlanePointer): number;
  chosen: { peek(): ReadonlySet<number>; value: ReadonlySet<number> };
  /** Takes what a box selects, with the box, where that is remembered. */
  takeBox?(box: [number, number, number, number], found: readonly number[]): void;
}

const far = (a: PlanePointer, b: PlanePointer): boolean => Math.hypot(a.at[0] - b.at[0], a.at[1] - b.at[1]) > 0.4 * a.reach;

export function areaGesture(start: PlanePointer, how: 'box' | 'lasso', things: Choosable): Gesture {
  const points: Point[] = [start.at];
  let dragged = false;
  return {
    move(pointer) {
      dragged ||= far(start, pointer);
      if (!dragged) return;
      points.push(pointer.at);
      drawing.value = how === 'box' ? { kind: 'box', from: start.at, to: pointer.at } : { kind: 'lasso', points: [...points] };
    },
    end(pointer) {
      drawing.value = null;
      if (dragged && how === 'box' && !start.more && things.takeBox) {
        const box = boxBetween(start.at, pointer.at);
        things.takeBox(box, inBox(things.places, [box[0], box[1]], [box[2], box[3]]));
        return;
      }
      const found = dragged ? (how === 'box' ? inBox(things.places, start.at, pointer.at) : within(things.places, points)) : [things.under(start)];
      choose(found.filter((one) => one >= 0), start.more, things);
    },
  };
}

function choose(found: readonly number[], more: boolean, { chosen }: Choosable): void {
  const next = new Set(more ? chosen.peek() : []);
  const all = found.every((one) => next.has(one));
  for (const one of found) {
    if (all) next.delete(one);
    else next.add(one);
  }
  chosen.value = next;
}
