// SPDX-License-Identifier: GPL-3.0-or-later

import { beginFactor, loadFactor, MOST_FACTOR, setFactor, slideFactor } from '../document/load_factor';
import { isLoaded } from '../document/marks';
import { NumberField } from '../widgets/number';
import { DragSlider } from './drag_slider';
import { W } from '../words';

const STEP = 0.01;

/** Slides all loads at once, and the surface follows. */
export function LoadFactor() {
  const factor = loadFactor.value;
  if (!isLoaded.value && factor === 1) return null;
  return (
    <>
      <h2>{W.loadFactor.title}</h2>
      <div class="slider" data-tip={W.loadFactor.tip}>
        <DragSlider id="load-factor" label={W.loadFactor.slide} least={0} most={Math.max(MOST_FACTOR, factor)} step={STEP} value={factor} onBegin={beginFactor} onSlide={slideFactor} />
        <NumberField narrow id="load-factor-number" label={W.loadFactor.title} value={factor} quantity="factor" onChange={setFactor} />
      </div>
    </>
  );
}
