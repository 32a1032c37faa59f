// SPDX-License-Identifier: GPL-3.0-or-later
// Where the plane is on the screen: metres to pixels and back, y upwards.

import { signal } from '@preact/signals';
import { surface, type Box } from '../../document/surface';
import { tileColour } from '../../document/tile_colours';
import type { Point } from '../../protocol/messages';

export interface Viewport {
  /** Pixels for a metre. */
  zoom: number;
  /** The place in metres at the middle of the view. */
  center: Point;
  width: number;
  height: number;
}

export const viewport = signal<Viewport>({ zoom: 1000, center: [0, 0], width: 1, height: 1 });

const MARGIN = 0.88;
const FURTHEST = 40;

export const toScreen = ({ zoom, center, width, height }: Viewport, [x, y]: Point): Point => [
  width / 2 + zoom * (x - center[0]),
  height / 2 - zoom * (y - center[1]),
];
export const toPlane = ({ zoom, center, width, height }: Viewport, [px, py]: Point): Point => [
  center[0] + (px - width / 2) / zoom,
  center[1] - (py - height / 2) / zoom,
];

/** `reserved`: pixels at the top that are covered; `foot`: those at the bottom. */
export function fitted(view: Viewport, { min, max }: Box, reserved = 0, foot = 0): Viewport {
  const room = Math.max(view.height - reserved - foot, 50);
  const zoom = MARGIN * Math.min(view.width / (max[0] - min[0] || 1), room / (max[1] - min[1] || 1));
  return { ...view, zoom, center: [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2 + (reserved - foot) / 2 / zoom] };
}

/** Zoom so that what is below the pointer stays there. */
export function zoomedAt(view: Viewport, at: Point, factor: number, box: Box): Viewport {
  const least = (0.2 * view.width) / (box.max[0] - box.min[0] || 1);
  const zoom = Math.min(Math.max(view.zoom * factor, least), least * 5 * FURTHEST);
  const fixed = toPlane(view, at);
  const next = { ...view, zoom };
  const moved = toPlane(next, at);
  return { ...next, center: [view.center[0] + fixed[0] - moved[0], view.center[1] + fixed[1] - moved[1]] };
}

export const moved = (view: Viewport, dx: number, dy: number): Viewport => ({
  ...view,
  center: [view.center[0] - dx / view.zoom, view.center[1] + dy / view.zoom],
});

const TOOLBAR_PX = 56;
const FOOT_PX = 44;
const FOOT_WITH_LEGEND_PX = 84;

/** See all of the surface. */
export function fit(): void {
  const now = surface.peek();
  if (now) viewport.value = fitted(viewport.peek(), now.box, TOOLBAR_PX, tileColour.peek() === 'none' ? FOOT_PX : FOOT_WITH_LEGEND_PX);
}

const PLACE_SIDES = 12;
/** Shows a place in the middle, near enough to see its tile apart from others. */
export function seePlace(place: Point): void {
  const now = surface.peek();
  const view = viewport.peek();
  if (!now) return;
  const zoom = Math.min(view.width, view.height) / (PLACE_SIDES * now.side);
  viewport.value = { ...view, center: place, zoom: Math.max(view.zoom, zoom) };
}
