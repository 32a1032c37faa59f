// SPDX-License-Identifier: GPL-3.0-or-later
// How tiles are computed: one model for all of them.

import { signal } from '@preact/signals';
import { setModel } from '../document/edits';
import { documentNow, hello } from '../document/store';
import type { TileModel } from '../protocol/messages';
import { NumberField } from '../widgets/number';
import { W } from '../words';

const FIRST_SHARE = 0.1;
const share = signal(FIRST_SHARE);

/** Why a model cannot be chosen for this document, and what to do; null where it can. */
export function obstacle({ parameters = [] }: TileModel): string | null {
  if (parameters.length === 0 || documentNow.value?.library) return null;
  return W.models.requiresCalibratedPatternsProject;
}

const chosenShare = (model: string): number | null => (model.startsWith('mixed:') ? Number(model.slice('mixed:'.length)) : null);

export function Models() {
  return (
    <div class="models" role="radiogroup" aria-label={W.models.model}>
      {(hello.value?.models ?? []).map((model) => <ModelRow key={model.name} model={model} />)}
    </div>
  );
}

function ModelRow({ model }: { model: TileModel }) {
  const { name, summary, large_displacements } = model;
  const now = documentNow.value?.model ?? '';
  const mixed = model.share ? chosenShare(now) : null;
  const why = obstacle(model);
  const choose = (part: number) => {
    share.value = part;
    setModel(model.share ? `${name}:${part}` : name);
  };
  return (
    <>
      <button type="button" role="radio" class="model" aria-checked={now === name || mixed !== null} data-model={name} disabled={why !== null} onClick={() => choose(mixed ?? share.value)}>
        <b>{name}</b>
        <span>{summary}</span>
        {why ? <em>{why}</em> : !large_displacements && <em>{W.models.smallDisplacements}</em>}
      </button>
      {mixed !== null && (
        <label class="field model-share"><span>{W.models.tilesWithFullBeams}</span>
          <NumberField id="mixed-share" label={W.models.shareOfTilesWith} least={0} most={1} value={mixed} quantity="share" onChange={choose} />
        </label>
      )}
    </>
  );
}
