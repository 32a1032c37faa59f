// SPDX-License-Identifier: GPL-3.0-or-later
// What the search may do, how it is doing, and its end by hand.

import { Play, Square } from 'lucide-preact';
import { designing, misfits } from '../document/design';
import { runDesign, stopDesign, wish } from '../document/design_search';
import { isHeld, isLoaded } from '../document/marks';
import { documentNow } from '../document/store';
import { target } from '../document/target';
import { designPicks, selectedTiles } from '../document/ui';
import { digits } from '../document/units';
import { Button, Check, Choice, Segments } from '../widgets/widgets';
import { NumberField } from '../widgets/number';
import { W } from '../words';

/** What is missing before a design can run; null: nothing. */
function missing(): string | null {
  if (!isHeld.value || !isLoaded.value) return W.design.needsLoad;
  if (target.value.length === 0) return W.design.needsTarget;
  if (wish.tiles.value === 'selected' && selectedTiles.value.size === 0) return W.design.needsTiles;
  return null;
}

export function DesignSearch() {
  const chosen = selectedTiles.value.size;
  const palettes = [
    { value: 'sample:64' as const, title: W.design.paletteSample },
    { value: 'document' as const, title: W.design.paletteDocument },
    ...(documentNow.value?.library ? [{ value: 'library' as const, title: W.design.paletteLibrary }] : []),
  ];
  return (
    <>
      <h2>{W.design.tiles}</h2>
      <Segments full label={W.design.tiles} value={wish.tiles.value} options={[{ value: 'all', title: W.design.all }, { value: 'selected', title: W.design.selection(chosen) }]}
        onPick={(tiles) => {
          wish.tiles.value = tiles;
          designPicks.value = tiles === 'selected' ? 'tiles' : 'nodes';
        }} />
      {wish.tiles.value === 'selected' && chosen === 0 && <p class="hint">{W.design.selectTiles}</p>}
      <h2>{W.design.search}</h2>
      <div class="field"><span>{W.design.palette}</span>
        <Choice id="design-palette" label={W.design.palette} value={wish.palette.value} options={palettes} onPick={(value) => (wish.palette.value = value)} />
      </div>
      <label class="field"><span>{W.design.most}</span>
        <NumberField id="most-patterns" label={W.design.mostLabel} least={1} value={wish.mostPatterns.value} quantity="plain"
          onChange={(value) => (wish.mostPatterns.value = Math.round(value))} onClear={() => (wish.mostPatterns.value = undefined)} empty={W.design.any} />
      </label>
      <Check label={W.design.factor} tip={W.design.factorTip} value={wish.freeFactor.value} onChange={(value) => (wish.freeFactor.value = value)} />
      <Running />
    </>
  );
}

function Running() {
  const now = designing.value;
  const why = missing();
  const best = misfits.value.at(-1);
  if (!now) {
    return (
      <>
        <div class="row run-design"><Button id="run-design" kind="main" title={why ?? W.design.runTip} icon={Play} label={W.design.run} disabled={why !== null} onPress={() => void runDesign()} /></div>
        {why && <p class="hint" id="design-needs">{why}</p>}
      </>
    );
  }
  return (
    <div class="designing" role="status">
      <MisfitCurve />
      <div class="working">
        <span><i class="pulse" /> {W.design.running(now.solutions)}{best !== undefined && `, ${W.design.misfit(digits(100 * best))}`}</span>
        <Button id="stop-design" title={W.design.stopTip} icon={Square} label={W.design.stop} onPress={stopDesign} />
      </div>
    </div>
  );
}

const [WIDE, HIGH] = [240, 44];

/** The misfit from the first painting to the best so far. */
export function MisfitCurve() {
  const values = misfits.value;
  if (values.length < 2) return null;
  const most = Math.max(...values);
  const at = values.map((value, i) => `${(WIDE * i) / (values.length - 1)},${HIGH - (HIGH - 4) * (value / (most || 1))}`);
  return <svg class="misfits" viewBox={`0 0 ${WIDE} ${HIGH}`} preserveAspectRatio="none" aria-hidden="true"><polyline points={at.join(' ')} /></svg>;
}
