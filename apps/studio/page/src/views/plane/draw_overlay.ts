// SPDX-License-Identifier: GPL-3.0-or-later
// The upper layer: what is pointed at and chosen, supports and loads. Cheap, so that it keeps up with the pointer.

import { HOLD_COLOURS, heldNodes, loadKinds, loadMarks, prescribedMarks, type LoadMark } from '../../document/marks';
import type { Surface } from '../../document/surface';
import { patternless } from '../../document/patterns_now';
import { liveTarget } from '../../document/target';
import { barEnds, overstressed, placeLookedAt, problems } from '../../document/truth';
import { choosesNodes, choosesTiles, mode, probed, selectedNodes, selectedTiles } from '../../document/ui';
import { themeColour } from '../../manners/theme';
import type { Point } from '../../protocol/messages';
import { useView } from './draw_tiles';
import { drawing, hoveredNode, hoveredNodes, hoveredTiles } from './overlay_state';
import { toScreen, type Viewport } from './viewport';

type Context = CanvasRenderingContext2D;

function tilePath(surface: Surface, tiles: Iterable<number>): Path2D {
  const path = new Path2D();
  for (const tile of tiles) {
    surface.polygons[tile]?.forEach(([x, y], i) => (i ? path.lineTo(x, y) : path.moveTo(x, y)));
    path.closePath();
  }
  return path;
}

export function drawOverlay(context: Context, view: Viewport, ratio: number, surface: Surface): void {
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, context.canvas.width, context.canvas.height);
  useView(context, view, ratio);
  drawUnpainted(context, view, surface);
  drawOverstressed(context, view);
  if (choosesTiles.value) drawTileMarks(context, view, surface);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  drawNodeMarks(context, view, surface);
  drawShape(context, view);
}

function drawTileMarks(context: Context, view: Viewport, surface: Surface): void {
  const accent = themeColour('--accent');
  const chosen = tilePath(surface, selectedTiles.value);
  context.fillStyle = accent;
  context.globalAlpha = 0.16;
  context.fill(chosen);
  context.globalAlpha = 1;
  context.strokeStyle = accent;
  context.lineWidth = 1.5 / view.zoom;
  context.stroke(chosen);
  const hovered = tilePath(surface, hoveredTiles.value);
  context.globalAlpha = 0.12;
  context.fill(hovered);
  context.globalAlpha = 1;
  context.lineWidth = 2 / view.zoom;
  context.stroke(hovered);
}

