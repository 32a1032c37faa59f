// SPDX-License-Identifier: GPL-3.0-or-later
// What a video shows, frame after frame.
import { expect, it, vi } from 'vitest';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
vi.stubGlobal('matchMedia', () => ({ matches: false, addEventListener: () => undefined }));
vi.stubGlobal('document', { documentElement: { dataset: {} }, createElement: () => ({ getContext: () => null }) });
vi.mock('../../src/views/pictures/picture', () => ({ frameImage: () => Promise.reject(new Error('no legend')) }));
const { framesOf, record, recorded, videoType } = await import('../../src/views/pictures/record');
const { shapes } = await import('../../src/document/store');

it('a load path goes there, rests, and comes back', () => {
  const frames = framesOf('path', 20);
  expect([frames[0], frames.at(-1), Math.max(...frames)]).toEqual([0, 0, 19]);
  expect(new Set(frames).size).toBe(20);
  for (let i = 1; i < frames.length; ++i) expect(Math.abs(frames[i] - frames[i - 1])).toBeLessThanOrEqual(1);
  expect(frames.length).toBeGreaterThan(100);
});

it('a mode swings whole periods, so that the video can be repeated', () => {
  const frames = framesOf('vibration', 5);
  expect(frames[0]).toBe(0);
  expect(frames.every((phase) => phase >= 0 && phase < 1)).toBe(true);
  expect(frames.filter((phase) => phase === 0)).toHaveLength(2);
});

it('the best kind that the browser can record is taken', () => {
  expect(videoType((type) => type.includes('vp8'))).toBe('video/webm;codecs=vp8');
  expect(videoType(() => false)).toBeUndefined();
});

it('a video that cannot begin leaves the way free for the next', async () => {
  const stage = { renderer: { domElement: { width: 4, height: 4 }, getPixelRatio: () => 1 }, draw: vi.fn() };
  shapes.value = { kind: 'vibration', values: [1], fields: [], shapes: [], expected: 2 };
  const view = { stage } as unknown as Parameters<typeof record>[0];
  await expect(record(view)).rejects.toThrow('no legend');
  expect(recorded.value).toBeNull();
  expect(stage.draw).toHaveBeenCalled();
  await expect(record(view)).rejects.toThrow('no legend');
});
