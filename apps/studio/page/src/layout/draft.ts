// SPDX-License-Identifier: GPL-3.0-or-later
// The layout that is drawn, with its undo. The program knows the rules: each change is a question to it.

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
const past = signal<readonly LayoutFile[]>([]);
const future = signal<readonly LayoutFile[]>([]);
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

/** Questions go one after the other: each changes what the one before has made. */
let last: Promise<unknown> = Promise.resolve();
function inTurn(action: () => Promise<void>): Promise<void> {
  const turn = last.then(action);
  last = turn;
  return turn;
}

/** Changes of one stroke are one step of undo; '' is none. */
let strokeBefore = '';

function show({ layout, nodes, edges }: LayoutLook, select: number | null): void {
  const now = draft.peek();
  if (!now) return;
  batch(() => {
    draft.value = { ...now, layout, nodes, edges };
    selectedNode.value = select;
    trouble.value = null;
  });
}

/** Asks for another layout than the one that is shown; takes it if it is one. */
async function draw(wanted: { layout?: LayoutFile; change?: LayoutChange }, stroke: string): Promise<void> {
  const now = draft.peek();
  if (!now) return;
  try {
    const next = await ask('draw_layout', { layout: now.layout, grid: grid.peek(), mirror: keepsMirror.peek(), ...wanted });
    const isOther = textOf(next.layout) !== textOf(now.layout);
    if (isOther && (stroke === '' || stroke !== strokeBefore)) past.value = [...past.peek(), now.layout].slice(-MOST_STEPS);
    if (isOther) [strokeBefore, future.value] = [stroke, []];
    show(next, next.node ?? (wanted.change && 'remove' in wanted.change ? null : selectedNode.peek()));
  } catch (error) {
    trouble.value = (error as Error).message;
  }
}

export async function openLayout(from: string): Promise<boolean> {
  ++numbering;
  try {
    const { layout, nodes, edges, path, hash } = await ask('open_layout', { from });
    batch(() => {
      draft.value = { layout, nodes, edges, path, hash, saved: textOf(layout) };
      [past.value, future.value, selectedNode.value, trouble.value] = [[], [], null, null];
    });
    return true;
  } catch (error) {
    tell((error as Error).message, 'error');
    return false;
  }
}

/** The layout that was just written to a file. */
export function savedAs(layout: LayoutFile, file: { path: string; hash: string }): void {
  const now = draft.peek();
  if (now) draft.value = { ...now, ...file, saved: textOf(layout) };
}

let strokes = 0;
export const newStroke = (): string => `stroke ${++strokes}`;

/** Grows when nodes may get other numbers. */
let numbering = 0;
function renumbering(change: LayoutChange): Promise<void> {
  ++numbering;
  return inTurn(() => draw({ change }, ''));
}

interface Move {
  node: number;
  to: Vector;
  stroke: string;
  numbering: number;
}
/** A node that has gone meanwhile, or has another number, is not moved. */
const moves = new Latest<Move>(({ node, to, stroke, numbering: then }) =>
  inTurn(async () => {
    if (then === numbering) await draw({ change: { move: node, to } }, stroke);
  }),
);
/** While a node is dragged: places that were overtaken are not asked for. */
export const moveNode = (node: number, to: Vector, stroke: string): void => moves.push({ node, to, stroke, numbering });

export const addNode = (add: NodeKind, to?: Vector): Promise<void> => renumbering({ add, ...(to ? { to } : {}) });
export const removeNode = (remove: number): Promise<void> => renumbering({ remove });
export const rename = (name: string): Promise<void> =>
  inTurn(async () => {
    const now = draft.peek();
    if (now && now.layout.name !== name) await draw({ layout: { ...now.layout, name } }, '');
  });

/** Goes to a layout of the history, which was one already. */
function goBack(from: typeof past, to: typeof past): Promise<void> {
  ++numbering;
  return inTurn(async () => {
    const now = draft.peek();
    const layout = from.peek().at(-1);
    if (!now || !layout) return;
    try {
      const look = await ask('draw_layout', { layout });
      [from.value, to.value, strokeBefore] = [from.peek().slice(0, -1), [...to.peek(), now.layout], ''];
      show(look, null);
    } catch (error) {
      trouble.value = (error as Error).message;
    }
  });
}
export const undo = (): Promise<void> => goBack(past, future);
export const redo = (): Promise<void> => goBack(future, past);
