// SPDX-License-Identifier: GPL-3.0-or-later
// The layout that is drawn, with its undo. The program knows the rules: each change is a request to it.

import { batch, computed, signal } from '@preact/signals';
import { ask } from '../document/studio';
import { tell } from '../document/tell';
import { Latest } from '../protocol/latest';
import type { Vector } from '../protocol/messages';
import type { LayoutChange, LayoutFile, LayoutLook, NodeKind } from '../protocol/requests';

export interface Draft extends LayoutLook {
  /** Its file on the server's machine; null: none yet. */
  path: string | null;
  /** Of the file as it was read or written last. */
  hash: string | null;
  /** The layout as it was opened or saved, as text. */
  saved: string;
}
export const draft = signal<Draft | null>(null);
/** Layouts with their nodes and edges, so that undo and redo ask the program nothing. */
const past = signal<readonly LayoutLook[]>([]);
const future = signal<readonly LayoutLook[]>([]);
const MOST_STEPS = 500;
export const canUndo = computed(() => past.value.length > 0);
export const canRedo = computed(() => future.value.length > 0);

/** The node that is selected. */
export const selectedNode = signal<number | null>(null);
/** Why the last change was refused. */
export const trouble = signal<string | null>(null);
export const GRIDS = [12, 20, 24, 60, 120, 1000] as const;
export const grid = signal<number>(60);
export const keepsMirror = signal(true);

export const textOf = (layout: LayoutFile): string => JSON.stringify(layout);
export const isUnsaved = computed(() => draft.value !== null && draft.value.saved !== textOf(draft.value.layout));

/** Requests wait for one another: each starts from what the one before has left. */
let last: Promise<unknown> = Promise.resolve();
export function inTurn<Result>(action: () => Promise<Result>): Promise<Result> {
  const turn = last.then(action);
  last = turn.catch(() => undefined);
  return turn;
}
/** Resolves when all changes so far are made or refused. */
export const changesMade = (): Promise<void> => inTurn(() => Promise.resolve());

/** How many layouts have been opened. */
let opened = 0;
/** A change of the layout that is shown now. It is dropped if another layout is opened before its turn. */
function changing(change: () => Promise<void>): Promise<void> {
  const then = opened;
  return inTurn(async () => {
    if (then === opened) await change();
  });
}

/** Changes of one gesture are one step of undo; '' is none. */
let gestureBefore = '';

const lookOf = ({ layout, nodes, edges }: LayoutLook): LayoutLook => ({ layout, nodes, edges });

function show(look: LayoutLook, select: number | null): void {
  const now = draft.peek();
  if (!now) return;
  batch(() => {
    draft.value = { ...now, ...lookOf(look) };
    selectedNode.value = select;
    trouble.value = null;
  });
}

/** Asks the program for a changed layout, and shows the layout or the reason for a refusal. */
async function draw(wanted: { layout?: LayoutFile; change?: LayoutChange }, gesture: string): Promise<void> {
  const now = draft.peek();
  if (!now) return;
  try {
    const next = await ask('draw_layout', { layout: now.layout, grid: grid.peek(), mirror: keepsMirror.peek(), ...wanted });
    const isOther = textOf(next.layout) !== textOf(now.layout);
    if (isOther && (gesture === '' || gesture !== gestureBefore)) past.value = [...past.peek(), lookOf(now)].slice(-MOST_STEPS);
    if (isOther) [gestureBefore, future.value] = [gesture, []];
    show(next, next.node ?? (wanted.change && 'remove' in wanted.change ? null : selectedNode.peek()));
  } catch (error) {
    trouble.value = (error as Error).message;
  }
}

/** Shows a layout in the place of the present one. */
function begin(next: Draft, before: readonly LayoutLook[]): void {
  ++opened;
  ++numbering;
  gestureBefore = '';
  batch(() => {
    draft.value = next;
    [past.value, future.value, selectedNode.value, trouble.value] = [before, [], null, null];
  });
}

/** Waits for earlier requests, so that the layout that was asked for last is shown. */
export function openLayout(from: string): Promise<boolean> {
  return inTurn(async () => {
    try {
      const { path, hash, ...look } = await ask('open_layout', { from });
      begin({ ...lookOf(look), path, hash, saved: textOf(look.layout) }, []);
      return true;
    } catch (error) {
      tell((error as Error).message, 'error');
      return false;
    }
  });
}

/** What is left of a layout whose changes were not saved. */
export type UnsavedLayout = Pick<Draft, 'layout' | 'saved' | 'path' | 'hash'>;

/** Shows a layout with its unsaved changes again: undo gives back what was saved. Resolves to whether the program takes it. */
export function recoverLayout({ layout, saved, path, hash }: UnsavedLayout): Promise<boolean> {
  return inTurn(async () => {
    try {
      const before = await ask('draw_layout', { layout: JSON.parse(saved) as LayoutFile });
      const now = await ask('draw_layout', { layout });
      begin({ ...lookOf(now), path, hash, saved: textOf(before.layout) }, [lookOf(before)]);
      return true;
    } catch {
      return false; // the page begins with another layout
    }
  });
}

/** Notes that a layout was written to a file. */
export function savedAs(layout: LayoutFile, file: { path: string; hash: string }): void {
  const now = draft.peek();
  if (now) draft.value = { ...now, ...file, saved: textOf(layout) };
}

/** Grows when nodes may get other numbers. */
let numbering = 0;
function renumbering(change: LayoutChange): Promise<void> {
  ++numbering;
  return changing(() => draw({ change }, ''));
}

interface Move {
  node: number;
  to: Vector;
  gesture: string;
  numbering: number;
}
/** A node that has gone meanwhile, or has another number, is not moved. */
const moves = new Latest<Move>(({ node, to, gesture, numbering: then }) =>
  inTurn(async () => {
    if (then === numbering) await draw({ change: { move: node, to } }, gesture);
  }),
);
/** While a node is dragged: places that were overtaken are not asked for. */
export const moveNode = (node: number, to: Vector, gesture: string): void => moves.push({ node, to, gesture, numbering });

export const addNode = (add: NodeKind, to?: Vector): Promise<void> => renumbering({ add, ...(to ? { to } : {}) });
export const removeNode = (remove: number): Promise<void> => renumbering({ remove });
export const rename = (name: string): Promise<void> =>
  changing(async () => {
    const now = draft.peek();
    if (now && now.layout.name !== name) await draw({ layout: { ...now.layout, name } }, '');
  });

/** Goes to a layout of the history. */
function goBack(from: typeof past, to: typeof past): Promise<void> {
  ++numbering;
  return changing(async () => {
    const now = draft.peek();
    const look = from.peek().at(-1);
    if (!now || !look) return;
    batch(() => {
      [from.value, to.value] = [from.peek().slice(0, -1), [...to.peek(), lookOf(now)]];
      show(look, null);
    });
    gestureBefore = '';
  });
}
export const undo = (): Promise<void> => goBack(past, future);
export const redo = (): Promise<void> => goBack(future, past);
