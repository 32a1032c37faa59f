// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a person can do to the document, one verb each.

import type { Load, LoadCase, Prescribed, Selection, SentLoadCase, Setting, Support } from '../protocol/messages';
import { Latest } from '../protocol/latest';
import type { PaintRequest, SentFile } from '../protocol/requests';
import { isRule } from './picked';
import { ask, tryAsk } from './studio';
import { documentNow, loadCase, working } from './store';
import { timeUntil } from './latency';
import { settled, shownAnew } from './settled';
import { tell } from './tell';
import { pending, selectedTiles } from './ui';

export const undo = (): void => void tryAsk('undo');
export const redo = (): void => void tryAsk('redo');

/** Edits with the same key that follow one another are one step of undo: a stroke, a drag. */
let gestures = 0;
export const newGesture = (what: string): string => `${what}-${++gestures}`;

/** An edit that changes nothing is answered, and no event follows. */
const hasChanged = (answer: { unchanged?: boolean } | null): boolean => answer !== null && !answer.unchanged;

/** Resolves to true if the surface has changed. */
async function sendPaint(request: PaintRequest): Promise<boolean> {
  const answer = await tryAsk('paint', request);
  for (const remark of answer?.remarks ?? []) tell(remark, 'warning');
  const isChanged = hasChanged(answer);
  if (!isChanged) pending.value = new Map();
  return isChanged;
}

export const paint = (tiles: readonly number[], pattern: string): void => void sendPaint({ tiles, pattern });

/** In the words of `fretwork paint`. The program decides which pattern each tile gets. */
export interface PaintingChoice {
  patterns: string;
  palette: readonly string[];
  /** The file that `image:` reads. */
  file?: SentFile;
}
/** Paints the selected tiles, or all. */
export function paintBy({ patterns, palette, file }: PaintingChoice): void {
  const chosen = [...selectedTiles.peek()];
  void sendPaint({ tiles: chosen.length ? chosen : undefined, patterns, palette: palette.join(','), file });
}

export const turn = (tiles: number[], by: number): void => void tryAsk('turn', { tiles, by });
export const setModel = (model: string): void => void tryAsk('set_model', { model });
export const setTileModel = (tiles: number[], model: string): void => void tryAsk('set_tile_model', { tiles, model });
export const setSetting = (setting: Setting, merge?: string): void => void tryAsk('set_setting', { setting, merge });
export const selectLoadCase = (index: number): void => void tryAsk('select_load_case', { index });
export const removeLoadCase = (index: number): void => void tryAsk('remove_load_case', { index });

const EMPTY: LoadCase = { name: 'load case 1', supports: [], loads: [], prescribed: [], gravity: [0, 0, 0] };

export function addLoadCase(from: Partial<LoadCase> = {}): void {
  const cases = documentNow.value?.load_cases ?? [];
  const names = new Set(cases.map((one) => one.name));
  let number = cases.length + 1;
  while (names.has(`load case ${number}`)) ++number;
  const load_case = stated({ ...EMPTY, ...from, name: from.name ?? `load case ${number}` });
  void tryAsk('set_load_case', { index: cases.length, load_case });
}

/** Change the selected load case, or make the first one. */
export function editLoadCase(change: (present: LoadCase) => Partial<LoadCase>, merge?: string): Promise<{ unchanged?: boolean } | null> {
  const now = documentNow.value;
  if (!now) return Promise.resolve(null);
  const present = loadCase.value ?? EMPTY;
  const index = now.load_cases.length ? now.selected_load_case : 0;
  return tryAsk('set_load_case', { index, load_case: stated({ ...present, ...change(present) }), merge });
}

/** A load case without its marks, which the program computes. */
function stated({ marks: _, ...load_case }: LoadCase & Partial<SentLoadCase>): LoadCase {
  return load_case;
}

/** Let another load case act as well, times a factor; 0 turns it off. */
export const combine = (name: string, factor: number): void =>
  void editLoadCase(({ combines = [] }) => {
    const rest = combines.filter(({ load_case }) => load_case !== name);
    return { combines: factor === 0 ? rest : [...rest, { load_case: name, factor }] };
  });

/** Resolves when the effect of an edit is shown, if only provisionally, or when an error is shown. */
async function seen(edit: () => Promise<boolean>): Promise<void> {
  const [done, shown] = [settled(), shownAnew()];
  const changing = edit();
  timeUntil(changing.then((isChanged) => isChanged && shown));
  if (await changing) await Promise.race([done, shown]);
}

