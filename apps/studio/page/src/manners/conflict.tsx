// SPDX-License-Identifier: GPL-3.0-or-later
// Asks which file is kept, before a file that somebody else has written is replaced.

import { nameOf } from '../document/names';
import { conflictAsked } from '../document/save';
import { Question } from '../widgets/question';
import { Button } from '../widgets/widgets';
import { W } from '../words';

export function ConflictSheet() {
  const asked = conflictAsked.value;
  if (!asked) return null;
  const { conflict, kind, answer } = asked;
  const name = nameOf(conflict.path);
  const isOwn = conflict.reason === 'changed';
  const title = isOwn ? W.conflict.wasChangedElsewhere(name) : W.conflict.replace(name);
  const words = isOwn ? W.conflict.anotherProgramChangedThis : W.conflict.thisFileContainsAnother(kind);
  return (
    <Question id="conflict" title={title} words={words} onEscape={() => answer('stay')}>
      <Button id="conflict-elsewhere" kind="main" title={W.conflict.keepThatFileAnd} label={W.conflict.saveToAnotherFile} onPress={() => answer('elsewhere')} />
      {isOwn && <Button id="conflict-theirs" title={W.conflict.reloadTheFileAnd} label={W.conflict.reloadFile} onPress={() => answer('theirs')} />}
      <Button id="conflict-mine" title={W.conflict.overwriteTheFileWith} label={W.conflict.overwrite} onPress={() => answer('mine')} />
      <Button id="conflict-stay" title={W.conflict.doNotSave} label={W.conflict.cancel} onPress={() => answer('stay')} />
    </Question>
  );
}
