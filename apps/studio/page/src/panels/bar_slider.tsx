// SPDX-License-Identifier: GPL-3.0-or-later

import { dragSetting, newGesture } from '../document/edits';
import { markInput } from '../document/latency';
import type { Setting } from '../protocol/messages';

const LEAST = 1e-4;
const STEP = 1e-5;

interface BarSliderProps {
  label: string;
  id: string;
  /** m */
  value: number;
  setting: Setting;
  settingOf: (value: number) => Setting;
}
let gesture = newGesture('bar');

/** A length of the section to slide, up to a third of a tile's side; the surface follows, and one slide is one step of undo. */
export function BarSlider({ label, id, value, setting, settingOf }: BarSliderProps) {
  const most = Math.max(setting.tile_side / 3, value, 2 * LEAST);
  return (
    <input id={id} type="range" aria-label={label} min={Math.min(LEAST, value)} max={most} step={STEP} value={value}
      onPointerDown={() => (gesture = newGesture('bar'))}
      onKeyDown={(event) => !event.repeat && (gesture = newGesture('bar'))}
      onInput={(event) => {
        markInput(event.timeStamp);
        dragSetting(settingOf(Number(event.currentTarget.value)), gesture);
      }} />
  );
}
