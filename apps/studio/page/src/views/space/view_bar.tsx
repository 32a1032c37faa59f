// SPDX-License-Identifier: GPL-3.0-or-later
// Named views, how large displacements are drawn, what they are coloured by.

import { Axis3d, Camera, Maximize, RectangleHorizontal, Square } from 'lucide-preact';
import { field, SCALES, scale } from '../../document/look';
import { compared } from '../../document/store';
import { Button, Choice } from '../../widgets/widgets';
import { savePicture } from '../../document/files';
import { currentScene } from './current';
import { available, FIELDS } from './fields';

const stepOf = (value: number): number => SCALES.reduce((best, step, i) => (Math.abs(step - value) < Math.abs(SCALES[best] - value) ? i : best), 0);

export function ViewBar() {
  const options = FIELDS.filter((row) => available(row, Boolean(compared.value?.solution)));
  const scene = currentScene.value;
  return (
    <div class="view-bar">
      <div class="card bar-group">
        <Button kind="bare" title="From the corner" shortcut="5" icon={Axis3d} onPress={() => scene?.look('iso')} />
        <Button kind="bare" title="From above" shortcut="6" icon={Square} onPress={() => scene?.look('top')} />
        <Button kind="bare" title="From the front" shortcut="7" icon={RectangleHorizontal} onPress={() => scene?.look('front')} />
        <Button kind="bare" title="See all of it" shortcut="F" icon={Maximize} onPress={() => scene?.look(null)} />
        <Button kind="bare" title="Save a picture with transparent ground" icon={Camera} onPress={() => void savePicture()} />
      </div>
      <div class="card bar-group grow">
        <label class="scale" data-tip="Displacements are drawn this many times as large as they are. Forces and numbers stay true.">
          <span>Scale</span>
          <input type="range" aria-label="Scale of displacements" min={0} max={SCALES.length - 1} step={1} value={stepOf(scale.value)}
            onInput={(event) => (scale.value = SCALES[Number(event.currentTarget.value)])} />
          <output id="scale-words">{scale.value === 1 ? 'true size' : `${scale.value} ×`}</output>
        </label>
      </div>
      <div class="card bar-group">
        <Choice id="field" label="Colour by" value={field.value} options={options.map(({ name, title }) => ({ value: name, title }))} onPick={(name) => (field.value = name)} />
      </div>
    </div>
  );
}
