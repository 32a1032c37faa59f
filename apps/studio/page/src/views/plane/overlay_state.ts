// SPDX-License-Identifier: GPL-3.0-or-later
// The pending action of the pointer in the plane.

import { signal } from '@preact/signals';
import type { Point } from '../../protocol/messages';

/** A circle goes around `from` and through `to`. */
export type Shape = { kind: 'box' | 'circle' | 'line'; from: Point; to: Point } | { kind: 'lasso'; points: Point[] };

export const hoveredTiles = signal<readonly number[]>([]);
export const hoveredNode = signal(-1);
/** A rim stretch that would be taken, or the first of its ends. */
export const hoveredNodes = signal<readonly number[]>([]);
export const drawing = signal<Shape | null>(null);
