// SPDX-License-Identifier: GPL-3.0-or-later

import { useEffect, useState } from 'preact/hooks';
import { Check, X } from 'lucide-preact';
import { startOpen } from '../document/ui';
import { Button } from '../widgets/widgets';
import { W } from '../words';
import { isLast, leaveTour, nextStep, pointers, step, stepDone, STEPS, tourStep } from './tour';
import './tour.css';

const LOOK_MS = 150;
const ROOM = 5;

export function TourCard() {
  const now = step.value;
  if (!now || startOpen.value) return null;
  const number = (tourStep.value ?? 0) + 1;
  return (
    <>
      <Ring />
      <section class="card tour" aria-label={W.tour.title} data-step={number} data-done={stepDone.value}>
        <header role="none">
          <span>{W.tour.step(number, STEPS.length)}</span>
          <Button kind="bare" id="tour-leave" title={W.tour.leave} icon={X} onPress={leaveTour} />
        </header>
        <h2>{now.title}</h2>
        <p aria-live="polite">{now.words}</p>
        <div class="row">
          <span class="tour-state" role="status">{stepDone.value ? <><Check aria-hidden />{W.tour.done}</> : W.tour.waiting}</span>
          <Button id="tour-next" kind="main" title={isLast.value ? W.tour.endTip : W.tour.nextTip} label={isLast.value ? W.tour.end : W.tour.next} disabled={!stepDone.value} onPress={nextStep} />
        </div>
      </section>
    </>
  );
}

interface Place {
  left: number;
  top: number;
  width: number;
  height: number;
}

function placeOf(selectors: readonly string[]): Place | null {
  const found = selectors.map((selector) => document.querySelector(selector)).filter((one) => one !== null);
  const box = found.at(-1)?.getBoundingClientRect();
  return box && box.width > 0 ? { left: box.left - ROOM, top: box.top - ROOM, width: box.width + 2 * ROOM, height: box.height + 2 * ROOM } : null;
}

/** A ring around what the step is done with. It takes no clicks. */
function Ring() {
  const [place, setPlace] = useState<Place | null>(null);
  const selectors = pointers.value;
  useEffect(() => {
    const look = () => setPlace((old) => {
      const next = placeOf(selectors);
      return JSON.stringify(old) === JSON.stringify(next) ? old : next;
    });
    look();
    const timer = setInterval(look, LOOK_MS);
    return () => clearInterval(timer);
  }, [selectors]);
  if (!place) return null;
  return <div class="tour-ring" aria-hidden="true" style={{ left: `${place.left}px`, top: `${place.top}px`, width: `${place.width}px`, height: `${place.height}px` }} />;
}
