// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the page of layouts.

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

function pressed(event: KeyboardEvent): string {
  const key = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const control = event.ctrlKey || event.metaKey ? 'Ctrl ' : '';
  return `${control}${control && event.shiftKey ? 'Shift ' : ''}${key}`;
}

export function watchLayoutKeys(): void {
  window.addEventListener('keydown', (event) => {
    const isTyping = (event.target as HTMLElement).matches('input:not([type=checkbox]), select, textarea');
    if (event.altKey || (isTyping && !event.ctrlKey && !event.metaKey)) return;
    const run = KEYS[pressed(event)];
    if (!run || (isTyping && !/S$/.test(pressed(event)))) return;
    event.preventDefault();
    run();
  });
}
