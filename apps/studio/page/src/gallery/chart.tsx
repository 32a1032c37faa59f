// SPDX-License-Identifier: GPL-3.0-or-later
// All patterns in the plane of two properties. A box drawn here filters the gallery; what the gallery shows is dark here.

import { signal } from '@preact/signals';
import { useEffect, useRef, useState } from 'preact/hooks';
import { patternTable } from '../document/store';
import { brush, brushOrFirst } from '../document/ui';
import { shown, digits } from '../document/units';
import { theme, themeColour } from '../manners/theme';
import type { PatternRow } from '../protocol/messages';
import { Choice } from '../widgets/widgets';
import { ranges, setRange, shownPatterns } from './filters';
import { rowsById } from './order';
import { extent, onScale, PROPERTIES, propertyRow, type Property, type PropertyName } from './properties';
import { W } from '../words';

const across = signal<PropertyName>('bending_young');
const upward = signal<PropertyName>('membrane_poisson');
const PAD = { left: 10, right: 10, top: 10, bottom: 10 };
type XY = [number, number];

interface Frame {
  width: number;
  height: number;
  x: { property: Property; range: XY };
  y: { property: Property; range: XY };
}

function place(frame: Frame, row: PatternRow): XY | null {
  const [x, y] = [onScale(frame.x.property, row), onScale(frame.y.property, row)];
  if (x === null || y === null) return null;
  return toPixels(frame, [x, y]);
}
const toPixels = ({ width, height, x, y }: Frame, [u, v]: XY): XY => [
  PAD.left + ((u - x.range[0]) / (x.range[1] - x.range[0] || 1)) * (width - PAD.left - PAD.right),
  height - PAD.bottom - ((v - y.range[0]) / (y.range[1] - y.range[0] || 1)) * (height - PAD.top - PAD.bottom),
];
const toValues = ({ width, height, x, y }: Frame, [px, py]: XY): XY => [
  x.range[0] + ((px - PAD.left) / (width - PAD.left - PAD.right)) * (x.range[1] - x.range[0]),
  y.range[0] + ((height - PAD.bottom - py) / (height - PAD.top - PAD.bottom)) * (y.range[1] - y.range[0]),
];

function draw(canvas: HTMLCanvasElement, frame: Frame, box: [XY, XY] | null): void {
  const ratio = window.devicePixelRatio;
  canvas.width = frame.width * ratio;
  canvas.height = frame.height * ratio;
  const context = canvas.getContext('2d') as CanvasRenderingContext2D;
  context.scale(ratio, ratio);
  const dots = (rows: readonly PatternRow[], colour: string, radius: number) => {
    context.fillStyle = colour;
    context.beginPath();
    for (const row of rows) {
      const at = place(frame, row);
      if (!at) continue;
      context.moveTo(at[0] + radius, at[1]);
      context.arc(at[0], at[1], radius, 0, 2 * Math.PI);
    }
    context.fill();
  };
  dots(patternTable.value?.patterns ?? [], themeColour('--line-strong'), 1.4);
  dots(shownPatterns.value, themeColour('--accent'), 1.8);
  const chosen = rowsById.value.get(brushOrFirst.value ?? '');
  if (chosen) dots([chosen], themeColour('--fixed'), 4);
  if (!box) return;
  context.fillStyle = themeColour('--accent');
  context.strokeStyle = themeColour('--accent');
  const [[x0, y0], [x1, y1]] = box;
  context.globalAlpha = 0.1;
  context.fillRect(x0, y0, x1 - x0, y1 - y0);
  context.globalAlpha = 1;
  context.strokeRect(x0 + 0.5, y0 + 0.5, x1 - x0, y1 - y0);
}

export function Chart() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const start = useRef<XY | null>(null);
  const [size, setSize] = useState({ width: 280, height: 190 });
  const [box, setBox] = useState<[XY, XY] | null>(null);
  const rows = patternTable.value?.patterns ?? [];
  const axis = (name: PropertyName) => ({ property: propertyRow(name), range: extent(propertyRow(name), rows) ?? ([0, 1] as XY) });
  const frame: Frame = { ...size, x: axis(across.value), y: axis(upward.value) };
  const kept = currentBox(frame);
  useEffect(() => {
    const element = canvas.current as HTMLCanvasElement;
    const resized = new ResizeObserver(() => setSize({ width: element.clientWidth, height: element.clientHeight }));
    resized.observe(element);
    return () => resized.disconnect();
  }, []);
  void theme.value;
  useEffect(() => draw(canvas.current as HTMLCanvasElement, frame, box ?? kept));
  const at = (event: PointerEvent): XY => [event.offsetX, event.offsetY];
  const filter = (a: XY, b: XY) => {
    const [u, v] = [toValues(frame, a), toValues(frame, b)];
    setRange(across.value, [Math.min(u[0], v[0]), Math.max(u[0], v[0])]);
    setRange(upward.value, [Math.min(u[1], v[1]), Math.max(u[1], v[1])]);
  };
  const release = (event: PointerEvent) => {
    const [from, to] = [start.current, at(event)];
    start.current = null;
    setBox(null);
    if (from && Math.hypot(to[0] - from[0], to[1] - from[1]) < 4) click(frame, to);
  };
  const options = PROPERTIES.map(({ name, title }) => ({ value: name, title }));
  return (
    <div class="chart">
      <Choice label={W.chart.upward} value={upward.value} options={options} onPick={(name) => { setRange(upward.value, null); upward.value = name; }} />
      <canvas ref={canvas} aria-label={W.chart.patternsByAndDrag(frame.x.property.title, frame.y.property.title)}
        onPointerDown={(event) => { start.current = at(event); event.currentTarget.setPointerCapture(event.pointerId); }}
        onPointerMove={(event) => {
          if (!start.current) return;
          setBox([start.current, at(event)]);
          filter(start.current, at(event));
        }}
        onPointerUp={release} />
      <div class="chart-ends"><span>{words(frame.x.property, frame.x.range[0])}</span>
        <Choice label={W.chart.across} value={across.value} options={options} onPick={(name) => { setRange(across.value, null); across.value = name; }} />
        <span>{words(frame.x.property, frame.x.range[1])}</span></div>
    </div>
  );
}

const words = (property: Property, value: number): string =>
  property.quantity === 'plain' ? digits(value, 2) : shown(property.logarithmic ? 10 ** value : value, property.quantity);

function currentBox(frame: Frame): [XY, XY] | null {
  const [x, y] = [ranges.value.get(across.value), ranges.value.get(upward.value)];
  if (!x || !y || across.value === upward.value) return null;
  return [toPixels(frame, [x[0], y[1]]), toPixels(frame, [x[1], y[0]])];
}

/** A click takes the nearest pattern, and ends the filter. */
function click(frame: Frame, at: XY): void {
  setRange(across.value, null);
  setRange(upward.value, null);
  let [best, distance] = [null as string | null, 14];
  for (const row of patternTable.value?.patterns ?? []) {
    const dot = place(frame, row);
    const away = dot ? Math.hypot(dot[0] - at[0], dot[1] - at[1]) : Infinity;
    if (away < distance) [best, distance] = [row.id, away];
  }
  if (best) brush.value = best;
}
