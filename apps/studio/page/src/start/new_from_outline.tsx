// SPDX-License-Identifier: GPL-3.0-or-later
// Drop an outline, see it, say how large it is, and cover it with tiles.

import { signal } from '@preact/signals';
import { FileUp } from 'lucide-preact';
import { inShownUnits, shown } from '../document/units';
import { Button, Check, Choice } from '../widgets/widgets';
import { Loops } from '../widgets/loops';
import { NumberField } from '../widgets/number';
import { setReadable, sizeAdvice, unreadable } from './tile_size';
import type { Point } from '../protocol/messages';
import { ALL, choosePart, height, isMesh, keepsFaces, LARGEST, measured, outline, outlineTrouble, part, setWidth, tilesAbout, tileSize, width } from './outline';
import { W } from '../words';

export const painting = signal<'one' | 'bare'>('one');
const over = signal(false);
const PREVIEW = { width: 168, height: 104 };
const LEAST_LENGTH = 0.001;

interface Props {
  busy: boolean;
  choose: () => void;
  take: (file: File) => void;
  make: () => void;
}

export function NewFromOutline({ busy, choose, take, make }: Props) {
  const file = outline.value;
  const takesFaces = isMesh.value && keepsFaces.value;
  const advice = takesFaces ? null : sizeAdvice.value;
  const wrong = outlineTrouble.value !== null || unreadable.value.size > 0 || advice?.isPossible === false;
  return (
    <div class={`drop${over.value ? ' over' : ''}${file ? ' taken' : ''}`}
      onDragOver={(event) => { event.preventDefault(); over.value = true; }} onDragLeave={() => (over.value = false)}
      onDrop={(event) => {
        event.preventDefault();
        event.stopPropagation();
        over.value = false;
        const dropped = event.dataTransfer?.files[0];
        if (dropped) take(dropped);
      }}>
      <button type="button" class="drop-target" id="choose-outline" onClick={choose}>
        {file && measured.value ? <Loops class="outline-preview" loops={measured.value.loops} room={PREVIEW} /> : <FileUp aria-hidden />}
        {file ? <MeasuredOutline name={file.name} /> : <span><b>{W.newFromOutline.dropAnOutlineHere}</b><br />{W.newFromOutline.svgDxfObjPly}</span>}
      </button>
      <div class="drop-options">
        <PartField />
        {file && measured.value && (
          <label class="field"><span>{W.newFromOutline.surfaceWidth}</span><NumberField id="outline-width" label={W.newFromOutline.surfaceWidth} least={LEAST_LENGTH} value={width.value} quantity="length" onChange={setWidth} onReadable={(is) => setReadable('width', is)} /></label>
        )}
        <TileFields takesFaces={takesFaces} />
        {advice && <p class={advice.isPossible ? 'hint' : 'drop-trouble'} role="status" id="size-advice">{advice.words}</p>}
        <div class="field"><span>{W.newFromOutline.patterns}</span>
          <Choice label={W.newFromOutline.initialPatterns} value={painting.value} onPick={(value) => (painting.value = value)}
            options={[{ value: 'one', title: W.newFromOutline.oneThatCanBe }, { value: 'bare', title: W.newFromOutline.none }]} />
        </div>
        <Button id="make" kind="main" wide title={takesFaces ? W.newFromOutline.useItsFaces : W.newFromOutline.coverWithNewTiles} label={!takesFaces && tilesAbout.value ? W.newFromOutline.createOf(tilesAbout.value) : W.newFromOutline.create} disabled={!file || busy || wrong} onPress={make} />
      </div>
    </div>
  );
}

/** Which of several parts of a drawing. */
function PartField() {
  const parts = measured.value?.parts ?? [];
  if (parts.length < 2) return null;
  const size = ([w, h]: Point): string => `${shown(w, 'length')} × ${shown(h, 'length')}`;
  const options = parts.map((one, at) => ({ value: at === 0 ? LARGEST : `${at + 1}`, title: W.newFromOutline.part(at + 1, size(one)) }));
  return (
    <div class="field"><span>{W.newFromOutline.partOfTheDrawing}</span>
      <Choice id="outline-part" label={W.newFromOutline.partOfTheDrawing} value={part.value} onPick={(which) => void choosePart(which)}
        options={[...options, { value: ALL, title: W.newFromOutline.allEachNeedsSupports(parts.length) }]} />
    </div>
  );
}

/** New tiles of some side, or the faces of a mesh. */
function TileFields({ takesFaces }: { takesFaces: boolean }) {
  return (
    <>
      {isMesh.value && <Check label={W.newFromOutline.useItsFacesAs} value={keepsFaces.value} onChange={(value) => (keepsFaces.value = value)} />}
      {!takesFaces && <label class="field"><span>{W.newFromOutline.tileSide}</span><NumberField id="tile-size" label={W.newFromOutline.tileSide} least={LEAST_LENGTH} value={tileSize.value} quantity="length" onChange={(value) => (tileSize.value = value)} onReadable={(is) => setReadable('tiles', is)} /></label>}
    </>
  );
}

function MeasuredOutline({ name }: { name: string }) {
  const now = measured.value;
  if (outlineTrouble.value) return <span><b>{name}</b><br /><span class="drop-trouble" role="alert" id="outline-trouble">{inShownUnits(outlineTrouble.value)}</span></span>;
  return (
    <span>
      <b>{name}</b><br />
      {now && <>{shown(width.value, 'length')} × {shown(height.value, 'length')}{width.value !== now.size[0] && W.newFromOutline.asDrawn(shown(now.size[0], 'length'))}<br /></>}
      {now?.remarks?.map((remark) => <span key={remark} class="remark">{inShownUnits(remark)}<br /></span>)}
      {W.newFromOutline.chooseAnother}
    </span>
  );
}

