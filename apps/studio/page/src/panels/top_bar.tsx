// SPDX-License-Identifier: GPL-3.0-or-later

import { CircleHelp, Columns2, Download, FilePlus2, Redo2, Save, Undo2 } from 'lucide-preact';
import { redo, undo } from '../document/edits';
import { save } from '../document/save';
import { documentNow } from '../document/store';
import { helpOpen, mode, MODES, split, startOpen, type Split } from '../document/ui';
import { unitSystem } from '../document/units';
import { ThemeButton } from '../manners/theme_button';
import { Button, Segments } from '../widgets/widgets';
import { ExportMenu, exportOpen } from './export_menu';
import { W } from '../words';
import './top_bar.css';

export function Mark() {
  return (
    <svg class="mark" viewBox="0 0 32 32" aria-hidden="true">
      <path d="M16 3 27.300 9.500V22.500L16 29 4.700 22.500V9.500Z" />
      <path d="M16 16V3M16 16 27.300 22.500M16 16 4.700 22.500" />
    </svg>
  );
}

export function TopBar() {
  const now = documentNow.value;
  const history = now?.history ?? { undo: null, redo: null };
  return (
    <header class="top-bar">
      <div class="brand"><Mark /></div>
      {!startOpen.value && now && <h1 class="unseen">{W.topBar.heading(now.name || W.topBar.untitled)}</h1>}
      {now && (
        <>
          <button type="button" class="document-name" data-tip={now.path ?? W.topBar.notSavedYet} onClick={() => (startOpen.value = true)}>
            <b>{now.name || W.topBar.untitled}</b>{!now.saved && <i class="unsaved" aria-label={W.topBar.unsavedChanges} />}
          </button>
          <div class="cluster">
            <Button kind="bare" title={W.topBar.newOrOpen} icon={FilePlus2} onPress={() => (startOpen.value = true)} />
            <Button kind="bare" id="save" title={W.topBar.save} shortcut="Ctrl S" icon={Save} onPress={() => void save()} />
            <span class="anchor">
              <Button kind="bare" id="export" title={W.topBar.export} icon={Download} pressed={exportOpen.value} onPress={() => (exportOpen.value = !exportOpen.value)} />
              <ExportMenu />
            </span>
          </div>
          <div class="cluster">
            <Button kind="bare" id="undo" title={history.undo ? W.topBar.undo(history.undo) : W.topBar.nothingToUndo} shortcut="Ctrl Z" icon={Undo2} disabled={!history.undo} onPress={undo} />
            <Button kind="bare" id="redo" title={history.redo ? W.topBar.redo(history.redo) : W.topBar.nothingToRedo} shortcut="Ctrl Shift Z" icon={Redo2} disabled={!history.redo} onPress={redo} />
          </div>
          <nav class="modes" aria-label={W.topBar.mode}>
            <Segments label={W.topBar.mode} value={mode.value} onPick={(next) => (mode.value = next)}
              options={MODES.map((row) => ({ value: row.mode, title: row.title, shortcut: row.key, tip: row.title }))} />
          </nav>
        </>
      )}
      <span class="gap" />
      <div class="cluster">
        {now && (
          <Segments<Split> label={W.topBar.views} iconsOnly={false} value={split.value} onPick={(next) => (split.value = next)}
            options={[{ value: 'plane', title: W.topBar.plane }, { value: 'both', title: '', tip: W.topBar.dAndD, icon: Columns2 }, { value: 'space', title: W.topBar.space }]} />
        )}
        <Button kind="bare" title={unitSystem.value === 'mm' ? W.topBar.millimetresClickForMetres : W.topBar.metresClickForMillimetres} label={<b class="unit">{unitSystem.value === 'mm' ? 'mm' : 'm'}</b>}
          onPress={() => (unitSystem.value = unitSystem.value === 'mm' ? 'SI' : 'mm')} />
        <ThemeButton />
        <Button kind="bare" id="help" title={W.topBar.keyboardShortcuts} shortcut="?" icon={CircleHelp} onPress={() => (helpOpen.value = true)} />
      </div>
    </header>
  );
}

