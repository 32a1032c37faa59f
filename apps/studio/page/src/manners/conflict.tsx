// SPDX-License-Identifier: GPL-3.0-or-later
// Before a file is replaced that somebody else has written, it is asked which of the two is kept.

import { useEffect, useRef } from 'preact/hooks';
import { nameOf } from '../document/names';
import { conflictAsked } from '../document/save';
import { Button } from '../widgets/widgets';
import { W } from '../words';

export function ConflictSheet() {
  const host = useRef<HTMLDivElement>(null);
  const asked = conflictAsked.value;
  useEffect(() => {
    if (asked) host.current?.querySelector('button')?.focus();
  }, [asked]);
  if (!asked) return null;
  const { conflict, kind, answer } = asked;
  const name = nameOf(conflict.path);
  const isOwn = conflict.reason === 'changed';
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Escape') answer('stay');
    event.stopPropagation();
  };
  return (
    <div class="veil ask" onKeyDown={keys}>
      <div class="sheet question" role="alertdialog" aria-modal="true" aria-labelledby="conflict-title" aria-describedby="conflict-words" ref={host}>
        <h1 id="conflict-title">{isOwn ? W.conflict.wasChangedElsewhere(name) : W.conflict.replace(name)}</h1>
        <p id="conflict-words">
          {isOwn
            ? W.conflict.anotherProgramChangedThis
            : W.conflict.thisFileContainsAnother(kind)}
        </p>
        <div class="row">
          <Button id="conflict-elsewhere" kind="main" title={W.conflict.keepThatFileAnd} label={W.conflict.saveToAnotherFile} onPress={() => answer('elsewhere')} />
          {isOwn && <Button id="conflict-theirs" title={W.conflict.reloadTheFileAnd} label={W.conflict.reloadFile} onPress={() => answer('theirs')} />}
          <Button id="conflict-mine" title={W.conflict.overwriteTheFileWith} label={W.conflict.overwrite} onPress={() => answer('mine')} />
          <Button id="conflict-stay" title={W.conflict.doNotSave} label={W.conflict.cancel} onPress={() => answer('stay')} />
        </div>
      </div>
    </div>
  );
}
