// SPDX-License-Identifier: GPL-3.0-or-later
// Named views, how large displacements are drawn, what they are coloured by.

import { Axis3d, Box, Camera, Maximize, RectangleHorizontal, Square } from 'lucide-preact';
import { field, projection, SCALES, scale } from '../../document/look';
import { compared } from '../../document/store';
import { Button, Choice } from '../../widgets/widgets';
import { savePicture } from '../../document/files';
import { currentScene } from './current';
import { available, FIELDS } from './fields';
import { W } from '../../words';

const stepOf = (value: number): number => SCALES.reduce((best, step, i) => (Math.abs(step - value) < Math.abs(SCALES[best] - value) ? i : best), 0);

export const switchProjection = (): void => void (projection.value = projection.peek() === 'parallel' ? 'perspective' : 'parallel');

export function ViewBar() {
  const options = FIELDS.filter((row) => available(row, Boolean(compared.value?.solution)));
  const scene = currentScene.value;
  return (
    <div class="view-bar">
      <div class="card bar-group">
        <Button kind="bare" title={W.viewBar.isometric} shortcut="6" icon={Axis3d} onPress={() => scene?.look('iso')} />
        <Button kind="bare" title={W.viewBar.top} shortcut="7" icon={Square} onPress={() => scene?.look('top')} />
        <Button kind="bare" title={W.viewBar.front} shortcut="8" icon={RectangleHorizontal} onPress={() => scene?.look('front')} />
        <Button kind="bare" title={W.viewBar.fitView} shortcut="F" icon={Maximize} onPress={() => scene?.look(null)} />
        <Button kind="bare" id="parallel" title={W.cameras.parallel} shortcut="9" icon={Box} pressed={projection.value === 'parallel'} onPress={switchProjection} />
        <Button kind="bare" title={W.viewBar.saveAPictureWith} icon={Camera} onPress={() => void savePicture()} />
      </div>
      <div class="card bar-group grow">
        <label class="scale" data-tip={W.viewBar.scaleOfTheDrawn}>
          <span>{W.viewBar.scale}</span>
          <input type="range" aria-label={W.viewBar.displacementScale} min={0} max={SCALES.length - 1} step={1} value={stepOf(scale.value)}
            onInput={(event) => (scale.value = SCALES[Number(event.currentTarget.value)])} />
          <output id="scale-words">{scale.value === 1 ? W.viewBar.trueSize : `${scale.value} ×`}</output>
        </label>
      </div>
      <div class="card bar-group">
        <Choice id="field" label={W.viewBar.colourBy} value={field.value} options={options.map(({ name, title }) => ({ value: name, title }))} onPick={(name) => (field.value = name)} />
      </div>
    </div>
  );
}
