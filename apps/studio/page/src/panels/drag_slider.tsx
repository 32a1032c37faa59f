// SPDX-License-Identifier: GPL-3.0-or-later

import { useRef } from 'preact/hooks';
import { newGesture } from '../document/edits';
import { markInput } from '../document/latency';

interface DragSliderProps {
  label: string;
  id?: string;
  least: number;
  most: number;
  step: number;
  value: number;
  /** Before the first value of a slide. */
  onBegin?: () => void;
  /** @param slide  the key of all edits of one slide, which are one step of undo */
  onSlide: (value: number, slide: string) => void;
}

/** A slider whose edits the surface follows; a slide by the pointer, or a key that is held, is one step of undo. */
export function DragSlider({ label, id, least, most, step, value, onBegin, onSlide }: DragSliderProps) {
  const slide = useRef('');
  const begin = () => {
    slide.current = newGesture('slide');
    onBegin?.();
  };
  return (
    <input id={id} type="range" aria-label={label} min={least} max={most} step={step} value={value}
      onPointerDown={begin} onKeyDown={(event) => !event.repeat && begin()}
      onInput={(event) => {
        if (!slide.current) begin();
        markInput(event.timeStamp);
        onSlide(Number(event.currentTarget.value), slide.current);
      }} />
  );
}
