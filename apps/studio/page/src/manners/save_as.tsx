// SPDX-License-Identifier: GPL-3.0-or-later
// Asks where to save: a path on the machine where the studio runs.

import { useEffect, useRef } from 'preact/hooks';
import { pathAsked } from '../document/save';
import { documentNow } from '../document/store';
import { Button } from '../widgets/widgets';
import { W } from '../words';

export function SaveAsSheet() {
  const field = useRef<HTMLInputElement>(null);
  const answer = pathAsked.value;
  useEffect(() => {
    if (answer) field.current?.select();
  }, [answer]);
  if (!answer) return null;
  const give = () => answer(field.current?.value.trim() || null);
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Escape') answer(null);
    if (event.key === 'Enter') give();
    event.stopPropagation();
  };
  const now = documentNow.value;
  return (
    <div class="veil ask" onKeyDown={keys}>
      <div class="sheet question" role="dialog" aria-modal="true" aria-labelledby="save-as-title">
        <h1 id="save-as-title">{W.saveAs.title}</h1>
        <p>{W.saveAs.words}</p>
        <input class="text-input" id="save-as-path" ref={field} aria-label={W.saveAs.path} value={now?.path ?? `${now?.name || W.saveAs.name}.json`} spellcheck={false} autocomplete="off" />
        <div class="row">
          <Button id="save-as" kind="main" title={W.saveAs.saveTip} label={W.saveAs.save} onPress={give} />
          <Button id="save-as-cancel" title={W.saveAs.cancelTip} label={W.saveAs.cancel} onPress={() => answer(null)} />
        </div>
      </div>
    </div>
  );
}
