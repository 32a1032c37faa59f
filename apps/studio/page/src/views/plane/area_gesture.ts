// SPDX-License-Identifier: GPL-3.0-or-later
// Choose things by click, box, circle or lasso. With Shift they are added to the chosen ones, or taken away
// if all of them are chosen already.

import type { Point, Selection } from '../../protocol/messages';
import { boxBetween, circleThrough } from '../../document/picked';
import { inBox, inCircle, within } from '../../painting/regions';
import type { Gesture, PlanePointer } from './gesture';
import { drawing, type Shape } from './overlay_state';

export type Area = 'box' | 'circle' | 'lasso';

/** The area that a tool draws: a box where it draws none of its own. */
export const areaOf = (tool: string): Area => (tool === 'lasso' || tool === 'circle' ? tool : 'box');

interface Choosable {
  places: readonly Point[];
  /** The one that a click means, or -1. */
  under(pointer: PlanePointer): number;
  chosen: { peek(): ReadonlySet<number>; value: ReadonlySet<number> };
  /** Takes what a box or a circle selects, with this rule, where that is remembered. */
  takeBy?(rule: Selection, found: readonly number[]): void;
}

const far = (a: PlanePointer, b: PlanePointer): boolean => Math.hypot(a.at[0] - b.at[0], a.at[1] - b.at[1]) > 0.4 * a.reach;

export function areaGesture(start: PlanePointer, how: Area, things: Choosable): Gesture {
  const points: Point[] = [start.at];
  let dragged = false;
  return {
    move(pointer) {
      dragged ||= far(start, pointer);
      if (!dragged) return;
      points.push(pointer.at);
      drawing.value = shapeOf(how, points);
    },
    end(pointer) {
      drawing.value = null;
      const rule = dragged ? ruleOf(how, start.at, pointer.at) : null;
      if (rule && !start.more && things.takeBy) {
        things.takeBy(rule, foundBy(rule, things.places));
        return;
      }
      const found = rule ? foundBy(rule, things.places) : dragged ? within(things.places, points) : [things.under(start)];
      choose(found.filter((one) => one >= 0), start.more, things);
    },
  };
}

function shapeOf(how: Area, points: readonly Point[]): Shape {
  return how === 'lasso' ? { kind: 'lasso', points: [...points] } : { kind: how, from: points[0], to: points[points.length - 1] };
}

/** The rule of a box by its corners, or of a circle by its middle and a point on it; null for a lasso. */
function ruleOf(how: Area, from: Point, to: Point): Selection | null {
  if (how === 'box') return { box: boxBetween(from, to) };
  return how === 'circle' ? { circle: circleThrough(from, to) } : null;
}

function foundBy({ box, circle }: Selection, places: readonly Point[]): number[] {
  if (circle) return inCircle(places, circle);
  return box ? inBox(places, [box[0], box[1]], [box[2], box[3]]) : [];
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
