// SPDX-License-Identifier: GPL-3.0-or-later
// A layout with changes that were not saved is kept by the tab: when the page is loaded again, they are there.

import { effect } from '@preact/signals';
import { tell } from '../document/tell';
import { W } from '../words';
import { firstLayout } from './address';
import { draft, isUnsaved, openLayout, recoverLayout, type UnsavedLayout } from './draft';

/** Each layout that an address names has its own place. */
const place = (): string => `fretwork.layout ${firstLayout()}`;

/** What the tab has kept for this address; null: nothing that can be read. */
function kept(): UnsavedLayout | null {
  try {
    return JSON.parse(sessionStorage.getItem(place()) ?? 'null') as UnsavedLayout | null;
  } catch {
    return null;
  }
}

/** Keeps changes, once a layout is shown. */
export function keepUnsaved(): void {
  effect(() => {
    const now = draft.value;
    if (!now) return;
    const { layout, saved, path, hash } = now;
    if (isUnsaved.value) sessionStorage.setItem(place(), JSON.stringify({ layout, saved, path, hash } satisfies UnsavedLayout));
    else sessionStorage.removeItem(place());
  });
}

/** Shows the layout with its unsaved changes, if there are any, or else the one that the address names. */
export async function openFirst(): Promise<void> {
  const before = kept();
  if (before && (await recoverLayout(before))) return tell(W.layouts.restored);
  await openLayout(firstLayout());
}
