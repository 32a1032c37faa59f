// SPDX-License-Identifier: GPL-3.0-or-later

import { Gauge, Play, Scale } from 'lucide-preact';
import { cancelWork, solveFull } from '../document/edits';
import { field, scale, shadows, showFull, showMarks, showRest } from '../document/look';
import { shapeIndex } from '../document/look';
import { stop } from '../document/shown';
import { compared, documentNow, live, notTheAnswer, others, problem, shapes, working } from '../document/store';
import { tryAsk } from '../document/studio';
import { probed } from '../document/ui';
import { digits, inShownUnits, shown } from '../document/units';
import { Button, Check } from '../widgets/widgets';
import { MaterialFields } from './material_fields';
import { Models } from './models';
import { W } from '../words';

const PATH_STEPS = 20;
const MODE_COUNT = 6;

export function LookPanel() {
  return (
    <div class="panel-scroll">
      <h2>{W.lookPanel.model}</h2>
      <Models />
      <h2>{W.lookPanel.result}</h2>
      <Answer />
      <h2>{W.lookPanel.fullModel}</h2>
      <FullModel />
      <h2>{W.lookPanel.animate}</h2>
      <div class="row">
        <Button title={W.lookPanel.deformationAsTheLoad} icon={Play} label={W.lookPanel.loadPath} disabled={!live.value} onPress={() => void animate(() => tryAsk('path', { steps: PATH_STEPS }))} />
        <Button title={W.lookPanel.naturalFrequencies} label={W.lookPanel.modes} onPress={() => void animate(() => tryAsk('modes', { count: MODE_COUNT }))} />
        <Button title={W.lookPanel.criticalLoadFactors} label={W.lookPanel.buckling} onPress={() => void animate(() => tryAsk('buckling', { count: MODE_COUNT }))} />
      </div>
      <h2>{W.lookPanel.show}</h2>
      <Check label={W.lookPanel.undeformedShape} value={showRest.value} onChange={(value) => (showRest.value = value)} />
      <Check label={W.lookPanel.supportsAndLoads} value={showMarks.value} onChange={(value) => (showMarks.value = value)} />
      <Check label={W.lookPanel.shadows} value={shadows.value} onChange={(value) => (shadows.value = value)} />
      <h2>{W.lookPanel.materialAndBars}</h2>
      <MaterialFields />
    </div>
  );
}

async function animate(begin: () => Promise<object | null>): Promise<void> {
  stop();
  shapes.value = null;
  shapeIndex.value = 0;
  working.value = { model: 'full', share: 0, background: true };
  if (!(await begin())) working.value = null;
}

function Answer() {
  const now = live.value;
  if (problem.value) return <p class="trouble">{inShownUnits(problem.value)}</p>;
  if (!now) return <p class="hint">{W.lookPanel.paintTheSurfaceAdd}</p>;
  const { info } = now;
  if (notTheAnswer.value) return <p class="trouble">{notTheAnswer.value}</p>;
  return (
    <>
      <dl class="facts">
        <dt>{W.lookPanel.largestDisplacement}</dt><dd id="largest" data-value={info.largest_displacement}>{shown(info.largest_displacement, 'length')}</dd>
        <dt>{W.lookPanel.computedIn}</dt><dd>{W.lookPanel.milliseconds(digits(1000 * info.seconds))}</dd>
        {info.stable === false && <><dt>{W.lookPanel.stable}</dt><dd class="bad">{W.lookPanel.no}</dd></>}
      </dl>
      {info.warnings.map((warning) => <p key={warning} class="warning">{warning}</p>)}
      {info.reactions && info.reactions.length > 0 && (
        <details>
          <summary>{W.lookPanel.reactions(info.reactions.length)}</summary>
          <table class="reactions">
            <thead><tr><th>{W.lookPanel.node}</th><th>x</th><th>y</th><th>z</th></tr></thead>
            <tbody>
              {info.reactions.map(({ node, force }) => (
                <tr key={node} tabIndex={0} onClick={() => (probed.value = { kind: 'node', index: node })}>
                  <td>{node}</td>{force.map((value, i) => <td key={i}>{shown(value, 'force')}</td>)}
                </tr>
              ))}
            </tbody>
          </table>
        </details>
      )}
    </>
  );
}

function FullModel() {
  const busy = working.value;
  const full = others.value.get('full');
  const isLive = documentNow.value?.model === 'full';
  const error = compared.value;
  const compare = async () => {
    scale.value = 1;
    field.value = 'error';
    await tryAsk('compare', { model: 'full' });
  };
  if (isLive) return <p class="hint">{W.lookPanel.theLiveModelIs}</p>;
  if (busy?.background) {
    return (
      <div class="working">
        <div class="progress" role="progressbar" aria-valuenow={Math.round(100 * busy.share)}><div style={{ width: `${100 * busy.share}%` }} /></div>
        <Button title={W.lookPanel.stop} label={W.lookPanel.cancel} onPress={cancelWork} />
      </div>
    );
  }
  return (
    <>
      <div class="row">
        <Button id="solve-full" title={W.lookPanel.solveOnceWithEvery} icon={Gauge} label={full ? W.lookPanel.solveAgain : W.lookPanel.solveFullModel} disabled={!live.value} onPress={() => void solveFull()} />
        <Button id="error-map" title={full ? W.lookPanel.colourByTheDistance : W.lookPanel.solveTheFullModel} icon={Scale} label={W.lookPanel.errorMap} disabled={!full} onPress={() => void compare()} />
      </div>
      {!full && <p class="hint" id="error-map-needs">{W.lookPanel.solveTheFullModel2}</p>}
      {full && <Check label={W.lookPanel.overlayFullModel} value={showFull.value} onChange={(value) => (showFull.value = value)} />}
      {full && <p class="hint">{W.lookPanel.fullDisplacement(shown(full.info.largest_displacement, 'length'), digits(full.info.seconds))}</p>}
      {error && <p class="hint">{W.lookPanel.error(shown(error.mean, 'length'), shown(error.largest, 'length'), digits(100 * error.relative))}</p>}
    </>
  );
}
