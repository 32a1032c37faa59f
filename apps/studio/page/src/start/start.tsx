// SPDX-License-Identifier: GPL-3.0-or-later
// Where work begins: an example, an outline of one's own, or a project that is there.

import { signal } from '@preact/signals';
import { FileUp, FolderOpen, History, X } from 'lucide-preact';
import { base64, openUpload } from '../document/files';
import { documentNow, hello, line } from '../document/store';
import { ask } from '../document/studio';
import { mode, selectedNodes, selectedTiles, startOpen } from '../document/ui';
import { Button, Choice } from '../widgets/widgets';
import { NumberField } from '../widgets/number';
import { Mark } from '../panels/top_bar';
import { startingPalette } from '../gallery/starting_palette';
import type { PatternTable } from '../protocol/messages';
import { ExampleDrawing } from './example_drawing';
import './start.css';

const tileSize = signal(0.026);
const painting = signal<'random' | 'bare'>('random');
const outline = signal<File | null>(null);
const busy = signal<string | null>(null);
const trouble = signal<string | null>(null);
const over = signal(false);
const PALETTE_SIZE = 24;
const OUTLINES = '.svg,.dxf,.obj,.ply,.off,.json';

async function begin(words: string, what: string, more: object): Promise<void> {
  busy.value = words;
  trouble.value = null;
  try {
    await ask(what, more);
    selectedNodes.value = new Set();
    selectedTiles.value = new Set();
    mode.value = 'paint';
    startOpen.value = false;
    outline.value = null;
  } catch (error) {
    trouble.value = (error as Error).message;
  }
  busy.value = null;
}

const fromExample = (name: string) => begin('Making the example …', 'new', { example: name });

async function fromOutline(): Promise<void> {
  const file = outline.value;
  if (!file) return;
  const patterns = painting.value === 'random' ? { patterns: 'random:1', ...(await palette()) } : {};
  await begin(`Tiling ${file.name} …`, 'new', { outline: { name: file.name, text_base64: await base64(file) }, tile_size: tileSize.value, ...patterns });
}

/** Chance needs patterns to choose from: the library's calibrated ones, or a spread of all. */
async function palette(): Promise<{ palette?: string }> {
  if (hello.value?.has_library) return {};
  const table = await ask<PatternTable>('patterns').catch(() => null);
  return table ? { palette: startingPalette(table.patterns, PALETTE_SIZE).join(',') } : {};
}

/** A project is opened at once; an outline waits for its tile size. */
export async function takeFile(file: File): Promise<void> {
  startOpen.value = true;
  const isProject = file.name.endsWith('.json') && (await file.slice(0, 4000).text()).includes('fretwork/project');
  if (!isProject) outline.value = file;
  else if (await openUpload(file)) startOpen.value = false;
}

function choose(accept: string, take: (file: File) => void): void {
  const input = Object.assign(document.createElement('input'), { type: 'file', accept });
  input.onchange = () => input.files?.[0] && take(input.files[0]);
  input.click();
}

export function Start() {
  const info = hello.value;
  const close = () => (startOpen.value = false);
  return (
    <div class="start" role="dialog" aria-label="Start">
      <div class="start-inner">
        <header>
          <Mark />
          <div>
            <h1>Fretwork studio</h1>
            <p>Paint patterns on a flat shape, hold it, load it, see it bend.</p>
          </div>
          {documentNow.value && <Button kind="bare" title="Back" shortcut="Esc" icon={X} onPress={close} />}
        </header>
        {trouble.value && <p class="trouble" role="alert" id="start-trouble">{trouble.value}</p>}
        <h2>Start from an example</h2>
        <div class="examples">
          {(info?.examples ?? []).map((example) => (
            <button key={example.name} type="button" class="example" data-example={example.name} disabled={busy.value !== null} onClick={() => void fromExample(example.name)}>
              <ExampleDrawing name={example.name} />
              <b>{example.title}</b>
              <span>{example.description}</span>
            </button>
          ))}
          {!info && line.value !== 'lost' && <p class="hint">One moment …</p>}
        </div>
        <h2>Or from an outline of your own</h2>
        <NewFromOutline />
        <div class="start-foot">
          <Button kind="bare" title="A project file of this machine" icon={FolderOpen} label="Open a project …" onPress={() => choose('.json', (file) => void takeFile(file))} />
          {info?.can_recover && !documentNow.value && (
            <Button kind="bare" title="What was open when the studio ended" icon={History} label="Continue where you stopped" onPress={() => void begin('Opening …', 'recover', {})} />
          )}
          {busy.value && <span class="busy" role="status"><i class="pulse" />{busy.value}</span>}
        </div>
      </div>
    </div>
  );
}

function NewFromOutline() {
  const file = outline.value;
  return (
    <div class={`drop${over.value ? ' over' : ''}${file ? ' taken' : ''}`}
      onDragOver={(event) => { event.preventDefault(); over.value = true; }} onDragLeave={() => (over.value = false)}
      onDrop={(event) => {
        event.preventDefault();
        event.stopPropagation();
        over.value = false;
        const dropped = event.dataTransfer?.files[0];
        if (dropped) void takeFile(dropped);
      }}>
      <button type="button" class="drop-target" id="choose-outline" onClick={() => choose(OUTLINES, (one) => void takeFile(one))}>
        <FileUp aria-hidden />
        {file ? <span><b>{file.name}</b><br />another one …</span> : <span><b>Drop an outline here</b><br />SVG, DXF, OBJ or PLY. Or press to choose.</span>}
      </button>
      <div class="drop-options">
        <label class="field"><span>Side of the tiles</span><NumberField id="tile-size" label="Side of the tiles" least={0.001} value={tileSize.value} quantity="length" onChange={(value) => (tileSize.value = value)} /></label>
        <div class="field"><span>Patterns</span>
          <Choice label="Patterns to begin with" value={painting.value} onPick={(value) => (painting.value = value)}
            options={[{ value: 'random', title: 'a mix to begin with' }, { value: 'bare', title: 'none, I paint' }]} />
        </div>
        <Button id="make" kind="main" wide title="Cover it with tiles" label="Make it" disabled={!file || busy.value !== null} onPress={() => void fromOutline()} />
      </div>
    </div>
  );
}
