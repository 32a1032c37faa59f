// SPDX-License-Identifier: GPL-3.0-or-later
// The page's passing state: not part of the document, and not undone.

import { computed, signal } from '@preact/signals';
import { documentNow } from './store';
import { W } from '../words';

export type Mode = 'paint' | 'hold' | 'load' | 'design' | 'look';
export const MODES: { mode: Mode; title: string; key: string }[] = [
  { mode: 'paint', title: W.ui.paint, key: '1' },
  { mode: 'hold', title: W.ui.supports, key: '2' },
  { mode: 'load', title: W.ui.load, key: '3' },
  { mode: 'design', title: W.ui.design, key: '4' },
  { mode: 'look', title: W.ui.results, key: '5' },
];
export const mode = signal<Mode>('paint');
/** What a click in the plane means while one designs. */
export const designPicks = signal<'nodes' | 'tiles'>('nodes');
/** Whether the side view is open, where a target curve is drawn. */
export const sideViewOpen = signal(false);
/** Modes in which nodes are chosen. */
export const choosesNodes = computed(() => mode.value === 'hold' || mode.value === 'load' || (mode.value === 'design' && designPicks.value === 'nodes'));
export const choosesTiles = computed(() => mode.value === 'paint' || (mode.value === 'design' && designPicks.value === 'tiles'));

export type PaintTool = 'brush' | 'fill' | 'replace' | 'pick' | 'gradient' | 'select' | 'circle' | 'lasso';
export type NodeTool = 'select' | 'circle' | 'lasso' | 'rim';
export const paintTool = signal<PaintTool>('brush');
export const nodeTool = signal<NodeTool>('select');
/** How many rings of tiles around the one below the pointer a brush paints. */
export const brushRings = signal(0);

/** The pattern that is painted with. */
export const brush = signal<string | null>(null);
export const brushOrFirst = computed(() => brush.value ?? documentNow.value?.palette[0] ?? null);

export const selectedTiles = signal<ReadonlySet<number>>(new Set());
export const selectedNodes = signal<ReadonlySet<number>>(new Set());
/** The load, prescribed displacement or target whose row is open. */
export const activeEntry = signal<{ kind: 'load' | 'prescribed' | 'target'; index: number } | null>(null);

export type Split = 'both' | 'plane' | 'space';
export const split = signal<Split>('both');
/** How much of the views the plane has, when both are seen. */
export const share = signal(0.44);
export const galleryWide = signal(false);
export const helpOpen = signal(false);
export const startOpen = signal(false);

/** The node or bar whose values are shown, in either view. */
export const probed = signal<{ kind: 'node' | 'beam'; index: number } | null>(null);

/** Tiles that were painted here and are not yet confirmed by the server. */
export const pending = signal<ReadonlyMap<number, string>>(new Map());
