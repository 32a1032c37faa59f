// SPDX-License-Identifier: GPL-3.0-or-later
// One line that says what to do next, until the surface bends; and what is wrong when it does not.

import { isHeld, isLoaded } from '../document/marks';
import { tilePatterns } from '../document/patterns_now';
import { documentNow, live, notTheAnswer, problem, working } from '../document/store';
import { inShownUnits } from '../document/units';
import { mode, type Mode } from '../document/ui';
import { W } from '../words';

interface Step {
  text: string;
  action?: string;
  to?: Mode;
  tone: 'step' | 'trouble';
}

function stepNow(): Step | null {
  if (!documentNow.value) return null;
  const bare = tilePatterns.value.filter((pattern) => pattern === '').length;
  if (bare > 0) return { text: W.nextStep.unpainted(bare), action: W.nextStep.paint, to: 'paint', tone: 'step' };
  if (!isHeld.value) return { text: W.nextStep.nextAddSupports, action: W.nextStep.addSupports, to: 'hold', tone: 'step' };
  if (!isLoaded.value) return { text: W.nextStep.nextAddALoad, action: W.nextStep.addALoad, to: 'load', tone: 'step' };
  if (problem.value) return { text: W.nextStep.noResult(problem.value), tone: 'trouble' };
  if (notTheAnswer.value) return { text: W.nextStep.theShapeShownIs(notTheAnswer.value), tone: 'trouble' };
  return null;
}

export function NextStep() {
  const step = stepNow();
  if (!step) return null;
  const here = step.to === mode.value;
  return (
    <div class={`card next-step ${step.tone}`} role="status">
      <span>{inShownUnits(step.text)}</span>
      {step.action && !here && (
        <button type="button" class="button main" id="next-step" onClick={() => (mode.value = step.to as Mode)}>{step.action}</button>
      )}
    </div>
  );
}

/** How the live model is doing, in the top bar. */
export function Status() {
  const busy = working.value;
  const now = live.value;
  if (busy) return <span class="status" aria-live="polite"><i class="pulse" />{W.nextStep.computing(busy.background ? W.nextStep.inTheBackground : busy.model, Math.round(100 * busy.share))}</span>;
  if (notTheAnswer.value || !now) return <span class="status" />;
  if (now.info.provisional) return <span class="status" aria-live="off"><i class="pulse" />{W.nextStep.solving}</span>;
  return <span class="status" data-tip={W.nextStep.timeOfTheLast}><i class="ready" />{W.nextStep.milliseconds(Math.max(1, Math.round(1000 * now.info.seconds)))}</span>;
}
