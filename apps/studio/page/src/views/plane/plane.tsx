// SPDX-License-Identifier: GPL-3.0-or-later
// The flat surface: paint tiles, choose nodes. Two canvases, so that moving the pointer does not draw all bars again.

import { effect, type ReadonlySignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { tilePatterns } from '../../document/patterns_now';
import { tileFills } from '../../document/tile_colours';
import { barSection, beams } from '../../document/store';
import { surface } from '../../document/surface';
import { heldNodes, loadMarks, prescribedMarks } from '../../document/marks';
import { liveTarget } from '../../document/target';
import { placeLookedAt, problems } from '../../document/truth';
import { choosesNodes, choosesTiles, mode, probed, selectedNodes, selectedTiles, split } from '../../document/ui';
import { NextStep } from '../../panels/next_step';
import { theme } from '../../manners/theme';
import { drawOverlay } from './draw_overlay';
import { drawTiles } from './draw_tiles';
import { drawing, hoveredNode, hoveredNodes, hoveredTiles } from './overlay_state';
import { PlaneBar } from './plane_bar';
import { TileColoursCard } from './tile_colours_card';
import { attachPlanePointer } from './plane_pointer';
import { fit, viewport } from './viewport';
import { W } from '../../words';
import './plane.css';


export function PlaneView() {
  const host = useRef<HTMLDivElement>(null);
  const lower = useRef<HTMLCanvasElement>(null);
  const upper = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const [box, tiles, marks] = [host.current as HTMLDivElement, lower.current as HTMLCanvasElement, upper.current as HTMLCanvasElement];
    const stops = [
      onFrame(tileSignals, () => showTiles(tiles)),
      onFrame(markSignals, () => showMarks(marks)),
      effect(() => void (surface.value && fit())),
      attachPlanePointer(marks),
    ];
    const resized = new ResizeObserver(() => {
      viewport.value = { ...viewport.peek(), width: box.clientWidth, height: box.clientHeight };
      fit();
    });
    resized.observe(box);
    return () => {
      resized.disconnect();
      stops.forEach((stop) => stop());
    };
  }, []);
  return (
    <div class="plane" ref={host}>
      <canvas ref={lower} />
      <canvas ref={upper} id="plane" data-mode={mode.value} tabIndex={0} aria-label={W.plane.dViewWheelTo} />
      <PlaneBar />
      <TileColoursCard />
      {split.value === 'plane' && <NextStep />}
    </div>
  );
}

const tileSignals = [viewport, surface, theme, tilePatterns, tileFills, barSection];
const markSignals = [
  viewport, surface, theme, mode, probed, selectedNodes, selectedTiles, heldNodes, loadMarks, prescribedMarks, hoveredTiles, hoveredNode, hoveredNodes, drawing, problems, placeLookedAt,
  liveTarget, choosesNodes, choosesTiles, beams,
];

/** Draw in the next frame after one of some signals has changed: what a person does goes to the server first. */
function onFrame(signals: readonly ReadonlySignal<unknown>[], draw: () => void): () => void {
  let asked = 0;
  const stop = effect(() => {
    for (const signal of signals) void signal.value;
    asked ||= requestAnimationFrame(() => {
      asked = 0;
      draw();
    });
  });
  return () => {
    cancelAnimationFrame(asked);
    stop();
  };
}

function sized(canvas: HTMLCanvasElement): { context: CanvasRenderingContext2D; ratio: number } {
  const { width, height } = viewport.value;
  const ratio = window.devicePixelRatio;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w) canvas.width = w;
  if (canvas.height !== h) canvas.height = h;
  return { context: canvas.getContext('2d') as CanvasRenderingContext2D, ratio };
}

function showTiles(canvas: HTMLCanvasElement): void {
  const { context, ratio } = sized(canvas);
  const now = surface.value;
  if (now) drawTiles(context, viewport.value, ratio, { surface: now, patterns: tilePatterns.value, fills: tileFills.value, barWidth: barSection.value.width });
  else context.clearRect(0, 0, canvas.width, canvas.height);
}

function showMarks(canvas: HTMLCanvasElement): void {
  const { context, ratio } = sized(canvas);
  if (surface.value) drawOverlay(context, viewport.value, ratio, surface.value);
}
