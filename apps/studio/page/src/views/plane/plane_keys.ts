// SPDX-License-Identifier: GPL-3.0-or-later
// The plane by keys: arrows go from tile to tile, or from node to node; Enter does there what a click does.

import { signal } from '@preact/signals';
import { nearestNode, surface } from '../../document/surface';
import { choosesTiles, mode } from '../../document/ui';
import type { Point } from '../../protocol/messages';
import type { PlanePointer, Tool } from './gesture';
import { viewport } from './viewport';

const STEPS: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const REACH_PX = 16;

/** The tile or node that keys have gone to. */
const at = signal<Point | null>(null);

/** The nearest place in a direction: sideways counts more, so that one goes straight. */
export function nextPlace(places: readonly Point[], from: Point, [dx, dy]: Point): Point | null {
  const ASIDE = 2.5;
  let [best, least]: [Point | null, number] = [null, Infinity];
  for (const place of places) {
    const along = (place[0] - from[0]) * dx + (place[1] - from[1]) * dy;
    const aside = Math.abs((place[0] - from[0]) * dy - (place[1] - from[1]) * dx);
    if (along <= 1e-9 || along < 0.5 * aside) continue;
    const length = along + ASIDE * aside;
    if (length < least) [best, least] = [place, length];
  }
  return best;
}

const nearest = (places: readonly Point[], to: Point): Point | null => places[nearestNode(places, to)] ?? null;

const pointerAt = (place: Point, event: KeyboardEvent): PlanePointer => ({ at: place, reach: REACH_PX / viewport.peek().zoom, more: event.shiftKey, alt: false, when: event.timeStamp });

/** Takes keys while the plane has the focus. */
export function attachPlaneKeys(canvas: HTMLCanvasElement, toolNow: () => Tool, until: AbortSignal): void {
  const places = (): readonly Point[] => {
    const now = surface.peek();
    if (!now) return [];
    return mode.peek() === 'paint' || choosesTiles.peek() ? now.centers : now.nodes;
  };
  canvas.addEventListener('keydown', (event) => {
    const step = STEPS[event.key];
    if (!step && event.key !== 'Enter') return;
    const all = places();
    const here = at.peek() && nearest(all, at.peek() as Point);
    if (step) at.value = here ? (nextPlace(all, here, step) ?? here) : nearest(all, viewport.peek().center);
    const place = step ? at.peek() : here;
    if (!place) return;
    event.preventDefault();
    event.stopPropagation();
    const pointer = pointerAt(place, event);
    if (step) toolNow().hover(pointer);
    else toolNow().press(pointer)?.end(pointer);
  }, { signal: until });
  canvas.addEventListener('blur', () => toolNow().hover(null), { signal: until });
}