const drag = new Latest<{ change: (present: LoadCase) => Partial<LoadCase>; merge: string }>(async ({ change, merge }) => {
  await seen(() => editLoadCase(change, merge).then(hasChanged));
});
/** As editLoadCase, for drags: an edit is sent when the last one is shown, if only provisionally. */
export const dragLoadCase = (change: (present: LoadCase) => Partial<LoadCase>, merge: string): void => drag.push({ change, merge });

const settingDrag = new Latest<{ setting: Setting; merge: string }>(async (request) => {
  await seen(() => tryAsk('set_setting', request).then(hasChanged));
});
/** As setSetting, while something is dragged. */
export const dragSetting = (setting: Setting, merge: string): void => settingDrag.push({ setting, merge });

const strokes = new Latest<{ merge: string }>(async ({ merge }) => {
  const groups = byPattern(pendingPaint);
  pendingPaint.clear();
  await seen(async () => {
    let isChanged = false;
    for (const [pattern, tiles] of groups) isChanged = (await sendPaint({ tiles, pattern, merge })) || isChanged;
    return isChanged;
  });
});
const pendingPaint = new Map<number, string>();
/** Tiles of one stroke; those not sent yet go together. */
export function strokeTo(tiles: readonly number[], pattern: string, merge: string): void {
  for (const tile of tiles) pendingPaint.set(tile, pattern);
  strokes.push({ merge });
}

/** By pattern: the brush may have changed between two strokes that wait. */
function byPattern(painted: ReadonlyMap<number, string>): Map<string, number[]> {
  const groups = new Map<string, number[]>();
  painted.forEach((pattern, tile) => groups.set(pattern, [...(groups.get(pattern) ?? []), tile]));
  return groups;
}

const replaced = <T>(list: readonly T[] | undefined, index: number, entry: T): T[] =>
  (list ?? []).map((old, i) => (i === index ? entry : old));
const without = <T>(list: readonly T[] | undefined, index: number): T[] => (list ?? []).filter((_, i) => i !== index);

/**
 * Holds nodes. Earlier supports let them go. One that is a rule, such as a side, a box or a circle, stays
 * whole if it has other nodes, too, and if the new support fixes as much.
 */
export function hold({ where, nodes }: { where: Selection; nodes: readonly number[] }, fixed: Support['fixed'], held: readonly number[][]): void {
  const taken = new Set(nodes);
  const isWithin = (support: Support) => isRule(support) && support.fixed.every((dof) => fixed.includes(dof));
  void editLoadCase(({ supports = [] }) => {
    const rest = supports.flatMap((support, i) => {
      const kept = held[i].filter((node) => !taken.has(node));
      if (kept.length === held[i].length || (kept.length && isWithin(support))) return [support];
      return kept.length ? [{ nodes: kept, fixed: support.fixed }] : [];
    });
    return { supports: fixed.length ? [...rest, { ...where, fixed }] : rest };
  });
}
export const replaceSupport = (index: number, support: Support): void =>
  void editLoadCase(({ supports }) => ({ supports: replaced(supports, index, support) }));
export const removeSupport = (index: number): void => void editLoadCase(({ supports }) => ({ supports: without(supports, index) }));

export const addLoad = (load: Load): void => void editLoadCase(({ loads = [] }) => ({ loads: [...loads, load] }));
export const replaceLoad = (index: number, load: Load): void => void editLoadCase(({ loads }) => ({ loads: replaced(loads, index, load) }));
export const dragLoad = (index: number, load: Load, merge: string): void =>
  dragLoadCase(({ loads }) => ({ loads: replaced(loads, index, load) }), merge);
export const removeLoad = (index: number): void => void editLoadCase(({ loads }) => ({ loads: without(loads, index) }));

export const addPrescribed = (entry: Prescribed): void =>
  void editLoadCase(({ prescribed = [] }) => ({ prescribed: [...prescribed, entry] }));
export const replacePrescribed = (index: number, entry: Prescribed): void =>
  void editLoadCase(({ prescribed }) => ({ prescribed: replaced(prescribed, index, entry) }));
export const dragPrescribed = (index: number, entry: Prescribed, merge: string): void =>
  dragLoadCase(({ prescribed }) => ({ prescribed: replaced(prescribed, index, entry) }), merge);
export const removePrescribed = (index: number): void =>
  void editLoadCase(({ prescribed }) => ({ prescribed: without(prescribed, index) }));

/** Compare the live model with the full one: solve that in the background, then ask for the difference. */
export async function solveFull(): Promise<void> {
  working.value = { model: 'full', share: 0, background: true };
  if (!(await tryAsk('solve', { model: 'full', background: true }))) working.value = null;
}
export const cancelWork = (): void => void ask('cancel').catch(() => undefined);
