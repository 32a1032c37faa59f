// SPDX-License-Identifier: GPL-3.0-or-later
// Drop an outline, see it, say how large it is, and cover it with tiles.

import { signal } from '@preact/signals';
import { FileUp } from 'lucide-preact';
import { inShownUnits, shown } from '../document/units';
import { Button, Check, Choice } from '../widgets/widgets';
import { NumberField } from '../widgets/number';
import { setReadable, sizeAdvice, unreadable } from './tile_size';
import type { Point } from '../protocol/messages';
import type { Measured } from '../protocol/requests';
import { ALL, choosePart, height, isMesh, keepsFaces, LARGEST, measured, outline, outlineTrouble, part, setWidth, tilesAbout, tileSize, width } from './outline';

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
        {file && measured.value ? <Preview of={measured.value} /> : <FileUp aria-hidden />}
        {file ? <MeasuredOutline name={file.name} /> : <span><b>Drop an outline here</b><br />SVG, DXF, OBJ, PLY or OFF. Or press to choose.</span>}
      </button>
      <div class="drop-options">
        <PartField />
        {file && measured.value && (
          <label class="field"><span>Width of the surface</span><NumberField id="outline-width" label="Width of the surface" least={LEAST_LENGTH} value={width.value} quantity="length" onChange={setWidth} onReadable={(is) => setReadable('width', is)} /></label>
        )}
        <TileFields takesFaces={takesFaces} />
        {advice && <p class={advice.isPossible ? 'hint' : 'drop-trouble'} role="status" id="size-advice">{advice.words}</p>}
        <div class="field"><span>Patterns</span>
          <Choice label="Patterns to begin with" value={painting.value} onPick={(value) => (painting.value = value)}
            options={[{ value: 'one', title: 'one that can be made' }, { value: 'bare', title: 'none, I paint' }]} />
        </div>
        <Button id="make" kind="main" wide title={takesFaces ? 'Paint its faces' : 'Cover it with tiles'} label={!takesFaces && tilesAbout.value ? `Make it, of about ${tilesAbout.value} tiles` : 'Make it'} disabled={!file || busy || wrong} onPress={make} />
      </div>
    </div>
  );
}

/** Which of several parts of a drawing. */
function PartField() {
  const parts = measured.value?.parts ?? [];
  if (parts.length < 2) return null;
  const size = ([w, h]: Point): string => `${shown(w, 'length')} × ${shown(h, 'length')}`;
  const options = parts.map((one, at) => ({ value: at === 0 ? LARGEST : `${at + 1}`, title: `${at + 1}, ${at === 0 ? 'the largest, ' : ''}${size(one)}` }));
  return (
    <div class="field"><span>Part of the drawing</span>
      <Choice id="outline-part" label="Part of the drawing" value={part.value} onPick={(which) => void choosePart(which)}
        options={[...options, { value: ALL, title: `all ${parts.length}; each needs supports` }]} />
    </div>
  );
}

/** New tiles of some side, or the faces of a mesh. */
function TileFields({ takesFaces }: { takesFaces: boolean }) {
  return (
    <>
      {isMesh.value && <Check label="Take its faces as tiles" value={keepsFaces.value} onChange={(value) => (keepsFaces.value = value)} />}
      {!takesFaces && <label class="field"><span>Side of the tiles</span><NumberField id="tile-size" label="Side of the tiles" least={LEAST_LENGTH} value={tileSize.value} quantity="length" onChange={(value) => (tileSize.value = value)} onReadable={(is) => setReadable('tiles', is)} /></label>}
    </>
  );
}

function MeasuredOutline({ name }: { name: string }) {
  const now = measured.value;
  if (outlineTrouble.value) return <span><b>{name}</b><br /><span class="drop-trouble" role="alert" id="outline-trouble">{inShownUnits(outlineTrouble.value)}</span></span>;
  return (
    <span>
      <b>{name}</b><br />
      {now && <>{shown(width.value, 'length')} × {shown(height.value, 'length')}{width.value !== now.size[0] && <>, drawn {shown(now.size[0], 'length')} wide</>}<br /></>}
      {now?.remarks?.map((remark) => <span key={remark} class="remark">{inShownUnits(remark)}<br /></span>)}
      another one …
    </span>
  );
}

function Preview({ of: { loops, size } }: { of: Measured }) {
  const xs = loops.flat().map(([x]) => x);
  const ys = loops.flat().map(([, y]) => y);
  const [left, top] = [Math.min(...xs), Math.max(...ys)];
  const zoom = Math.min(PREVIEW.width / size[0], PREVIEW.height / size[1]);
  const path = loops.map((loop) => `M${loop.map(([x, y]) => `${(zoom * (x - left)).toFixed(1)} ${(zoom * (top - y)).toFixed(1)}`).join('L')}Z`).join('');
  return (
    <svg class="outline-preview" width={zoom * size[0] + 4} height={zoom * size[1] + 4} viewBox={`-2 -2 ${zoom * size[0] + 4} ${zoom * size[1] + 4}`} aria-hidden="true">
      <path d={path} />
    </svg>
  );
}
