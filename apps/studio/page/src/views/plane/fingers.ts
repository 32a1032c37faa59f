// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers in the plane: one works as the pointer does, two move and zoom the view.

import { surface } from '../../document/surface';
import type { Point } from '../../protocol/messages';
import { moved, viewport, zoomedAt } from './viewport';

/** One finger that moved less is a tap; before that, a second finger may come. */
const TAP_PX = 7;

interface Finger {
  first: PointerEvent;
  at: Point;
}

export class Fingers {
  private readonly down = new Map<number, Finger>();
  /** Two fingers have moved the view: nothing is painted until all are gone. */
  private movesView = false;
  /** The finger that works until all are gone; null: none has begun. */
  private worker: number | null = null;

  /** Whether the press waits: for a move, a second finger, or the end of a tap. */
  press(event: PointerEvent): boolean {
    if (this.down.size === 0) [this.movesView, this.worker] = [false, null];
    this.down.set(event.pointerId, { first: event, at: [event.offsetX, event.offsetY] });
    if (this.down.size === 2 && this.worker === null) this.movesView = true;
    return true;
  }

  /**
   * Returns 'view' if the view was moved or if this finger does nothing, the first event if a gesture begins,
   * or null if it goes on.
   */
  move(event: PointerEvent): 'view' | PointerEvent | null {
    const finger = this.down.get(event.pointerId);
    if (!finger) return null;
    const at: Point = [event.offsetX, event.offsetY];
    if (this.movesView) {
      this.moveView(event.pointerId, at);
      finger.at = at;
      return 'view';
    }
    if (this.worker !== null) return event.pointerId === this.worker ? null : 'view';
    if (Math.hypot(at[0] - finger.first.offsetX, at[1] - finger.first.offsetY) < TAP_PX) return 'view';
    this.worker = event.pointerId;
    return finger.first;
  }

  /** Returns the event of a tap, 'view' if another finger goes on, or null if this one's work ends. */
  release(event: PointerEvent): 'view' | PointerEvent | null {
    const finger = this.down.get(event.pointerId);
    this.down.delete(event.pointerId);
    if (this.worker !== null) return event.pointerId === this.worker ? null : 'view';
    return finger && !this.movesView && event.type === 'pointerup' ? finger.first : null;
  }

  /** What lies between the fingers stays there. */
  private moveView(id: number, at: Point): void {
    const moving = this.down.get(id);
    const other = [...this.down].find(([key]) => key !== id)?.[1];
    const now = surface.peek();
    if (!moving || !other || !now) return;
    const before = Math.hypot(moving.at[0] - other.at[0], moving.at[1] - other.at[1]);
    const after = Math.hypot(at[0] - other.at[0], at[1] - other.at[1]);
    const middle: Point = [(at[0] + other.at[0]) / 2, (at[1] + other.at[1]) / 2];
    const shifted = moved(viewport.peek(), (at[0] - moving.at[0]) / 2, (at[1] - moving.at[1]) / 2);
    viewport.value = zoomedAt(shifted, middle, before > 0 ? after / before : 1, now.box);
  }
}
