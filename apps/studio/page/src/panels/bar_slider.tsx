// SPDX-License-Identifier: GPL-3.0-or-later

import { dragSetting } from '../document/edits';
import type { Setting } from '../protocol/messages';
import { DragSlider } from './drag_slider';

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

/** A length of the section to slide, up to a third of a tile's side; the surface follows, and one slide is one step of undo. */
export function BarSlider({ label, id, value, setting, settingOf }: BarSliderProps) {
  const most = Math.max(setting.tile_side / 3, value, 2 * LEAST);
  return (
    <DragSlider id={id} label={label} least={Math.min(LEAST, value)} most={most} step={STEP} value={value} onSlide={(next, slide) => dragSetting(settingOf(next), slide)} />
  );
}
