// SPDX-License-Identifier: GPL-3.0-or-later
// What a video shows, frame after frame.
import { expect, it, vi } from 'vitest';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
vi.stubGlobal('matchMedia', () => ({ matches: false, addEventListener: () => undefined }));
vi.stubGlobal('document', { documentElement: { dataset: {} } });
const { framesOf, videoType } = await import('../../src/views/pictures/record');

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
