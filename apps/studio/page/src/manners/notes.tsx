// SPDX-License-Identifier: GPL-3.0-or-later

import { X } from 'lucide-preact';
import { line } from '../document/store';
import { dismiss, notes } from '../document/tell';
import { Button } from '../widgets/widgets';

export function Notes() {
  return (
    <div class="notes" aria-live="assertive">
      {notes.value.map(({ id, text, tone }) => (
        <div key={id} class={`note ${tone}`} role={tone === 'error' ? 'alert' : 'status'}>
          <span>{text}</span>
          <Button kind="bare" title="Close" icon={X} onPress={() => dismiss(id)} />
        </div>
      ))}
    </div>
  );
}

export function LineNotice() {
  if (line.value === 'refused')
    return <div class="lost" role="alert">This address is of an earlier run of the studio. Open the address that the studio printed when it was started again; what was not saved is offered there.</div>;
  if (line.value !== 'lost') return null;
  return <div class="lost" role="alert">The connection to the studio is lost; trying again … Your work is kept: if the studio has ended, start it again and open the address that it prints.</div>;
}
