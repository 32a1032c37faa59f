// SPDX-License-Identifier: GPL-3.0-or-later
// The lower layer: tiles and their bars in real width. Drawn anew when painting or view change.

import { fanSegments } from '../../pattern/fan';
import type { Surface } from '../../document/surface';
import { themeColour } from '../../manners/theme';
import type { Viewport } from './viewport';

export interface TilePicture {
  surface: Surface;
  patterns: readonly string[];
  barWidth: number;
}

/** The bars of each tile, kept until its pattern changes. */
const fans = new WeakMap<Surface, Map<number, { pattern: string; path: Path2D }>>();

function fanPath(surface: Surface, tile: number, pattern: string): Path2D {
  const known = fans.get(surface) ?? new Map<number, { pattern: string; path: Path2D }>();
  fans.set(surface, known);
  const before = known.get(tile);
  if (before?.pattern === pattern) return before.path;
  const path = new Path2D();
  const segments = fanSegments(pattern, surface.polygons[tile], surface.layoutNodes);
  for (let i = 0; i < segments.length; i += 4) {
    path.moveTo(segments[i], segments[i + 1]);
    path.lineTo(segments[i + 2], segments[i + 3]);
  }
  known.set(tile, { pattern, path });
  return path;
}

const outlines = new WeakMap<Surface, Path2D>();

function outline(surface: Surface): Path2D {
  const known = outlines.get(surface);
  if (known) return known;
  const path = new Path2D();
  for (const polygon of surface.polygons) {
    polygon.forEach(([x, y], i) => (i ? path.lineTo(x, y) : path.moveTo(x, y)));
    path.closePath();
  }
  outlines.set(surface, path);
  return path;
}

export function useView(context: CanvasRenderingContext2D, view: Viewport, ratio: number): void {
  const { zoom, center, width, height } = view;
  context.setTransform(ratio * zoom, 0, 0, -ratio * zoom, ratio * (width / 2 - zoom * center[0]), ratio * (height / 2 + zoom * center[1]));
}

export function drawTiles(context: CanvasRenderingContext2D, view: Viewport, ratio: number, picture: TilePicture): void {
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, context.canvas.width, context.canvas.height);
  useView(context, view, ratio);
  const { surface, patterns, barWidth } = picture;
  const tiles = outline(surface);
  context.fillStyle = themeColour('--raised');
  context.fill(tiles);
  context.lineWidth = 0.75 / view.zoom;
  context.strokeStyle = themeColour('--line');
  context.stroke(tiles);
  context.lineCap = 'round';
  context.lineWidth = Math.max(barWidth, 1 / view.zoom);
  context.strokeStyle = themeColour('--bar');
  const all = new Path2D();
  patterns.forEach((pattern, tile) => pattern && all.addPath(fanPath(surface, tile, pattern)));
  context.stroke(all);
}
