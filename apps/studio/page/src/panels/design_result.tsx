// SPDX-License-Identifier: GPL-3.0-or-later
// What a design has come to, and how far the live shape is from the target.

import { useEffect, useRef } from 'preact/hooks';
import { designed } from '../document/design';
import { documentNow } from '../document/store';
import { liveError } from '../document/target';
import { digits, shown, withShownValues } from '../document/units';
import type { Designed } from '../protocol/messages';
import { W } from '../words';

const percent = (share: number | null): string => (share === null ? '–' : `${digits(100 * share)} %`);

export function DesignResult() {
  const error = liveError.value;
  const result = designed.value;
  const host = useRef<HTMLElement>(null);
  useEffect(() => {
    if (result) host.current?.scrollIntoView({ block: 'nearest' });
  }, [result]);
  if (!error && !result) return null;
  return (
    <section ref={host}>
      <h2>{W.design.result}</h2>
      <dl class="facts" id="design-result">
        {error && documentNow.value && <><dt data-tip={W.design.nowTip}>{W.design.now}</dt><dd id="distance-now">{shown(error.mean, 'length')} / {shown(error.largest, 'length')}</dd></>}
        {result && <Facts result={result} />}
      </dl>
      {result && <Remarks result={result} />}
    </section>
  );
}

function Facts({ result }: { result: Designed }) {
  return (
    <>
      <dt>{W.design.mean}</dt><dd id="design-error">{percent(result.error_mean)}</dd>
      <dt>{W.design.largest}</dt><dd>{percent(result.error_largest)}</dd>
      <dt data-tip={result.best_uniform_pattern}>{W.design.uniform}</dt><dd>{percent(result.error_best_uniform)}</dd>
      <dt>{W.design.closed}</dt><dd id="share-closed">{percent(result.share_closed)}</dd>
      <dt>{W.design.used}</dt><dd>{result.patterns.length}</dd>
      {result.factors.map((factor, i) => factor !== 1 && [<dt key={`${i} name`}>{W.design.factorFound(result.load_cases[i])}</dt>, <dd key={i}>× {digits(factor)}</dd>])}
    </>
  );
}

const sentence = (words: string): string => `${words[0]?.toUpperCase() ?? ''}${words.slice(1)}.`;

function Remarks({ result }: { result: Designed }) {
  const ended = result.sketch ? W.design.sketch : sentence(result.words);
  return (
    <>
      <p class="hint" id="design-end">{ended} {result.error_mean === null ? W.design.unchecked : W.design.ofWanted}</p>
      {result.stable === false && <p class="warning">{W.design.notStable}</p>}
      {!result.sketch && !result.is_better && result.error_mean !== null && <p class="warning">{W.design.notBetter}</p>}
      {result.warning_parts.map(({ text, values }) => <p key={text} class="warning">{sentence(withShownValues(text, values))}</p>)}
    </>
  );
}
