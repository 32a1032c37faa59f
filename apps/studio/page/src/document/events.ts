// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the messages of the server into the signals of the store.

import { batch } from '@preact/signals';
import type { Beams, Solution } from '../protocol/binary';
import type { Reaction, ServerEvent, Solved, StudioDocument } from '../protocol/messages';
import { designed, designing, takeDesigned, takeDesigning } from './design';
import * as store from './store';
import { target } from './target';
import { lookedAt } from './truth';
import { tell } from './tell';
import { activeEntry, pending, selectedNodes, selectedTiles } from './ui';
import { W } from '../words';

/** Which event the next solution belongs to: a binary message follows the event that announces it. */
type Awaited = { of: 'solved'; info: Solved } | { of: 'compared' } | { of: 'modes' } | null;
let awaited: Awaited = null;

/** For a new connection: what the old one announced does not come. */
export function forgetAwaited(): void {
  awaited = null;
}

export function takeEvent(message: ServerEvent): void {
  batch(() => {
    store.revision.value = Math.max(store.revision.value, message.revision);
    take(message);
  });
}

function take(message: ServerEvent): void {
  switch (message.event) {
    case 'document':
      forget(message);
      store.documentNow.value = message;
      if (message.recovered) tell(W.events.unsavedChangesWereRestored);
      break;
    case 'changed':
      change(message);
      break;
    case 'solving':
      store.working.value = { model: message.model, share: message.share, background: message.background === true };
      break;
    case 'solved':
      awaited = { of: 'solved', info: { ...message, reactions: message.reactions?.map(reactionOf) } };
      break;
    case 'failed':
      failed(message);
      break;
    case 'modes':
      awaited = { of: 'modes' };
      store.working.value = null;
      store.shapes.value = { kind: message.kind, fields: [], values: message.values, shapes: [], expected: message.values.length };
      break;
    case 'compared':
      awaited = { of: 'compared' };
      store.compared.value = { mean: message.mean, largest: message.largest, relative: message.relative, solution: null };
      store.working.value = null;
      break;
    case 'making':
      store.making.value = message;
      break;
    case 'designing':
      takeDesigning(message);
      break;
    case 'designed':
      takeDesigned(message);
      break;
    case 'model_error':
      store.estimated.value = message;
      break;
    case 'warning':
      tell(message.text, 'warning');
      break;
    case 'layout_count':
      store.countSoFar.value = message;
      break;
  }
}

/** Reactions are rows of seven numbers, or written out. */
function reactionOf(row: Reaction | number[]): Reaction {
  if (!Array.isArray(row)) return row;
  const [node, fx, fy, fz, mx, my, mz] = row;
  return { node, force: [fx, fy, fz], moment: [mx, my, mz] };
}

/** A target is of the nodes of one surface. */
const isSameSurface = (next: StudioDocument): boolean =>
  JSON.stringify(store.documentNow.peek()?.interface_nodes) === JSON.stringify(next.interface_nodes);

function forget(next: StudioDocument): void {
  if (!isSameSurface(next)) forgetNumbers();
  [designing.value, designed.value] = [null, null];
  store.estimated.value = null;
  pending.value = new Map();
  store.live.value = null;
  store.problem.value = null;
  store.others.value = new Map();
  store.working.value = null;
  store.compared.value = null;
  store.shapes.value = null;
  forgetMaking();
}

/** Numbers of tiles and nodes have no meaning on other tiles. */
function forgetNumbers(): void {
  target.value = [];
  selectedTiles.value = new Set();
  selectedNodes.value = new Set();
  activeEntry.value = null;
}

function forgetMaking(): void {
  store.making.value = null;
  lookedAt.value = null;
}

/** Forgets the pending paint that is now in the document. */
function confirmPainting(): void {
  const now = store.documentNow.value as StudioDocument;
  const ahead = [...pending.value].filter(([tile, pattern]) => (now.palette[now.painting[tile]] ?? '') !== pattern);
  if (ahead.length !== pending.value.size) pending.value = new Map(ahead);
}

/** Results of an earlier state no longer hold once something that they depend on is edited. */
function change(message: Partial<StudioDocument>): void {
  const before = store.documentNow.value;
  if (!before) return;
  if (message.tiles) forget({ ...before, ...message });
  store.documentNow.value = { ...before, ...message };
  if (message.painting) confirmPainting();
  if (message.painting || message.turns || message.setting) forgetMaking();
  const selects = message.selected_load_case !== undefined && message.selected_load_case !== before.selected_load_case;
  if (message.painting || message.turns || message.load_cases || message.setting || selects) {
    store.others.value = new Map();
    store.compared.value = null;
    store.shapes.value = null;
    designed.value = null;
    store.estimated.value = null;
  }
  if (message.model !== undefined || message.tile_models) store.estimated.value = null;
}

function failed({ error, model, background, revision }: { error: string; model: string; background?: boolean; revision: number }): void {
  if (model === 'design') designing.value = null;
  else store.working.value = null;
  if (!background) [store.live.value, store.problem.value, store.answered.value, store.positioned.value] = [null, error, revision, revision];
  else if (error !== 'cancelled') tell(error, 'error');
}

export function takeBinary(message: Beams | Solution): void {
  if (message.kind === 'beams') {
    store.beams.value = message;
    return;
  }
  const target = awaited;
  if (!target || !store.beams.value) return;
  batch(() => {
    if (target.of === 'solved') solved(target.info, message, store.beams.value as Beams);
    else if (target.of === 'compared' && store.compared.value) store.compared.value = { ...store.compared.value, solution: message };
    else if (target.of === 'modes' && store.shapes.value) addShape(message);
  });
}

function addShape(solution: Solution): void {
  const shape = store.shapes.value;
  if (shape) store.shapes.value = { ...shape, shapes: [...shape.shapes, solution] };
}

function solved(info: Solved, solution: Solution, beams: Beams): void {
  if (solution.of !== beams.revision) return;
  if (info.step !== undefined) {
    const first = info.step === 1 || store.shapes.value?.kind !== 'path';
    const before = first ? { kind: 'path' as const, fields: info.fields, values: [], shapes: [], expected: info.steps ?? 0 } : (store.shapes.value as store.Shape);
    store.shapes.value = { ...before, values: [...before.values, info.load_factor], shapes: [...before.shapes, solution] };
    if (info.step === info.steps) store.working.value = null;
    return;
  }
  const model = { info, solution, beams };
  if (info.background) {
    store.others.value = new Map(store.others.value).set(info.model, model);
    store.working.value = null;
    return;
  }
  store.positioned.value = info.revision;
  if (info.provisional) {
    const before = store.live.peek()?.info;
    store.live.value = { ...model, info: { ...info, reactions: before?.reactions, seconds: before?.seconds ?? 0 } };
    return;
  }
  store.live.value = model;
  store.answered.value = info.revision;
  store.problem.value = null;
  if (!store.working.value?.background) store.working.value = null;
}
