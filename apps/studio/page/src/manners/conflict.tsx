// SPDX-License-Identifier: GPL-3.0-or-later
// Before a file is replaced that somebody else has written, it is asked which of the two is kept.

import { useEffect, useRef } from 'preact/hooks';
import { conflictAsked } from '../document/save';
import { Button } from '../widgets/widgets';

export function ConflictSheet() {
  const host = useRef<HTMLDivElement>(null);
  const asked = conflictAsked.value;
  useEffect(() => {
    if (asked) host.current?.querySelector('button')?.focus();
  }, [asked]);
  if (!asked) return null;
  const { conflict, answer } = asked;
  const name = conflict.path.split('/').pop();
  const isOwn = conflict.reason === 'changed';
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Escape') answer('stay');
    event.stopPropagation();
  };
  return (
    <div class="veil ask" onKeyDown={keys}>
      <div class="sheet question" role="alertdialog" aria-modal="true" aria-labelledby="conflict-title" aria-describedby="conflict-words" ref={host}>
        <h1 id="conflict-title">{isOwn ? `“${name}” was changed elsewhere` : `Replace “${name}”?`}</h1>
        <p id="conflict-words">
          {isOwn
            ? 'Another program wrote this file after it was opened here. Saving would take those changes back.'
            : 'Another project is in this file.'}
        </p>
        <div class="row">
          <Button id="conflict-elsewhere" kind="main" title="Leave that file as it is, and save this surface in another one" label="Save as another file" onPress={() => answer('elsewhere')} />
          {isOwn && <Button id="conflict-theirs" title="Open the file as it is now; the changes made here are given up" label="Keep theirs" onPress={() => answer('theirs')} />}
          <Button id="conflict-mine" title="Replace the file by this surface" label={isOwn ? 'Keep mine' : 'Replace it'} onPress={() => answer('mine')} />
          <Button id="conflict-stay" title="Do not save now" label="Cancel" onPress={() => answer('stay')} />
        </div>
      </div>
    </div>
  );
}
