// SPDX-License-Identifier: GPL-3.0-or-later

import { Dices, ImageDown, PaintBucket, RotateCw, X } from 'lucide-preact';
import { paint, paintBy, setTileModel, turn } from '../document/edits';
import { documentNow, hello } from '../document/store';
import { surface } from '../document/surface';
import { tell } from '../document/tell';
import { brushOrFirst, selectedTiles } from '../document/ui';
import { Gallery } from '../gallery/gallery';
import { orderedPalette } from '../gallery/order';
import { pngInBase64 } from '../painting/read_image';
import { Button, Choice } from '../widgets/widgets';
import { retileOpen } from '../tiles/retile';
import { obstacle } from './models';
import { RetilePanel } from '../tiles/retile_panel';
import { W } from '../words';

const targets = (): number[] => {
  const chosen = [...selectedTiles.peek()];
  return chosen.length ? chosen : (surface.peek()?.centers.map((_, tile) => tile) ?? []);
};

let seed = 1;

async function paintImage(file: File): Promise<void> {
  try {
    paintBy({ patterns: 'image:', palette: orderedPalette.peek(), file: { name: file.name, text_base64: await pngInBase64(file) } });
  } catch (error) {
    tell((error as Error).message, 'error');
  }
}

function chooseImage(): void {
  const input = Object.assign(document.createElement('input'), { type: 'file', accept: 'image/*' });
  input.onchange = () => input.files?.[0] && void paintImage(input.files[0]);
  input.click();
}

export function PaintPanel() {
  if (retileOpen.value) return <RetilePanel />;
  return <Painting />;
}

function Painting() {
  const chosen = selectedTiles.value;
  const models = hello.value?.models ?? [];
  const model = documentNow.value?.tile_models[[...chosen][0]] ?? '';
  return (
    <>
      <Gallery />
      <footer class="panel-foot">
        <div class="foot-head">
          <span id="tiles-chosen">{chosen.size ? W.paintPanel.selected(chosen.size) : W.paintPanel.allTiles}</span>
          {chosen.size > 0 && <Button kind="bare" title={W.paintPanel.clearSelection} shortcut="Esc" icon={X} onPress={() => (selectedTiles.value = new Set())} />}
        </div>
        <div class="row">
          <Button title={W.paintPanel.paintWithThePattern} icon={PaintBucket} label={W.paintPanel.fill}
            onPress={() => { const pattern = brushOrFirst.value; if (pattern) paint(targets(), pattern); }} />
          <Button title={W.paintPanel.randomPatternsFromThe} icon={Dices} label={W.paintPanel.random}
            onPress={() => paintBy({ patterns: `random:${seed++}`, palette: orderedPalette.value })} />
          <Button title={W.paintPanel.paintFromAPicture} icon={ImageDown} label={W.paintPanel.image} onPress={chooseImage} />
          <Button title={W.paintPanel.rotateThePatternsBy} shortcut="T" icon={RotateCw} onPress={() => turn(targets(), 1)} />
        </div>
        {chosen.size > 0 && (
          <div class="field"><span>{W.paintPanel.model}</span>
            <Choice label={W.paintPanel.modelOfTheSelected} value={model} onPick={(name) => setTileModel([...chosen], name)}
              options={[{ value: '', title: W.paintPanel.sameAsAll }, ...models.filter(({ share }) => !share).map((one) => ({ value: one.name, title: one.name, disabled: obstacle(one) !== null }))]} />
          </div>
        )}
      </footer>
    </>
  );
}
