// SPDX-License-Identifier: GPL-3.0-or-later
// Other load cases that act together with this one, each with a factor.

import { combine } from '../document/edits';
import { documentNow, loadCase } from '../document/store';
import { NumberField } from '../widgets/number';
import { W } from '../words';

export function Combination() {
  const now = documentNow.value;
  const present = loadCase.value;
  const others = now?.load_cases.filter((one) => one !== present) ?? [];
  if (!present || others.length === 0) return null;
  const factor = (name: string): number => present.combines?.find(({ load_case }) => load_case === name)?.factor ?? 0;
  return (
    <>
      <h2>{W.combination.combineWith}</h2>
      {others.map(({ name }) => (
        <label key={name} class="field"><span>{name}</span>
          <NumberField narrow label={W.combination.factorOf(name)} value={factor(name)} quantity="factor" onChange={(value) => combine(name, value)} />
        </label>
      ))}
      <p class="hint">{W.combination.addsTheirSupportsAnd}</p>
    </>
  );
}
