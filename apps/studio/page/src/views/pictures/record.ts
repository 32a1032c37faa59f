// SPDX-License-Identifier: GPL-3.0-or-later
// A load path or a mode as a video: the browser's own recorder takes the 3D view, frame after frame.

import { signal } from '@preact/signals';
import { shapeIndex } from '../../document/look';
import { phase, stop } from '../../document/shown';
import { shapes, type Shape } from '../../document/store';
import { themeColour } from '../../manners/theme';
import { frameImage } from './picture';
import type { SceneView } from '../space/scene_view';

const FRAMES_A_SECOND = 30;
const FRAME_MS = 1000 / FRAMES_A_SECOND;
const MODE_FRAMES = 48;
const LEAST_PATH_FRAMES = 60;
const REST_FRAMES = 10;
const MEGABIT = 1e6;

/** How much of a video is recorded; null: none is. */
export const recorded = signal<number | null>(null);

/** The first type that the browser can record, the smallest first. */
export const videoType = (isSupported: (type: string) => boolean): string | undefined =>
  ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'].find(isSupported);

export const canRecord = (): boolean => typeof MediaRecorder !== 'undefined' && videoType((type) => MediaRecorder.isTypeSupported(type)) !== undefined;

/** What each frame shows: a step of the path (there, a rest, and back), or a moment of a swing. */
export function framesOf(kind: 'path' | 'vibration' | 'buckling', steps: number): number[] {
  if (kind !== 'path') return Array.from({ length: 2 * MODE_FRAMES }, (_, i) => (i / MODE_FRAMES) % 1);
  const each = Math.max(1, Math.ceil(LEAST_PATH_FRAMES / steps));
  const there = Array.from({ length: steps * each }, (_, i) => Math.floor(i / each));
  return [...there, ...Array<number>(REST_FRAMES).fill(steps - 1), ...[...there].reverse()];
}

const nextFrame = (): Promise<void> => new Promise((done) => setTimeout(done, FRAME_MS));

/** Resolves to the video, or to nothing if the shapes went away meanwhile. */
export async function record(view: SceneView): Promise<Blob | null> {
  const now = shapes.peek();
  if (!now || recorded.peek() !== null) return null;
  recorded.value = 0;
  let detach = (): void => undefined;
  try {
    stop();
    const source = view.stage.renderer.domElement;
    const canvas = Object.assign(document.createElement('canvas'), { width: source.width & ~1, height: source.height & ~1 });
    const context = canvas.getContext('2d') as CanvasRenderingContext2D;
    const legend = await frameImage(canvas.width, view.stage.renderer.getPixelRatio());
    detach = view.stage.afterDraw(() => {
      context.fillStyle = themeColour('--ground');
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.drawImage(source, 0, 0);
      context.drawImage(legend, 0, 0, legend.width, legend.height);
    });
    return await play(view, canvas, now);
  } finally {
    detach();
    recorded.value = null;
    view.stage.draw();
  }
}

async function play(view: SceneView, canvas: HTMLCanvasElement, now: Shape): Promise<Blob | null> {
  const frames = framesOf(now.kind, now.shapes.length);
  const recorder = new MediaRecorder(canvas.captureStream(FRAMES_A_SECOND), {
    mimeType: videoType((type) => MediaRecorder.isTypeSupported(type)),
    videoBitsPerSecond: 12 * MEGABIT,
  });
  const pieces: Blob[] = [];
  recorder.ondataavailable = ({ data }) => pieces.push(data);
  const ended = new Promise((done) => (recorder.onstop = done));
  recorder.start();
  for (let i = 0; i < frames.length && shapes.peek() === now; ++i) {
    if (now.kind === 'path') shapeIndex.value = frames[i];
    else phase.value = frames[i];
    view.stage.drawOnce();
    recorded.value = i / frames.length;
    await nextFrame();
  }
  recorder.stop();
  await ended;
  return shapes.peek() === now ? new Blob(pieces, { type: 'video/webm' }) : null;
}
