// SPDX-License-Identifier: GPL-3.0-or-later
// All patterns of the document's layout with their properties, asked once for each layout.

import { ask } from '../document/studio';
import { documentNow, patternTable } from '../document/store';
import { tell } from '../document/tell';

let asked: string | null = null;

export function wantPatterns(): void {
  const layout = documentNow.value?.layout;
  const wanted = layout ?? '';
  if (asked === wanted) return;
  asked = wanted;
  ask('patterns', layout ? { layout } : {}).then(
    (table) => (patternTable.value = table),
    (error: Error) => {
      asked = null;
      tell(error.message, 'error');
    },
  );
}
