// SPDX-License-Identifier: GPL-3.0-or-later

/** The keys that are pressed, as tables of shortcuts write them: "Ctrl Shift Z", "B", "Escape". */
export function keysOf(event: Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'shiftKey'>): string {
  const key = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const control = event.ctrlKey || event.metaKey ? 'Ctrl ' : '';
  return `${control}${control && event.shiftKey ? 'Shift ' : ''}${key}`;
}
