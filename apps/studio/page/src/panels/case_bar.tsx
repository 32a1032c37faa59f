// SPDX-License-Identifier: GPL-3.0-or-later
// Named load cases: switch, rename, add, copy, remove.

import { Copy, Plus, Trash2 } from 'lucide-preact';
import { signal } from '@preact/signals';
import { addLoadCase, editLoadCase, removeLoadCase, selectLoadCase } from '../document/edits';
import { documentNow, loadCase } from '../document/store';
import { Button } from '../widgets/widgets';
import { W } from '../words';

const renaming = signal(false);

export function CaseBar() {
  const now = documentNow.value;
  const present = loadCase.value;
  if (!now || !present) return null;
  const rename = (name: string) => {
    renaming.value = false;
    if (name.trim() && name !== present.name) void editLoadCase(() => ({ name: name.trim() }));
  };
  return (
    <div class="case-bar">
      {renaming.value ? (
        <input class="text-input" aria-label={W.caseBar.nameOfTheLoad} value={present.name} ref={(element) => element?.focus()}
          onBlur={(event) => rename(event.currentTarget.value)}
          onKeyDown={(event) => {
            event.stopPropagation();
            if (event.key === 'Enter') rename(event.currentTarget.value);
            if (event.key === 'Escape') renaming.value = false;
          }} />
      ) : (
        <select class="choice" id="load-case" aria-label={W.caseBar.loadCase} value={String(now.selected_load_case)} onDblClick={() => (renaming.value = true)} data-tip={W.caseBar.loadCaseDoubleClick}
          onChange={(event) => {
            if (event.currentTarget.value === 'rename') renaming.value = true;
            else selectLoadCase(Number(event.currentTarget.value));
          }}>
          {now.load_cases.map((one, index) => <option key={index} value={String(index)}>{one.name}</option>)}
          <option value="rename">{W.caseBar.rename}</option>
        </select>
      )}
      <Button kind="bare" title={W.caseBar.newLoadCase} icon={Plus} onPress={() => addLoadCase()} />
      <Button kind="bare" title={W.caseBar.copyThisLoadCase} icon={Copy} onPress={() => addLoadCase({ ...present, name: `${present.name} copy` })} />
      <Button kind="bare" title={W.caseBar.removeThisLoadCase} icon={Trash2} disabled={now.load_cases.length < 2} onPress={() => removeLoadCase(now.selected_load_case)} />
    </div>
  );
}
