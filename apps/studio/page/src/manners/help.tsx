// SPDX-License-Identifier: GPL-3.0-or-later

import { X } from 'lucide-preact';
import { helpOpen } from '../document/ui';
import { Button } from '../widgets/widgets';
import { SHORTCUTS } from './shortcuts';
import './help.css';

const POINTER: [string, string][] = [
  ['Drag in space', 'turn'],
  ['Right drag in space', 'move'],
  ['Wheel', 'zoom'],
  ['Drag an arrow’s free end', 'change the force; Shift lets it leave the axes'],
  ['Middle drag, or Space and drag', 'move the plane'],
];

export function HelpSheet() {
  if (!helpOpen.value) return null;
  const groups = [...new Set(SHORTCUTS.map(({ group }) => group))];
  const close = () => (helpOpen.value = false);
  return (
    <div class="veil" onClick={(event) => event.target === event.currentTarget && close()}>
      <div class="sheet help" role="dialog" aria-modal="true" aria-label="Keys">
        <header role="none">
          <h1>Keys and pointer</h1>
          <Button kind="bare" title="Close" icon={X} onPress={close} />
        </header>
        <div class="help-groups">
          {groups.map((group) => (
            <section key={group}>
              <h2>{group}</h2>
              <dl>
                {SHORTCUTS.filter((row) => row.group === group && row.keys !== 'Ctrl Y').map(({ keys, words }) => [
                  <dt key={keys}>{keys.split(' ').map((key) => <kbd key={key}>{key}</kbd>)}</dt>,
                  <dd key={`${keys} words`}>{words}</dd>,
                ])}
              </dl>
            </section>
          ))}
          <section>
            <h2>Pointer</h2>
            <dl class="pointer-list">{POINTER.map(([what, words]) => [<dt key={what}>{what}</dt>, <dd key={words}>{words}</dd>])}</dl>
          </section>
        </div>
      </div>
    </div>
  );
}
