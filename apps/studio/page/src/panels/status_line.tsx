// SPDX-License-Identifier: GPL-3.0-or-later
// The line at the bottom: what is wrong and where, how far the model is off, what the surface is made of, how the solver is doing.

import { signal } from '@preact/signals';
import { TriangleAlert } from 'lucide-preact';
import { estimated, hello, live, making, notTheAnswer, setting } from '../document/store';
import { lookedAt, nextPlace, problemCount, problems, type Problem } from '../document/truth';
import { digits } from '../document/units';
import { mode, split } from '../document/ui';
import { seePlace } from '../views/plane/viewport';
import { W } from '../words';
import { materialName } from './material_fields';
import { Status } from './next_step';
import './status_line.css';

const open = signal(false);

function goTo({ kind }: Problem): void {
  const place = nextPlace(kind);
  if (split.peek() === 'space') split.value = 'both';
  if (place) seePlace(place);
}

export function StatusLine() {
  return (
    <footer class="status-line" aria-label={W.truth.line}>
      <Problems />
      <ModelError />
      <span class="gap" />
      <MadeOf />
      <Status />
    </footer>
  );
}

function Problems() {
  const count = problemCount.value;
  if (count === 0) {
    const words = making.value ? W.truth.clear : live.value ? W.truth.looking : '';
    return <span id="problems" class="status-item">{making.value && <i class="ready" />}{words}</span>;
  }
  return (
    <span class="anchor" onKeyDown={(event) => event.key === 'Escape' && (open.value = false)}>
      <button type="button" id="problems" class="status-item bad" aria-expanded={open.value} data-tip={W.truth.open} onClick={() => (open.value = !open.value)}>
        <TriangleAlert aria-hidden />{W.truth.problems(count)}
      </button>
      {open.value && (
        <div class="card problem-list" role="group" aria-label={W.truth.list}>
          {problems.value.map((problem) => <ProblemRow key={problem.kind} problem={problem} />)}
        </div>
      )}
    </span>
  );
}

function ProblemRow({ problem }: { problem: Problem }) {
  const { kind, count, places } = problem;
  const at = lookedAt.value?.kind === kind ? lookedAt.value.index + 1 : 0;
  return (
    <button type="button" data-problem={kind} onClick={() => goTo(problem)}>
      <span>{W.truth[kind](count)}</span>{at > 0 && <i>{W.truth.place(at, places.length)}</i>}
    </button>
  );
}

/** The model is the reference itself, or nothing is known of its error. */
const hasNoEstimate = (model: string, doubtful: boolean | null): boolean =>
  doubtful === null || hello.value?.models.find(({ name }) => name === model)?.reference === true;

function ModelError() {
  const info = live.value?.info;
  if (!info || notTheAnswer.value || info.provisional || hasNoEstimate(info.model, info.doubtful)) return null;
  if (!info.doubtful) return <span class="status-item" id="model-error" data-tip={W.truth.errorSmallTip}>{W.truth.errorSmall}</span>;
  const error = estimated.value;
  if (!error) return <span class="status-item" id="model-error">{W.truth.doubtful}</span>;
  const [mean, largest] = [digits(100 * error.mean, 2), digits(100 * error.largest, 2)];
  const stress = error.largest_stress === null ? '' : W.truth.stressErrorTip(digits(100 * error.largest_stress, 2));
  return (
    <button type="button" class={`status-item${error.is_warned ? ' doubt' : ''}`} id="model-error" data-tip={W.truth.errorTip(mean, largest) + stress} onClick={() => (mode.value = 'look')}>
      {W.truth.error(largest)}
    </button>
  );
}

function MadeOf() {
  const now = setting.value;
  if (!now) return null;
  const joints = now.joints ?? 'centreline';
  return (
    <button type="button" class="status-item" id="made-of" data-tip={W.truth.jointsTip[joints] ?? joints} onClick={() => (mode.value = 'look')}>
      {W.truth.setting(materialName(now.material), W.truth.joints[joints] ?? joints)}
    </button>
  );
}
