// SPDX-License-Identifier: GPL-3.0-or-later
// The keys, in one table: what they do and what the help sheet says.

import { redo, turn, undo } from '../document/edits';
import { save } from '../document/save';
import { DOFS } from '../protocol/messages';
import { documentNow } from '../document/store';
import {
  activeEntry, brushRings, galleryWide, helpOpen, mode, MODES, nodeTool, paintTool, probed, selectedNodes, selectedTiles, split, startOpen, type NodeTool,
  type PaintTool,
} from '../document/ui';
import { holdChosen } from '../panels/hold_panel';
import { pressChosen } from '../panels/load_panel';
import { currentScene } from '../views/space/current';
import { fit } from '../views/plane/viewport';

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
  { keys: 'Ctrl Z', words: 'Undo', group: 'Document', run: undo },
  { keys: 'Ctrl Shift Z', words: 'Redo', group: 'Document', run: redo },
  { keys: 'Ctrl Y', words: 'Redo', group: 'Document', run: redo },
  { keys: 'Ctrl S', words: 'Save', group: 'Document', run: () => void save() },
  ...MODES.map((row) => ({ keys: row.key, words: row.title, group: 'What to do', run: () => (mode.value = row.mode) })),
  { keys: 'B', words: 'Brush', group: 'Paint', run: paintWith('brush') },
  { keys: 'G', words: 'Fill connected tiles', group: 'Paint', run: paintWith('fill') },
  { keys: 'R', words: 'Replace a pattern everywhere', group: 'Paint', run: paintWith('replace') },
  { keys: 'I', words: 'Pick a pattern (or Alt and click)', group: 'Paint', run: paintWith('pick') },
  { keys: 'D', words: 'Gradient', group: 'Paint', run: paintWith('gradient') },
  { keys: '[', words: 'Narrower brush', group: 'Paint', run: wider(-1) },
  { keys: ']', words: 'Wider brush', group: 'Paint', run: wider(1) },
  { keys: 'T', words: 'Turn the selected tiles', group: 'Paint', run: () => selectedTiles.value.size && turn([...selectedTiles.value], 1) },
  { keys: 'C', words: 'Chart of patterns', group: 'Paint', run: () => (galleryWide.value = !galleryWide.value) },
  { keys: 'V', words: 'Choose by click or box (Shift adds)', group: 'Choose', run: chooseWith('select') },
  { keys: 'L', words: 'Choose with a lasso', group: 'Choose', run: chooseWith('lasso') },
  { keys: 'E', words: 'Choose a stretch of the rim', group: 'Choose', run: () => (nodeTool.value = 'rim') },
  { keys: 'Escape', words: 'Choose nothing', group: 'Choose', run: letGo },
  { keys: 'X', words: 'Fix the chosen nodes; in Load: a force on them', group: 'Hold and load', run: fixOrPress },
  { keys: 'P', words: 'Pin the chosen nodes', group: 'Hold and load', run: holding(['ux', 'uy', 'uz']) },
  { keys: 'O', words: 'Put the chosen nodes on rollers', group: 'Hold and load', run: holding(['uz']) },
  { keys: '5', words: 'From the corner', group: 'View', run: () => currentScene.value?.look('iso') },
  { keys: '6', words: 'From above', group: 'View', run: () => currentScene.value?.look('top') },
  { keys: '7', words: 'From the front', group: 'View', run: () => currentScene.value?.look('front') },
  { keys: 'F', words: 'See all of it in space', group: 'View', run: () => currentScene.value?.look(null) },
  { keys: '0', words: 'See all of it in the plane', group: 'View', run: fit },
  { keys: 'Tab ↹', words: 'Through all controls', group: 'View', run: () => undefined },
  { keys: '\\', words: 'Plane, space, or both', group: 'View', run: () => (split.value = { both: 'space', space: 'plane', plane: 'both' }[split.value] as typeof split.value) },
  { keys: '?', words: 'This sheet', group: 'View', run: () => (helpOpen.value = !helpOpen.value) },
];

function pressed(event: KeyboardEvent): string {
  const key = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const control = event.ctrlKey || event.metaKey ? 'Ctrl ' : '';
  return `${control}${control && event.shiftKey ? 'Shift ' : ''}${key}`;
}

export function watchKeys(): void {
  window.addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement;
    if (target.matches('input:not([type=range]):not([type=checkbox]), select, textarea') || event.altKey) return;
    const shortcut = SHORTCUTS.find(({ keys }) => keys === pressed(event));
    if (!shortcut) return;
    event.preventDefault();
    shortcut.run();
  });
}
