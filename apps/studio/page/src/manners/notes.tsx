// SPDX-License-Identifier: GPL-3.0-or-later

import { X } from 'lucide-preact';
import { line } from '../document/store';
import { dismiss, notes } from '../document/tell';
import { Button } from '../widgets/widgets';
import { W } from '../words';

export function Notes() {
  return (
    <div class="notes" aria-live="assertive">
      {notes.value.map(({ id, text, tone }) => (
        <div key={id} class={`note ${tone}`} role={tone === 'error' ? 'alert' : 'status'}>
          <span>{text}</span>
          <Button kind="bare" title={W.notes.close} icon={X} onPress={() => dismiss(id)} />
        </div>
      ))}
    </div>
  );
}

export function LineNotice() {
  if (line.value === 'refused')
    return <div class="lost" role="alert">{W.notes.thisAddressBelongsTo}</div>;
  if (line.value !== 'lost') return null;
  return <div class="lost" role="alert">{W.notes.connectionLostReconnectingYour}</div>;
}
