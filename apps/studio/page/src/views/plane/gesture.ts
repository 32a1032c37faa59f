// SPDX-License-Identifier: GPL-3.0-or-later

import type { Point } from '../../protocol/messages';

export interface PlanePointer {
  at: Point;
  /** How far a finger's breadth is, in metres. */
  reach: number;
  more: boolean;
  alt: boolean;
  when: number;
}

/** The work of a tool while the button is down. */
export interface Gesture {
  move(pointer: PlanePointer): void;
  end(pointer: PlanePointer): void;
}
export interface Tool {
  hover(pointer: PlanePointer | null): void;
  press(pointer: PlanePointer): Gesture | null;
}
