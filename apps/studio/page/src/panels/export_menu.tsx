// SPDX-License-Identifier: GPL-3.0-or-later

import { signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { download, exportTo, offered, savePicture } from '../document/files';
import { saveElsewhere } from '../document/save';
import { MakingFields } from './making_fields';
import { W } from '../words';

export const exportOpen = signal(false);

function pick(action: () => void): void {
  exportOpen.value = false;
  action();
}

export function ExportMenu() {
  const host = useRef<HTMLDivElement>(null);
  const open = exportOpen.value;
  useEffect(() => {
    if (!open) return;
    (host.current?.querySelector('button') as HTMLElement | null)?.focus();
    const outside = (event: PointerEvent) => {
      if (!host.current?.parentElement?.contains(event.target as Node)) exportOpen.value = false;
    };
    document.addEventListener('pointerdown', outside);
    return () => document.removeEventListener('pointerdown', outside);
  }, [open]);
  if (!open) return null;
  const keys = (event: KeyboardEvent) => {
    const buttons = [...(host.current?.querySelectorAll('button') ?? [])];
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === 'Escape') exportOpen.value = false;
    if (step && event.target instanceof HTMLButtonElement) buttons[(buttons.indexOf(document.activeElement as HTMLButtonElement) + step + buttons.length) % buttons.length].focus();
    event.stopPropagation();
  };
  return (
    <div class="card menu" role="dialog" aria-label={W.exportMenu.export} ref={host} onKeyDown={keys}>
      <button type="button" id="save-as-menu" onClick={() => pick(() => void saveElsewhere())}><b>{W.saveAs.menu}</b><span>{W.saveAs.menuWords}</span></button>
      <button type="button" data-export="json" onClick={() => pick(() => void download())}><b>{W.exportMenu.project}</b><span>{W.exportMenu.everythingForTheStudio}</span></button>
      <button type="button" data-export="png" onClick={() => pick(() => void savePicture())}><b>{W.exportMenu.picture}</b><span>{W.exportMenu.theDViewPng}</span></button>
      <button type="button" data-export="picture-svg" onClick={() => pick(() => void savePicture('svg'))}><b>{W.exportMenu.vectorPicture}</b><span>{W.exportMenu.theDViewSvg}</span></button>
      <hr />
      {offered().map((row) => (
        <button key={row.ending} type="button" data-export={row.ending} onClick={() => pick(() => void exportTo(row))}><b>{row.title}</b><span>{row.words}</span></button>
      ))}
      <hr />
      <MakingFields />
    </div>
  );
}
