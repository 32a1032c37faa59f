// SPDX-License-Identifier: GPL-3.0-or-later

import { MAKING, making } from '../document/making';
import { W } from '../words';

/** The entries that DXF, STL, 3MF and the facts use. */
export function MakingFields() {
  return (
    <details class="making" onToggle={(event) => event.currentTarget.scrollIntoView({ block: 'end' })}>
      <summary>{W.makingFields.fabricationOptions}</summary>
      {MAKING.map(({ name, title, words, example, unit }) => (
        <label key={name} title={words}>
          <b>{title}</b>
          <input class="text-input" type="text" inputMode="decimal" data-making={name} placeholder={example} value={making.value[name] ?? ''}
            onInput={(event) => (making.value = { ...making.value, [name]: event.currentTarget.value })} />
          <span>{unit}, {words}</span>
        </label>
      ))}
    </details>
  );
}
