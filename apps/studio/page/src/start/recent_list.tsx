// SPDX-License-Identifier: GPL-3.0-or-later
// Project files that were open before.

import { FileText } from 'lucide-preact';
import { nameOf } from '../document/names';
import { recent } from '../document/recent';
import { W } from '../words';

export function RecentList({ open, busy }: { open: (path: string) => void; busy: boolean }) {
  if (recent.value.length === 0) return null;
  return (
    <>
      <h2>{W.recent.title}</h2>
      <ul class="recoverable">
        {recent.value.map((path) => (
          <li key={path}>
            <button type="button" class="recover" data-path={path} disabled={busy} onClick={() => open(path)}>
              <FileText aria-hidden /><b>{nameOf(path)}</b><span>{path}</span>
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}
