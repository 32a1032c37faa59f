// SPDX-License-Identifier: GPL-3.0-or-later
// The keys, in one table: what they do and what the help sheet says.

import { redo, turn, undo } from '../document/edits';
import { save, saveElsewhere } from '../document/save';
import { DOFS } from '../protocol/messages';
import { documentNow } from '../document/store';
import {
  activeEntry, brushRings, galleryWide, helpOpen, mode, MODES, nodeTool, paintTool, probed, selectedNodes, selectedTiles, split, startOpen, type NodeTool,
  type PaintTool,
} from '../document/ui';
import { holdChosen } from '../panels/hold_panel';
import { pressChosen } from '../panels/load_panel';
import { currentScene } from '../views/space/current';
import { switchProjection } from '../views/space/view_bar';
import { fit } from '../views/plane/viewport';
import { keysOf } from './keys';
import { W } from '../words';

export interface Shortcut {
  keys: string;
  words: string;
  group: string;
  run: () => void;
}

const paintWith = (tool: PaintTool) => () => {
  if (mode.value === 'paint') paintTool.value = tool;
};
function chooseWith(tool: NodeTool & PaintTool): () => void {
  return () => {
    if (mode.value === 'paint') paintTool.value = tool;
    else nodeTool.value = tool;
  };
}
const holding = (fixed: Parameters<typeof holdChosen>[0]) => () => mode.value === 'hold' && holdChosen(fixed);
const wider = (by: number) => () => (brushRings.value = Math.min(5, Math.max(0, brushRings.value + by)));

function letGo(): void {
  if (helpOpen.value) helpOpen.value = false;
  else if (startOpen.value && documentNow.value) startOpen.value = false;
  else if (probed.value) probed.value = null;
  else {
    selectedTiles.value = new Set();
    selectedNodes.value = new Set();
    activeEntry.value = null;
  }
}

function fixOrPress(): void {
  if (mode.value === 'hold') holdChosen([...DOFS]);
  if (mode.value === 'load') pressChosen();
}

export const SHORTCUTS: Shortcut[] = [
  { keys: 'Ctrl Z', words: W.shortcuts.undo, group: W.shortcuts.document, run: undo },
  { keys: 'Ctrl Shift Z', words: W.shortcuts.redo, group: W.shortcuts.document, run: redo },
  { keys: 'Ctrl Y', words: W.shortcuts.redo, group: W.shortcuts.document, run: redo },
  { keys: 'Ctrl S', words: W.shortcuts.save, group: W.shortcuts.document, run: () => void save() },
  { keys: 'Ctrl Shift S', words: W.saveAs.title, group: W.shortcuts.document, run: () => void saveElsewhere() },
  ...MODES.map((row) => ({ keys: row.key, words: row.title, group: W.shortcuts.mode, run: () => (mode.value = row.mode) })),
  { keys: 'B', words: W.shortcuts.brush, group: W.shortcuts.paint, run: paintWith('brush') },
  { keys: 'G', words: W.shortcuts.fillConnectedTiles, group: W.shortcuts.paint, run: paintWith('fill') },
  { keys: 'R', words: W.shortcuts.replaceAPatternEverywhere, group: W.shortcuts.paint, run: paintWith('replace') },
  { keys: 'I', words: W.shortcuts.pickAPatternOr, group: W.shortcuts.paint, run: paintWith('pick') },
  { keys: 'D', words: W.shortcuts.gradient, group: W.shortcuts.paint, run: paintWith('gradient') },
  { keys: '[', words: W.shortcuts.narrowerBrush, group: W.shortcuts.paint, run: wider(-1) },
  { keys: ']', words: W.shortcuts.widerBrush, group: W.shortcuts.paint, run: wider(1) },
  { keys: 'T', words: W.shortcuts.rotateTheSelectedTiles, group: W.shortcuts.paint, run: () => selectedTiles.value.size && turn([...selectedTiles.value], 1) },
  { keys: 'C', words: W.shortcuts.patternChart, group: W.shortcuts.paint, run: () => (galleryWide.value = !galleryWide.value) },
  { keys: 'V', words: W.shortcuts.selectByClickOr, group: W.shortcuts.select, run: chooseWith('select') },
  { keys: 'K', words: W.shortcuts.selectWithACircle, group: W.shortcuts.select, run: chooseWith('circle') },
  { keys: 'L', words: W.shortcuts.selectWithALasso, group: W.shortcuts.select, run: chooseWith('lasso') },
  { keys: 'E', words: W.shortcuts.selectAlongTheEdge, group: W.shortcuts.select, run: () => (nodeTool.value = 'rim') },
  { keys: 'Escape', words: W.shortcuts.clearSelection, group: W.shortcuts.select, run: letGo },
  { keys: 'X', words: W.shortcuts.fixTheSelectedNodes, group: W.shortcuts.supportsAndLoads, run: fixOrPress },
  { keys: 'P', words: W.shortcuts.pinTheSelectedNodes, group: W.shortcuts.supportsAndLoads, run: holding(['ux', 'uy', 'uz']) },
  { keys: 'O', words: W.shortcuts.putTheSelectedNodes, group: W.shortcuts.supportsAndLoads, run: holding(['uz']) },
  { keys: '6', words: W.shortcuts.isometric, group: W.shortcuts.view, run: () => currentScene.value?.look('iso') },
  { keys: '7', words: W.shortcuts.top, group: W.shortcuts.view, run: () => currentScene.value?.look('top') },
  { keys: '8', words: W.shortcuts.front, group: W.shortcuts.view, run: () => currentScene.value?.look('front') },
  { keys: '9', words: W.cameras.parallel, group: W.shortcuts.view, run: switchProjection },
  { keys: 'F', words: W.shortcuts.fitDView, group: W.shortcuts.view, run: () => currentScene.value?.look(null) },
  { keys: '0', words: W.shortcuts.fitDView2, group: W.shortcuts.view, run: fit },
  { keys: 'Tab ↹', words: W.shortcuts.nextControl, group: W.shortcuts.view, run: () => undefined },
  { keys: '\\', words: W.shortcuts.dDOrBoth, group: W.shortcuts.view, run: () => (split.value = { both: 'space', space: 'plane', plane: 'both' }[split.value] as typeof split.value) },
  { keys: '?', words: W.shortcuts.thisHelp, group: W.shortcuts.view, run: () => (helpOpen.value = !helpOpen.value) },
];

export function watchKeys(): void {
  window.addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement;
    if (target.matches('input:not([type=range]):not([type=checkbox]), select, textarea') || event.altKey) return;
    const shortcut = SHORTCUTS.find(({ keys }) => keys === keysOf(event));
    if (!shortcut) return;
    event.preventDefault();
    shortcut.run();
  });
}
