// SPDX-License-Identifier: GPL-3.0-or-later
// Where work begins: an example, an outline of one's own, or a project that is there.

import { signal } from '@preact/signals';
import { Compass, FolderOpen, HardDrive, Triangle, X } from 'lucide-preact';
import { openUpload } from '../document/files';
import { documentNow, hello, line } from '../document/store';
import { ask } from '../document/studio';
import { tell } from '../document/tell';
import { inShownUnits } from '../document/units';
import { leave } from '../manners/unsaved';
import { mode, selectedNodes, selectedTiles, startOpen } from '../document/ui';
import { Button } from '../widgets/widgets';
import type { Discarding } from '../protocol/requests';
import { Mark } from '../panels/top_bar';
import { ExamplePicture } from './example_picture';
import { NewFromOutline, painting } from './new_from_outline';
import { outline, outlineRequest, takeOutline, tilesRequest } from './outline';
import { askForPath, PROJECT } from '../document/folders';
import { forgetRecent } from '../document/recent';
import { RecentList } from './recent_list';
import { RecoverList } from './recover_list';
import { pageAddress } from '../layout/address';
import { startTourAfter, TOUR_EXAMPLE } from '../tour/tour';
import { W } from '../words';
import './start.css';

const busy = signal<string | null>(null);
const trouble = signal<string | null>(null);
const OUTLINES = '.svg,.dxf,.obj,.ply,.off,.json';

async function begin(words: string, request: (left: Discarding) => Promise<{ remarks?: string[] }>): Promise<void> {
  const left = await leave();
  if (!left) return;
  busy.value = words;
  trouble.value = null;
  try {
    const { remarks } = await request(left);
    if (remarks?.length) tell(`${outline.peek()?.name ?? W.start.outline}: ${remarks.join('; ')}.`, 'warning');
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

const fromExample = (name: string) => begin(W.start.openingTheExample, (left) => ask('new', { example: name, ...left }));

async function takeTour(): Promise<void> {
  const before = documentNow.peek();
  await begin(W.tour.opening, async (left) => {
    const made = await ask('new', { example: TOUR_EXAMPLE, ...left });
    startTourAfter(before);
    return made;
  });
}

/** A file that cannot be opened leaves the list. */
async function openRecent(path: string): Promise<void> {
  await begin(W.start.opening, (left) => ask('open', { path, ...left }));
  if (trouble.peek()) forgetRecent(path);
}

async function browse(): Promise<void> {
  const path = await askForPath({ purpose: 'open', kind: PROJECT });
  if (path) await begin(W.start.opening, (left) => ask('open', { path, ...left }));
}

async function fromOutline(): Promise<void> {
  const file = outline.value;
  if (!file) return;
  const patterns = painting.value === 'one' ? { patterns: 'made:one' } : {};
  const request = { outline: await outlineRequest(file), ...tilesRequest(), ...patterns };
  await begin(W.start.tiling(file.name), (left) => ask('new', { ...request, ...left }));
}

/** A project is opened at once; an outline waits for its tile size. */
export async function takeFile(file: File): Promise<void> {
  startOpen.value = true;
  const isProject = /\.json$/i.test(file.name) && (await file.slice(0, 4000).text()).includes('fretwork/project');
  if (!isProject) await takeOutline(file);
  else {
    const left = await leave();
    if (left && (await openUpload(file, left))) startOpen.value = false;
  }
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
    <div class="start" role="dialog" aria-label={W.start.start}>
      <div class="start-inner">
        <header role="none">
          <Mark />
          <div>
            <h1>{W.start.fretworkStudio}</h1>
            <p>{W.start.paintTilesSetSupports}</p>
          </div>
          <Button id="take-tour" title={W.tour.beginTip} icon={Compass} label={W.tour.begin} disabled={busy.value !== null || !info} onPress={() => void takeTour()} />
          {documentNow.value && <Button kind="bare" title={W.start.back} shortcut="Esc" icon={X} onPress={close} />}
        </header>
        {trouble.value && <p class="trouble" role="alert" id="start-trouble">{inShownUnits(trouble.value)}</p>}
        <RecoverList busy={busy.value !== null} open={(key) => void begin(W.start.opening, (left) => ask('recover', { key, ...left }))} />
        <RecentList busy={busy.value !== null} open={(path) => void openRecent(path)} />
        <h2>{W.start.startFromAnExample}</h2>
        <div class="examples">
          {(info?.examples ?? []).map((example) => (
            <button key={example.name} type="button" class="example" data-example={example.name} disabled={busy.value !== null} onClick={() => void fromExample(example.name)}>
              <ExamplePicture name={example.name} />
              <b>{example.title}</b>
              <span>{example.description}</span>
            </button>
          ))}
          {!info && line.value !== 'lost' && <p class="hint">{W.start.loading}</p>}
        </div>
        <h2>{W.start.orStartFromYour}</h2>
        <NewFromOutline busy={busy.value !== null} choose={() => choose(OUTLINES, (one) => void takeFile(one))} take={(file) => void takeFile(file)} make={() => void fromOutline()} />
        <div class="start-foot">
          <Button kind="bare" title={W.start.aProjectFileOn} icon={FolderOpen} label={W.start.openAProject} onPress={() => choose('.json', (file) => void takeFile(file))} />
          <Button kind="bare" id="browse" title={W.folder.browseTip} icon={HardDrive} label={W.folder.browse} onPress={() => void browse()} />
          <Button kind="bare" id="draw-layout" title={W.layouts.drawTip} icon={Triangle} label={W.layouts.draw} onPress={() => location.assign(pageAddress('layout'))} />
          {busy.value && <span class="busy" role="status"><i class="pulse" />{busy.value}</span>}
        </div>
      </div>
    </div>
  );
}
