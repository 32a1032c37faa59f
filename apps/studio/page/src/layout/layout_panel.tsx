// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of the layout: how many edges and patterns, some of them as fans, and where exactly its nodes lie.

import { Thumbnail } from '../gallery/thumbnail';
import { W } from '../words';
import { counted, countTrouble, foundNow, isCounting } from './count';
import { draft, selectedNode } from './draft';

const FAN_PX = 88;
const inWords = (count: number): string => count.toLocaleString('en-US');

/** A count that ended, or what one under way has found. */
function patternsNow(): string {
  if (countTrouble.value) return countTrouble.value;
  if (isCounting.value && foundNow.value !== null) return W.layouts.soFar(inWords(foundNow.value));
  const last = counted.value;
  if (!last) return W.layouts.counting;
  return last.complete ? inWords(last.patterns) : W.layouts.moreThan(inWords(last.patterns));
}

function Numbers() {
  return (
    <dl class="facts layout-facts">
      <dt>{W.layouts.edges}</dt><dd id="layout-edges">{draft.value?.edges.length ?? ''}</dd>
      <dt>{W.layouts.patterns}</dt><dd><span id="layout-patterns" role="status" data-counting={isCounting.value}>{patternsNow()}</span>{isCounting.value && <i class="pulse" />}</dd>
    </dl>
  );
}

function Fans() {
  const last = counted.value;
  if (!last) return null;
  const { patterns, complete, samples, places } = last;
  const words = samples.length === patterns ? W.layouts.all : complete ? W.layouts.some(samples.length) : W.layouts.someOf(samples.length);
  if (samples.length === 0) return <p class="hint">{complete ? W.layouts.none : W.layouts.bounded}</p>;
  return (
    <>
      <p class="hint">{words}{!complete && ` ${W.layouts.bounded}`}</p>
      <ul class="layout-fans" aria-label={words}>
        {samples.map((id) => <li key={id} data-tip={id}><span role="img" aria-label={id}><Thumbnail id={id} size={FAN_PX} bar={0.06} of={places} /></span></li>)}
      </ul>
    </>
  );
}

function NodeList() {
  return (
    <>
      <h2>{W.layouts.nodes}</h2>
      <p class="hint">{W.layouts.exact}</p>
      <ul class="layout-nodes">
        {draft.value?.nodes.map(({ kind, exact }, index) => (
          <li key={index}>
            <button type="button" aria-pressed={selectedNode.value === index} onClick={() => (selectedNode.value = index)}>
              <b>{W.layouts.row(index)}</b><span>{W.layouts.kinds[kind]}</span><code>{exact.join('  ')}</code>
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}

export function LayoutPanel() {
  return (
    <aside class="side layout-panel" aria-label={W.layouts.patterns}>
      <div class="panel-scroll">
        <Numbers />
        <Fans />
        <NodeList />
      </div>
    </aside>
  );
}
