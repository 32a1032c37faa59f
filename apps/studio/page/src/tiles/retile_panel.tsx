// SPDX-License-Identifier: GPL-3.0-or-later
// Other tiles for the surface, in the place of the patterns while it is open.

import { X } from 'lucide-preact';
import {
  applyTiles, comes, droppedWords, isOtherLayout, lookAhead, paintingWords, patterns, retileTrouble, retiling, side, sideRange, tilesAbout, toggleRetile, wantedAngle,
  wantedLayout, wantedPatterns, wantedSide, type Patterns,
} from './retile';
import { documentNow, hello } from '../document/store';
import { surface } from '../document/surface';
import { brushOrFirst } from '../document/ui';
import { digits, inShownUnits, shown } from '../document/units';
import type { Point } from '../protocol/messages';
import type { Retiled } from '../protocol/requests';
import { Loops } from '../widgets/loops';
import { NumberField } from '../widgets/number';
import { Button, Choice } from '../widgets/widgets';
import { W } from '../words';
import './retile.css';

const LEAST_SIDE = 1e-4;
const STEPS = 400;
const ROOM = { width: 264, height: 164 };

export function RetilePanel() {
  const now = surface.value;
  if (!now) return null;
  const tiles = comes.value;
  return (
    <div class="panel-scroll retile" data-busy={retiling.value}>
      <header role="none">
        <h2>{W.retile.title}</h2>
        <Button kind="bare" id="retile-close" title={W.retile.close} icon={X} onPress={toggleRetile} />
      </header>
      <p class="hint" id="tiles-now">{W.retile.now}: {W.retile.tilesNow(now.tiles.length, shown(now.side, 'length'))}</p>
      <SideFields />
      <OtherFields />
      {retileTrouble.value && <p class="trouble" role="alert" id="retile-trouble">{inShownUnits(retileTrouble.value)}</p>}
      {retiling.value && <p class="busy" role="status"><i class="pulse" />{W.retile.busy}</p>}
      {!tiles && !retiling.value && !retileTrouble.value && tilesAbout.value !== null && <p class="hint">{W.retile.about(digits(tilesAbout.value, 2))}</p>}
      {tiles && <Coming tiles={tiles} />}
      <Button id="retile-apply" kind="main" wide title={W.retile.applyTip} label={W.retile.apply} disabled={!tiles || retiling.value} onPress={() => void applyTiles()} />
    </div>
  );
}

/** The slider says at once how many tiles there will be, and the program makes them when it is let go. */
function SideFields() {
  const { least, most } = sideRange.value;
  return (
    <>
      <label class="field"><span>{W.retile.side}</span>
        <NumberField id="retile-side" label={W.retile.side} least={LEAST_SIDE} value={side.value} quantity="length" onChange={(value) => { wantedSide.value = value; lookAhead(); }} />
      </label>
      <div class="slider">
        <input id="retile-slider" type="range" aria-label={W.retile.slideSide} min={Math.log(least)} max={Math.log(most)} step={Math.log(most / least) / STEPS} value={Math.log(side.value)}
          onInput={(event) => (wantedSide.value = Number(Math.exp(Number(event.currentTarget.value)).toPrecision(3)))} onChange={lookAhead} />
      </div>
    </>
  );
}

function OtherFields() {
  const layouts = hello.value?.layouts ?? [];
  const own = documentNow.value?.layout ?? '';
  const ways: { value: Patterns; title: string; disabled?: boolean }[] = [
    { value: 'keep', title: W.retile.keep, disabled: isOtherLayout.value },
    { value: 'brush', title: W.retile.brush, disabled: isOtherLayout.value || brushOrFirst.value === null },
    { value: 'made:one', title: W.retile.made },
  ];
  const names = layouts.includes(own) ? layouts : [own, ...layouts];
  return (
    <>
      <label class="field" data-tip={W.retile.angleTip}><span>{W.retile.angle}</span>
        <NumberField id="retile-angle" label={W.retile.angle} value={wantedAngle.value ?? undefined} empty={W.retile.bestAngle} quantity="angle"
          onChange={(value) => { wantedAngle.value = value; lookAhead(); }} onClear={() => { wantedAngle.value = null; lookAhead(); }} />
      </label>
      <div class="field"><span>{W.retile.layout}</span>
        <Choice id="retile-layout" label={W.retile.layout} value={wantedLayout.value ?? own} options={names.map((name) => ({ value: name, title: name }))}
          onPick={(name) => { wantedLayout.value = name; lookAhead(); }} />
      </div>
      <div class="field"><span>{W.retile.patterns}</span>
        <Choice id="retile-patterns" label={W.retile.patterns} value={patterns.value} options={ways} onPick={(way) => { wantedPatterns.value = way; lookAhead(); }} />
      </div>
    </>
  );
}

const polygonsOf = ({ vertices = [], polygons = [] }: Retiled): Point[][] => polygons.map((polygon) => polygon.map((vertex) => vertices[vertex]));

function Coming({ tiles }: { tiles: Retiled }) {
  const { side: sides } = tiles;
  const gone = droppedWords(tiles.dropped);
  return (
    <>
      <Loops class="retile-picture" label={W.retile.picture} loops={polygonsOf(tiles)} room={ROOM} />
      <dl class="facts">
        <dt>{W.retile.tiles}</dt><dd id="retile-tiles">{tiles.tiles}</dd>
        <dt>{W.retile.mean}</dt><dd>{shown(sides.mean, 'length')}</dd>
        <dt>{W.retile.range}</dt><dd>{shown(sides.smallest, 'length')} … {shown(sides.largest, 'length')}</dd>
        <dt>{W.retile.deviation}</dt><dd>{shown(sides.deviation, 'length')}</dd>
        <dt>{W.retile.hexagons}</dt><dd>{digits(100 * tiles.hexagon_share, 2)} %</dd>
      </dl>
      {paintingWords(tiles, patterns.value).map((words) => <p key={words} class="hint">{words}</p>)}
      {tiles.unpainted > 0 && <p class="warning">{W.retile.unpainted(tiles.unpainted)}</p>}
      {tiles.remarks.map((remark) => <p key={remark} class="warning">{inShownUnits(remark)}</p>)}
      {gone ? <p class="warning" id="retile-dropped">{gone}</p> : <p class="hint" id="retile-keeps">{W.retile.keepsAll}</p>}
    </>
  );
}
