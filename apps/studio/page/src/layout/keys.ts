// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the page of layouts.

import { keysOf } from '../manners/keys';
import { redo, removeNode, selectedNode, undo } from './draft';
import { saveLayout, saveLayoutElsewhere } from './save';

const KEYS: Record<string, () => void> = {
  'Ctrl Z': () => void undo(),
  'Ctrl Shift Z': () => void redo(),
  'Ctrl Y': () => void redo(),
  'Ctrl S': () => void saveLayout(),
  'Ctrl Shift S': () => void saveLayoutElsewhere(),
  Delete: removeSelected,
  Backspace: removeSelected,
  Escape: () => (selectedNode.value = null),
};

export function removeSelected(): void {
  const node = selectedNode.peek();
  if (node !== null) void removeNode(node);
}

export function watchLayoutKeys(): void {
  window.addEventListener('keydown', (event) => {
    const isTyping = (event.target as HTMLElement).matches('input:not([type=checkbox]), select, textarea');
    if (event.altKey || (isTyping && !event.ctrlKey && !event.metaKey)) return;
    const keys = keysOf(event);
    const run = KEYS[keys];
    if (!run || (isTyping && !/S$/.test(keys))) return;
    event.preventDefault();
    run();
  });
}
