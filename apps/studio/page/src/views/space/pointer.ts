// SPDX-License-Identifier: GPL-3.0-or-later
// Pointing in space: take a handle, or click a node; everything else turns the view.

import { beams } from '../../document/store';
import { surface } from '../../document/surface';
import { mode, probed, selectedNodes } from '../../document/ui';
import { handleAt, TOUCH_REACH_PX, type Drag } from './handles';
import { nearestBar, nearestOnScreen } from './placed';
import type { SceneView } from './scene_view';

const CLICK_PX = 4;
const NODE_REACH_PX = 22;
const BAR_REACH_PX = 7;

export function attachPointer(canvas: HTMLCanvasElement, view: SceneView): () => void {
  let drag: Drag | null = null;
  let pressed: [number, number] | null = null;
  const at = (event: PointerEvent): [number, number] => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const seen = () => ({ camera: view.stage.camera, size: { width: canvas.clientWidth, height: canvas.clientHeight } });

  const down = (event: PointerEvent) => {
    if (event.button !== 0) return;
    pressed = at(event);
    drag = handleAt(pressed, seen(), { arrows: view.arrows, reach: event.pointerType === 'touch' ? TOUCH_REACH_PX : undefined })?.take(pressed, seen()) ?? null;
    if (!drag) return;
    view.stage.controls.enabled = false;
    view.dragging = true;
    canvas.setPointerCapture(event.pointerId);
  };
  // If the browser reports each move at once, a drag does not wait for the next picture.
  const follow = (event: PointerEvent) => drag?.move({ at: at(event), free: event.shiftKey, when: event.timeStamp });
  const isToldAtOnce = 'onpointerrawupdate' in canvas;
  const move = (event: PointerEvent) => {
    if (drag && !isToldAtOnce) follow(event);
    else if (event.buttons === 0) canvas.style.cursor = handleAt(at(event), seen(), { arrows: view.arrows }) ? 'grab' : '';
  };
  const up = (event: PointerEvent) => {
    const place = at(event);
    const clicked = pressed && !drag && Math.hypot(place[0] - pressed[0], place[1] - pressed[1]) < CLICK_PX;
    drag?.end();
    drag = pressed = null;
    view.dragging = false;
    view.stage.controls.enabled = true;
    if (clicked) click(place, event.shiftKey);
  };

  const click = (place: [number, number], more: boolean) => {
    const all = mode.peek() === 'look';
    const bar = all ? nearestBar(place, seen(), BAR_REACH_PX) : -1;
    if (bar >= 0) {
      probed.value = { kind: 'beam', index: bar };
      return;
    }
    const count = all ? (beams.peek()?.nodes ?? 0) : (surface.peek()?.nodes.length ?? 0);
    const node = nearestOnScreen(count, place, seen(), NODE_REACH_PX);
    if (all || mode.peek() === 'paint') probed.value = node < 0 ? null : { kind: 'node', index: node };
    else selectedNodes.value = toggled(more ? selectedNodes.peek() : new Set(), node);
  };

  canvas.addEventListener('pointerdown', down, { capture: true });
  canvas.addEventListener('pointermove', move);
  if (isToldAtOnce) canvas.addEventListener('pointerrawupdate', follow as EventListener);
  canvas.addEventListener('pointerup', up);
  return () => {
    canvas.removeEventListener('pointerdown', down, { capture: true });
    canvas.removeEventListener('pointermove', move);
    canvas.removeEventListener('pointerrawupdate', follow as EventListener);
    canvas.removeEventListener('pointerup', up);
  };
}

function toggled(set: ReadonlySet<number>, node: number): ReadonlySet<number> {
  const next = new Set(set);
  if (node < 0) return next;
  if (!next.delete(node)) next.add(node);
  return next;
}
