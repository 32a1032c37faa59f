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

const PATH_STEPS = 20;
const MODE_COUNT = 6;

export function LookPanel() {
  return (
    <div class="panel-scroll">
      <h2>Model</h2>
      <Models />
      <h2>Answer</h2>
      <Answer />
      <h2>Full model</h2>
      <FullModel />
      <h2>Play</h2>
      <div class="row">
        <Button title="How the surface bends while the load grows" icon={Play} label="Load path" disabled={!live.value} onPress={() => void animate(() => tryAsk('path', { steps: PATH_STEPS }))} />
        <Button title="How it swings by itself, and how fast" label="Modes" onPress={() => void animate(() => tryAsk('modes', { count: MODE_COUNT }))} />
        <Button title="How it buckles, and at how many times the load" label="Buckling" onPress={() => void animate(() => tryAsk('buckling', { count: MODE_COUNT }))} />
      </div>
      <h2>Show</h2>
      <Check label="Shape at rest" value={showRest.value} onChange={(value) => (showRest.value = value)} />
      <Check label="Supports and loads" value={showMarks.value} onChange={(value) => (showMarks.value = value)} />
      <Check label="Shadows" value={shadows.value} onChange={(value) => (shadows.value = value)} />
      <h2>Material and bars</h2>
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
  if (!now) return <p class="hint">Once the surface is painted, held and loaded, what it does stands here.</p>;
  const { info } = now;
  if (notTheAnswer.value) return <p class="trouble">{notTheAnswer.value}</p>;
  return (
    <>
      <dl class="facts">
        <dt>largest displacement</dt><dd id="largest" data-value={info.largest_displacement}>{shown(info.largest_displacement, 'length')}</dd>
        <dt>computed in</dt><dd>{digits(1000 * info.seconds)} ms</dd>
        {info.stable === false && <><dt>stable</dt><dd class="bad">no</dd></>}
      </dl>
      {info.warnings.map((warning) => <p key={warning} class="warning">{warning}</p>)}
      {info.reactions && info.reactions.length > 0 && (
        <details>
          <summary>Reactions at {info.reactions.length} nodes</summary>
          <table class="reactions">
            <thead><tr><th>node</th><th>x</th><th>y</th><th>z</th></tr></thead>
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
  if (isLive) return <p class="hint">The live model is the full one.</p>;
  if (busy?.background) {
    return (
      <div class="working">
        <div class="progress" role="progressbar" aria-valuenow={Math.round(100 * busy.share)}><div style={{ width: `${100 * busy.share}%` }} /></div>
        <Button title="Stop" label="Cancel" onPress={cancelWork} />
      </div>
    );
  }
  return (
    <>
      <div class="row">
        <Button id="solve-full" title="Every bar of every pattern, once, in the background" icon={Gauge} label={full ? 'Again' : 'Solve in full'} disabled={!live.value} onPress={() => void solveFull()} />
        <Button id="error-map" title={full ? 'Colours show how far the live model is from the full one' : 'Solve in full first: colours then show how far the live model is from the full one'} icon={Scale} label="Error map" disabled={!full} onPress={() => void compare()} />
      </div>
      {!full && <p class="hint" id="error-map-needs">The error map needs the full model: solve in full first.</p>}
      {full && <Check label="Lay it over, in grey" value={showFull.value} onChange={(value) => (showFull.value = value)} />}
      {full && <p class="hint">Its largest displacement: {shown(full.info.largest_displacement, 'length')}, in {digits(full.info.seconds)} s</p>}
      {error && <p class="hint">Error: {shown(error.mean, 'length')} in the mean, {shown(error.largest, 'length')} at most; {digits(100 * error.relative)} % of all movement</p>}
    </>
  );
}
