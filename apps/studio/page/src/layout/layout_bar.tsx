// SPDX-License-Identifier: GPL-3.0-or-later
// What is done with the layout as a whole: its name, its file, undo.

import { useEffect, useState } from 'preact/hooks';
import { Box, FolderOpen, Redo2, Save, Undo2 } from 'lucide-preact';
import { hello } from '../document/store';
import { ThemeButton } from '../manners/theme_button';
import { Mark } from '../panels/top_bar';
import { Button } from '../widgets/widgets';
import { W } from '../words';
import { canRedo, canUndo, draft, isUnsaved, redo, rename, undo } from './draft';
import { beginWith, openLayoutFile, saveLayout } from './save';
import { pageAddress } from './address';
import '../panels/top_bar.css';

function NameField() {
  const name = draft.value?.layout.name ?? '';
  const [text, setText] = useState(name);
  useEffect(() => setText(name), [name]);
  const take = () => void rename(text.trim()).then(() => setText(draft.peek()?.layout.name ?? ''));
  return (
    <input class="text-input layout-name" id="layout-name" aria-label={W.layouts.name} data-tip={W.layouts.nameTip} value={text} spellcheck={false} autocomplete="off"
      onInput={(event) => setText(event.currentTarget.value)} onBlur={take} onKeyDown={(event) => event.key === 'Enter' && take()} />
  );
}

/** Choosing a layout opens it; the field always shows its own title. */
function BeginWith() {
  return (
    <select id="layout-begin" class="choice" aria-label={W.layouts.begin} data-tip={W.layouts.beginTip} value=""
      onChange={(event) => {
        const name = event.currentTarget.value;
        event.currentTarget.value = '';
        void beginWith(name);
      }}>
      <option value="" disabled>{W.layouts.begin}</option>
      {hello.value?.layouts.map((name) => <option key={name} value={name}>{name}</option>)}
    </select>
  );
}

export function LayoutBar() {
  const now = draft.value;
  return (
    <header class="top-bar">
      <div class="brand"><Mark /></div>
      <h1 class="unseen">{W.layouts.heading(now?.layout.name ?? '')}</h1>
      <div class="layout-names"><NameField />{isUnsaved.value && <i class="unsaved" role="img" aria-label={W.topBar.unsavedChanges} />}</div>
      <div class="cluster">
        <BeginWith />
        <Button kind="bare" id="layout-open" title={W.layouts.open} icon={FolderOpen} onPress={() => void openLayoutFile()} />
        <Button kind="bare" id="layout-save" title={W.layouts.save} shortcut="Ctrl S" icon={Save} disabled={!now} onPress={() => void saveLayout()} />
      </div>
      <div class="cluster">
        <Button kind="bare" id="undo" title={W.layouts.undo} shortcut="Ctrl Z" icon={Undo2} disabled={!canUndo.value} onPress={() => void undo()} />
        <Button kind="bare" id="redo" title={W.layouts.redo} shortcut="Ctrl Shift Z" icon={Redo2} disabled={!canRedo.value} onPress={() => void redo()} />
      </div>
      <span class="gap" />
      <div class="cluster">
        <Button kind="bare" id="to-surfaces" title={W.layouts.surfacesTip} icon={Box} label={W.layouts.surfaces} onPress={() => location.assign(pageAddress(null))} />
        <ThemeButton />
      </div>
    </header>
  );
}
