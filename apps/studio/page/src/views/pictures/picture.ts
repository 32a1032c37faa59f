// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D view as a file: what is on the screen with its legend, cut to what there is to see.

import { Vector3 } from 'three';
import { heldNodes, HOLD_COLOURS, loadMarks, prescribedMarks } from '../../document/marks';
import { scale, showMarks, showRest } from '../../document/look';
import { fullUnderneath, shown, shownOfBars, UNDERNEATH } from '../../document/shown';
import { barSection, beams, documentNow, loadCase, shapes } from '../../document/store';
import { surface } from '../../document/surface';
import { digits, shown as inUnits } from '../../document/units';
import { theme, themeColour } from '../../manners/theme';
import { W } from '../../words';
import { colourAt } from '../space/colours';
import type { Values } from '../space/fields';
import { legend } from '../space/legend_state';
import { pushes } from '../space/marks_view';
import { escaped, framed, PICTURE_PAD, roundLength, type Frame, type FramedPicture } from './picture_frame';
import { middle, nodePlace } from '../space/placed';
import type { SceneView } from '../space/scene_view';
import { Projector, vectorBars, type VectorBars, type VectorView } from './vector_bars';

const COLOURS_SHOWN = 16;
const GREY = '#9b9fa5';
const BLUE = '#4a8ee0';
const MARGIN = 6;

const css = ([r, g, b]: readonly number[]): string => `#${[r, g, b].map((c) => c.toString(16).padStart(2, '0')).join('')}`;

function captionNow(): string {
  const now = documentNow.peek();
  const box = surface.peek()?.box;
  const size = box ? `${inUnits(box.max[0] - box.min[0], 'length')} × ${inUnits(box.max[1] - box.min[1], 'length')}` : '';
  if (!shown.peek() || shapes.peek()) return size;
  const drawn = scale.peek() === 1 ? W.viewBar.trueSize.toLowerCase() : `${digits(scale.peek())} ×`;
  return [loadCase.peek()?.name, now?.model, drawn, size].filter(Boolean).join(', ');
}

/** @param perPixel metres for a pixel; null in perspective */
function frameNow(perPixel: number | null, width: number): Frame {
  const now = legend.peek();
  const length = perPixel === null ? 0 : roundLength(0.25 * Math.max(width, 300) * perPixel);
  return {
    title: documentNow.peek()?.name || W.topBar.untitled,
    caption: captionNow(),
    legend: now && {
      title: now.row.title,
      colours: Array.from({ length: COLOURS_SHOWN }, (_, i) => css(colourAt(now.row.map, i / (COLOURS_SHOWN - 1)))),
      values: [now.low, (now.low + now.high) / 2, now.high].map((value) => inUnits(value, now.row.quantity)) as [string, string, string],
    },
    scaleBar: perPixel === null ? null : { length: length / perPixel, words: inUnits(length, 'length') },
    ink: theme.peek() === 'dark' ? '#f1efeb' : '#1d2126',
    halo: theme.peek() === 'dark' ? '#16181b' : '#ffffff',
  };
}

export interface Area {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** The part of a picture in which something is seen. Whatever is fainter than a shadow's end does not count. */
export function coveredArea({ data, width, height }: Pick<ImageData, 'data' | 'width' | 'height'>): Area | null {
  const FAINT = 12;
  let [left, top, right, bottom] = [width, height, -1, -1];
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      if (data[4 * (y * width + x) + 3] <= FAINT) continue;
      [left, right] = [Math.min(left, x), Math.max(right, x)];
      [top, bottom] = [Math.min(top, y), y];
    }
  }
  return right < 0 ? null : { left, top, width: right - left + 1, height: bottom - top + 1 };
}

function canvasOf(width: number, height: number): { canvas: HTMLCanvasElement; context: CanvasRenderingContext2D } {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  return { canvas, context: canvas.getContext('2d', { willReadFrequently: true }) as CanvasRenderingContext2D };
}

function blobOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((done, fail) => canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error(W.stage.thePictureCouldNot))), 'image/png'));
}

/** A picture cut to what is seen in it. */
async function cropped(picture: Blob): Promise<HTMLCanvasElement> {
  const bitmap = await createImageBitmap(picture);
  const whole = canvasOf(bitmap.width, bitmap.height);
  whole.context.drawImage(bitmap, 0, 0);
  const area = coveredArea(whole.context.getImageData(0, 0, bitmap.width, bitmap.height)) ?? { left: 0, top: 0, width: bitmap.width, height: bitmap.height };
  const part = canvasOf(area.width, area.height);
  part.context.drawImage(bitmap, -area.left, -area.top);
  return part.canvas;
}

/** `ratio`: pixels for one of the drawing. */
async function rasterized({ text, width, height }: FramedPicture, ratio: number): Promise<HTMLCanvasElement> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  const { canvas, context } = canvasOf(Math.round(ratio * width), Math.round(ratio * height));
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas;
}

/** The view as a PNG on transparent ground, with fine light and shadows. */
export async function pngPicture(view: SceneView): Promise<Blob> {
  const ratio = 2 * view.stage.renderer.getPixelRatio();
  const part = await cropped(await view.stage.picture());
  const size = { width: part.width / ratio, height: part.height / ratio };
  const image = `<image href="${part.toDataURL('image/png')}" width="${size.width}" height="${size.height}"/>`;
  return blobOf(await rasterized(framed(image, size, frameNow(view.metresPerPixel, size.width)), ratio));
}

/** Title and legend of the present view as a picture, to be laid over others. `ratio`: pixels of the picture for one of the page. */
export function frameImage(width: number, ratio: number): Promise<HTMLCanvasElement> {
  const inner = { width: Math.max(0, width / ratio - 2 * PICTURE_PAD), height: 0 };
  return rasterized(framed('', inner, frameNow(null, inner.width)), ratio);
}

