// SPDX-License-Identifier: GPL-3.0-or-later

import { Download, LayoutGrid, MoveVertical, RotateCcw, Weight } from 'lucide-preact';
import { addLoad, addPrescribed, editLoadCase, setSetting } from '../document/edits';
import { hasGravity, isLoaded, loadMarks, prescribedMarks } from '../document/marks';
import { boxOfAll, whereChosen } from '../document/picked';
import { documentNow, loadCase } from '../document/store';
import { activeEntry, selectedNodes } from '../document/ui';
import { STANDARD_GRAVITY } from '../document/units';
import { Button, Check } from '../widgets/widgets';
import { NumberField } from '../widgets/number';
import { CaseBar } from './case_bar';
import { Combination } from './combination';
import { ChosenNodes } from './chosen_nodes';
import { LoadFactor } from './load_factor';
import { LoadRow } from './load_row';
import { PrescribedRow } from './prescribed_row';
import { W } from '../words';

const FIRST_FORCE = -0.1;
const FIRST_MOMENT = 0.002;
const FIRST_MOVE = 0.01;
const FIRST_AREA_LOAD = -2;

export function pressChosen(): void {
  if (!selectedNodes.peek().size) return;
  activeEntry.value = { kind: 'load', index: loadMarks.peek().length };
  addLoad({ ...whereChosen(), force: [0, 0, FIRST_FORCE], amount: 'total' });
  selectedNodes.value = new Set();
}

function turnChosen(): void {
  activeEntry.value = { kind: 'load', index: loadMarks.peek().length };
  addLoad({ ...whereChosen(), moment: [0, FIRST_MOMENT, 0], amount: 'total' });
  selectedNodes.value = new Set();
}

function moveChosen(): void {
  activeEntry.value = { kind: 'prescribed', index: prescribedMarks.peek().length };
  addPrescribed({ ...whereChosen(), uz: FIRST_MOVE });
  selectedNodes.value = new Set();
}

/** Puts a load per area on what is chosen, or on all. */
function coverChosen(): void {
  const box = boxOfAll();
  if (!box) return;
  const where = selectedNodes.peek().size ? whereChosen() : { box };
  activeEntry.value = { kind: 'load', index: loadMarks.peek().length };
  addLoad({ ...where, per_area: [0, 0, FIRST_AREA_LOAD] });
  selectedNodes.value = new Set();
}

export function LoadPanel() {
  const some = selectedNodes.value.size > 0;
  const nothing = loadMarks.value.length === 0 && prescribedMarks.value.length === 0;
  return (
    <>
      <CaseBar />
      <div class="panel-scroll">
        <ChosenNodes purpose="load" />
        <div class="row">
          <Button id="add-force" title={W.loadPanel.applyAForceTo} shortcut="X" disabled={!some} icon={Download} label={W.loadPanel.force} onPress={pressChosen} />
          <Button title={W.loadPanel.applyAMomentTo} disabled={!some} icon={RotateCcw} label={W.loadPanel.moment} onPress={turnChosen} />
          <Button title={W.loadPanel.prescribeADisplacementOf} disabled={!some} icon={MoveVertical} label={W.loadPanel.displace} onPress={moveChosen} />
        </div>
        <div class="row">
          <Button id="add-area-load" title={W.loadPanel.loadPerSquareMetre} icon={LayoutGrid} label={some ? W.loadPanel.areaLoad : W.loadPanel.areaLoadEverywhere} onPress={coverChosen} />
        </div>
        <h2>{W.loadPanel.weight}</h2>
        <Gravity />
        <h2>{W.loadPanel.loads}</h2>
        {nothing && !isLoaded.value && <p class="hint">{W.loadPanel.noLoadsYetSelect}</p>}
        <ul class="entries">
          {loadMarks.value.map((mark) => <LoadRow key={`load-${mark.index}`} mark={mark} />)}
          {prescribedMarks.value.map((mark) => <PrescribedRow key={`move-${mark.index}`} mark={mark} />)}
        </ul>
        <LoadFactor />
        <Combination />
      </div>
    </>
  );
}

function Gravity() {
  const gravity = loadCase.value?.gravity ?? [0, 0, 0];
  const setting = documentNow.value?.setting;
  const on = hasGravity.value;
  return (
    <div class="gravity">
      <Check label={<><Weight aria-hidden />{W.loadPanel.selfWeight}</>} value={on} onChange={(value) => void editLoadCase(() => ({ gravity: [0, 0, value ? -STANDARD_GRAVITY : 0] }))} />
      {on && setting && (
        <>
          <label class="field"><span>{W.loadPanel.gravityAlongZ}</span>
            <NumberField label={W.loadPanel.gravityAlongZ} value={gravity[2]} quantity="acceleration" onChange={(z) => void editLoadCase(() => ({ gravity: [gravity[0], gravity[1], z] }))} />
          </label>
          <label class="field"><span>{W.loadPanel.density}</span>
            <NumberField label={W.loadPanel.materialDensity} least={0} value={setting.material.density} quantity="density"
              onChange={(density) => setSetting({ ...setting, material: { ...setting.material, density } })} />
          </label>
        </>
      )}
    </div>
  );
}
