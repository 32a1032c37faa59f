// SPDX-License-Identifier: GPL-3.0-or-later
// A tour of six steps through a real surface. Each step waits until the person has done it, and it can be left at any time.

import { computed, effect, signal } from '@preact/signals';
import { documentNow, loadCase, others } from '../document/store';
import type { StudioDocument } from '../protocol/messages';
import { mode, type Mode } from '../document/ui';
import { exportOpen } from '../panels/export_menu';
import { retileOpen } from '../tiles/retile';
import { W } from '../words';

export interface Step {
  title: string;
  words: string;
  /** Where it is done. */
  mode: Mode;
  /** What it is done with: selectors. The last one that is on the page is pointed at. */
  at: readonly string[];
  /** The step is done once this is another text than when the step began. */
  mark: () => string;
  /** Whether it is done already, so that nothing need change. */
  isDone?: () => boolean;
}

const textOf = (value: unknown): string => JSON.stringify(value) ?? '';
export const TOUR_EXAMPLE = 'bridge';

export const STEPS: readonly Step[] = [
  { ...W.tour.paint, mode: 'paint', at: ['[data-value=paint]', '#plane'], mark: () => textOf([documentNow.value?.painting, documentNow.value?.palette]) },
  { ...W.tour.hold, mode: 'hold', at: ['[data-value=hold]', '#choose-right', '#hold-fixed:enabled'], mark: () => textOf(loadCase.value?.supports) },
  { ...W.tour.load, mode: 'load', at: ['[data-value=load]', '#load-factor'], mark: () => textOf(loadCase.value?.loads) },
  { ...W.tour.tiles, mode: 'paint', at: ['[data-value=paint]', '#retile', '#retile-slider', '#retile-apply:enabled'], mark: () => textOf(documentNow.value?.interface_nodes.length) },
  { ...W.tour.check, mode: 'look', at: ['[data-value=look]', '#solve-full'], mark: () => textOf(others.value.has('full')), isDone: () => others.value.has('full') },
  { ...W.tour.take, mode: 'look', at: ['#export'], mark: () => textOf(exportOpen.value) },
];

/** The step that one is at; null: there is no tour. */
export const tourStep = signal<number | null>(null);
export const stepDone = signal(false);
export const step = computed<Step | null>(() => (tourStep.value === null ? null : STEPS[tourStep.value]));
export const isLast = computed(() => tourStep.value === STEPS.length - 1);

let markAtFirst = '';

function beginStep(index: number | null): void {
  stepDone.value = false;
  if (index !== null) markAtFirst = STEPS[index].mark();
  tourStep.value = index;
}
export const startTour = (): void => beginStep(0);
/** Starts once another surface is shown: the request for it is answered before that. */
export function startTourAfter(before: StudioDocument | null): void {
  const stop = documentNow.subscribe((now) => {
    if (!now || now.vertices === before?.vertices) return;
    startTour();
    queueMicrotask(() => stop());
  });
}
export const leaveTour = (): void => beginStep(null);
export function nextStep(): void {
  const now = tourStep.peek();
  if (now === null || !stepDone.peek()) return;
  beginStep(isLast.peek() ? null : now + 1);
}

/** Once done, a step stays done. */
effect(() => {
  const now = step.value;
  if (now && documentNow.value && (now.isDone?.() || now.mark() !== markAtFirst)) stepDone.value = true;
});

/** The selectors that are worth pointing at: in another mode the way there is shown first. */
export const pointers = computed<readonly string[]>(() => {
  const now = step.value;
  if (!now || stepDone.value) return [];
  if (mode.value !== now.mode && now.at.length > 1) return now.at.slice(0, 1);
  return retileOpen.value ? now.at.filter((selector) => selector !== '#retile') : now.at;
});
