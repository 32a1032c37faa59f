// SPDX-License-Identifier: GPL-3.0-or-later

import { newGesture } from '../document/edits';
import { markInput } from '../document/latency';
import { beginFactor, loadFactor, MOST_FACTOR, setFactor, slideFactor } from '../document/load_factor';
import { isLoaded } from '../document/marks';
import { NumberField } from '../widgets/number';
import { W } from '../words';

const STEP = 0.01;
let gesture = newGesture('factor');

function begin(): void {
  gesture = newGesture('factor');
  beginFactor();
}

/** Slides all loads at once, and the surface follows. */
export function LoadFactor() {
  const factor = loadFactor.value;
  if (!isLoaded.value && factor === 1) return null;
  return (
    <>
      <h2>{W.loadFactor.title}</h2>
      <div class="slider" data-tip={W.loadFactor.tip}>
        <input id="load-factor" type="range" aria-label={W.loadFactor.slide} min={0} max={Math.max(MOST_FACTOR, factor)} step={STEP} value={factor}
          onPointerDown={begin} onKeyDown={(event) => !event.repeat && begin()}
          onInput={(event) => {
            markInput(event.timeStamp);
            slideFactor(Number(event.currentTarget.value), gesture);
          }} />
        <NumberField narrow id="load-factor-number" label={W.loadFactor.title} value={factor} quantity="factor" onChange={setFactor} />
      </div>
    </>
  );
}
