// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with changes that were never saved: what a studio showed when it ended, or before another took its place.

import { useEffect } from 'preact/hooks';
import { History, Trash2 } from 'lucide-preact';
import { recoverable } from '../document/store';
import { ask, tryAsk } from '../document/studio';
import type { Recoverable } from '../protocol/messages';
import { Button } from '../widgets/widgets';
import { W } from '../words';

const take = (answer: { recoverable: Recoverable[] } | null) => answer && (recoverable.value = answer.recoverable);

function when(seconds: number): string {
  const then = new Date(1000 * seconds);
  const isToday = then.toDateString() === new Date().toDateString();
  const time = then.toLocaleTimeString([], { hour: '2-digit', minute: '2-digit' });
  return isToday ? W.recoverList.today(time) : `${then.toLocaleDateString([], { day: 'numeric', month: 'long', year: 'numeric' })}, ${time}`;
}

export function RecoverList({ open, busy }: { open: (key: string) => void; busy: boolean }) {
  useEffect(() => void ask('recoverable').then(take, () => undefined), []);
  const list = recoverable.value;
  if (list.length === 0) return null;
  return (
    <>
      <h2>{W.recoverList.notSavedYet}</h2>
      <ul class="recoverable">
        {list.map(({ key, name, path, time, tiles }) => (
          <li key={key}>
            <button type="button" class="recover" data-key={key} disabled={busy} onClick={() => open(key)}>
              <History aria-hidden />
              <b>{name}</b>
              <span>{W.recoverList.about(tiles, when(time), path)}</span>
            </button>
            <Button kind="bare" title={W.recoverList.deleteForGood(name)} icon={Trash2} disabled={busy} onPress={() => void tryAsk('forget', { key }).then(take)} />
          </li>
        ))}
      </ul>
    </>
  );
}
