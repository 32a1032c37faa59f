// SPDX-License-Identifier: GPL-3.0-or-later
// How results are shown.

import { computed, signal } from '@preact/signals';
import { strength } from './store';
import { probed } from './ui';

export type FieldName =
  | 'plain' | 'displacement' | 'uz' | 'rotation' | 'N' | 'T' | 'M2' | 'M3' | 'V2' | 'V3' | 'von_mises' | 'stress' | 'utilization' | 'error';

export const field = signal<FieldName>('displacement');
const ON_BARS: Partial<Record<FieldName, string>> = { N: 'N', T: 'T', M2: 'M2', M3: 'M3', V2: 'V2', V3: 'V3', von_mises: 'von_mises', stress: 'stress', utilization: 'von_mises' };
/** The fields shown for the bar that was clicked. */
export const ALL_ON_BARS = ['N', 'V2', 'V3', 'T', 'M2', 'M3', 'stress', 'von_mises'];
const isBarProbed = computed(() => probed.value?.kind === 'beam');
/** The fields of bars, by the server's names, that are needed for the colours or for the clicked bar. */
export const beamFields = computed<string[]>(() => {
  if (isBarProbed.value) return ALL_ON_BARS;
  const name = ON_BARS[field.value];
  // With a strength, the status line counts the bars above it.
  const counted = strength.value === null ? [] : ['von_mises'];
  return [...new Set([...(name ? [name] : []), ...counted])];
});

/** Bounds of colours that somebody has set, by field; without an entry they follow the values. */
export const ranges = signal<Partial<Record<FieldName, { low: number; high: number }>>>({});

/** Displacements are drawn this many times as large as they are. */
export const scale = signal(1);
export const showFull = signal(true);
export const showRest = signal(false);
export const showMarks = signal(true);
export const shadows = signal(true);

/** In perspective, or parallel, where lengths across the view can be compared. */
export const projection = signal<'perspective' | 'parallel'>('perspective');

/** Playback of a load path or of modes: whether it runs, and which shape is shown. */
export const playing = signal(false);
export const shapeIndex = signal(0);

export const SCALES = [0, 0.5, 1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000];
