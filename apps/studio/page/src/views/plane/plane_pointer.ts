// SPDX-License-Identifier: GPL-3.0-or-later
// Pointer and wheel in the plane: move and zoom the view, or hand on to the mode's tool.

import { surface } from '../../document/surface';
import { choosesTiles, mode } from '../../document/ui';
import { choosingTool, tilesTool } from './paint_tools';
import { nodesTool } from './node_tools';
import type { Gesture, PlanePointer, Tool } from './gesture';
import { hoveredNode, hoveredTiles } from './overlay_state';
import { Fingers } from './fingers';
import { attachPlaneKeys } from './plane_keys';
import { moved, toPlane, viewport, zoomedAt } from './viewport';

const FINGER_PX = 16;
const toolNow = (): Tool => (mode.peek() === 'paint' ? tilesTool : choosesTiles.peek() ? choosingTool : nodesTool);

function read(canvas: HTMLCanvasElement, event: PointerEvent): PlanePointer {
  const box = canvas.getBoundingClientRect();
  const view = viewport.peek();
  return {
    at: toPlane(view, [event.clientX - box.left, event.clientY - box.top]),
    reach: FINGER_PX / view.zoom,
    more: event.shiftKey,
    alt: event.altKey,
    when: event.timeStamp,
  };
}

export function attachPlanePointer(canvas: HTMLCanvasElement): () => void {
  const handlers = new AbortController();
  const options = { signal: handlers.signal };
  let gesture: Gesture | null = null;
  let moving = false;
  let space = false;
  const fingers = new Fingers();

  canvas.addEventListener('pointerdown', (event) => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    if (event.pointerType === 'touch' && fingers.press(event)) return;
    moving = event.button === 1 || event.button === 2 || space;
    if (!moving && event.button === 0) gesture = toolNow().press(read(canvas, event));
  }, options);
  canvas.addEventListener('pointermove', (event) => {
    if (event.pointerType === 'touch') {
      const begun = fingers.move(event);
      if (begun === 'view') return;
      if (begun) gesture = toolNow().press(read(canvas, begun));
    }
    if (moving) viewport.value = moved(viewport.peek(), event.movementX, event.movementY);
    else if (gesture) for (const part of event.getCoalescedEvents?.() ?? [event]) gesture.move(read(canvas, part));
    if (!moving) toolNow().hover(read(canvas, event));
  }, options);
  const release = (event: PointerEvent) => {
    if (event.pointerType === 'touch') {
      const tapped = fingers.release(event);
      if (tapped === 'view') return;
      if (tapped) gesture = toolNow().press(read(canvas, tapped));
    }
    gesture?.end(read(canvas, event));
    gesture = null;
    moving = false;
  };
  canvas.addEventListener('pointerup', release, options);
  canvas.addEventListener('pointercancel', release, options);
  canvas.addEventListener('pointerleave', () => {
    hoveredTiles.value = [];
    hoveredNode.value = -1;
  }, options);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault(), options);
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    const now = surface.peek();
    const box = canvas.getBoundingClientRect();
    if (now) viewport.value = zoomedAt(viewport.peek(), [event.clientX - box.left, event.clientY - box.top], Math.exp(-0.0016 * event.deltaY), now.box);
  }, { ...options, passive: false });
  const spaceKey = (event: KeyboardEvent) => {
    if (event.code !== 'Space' || document.activeElement !== canvas) return;
    event.preventDefault();
    space = event.type === 'keydown';
  };
  attachPlaneKeys(canvas, toolNow, handlers.signal);
  window.addEventListener('keydown', spaceKey, options);
  window.addEventListener('keyup', spaceKey, options);
  return () => handlers.abort();
}
