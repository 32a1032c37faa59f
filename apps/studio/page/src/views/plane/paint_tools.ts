// SPDX-License-Identifier: GPL-3.0-or-later

import { newGesture, paint, paintBy, strokeTo } from '../../document/edits';
import { markInput } from '../../document/latency';
import { tilePatterns } from '../../document/patterns_now';
import { neighbours, surface, tileAt } from '../../document/surface';
import { brush, brushOrFirst, brushRings, nodeTool, paintTool, pending, selectedTiles } from '../../document/ui';
import { orderedPalette } from '../../gallery/order';
import { alongLine } from '../../painting/gradient';
import { allWith, ringsAround, sameRegion } from '../../painting/regions';
import { areaGesture, areaOf, type Area } from './area_gesture';
import type { Gesture, PlanePointer, Tool } from './gesture';
import { drawing, hoveredTiles } from './overlay_state';

const tileUnder = (pointer: PlanePointer): number => (surface.peek() ? tileAt(surface.peek()!, pointer.at) : -1);

/** The tiles that a press here would paint. */
function meant(tile: number): number[] {
  if (tile < 0) return [];
  const patterns = tilePatterns.peek();
  const around = neighbours.peek();
  switch (paintTool.peek()) {
    case 'brush':
      return ringsAround(tile, brushRings.peek(), around);
    case 'fill':
      return sameRegion(tile, (one) => patterns[one], around);
    case 'replace':
      return allWith(patterns[tile], patterns);
    default:
      return [tile];
  }
}

function pick(tile: number): void {
  const pattern = tilePatterns.peek()[tile];
  if (!pattern) return;
  brush.value = pattern;
  if (paintTool.peek() === 'pick') paintTool.value = 'brush';
}

function showAhead(tiles: readonly number[], pattern: string): void {
  const next = new Map(pending.peek());
  tiles.forEach((tile) => next.set(tile, pattern));
  pending.value = next;
}

function stroke(start: PlanePointer): Gesture {
  const merge = newGesture('stroke');
  const done = new Set<number>();
  const dab = (pointer: PlanePointer) => {
    const pattern = brushOrFirst.peek();
    const patterns = tilePatterns.peek();
    const tiles = meant(tileUnder(pointer)).filter((tile) => !done.has(tile) && patterns[tile] !== pattern);
    if (!pattern || tiles.length === 0) return;
    tiles.forEach((tile) => done.add(tile));
    showAhead(tiles, pattern);
    markInput(pointer.when);
    strokeTo(tiles, pattern, merge);
  };
  dab(start);
  return { move: dab, end: () => undefined };
}

function paintOnce(pointer: PlanePointer): null {
  const tiles = meant(tileUnder(pointer));
  const pattern = brushOrFirst.peek();
  if (!pattern || tiles.length === 0) return null;
  showAhead(tiles, pattern);
  markInput(pointer.when);
  paint(tiles, pattern);
  return null;
}

function gradient(start: PlanePointer): Gesture {
  return {
    move: (pointer) => (drawing.value = { kind: 'line', from: start.at, to: pointer.at }),
    end(pointer) {
      drawing.value = null;
      if (Math.hypot(pointer.at[0] - start.at[0], pointer.at[1] - start.at[1]) < pointer.reach) return;
      paintBy({ patterns: alongLine(start.at, pointer.at), palette: orderedPalette.peek() });
    },
  };
}

function chooseTiles(pointer: PlanePointer, how: Area): Gesture {
  return areaGesture(pointer, how, { places: surface.peek()?.centers ?? [], under: tileUnder, chosen: selectedTiles });
}

export const tilesTool: Tool = {
  hover(pointer) {
    const next = pointer ? meant(tileUnder(pointer)) : [];
    const before = hoveredTiles.peek();
    if (next.length !== before.length || next.some((tile, i) => tile !== before[i])) hoveredTiles.value = next;
  },
  press(pointer) {
    if (pointer.alt) {
      pick(tileUnder(pointer));
      return null;
    }
    switch (paintTool.peek()) {
      case 'brush':
        return stroke(pointer);
      case 'fill':
      case 'replace':
        return paintOnce(pointer);
      case 'pick':
        pick(tileUnder(pointer));
        return null;
      case 'gradient':
        return gradient(pointer);
      case 'select':
      case 'circle':
      case 'lasso':
        return chooseTiles(pointer, areaOf(paintTool.peek()));
    }
  },
};

/** Selects tiles and paints none. */
export const choosingTool: Tool = {
  hover(pointer) {
    const tile = pointer ? tileUnder(pointer) : -1;
    if (tile !== (hoveredTiles.peek()[0] ?? -1)) hoveredTiles.value = tile < 0 ? [] : [tile];
  },
  press: (pointer) => chooseTiles(pointer, areaOf(nodeTool.peek())),
};