function dot(context: Context, at: Point, radius: number, colour: string, ring?: string): void {
  context.beginPath();
  context.arc(at[0], at[1], radius, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.fill();
  if (!ring) return;
  context.lineWidth = 1.5;
  context.strokeStyle = ring;
  context.stroke();
}

function drawNodeMarks(context: Context, view: Viewport, surface: Surface): void {
  const editing = choosesNodes.value;
  const radius = Math.min(Math.max(0.14 * surface.side * view.zoom, 2.5), 7);
  const place = (node: number): Point => toScreen(view, surface.nodes[node] ?? [0, 0]);
  if (editing) for (let node = 0; node < surface.nodes.length; ++node) dot(context, place(node), Math.min(0.45 * radius, 2.5), themeColour('--ink-3'));
  if (!editing || mode.value === 'design') drawFaintMarks(context, place, 0.5 * radius);
  else drawMarks(context, place, radius);
  if (mode.value === 'design') for (const { node } of liveTarget.value) diamond(context, place(node), 0.9 * radius, themeColour('--target'));
  drawRings(context, surface, place, radius);
  drawProblemPlaces(context, view);
}

function drawMarks(context: Context, place: (node: number) => Point, radius: number): void {
  const raised = themeColour('--raised');
  for (const { node, kind } of heldNodes.value) dot(context, place(node), radius, themeColour(HOLD_COLOURS[kind]), raised);
  for (const mark of loadMarks.value) {
    for (const kind of loadKinds(mark)) for (const node of mark.nodes) arrow(context, place(node), [mark[kind][0], -mark[kind][1]], radius, themeColour(`--${kind}`));
    for (const node of mark.nodes) dot(context, place(node), 0.62 * radius, loadColour(mark), raised);
  }
  for (const mark of prescribedMarks.value) for (const node of mark.nodes) diamond(context, place(node), 0.95 * radius, themeColour('--move'));
}

/** The colour of a load: that of its force, or of its moment if it has no force. */
const loadColour = (mark: LoadMark): string => themeColour(`--${loadKinds(mark)[0] ?? 'force'}`);

function drawRings(context: Context, surface: Surface, place: (node: number) => Point, radius: number): void {
  for (const node of selectedNodes.value) ring(context, place(node), radius + 2.5, 2);
  for (const node of hoveredNodes.value) ring(context, place(node), radius + 2, 1.5);
  if (hoveredNode.value >= 0) ring(context, place(hoveredNode.value), radius + 3, 2);
  const at = probed.value;
  if (at?.kind === 'node' && at.index < surface.nodes.length) ring(context, place(at.index), radius + 4, 2);
}

/** While one paints or looks, marks are there but do not cover the patterns. */
function drawFaintMarks(context: Context, place: (node: number) => Point, radius: number): void {
  for (const { node, kind } of heldNodes.value) dot(context, place(node), radius, themeColour(HOLD_COLOURS[kind]));
  for (const mark of loadMarks.value) for (const node of mark.nodes) dot(context, place(node), 0.6 * radius, loadColour(mark));
  for (const mark of prescribedMarks.value) for (const node of mark.nodes) diamond(context, place(node), radius, themeColour('--move'));
}

/** Where bars overlap or gaps are too narrow; the place that is looked at is ringed. */
function drawProblemPlaces(context: Context, view: Viewport): void {
  const colour = themeColour('--error');
  for (const { kind, places } of problems.value) {
    if (kind !== 'unpainted' && kind !== 'stress') for (const place of places) dot(context, toScreen(view, place), 2, colour);
  }
  if (placeLookedAt.value) ring(context, toScreen(view, placeLookedAt.value), 14, 2.5, colour);
}

/** Tiles without a pattern, red. */
function drawUnpainted(context: Context, view: Viewport, surface: Surface): void {
  if (patternless.value.length === 0) return;
  const bare = tilePath(surface, patternless.value);
  context.fillStyle = context.strokeStyle = themeColour('--error');
  context.globalAlpha = 0.12;
  context.fill(bare);
  context.globalAlpha = 0.6;
  context.lineWidth = 1 / view.zoom;
  context.stroke(bare);
  context.globalAlpha = 1;
}

/** Bars above the strength, red. */
function drawOverstressed(context: Context, view: Viewport): void {
  context.beginPath();
  for (const bar of overstressed.value) {
    const ends = barEnds(bar);
    if (!ends) continue;
    context.moveTo(...ends[0]);
    context.lineTo(...ends[1]);
  }
  context.strokeStyle = themeColour('--error');
  context.lineWidth = 3 / view.zoom;
  context.stroke();
}

function ring(context: Context, at: Point, radius: number, width: number, colour = themeColour('--accent')): void {
  context.beginPath();
  context.arc(at[0], at[1], radius, 0, 2 * Math.PI);
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.stroke();
}

/** The part of a force or a moment that lies in the plane; one out of the plane shows as the dot alone. */
function arrow(context: Context, at: Point, [x, y]: Point, radius: number, colour: string): void {
  const size = Math.hypot(x, y);
  if (size === 0) return;
  const [dx, dy] = [(x / size) * radius * 4, (y / size) * radius * 4];
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(at[0], at[1]);
  context.lineTo(at[0] + dx, at[1] + dy);
  context.lineTo(at[0] + 0.7 * dx - 0.25 * dy, at[1] + 0.7 * dy + 0.25 * dx);
  context.moveTo(at[0] + dx, at[1] + dy);
  context.lineTo(at[0] + 0.7 * dx + 0.25 * dy, at[1] + 0.7 * dy - 0.25 * dx);
  context.stroke();
}

function diamond(context: Context, [x, y]: Point, radius: number, colour: string): void {
  context.beginPath();
  context.moveTo(x, y - radius);
  context.lineTo(x + radius, y);
  context.lineTo(x, y + radius);
  context.lineTo(x - radius, y);
  context.closePath();
  context.fillStyle = colour;
  context.fill();
}

function drawShape(context: Context, view: Viewport): void {
  const shape = drawing.value;
  if (!shape) return;
  context.beginPath();
  if (shape.kind === 'lasso') shape.points.map((point) => toScreen(view, point)).forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
  else {
    const [a, b] = [toScreen(view, shape.from), toScreen(view, shape.to)];
    if (shape.kind === 'box') context.rect(a[0], a[1], b[0] - a[0], b[1] - a[1]);
    else if (shape.kind === 'circle') context.arc(a[0], a[1], Math.hypot(b[0] - a[0], b[1] - a[1]), 0, 2 * Math.PI);
    else {
      context.moveTo(...a);
      context.lineTo(...b);
    }
  }
  context.setLineDash([5, 4]);
  context.lineWidth = 1.5;
  context.strokeStyle = themeColour('--accent');
  context.stroke();
  context.setLineDash([]);
  if (shape.kind === 'line') return;
  context.globalAlpha = 0.08;
  context.fillStyle = themeColour('--accent');
  context.fill();
  context.globalAlpha = 1;
}