/** The colour of each bar, from the values that are shown. */
function colours(values: Values | null, plain: string): VectorBars['colour'] {
  const map = legend.peek()?.row.map ?? 'sizes';
  const ends = beams.peek()?.ends;
  if (!values || !ends) return () => plain;
  const { on, low, high } = values;
  const valueAt = (bar: number, end: number): number => values.values[on === 'nodes' ? ends[2 * bar + end] : 2 * bar + end];
  return (bar, share) => {
    const value = (1 - share) * valueAt(bar, 0) + share * valueAt(bar, 1);
    return Number.isNaN(value) ? GREY : css(colourAt(map, (value - low) / (high - low || 1)));
  };
}

function layersNow(values: Values | null): VectorBars[] {
  const bars = beams.peek();
  if (!bars) return [];
  const now = shownOfBars.peek();
  const section = barSection.peek();
  const base = { beams: bars, section };
  const full = fullUnderneath.peek();
  const thinner = { width: UNDERNEATH * section.width, height: UNDERNEATH * section.height };
  const layers: VectorBars[] = [];
  if (showRest.peek()) layers.push({ ...base, solution: null, factor: 0, colour: () => GREY, opacity: 0.3 });
  if (full) layers.push({ ...base, section: thinner, solution: full, factor: scale.peek(), colour: () => GREY, opacity: 1 });
  layers.push({ ...base, solution: now?.solution ?? null, factor: now?.factor ?? 0, colour: colours(values, now ? BLUE : GREY), opacity: 1 });
  return layers;
}

/** Supports as discs, given displacements as diamonds, forces and moments as arrows. */
function marksDrawn(view: VectorView, scene: SceneView): string {
  if (!showMarks.peek()) return '';
  const project = new Projector(view);
  const discs = heldNodes.peek().map(({ node, kind }) => marked(project, nodePlace(node), ({ x, y }) => `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="4" fill="${themeColour(HOLD_COLOURS[kind])}"/>`));
  const diamonds = prescribedMarks.peek().flatMap(({ nodes }) => [
    marked(project, middle(nodes), (at) => diamond(at, 9)),
    ...nodes.map((node) => marked(project, nodePlace(node), (at) => diamond(at, 4))),
  ]);
  const arrows = loadMarks.peek().flatMap((mark) =>
    (['force', 'moment'] as const).map((key) => {
      const along = new Vector3(...mark[key]).multiplyScalar(scene.arrows[key]);
      if (along.length() === 0) return '';
      const at = middle(mark.nodes);
      const from = pushes(mark[key]) ? at.clone().sub(along) : at;
      const seen = project.ahead(from, from.clone().add(along));
      return seen ? arrow(project.see(seen[0]), project.see(seen[1]), themeColour(`--${key}`)) : '';
    }),
  );
  return `<g>${discs.join('')}${diamonds.join('')}${arrows.join('')}</g>`;
}

/** A mark at a place, if that lies before the camera. */
const marked = (project: Projector, place: Vector3, draw: (at: Flat) => string): string => (project.ahead(place, place) ? draw(project.see(place)) : '');

/** The mark of a prescribed displacement. */
const diamond = ({ x, y }: Flat, size: number): string =>
  `<path d="M${[[x, y - size], [x + size, y], [x, y + size], [x - size, y]].map((corner) => corner.map((one) => one.toFixed(1)).join(' ')).join('L')}Z" fill="${themeColour('--move')}"/>`;

interface Flat {
  x: number;
  y: number;
}
function arrow(from: Flat, to: Flat, colour: string): string {
  const length = Math.hypot(to.x - from.x, to.y - from.y) || 1;
  const [dx, dy] = [(to.x - from.x) / length, (to.y - from.y) / length];
  const head = Math.min(12, 0.6 * length);
  const neck = { x: to.x - head * dx, y: to.y - head * dy };
  const corner = (side: number): string => `${(neck.x - side * 0.45 * head * dy).toFixed(1)} ${(neck.y + side * 0.45 * head * dx).toFixed(1)}`;
  return (
    `<path d="M${from.x.toFixed(1)} ${from.y.toFixed(1)}L${neck.x.toFixed(1)} ${neck.y.toFixed(1)}" stroke="${colour}" stroke-width="3"/>` +
    `<path d="M${to.x.toFixed(1)} ${to.y.toFixed(1)}L${corner(1)}L${corner(-1)}Z" fill="${colour}"/>`
  );
}

/** The box of all lines and marks of a drawing. */
function boxOf(drawing: string): Area {
  const host = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  host.setAttribute('style', 'position:absolute;visibility:hidden');
  host.innerHTML = drawing;
  document.body.append(host);
  const { x, y, width, height } = host.getBBox();
  host.remove();
  return { left: x - MARGIN, top: y - MARGIN, width: width + 2 * MARGIN, height: height + 2 * MARGIN };
}

/** The view as an SVG of lines and areas, for drawings and print. */
export function svgPicture(scene: SceneView): string {
  const { clientWidth: width, clientHeight: height } = scene.stage.renderer.domElement;
  const view = { camera: scene.stage.camera, width, height };
  const drawing = vectorBars(layersNow(scene.valuesNow), view) + marksDrawn(view, scene);
  const area = boxOf(drawing);
  const { text } = framed(`<g transform="translate(${-area.left} ${-area.top})">${drawing}</g>`, area, frameNow(scene.metresPerPixel, area.width));
  return text.replace('<svg ', `<svg aria-label="${escaped(captionNow())}" `);
}
