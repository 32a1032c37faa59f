// SPDX-License-Identifier: GPL-3.0-or-later
// Folders of the machine where the studio runs: a file to open, or a name to save to.

import { useEffect, useRef, useState } from 'preact/hooks';
import { CornerLeftUp, FileText, Folder, House } from 'lucide-preact';
import { folderAsked, folderNow, folderTrouble, goTo, pathOf } from '../document/folders';
import type { FolderEntry } from '../protocol/requests';
import { Button } from '../widgets/widgets';
import { W } from '../words';

interface RowProps {
  entry: FolderEntry;
  kind: 'folder' | 'file';
  isPicked: boolean;
  onPick: (entry: FolderEntry, at: 'once' | 'twice') => void;
}
function Row({ entry, kind, isPicked, onPick }: RowProps) {
  const Picture = kind === 'folder' ? Folder : FileText;
  return (
    <li>
      <button type="button" class="folder-row" data-kind={kind} data-path={entry.path} aria-pressed={isPicked} aria-label={kind === 'folder' ? W.folder.folderRow(entry.name) : entry.name}
        onClick={() => onPick(entry, 'once')} onDblClick={() => onPick(entry, 'twice')}>
        <Picture aria-hidden /><span>{entry.name}</span>
        {kind === 'file' && <time>{new Date(1000 * entry.time).toLocaleDateString()}</time>}
      </button>
    </li>
  );
}

function Places() {
  const now = folderNow.value;
  return (
    <div class="folder-places">
      <Button kind="bare" id="folder-up" title={W.folder.up} icon={CornerLeftUp} disabled={!now?.parent} onPress={() => now?.parent && void goTo(now.parent)} />
      <Button kind="bare" id="folder-home" title={W.folder.home} icon={House} disabled={!now?.home} onPress={() => now?.home && void goTo(now.home)} />
      <output id="folder-path">{now?.path ?? W.folder.loading}</output>
    </div>
  );
}

/** Arrow keys go from row to row, Backspace to the folder above. */
function listKeys(event: KeyboardEvent): void {
  const rows = [...(event.currentTarget as HTMLElement).querySelectorAll<HTMLElement>('.folder-row')];
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (step) {
    event.preventDefault();
    rows[Math.min(rows.length - 1, Math.max(0, rows.indexOf(document.activeElement as HTMLElement) + step))]?.focus();
  }
  const parent = folderNow.peek()?.parent;
  if (event.key === 'Backspace' && parent) void goTo(parent);
}

export function FolderSheet() {
  const asked = folderAsked.value;
  return asked && <OpenFolderSheet key={asked.purpose} {...asked} />;
}

function OpenFolderSheet({ purpose, kind, name: suggested = '', answer }: NonNullable<typeof folderAsked.value>) {
  const field = useRef<HTMLInputElement>(null);
  const host = useRef<HTMLDivElement>(null);
  const saving = purpose === 'save';
  const [name, setName] = useState(suggested);
  useEffect(() => (saving ? field.current?.select() : host.current?.querySelector('button')?.focus()), []);
  const now = folderNow.value;
  const give = (text = name) => {
    const path = pathOf(text, folderNow.peek()?.path);
    if (path) answer(path);
  };
  const pick = (entry: FolderEntry, isFolder: boolean, at: 'once' | 'twice') => {
    if (!isFolder) setName(entry.name);
    if (isFolder && at === 'once') void goTo(entry.path);
    if (!isFolder && at === 'twice' && !saving) give(entry.name);
  };
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Escape') answer(null);
    if (event.key === 'Enter' && event.target === field.current) give();
    event.stopPropagation();
  };
  return (
    <div class="veil ask" onKeyDown={keys}>
      <div class="sheet question folder-sheet" role="dialog" aria-modal="true" aria-labelledby="folder-title" ref={host}>
        <h1 id="folder-title">{saving ? W.saveAs.title : W.folder.openTitle(kind)}</h1>
        <p>{saving ? W.saveAs.words : W.folder.openWords(kind)}</p>
        <Places />
        {folderTrouble.value && <p class="trouble" role="alert" id="folder-trouble">{folderTrouble.value}</p>}
        <ul class="folder-list" aria-label={W.folder.places} onKeyDown={listKeys}>
          {now?.folders.map((entry) => <Row key={entry.path} entry={entry} kind="folder" isPicked={false} onPick={(one, at) => pick(one, true, at)} />)}
          {now?.files.map((entry) => <Row key={entry.path} entry={entry} kind="file" isPicked={entry.name === name} onPick={(one, at) => pick(one, false, at)} />)}
        </ul>
        {now && now.folders.length + now.files.length === 0 && <p class="hint">{W.folder.empty(kind)}</p>}
        {now && now.left_out > 0 && <p class="hint">{W.folder.leftOut(now.left_out)}</p>}
        <label class="folder-name"><span>{W.folder.name}</span>
          <input class="text-input" id="save-as-path" ref={field} value={name} spellcheck={false} autocomplete="off" onInput={(event) => setName(event.currentTarget.value)} />
        </label>
        <div class="row">
          {saving
            ? <Button id="save-as" kind="main" title={W.saveAs.saveTip} label={W.saveAs.save} disabled={!name.trim()} onPress={() => give()} />
            : <Button id="open-path" kind="main" title={W.folder.openTip(kind)} label={W.folder.open} disabled={!name.trim()} onPress={() => give()} />}
          <Button id="save-as-cancel" title={W.saveAs.cancelTip} label={W.saveAs.cancel} onPress={() => answer(null)} />
        </div>
      </div>
    </div>
  );
}
