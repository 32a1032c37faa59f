// SPDX-License-Identifier: GPL-3.0-or-later
// The lower layer: tiles and their bars in real width. Redrawn when the view changes; after painting, only
// where tiles have changed.

import { fanSegments } from '../../pattern/fan';
import { neighbours, type Surface } from '../../document/surface';
import { themeColour } from '../../manners/theme';
import { ringsAround } from '../../painting/regions';
import type { Viewport } from './viewport';

export interface TilePicture {
  surface: Surface;
  patterns: readonly string[];
  /** The colour of each tile, null for the plain one; null: all are plain. */
  fills: readonly (string | null)[] | null;
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

function outline(surface: Surface, tiles: Iterable<number>): Path2D {
  const path = new Path2D();
  for (const tile of tiles) {
    surface.polygons[tile].forEach(([x, y], i) => (i ? path.lineTo(x, y) : path.moveTo(x, y)));
    path.closePath();
  }
  return path;
}

export function useView(context: CanvasRenderingContext2D, view: Viewport, ratio: number): void {
  const { zoom, center, width, height } = view;
  context.setTransform(ratio * zoom, 0, 0, -ratio * zoom, ratio * (width / 2 - zoom * center[0]), ratio * (height / 2 + zoom * center[1]));
}

const all = (surface: Surface): number[] => surface.polygons.map((_, tile) => tile);

/** The present content of a canvas. */
interface Drawn {
  picture: TilePicture;
  view: Viewport;
  ratio: number;
  theme: string;
}
const drawn = new WeakMap<HTMLCanvasElement, Drawn>();
const MOST_SINGLY = 40;

/** The tiles with another pattern or colour than on the canvas; null if all must be drawn. */
function changedTiles(canvas: HTMLCanvasElement, now: Drawn): number[] | null {
  const before = drawn.get(canvas);
  const isFilled = (picture: TilePicture): boolean => picture.fills !== null;
  const isSame = before && isFilled(before.picture) === isFilled(now.picture) && before.view === now.view && before.ratio === now.ratio && before.theme === now.theme;
  if (!isSame || before.picture.surface !== now.picture.surface || before.picture.barWidth !== now.picture.barWidth) return null;
  const changed = now.picture.patterns.flatMap((pattern, tile) => (pattern === before.picture.patterns[tile] && now.picture.fills?.[tile] === before.picture.fills?.[tile] ? [] : [tile]));
  return changed.length > MOST_SINGLY ? null : changed;
}

export function drawTiles(context: CanvasRenderingContext2D, view: Viewport, ratio: number, picture: TilePicture): void {
  const now = { picture, view, ratio, theme: themeColour('--bar') };
  const changed = changedTiles(context.canvas, now);
  drawn.set(context.canvas, now);
  if (!changed) {
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, context.canvas.width, context.canvas.height);
  }
  useView(context, view, ratio);
  if (!changed) return drawSome(context, view, picture, all(picture.surface));
  for (const tile of changed) drawAgain(context, view, picture, tile);
}

/** Draws a tile and its neighbours, because bars reach into the next tile by half their width. */
function drawAgain(context: CanvasRenderingContext2D, view: Viewport, picture: TilePicture, tile: number): void {
  context.save();
  context.clip(outline(picture.surface, ringsAround(tile, 1, neighbours.peek())));
  drawSome(context, view, picture, ringsAround(tile, 2, neighbours.peek()));
  context.restore();
}

/** On coloured tiles bars are dark in both themes. */
const DARK_BARS = '#22303c';

function fillTiles(context: CanvasRenderingContext2D, surface: Surface, fills: readonly (string | null)[], some: readonly number[]): void {
  const tilesOf = new Map<string, number[]>();
  for (const tile of some) {
    const colour = fills[tile];
    if (!colour) continue;
    const alike = tilesOf.get(colour) ?? [];
    if (alike.push(tile) === 1) tilesOf.set(colour, alike);
  }
  for (const [colour, tiles] of tilesOf) {
    context.fillStyle = colour;
    context.fill(outline(surface, tiles));
  }
}

function drawSome(context: CanvasRenderingContext2D, view: Viewport, { surface, patterns, fills, barWidth }: TilePicture, some: readonly number[]): void {
  const tiles = outline(surface, some);
  context.fillStyle = themeColour('--raised');
  context.fill(tiles);
  if (fills) fillTiles(context, surface, fills, some);
  context.lineWidth = 0.75 / view.zoom;
  context.strokeStyle = themeColour('--line');
  context.stroke(tiles);
  context.lineCap = 'round';
  context.lineWidth = Math.max(barWidth, 1 / view.zoom);
  context.strokeStyle = fills ? DARK_BARS : themeColour('--bar');
  const bars = new Path2D();
  for (const tile of some) if (patterns[tile]) bars.addPath(fanPath(surface, tile, patterns[tile]));
  context.stroke(bars);
}
