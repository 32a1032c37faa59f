// SPDX-License-Identifier: GPL-3.0-or-later

import { X } from 'lucide-preact';
import { helpOpen } from '../document/ui';
import { Button } from '../widgets/widgets';
import { SHORTCUTS } from './shortcuts';
import { W } from '../words';
import './help.css';

const POINTER: [string, string][] = [
  [W.help.dragInD, W.help.turn],
  [W.help.rightDragInD, W.help.move],
  [W.help.wheel, W.help.zoom],
  [W.help.dragAnArrowTip, W.help.changeTheForceShift],
  [W.help.middleDragOrSpace, W.help.panInD],
  [W.help.fingers, W.help.fingersDo],
  [W.help.arrowKeys2D, W.help.goAndAct],
  [W.help.arrowKeys3D, W.help.orbitAndZoom],
];

export function HelpSheet() {
  if (!helpOpen.value) return null;
  const groups = [...new Set(SHORTCUTS.map(({ group }) => group))];
  const close = () => (helpOpen.value = false);
  return (
    <div class="veil" onClick={(event) => event.target === event.currentTarget && close()}>
      <div class="sheet help" role="dialog" aria-modal="true" aria-label={W.help.keyboardShortcuts}>
        <header role="none">
          <h1>{W.help.keyboardAndPointer}</h1>
          <Button kind="bare" title={W.help.close} icon={X} onPress={close} />
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
            <h2>{W.help.pointer}</h2>
            <dl class="pointer-list">{POINTER.map(([what, words]) => [<dt key={what}>{what}</dt>, <dd key={words}>{words}</dd>])}</dl>
          </section>
        </div>
      </div>
    </div>
  );
}
