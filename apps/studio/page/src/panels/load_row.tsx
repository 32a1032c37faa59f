// SPDX-License-Identifier: GPL-3.0-or-later

import { ArrowDownRight, RotateCcw, Trash2 } from 'lucide-preact';
import { removeLoad, replaceLoad } from '../document/edits';
import { size, type LoadMark } from '../document/marks';
import { selectionWords } from './selection_words';
import { selectAgain } from '../document/picked';
import { activeEntry } from '../document/ui';
import { shown, type Quantity } from '../document/units';
import type { Load, Vector } from '../protocol/messages';
import { Button, Segments } from '../widgets/widgets';
import { NumberField } from '../widgets/number';
import { W } from '../words';

/** The load on each square metre or metre, if it is given so. */
function spreadOf({ per_area, per_length }: Load) {
  if (per_area) return { key: 'per_area', label: 'Area', quantity: 'area_load', vector: per_area } as const;
  return per_length ? ({ key: 'per_length', label: 'Line', quantity: 'line_load', vector: per_length } as const) : null;
}

function described({ load, force, moment }: LoadMark) {
  const spread = spreadOf(load);
  if (spread) return { twists: false, spread, words: shown(size(spread.vector), spread.quantity), how: W.loadRow.text(shown(size(force), 'force')) };
  const twists = size(moment) > 0 || (load.moment !== undefined && load.force === undefined);
  const words = twists ? shown(size(moment), 'moment') : shown(size(force), 'force');
  return { twists, spread, words, how: load.amount === 'total' ? W.loadRow.total : 'each' };
}

/** One load: its size, where it acts, and its components to type. */
export function LoadRow({ mark }: { mark: LoadMark }) {
  const { load, index, nodes } = mark;
  const open = activeEntry.value?.kind === 'load' && activeEntry.value.index === index;
  const { twists, spread, words, how } = described(mark);
  const Picture = twists ? RotateCcw : ArrowDownRight;
  return (
    <li class={`entry${open ? ' open' : ''}`}>
      <button type="button" class="entry-title" aria-expanded={open} onClick={() => (activeEntry.value = open ? null : { kind: 'load', index })}>
        <Picture aria-hidden class={twists ? 'tint-moment' : 'tint-force'} />
        <span class="entry-words"><b>{words}</b> {how}, {selectionWords(load, nodes.length)}</span>
      </button>
      <Button kind="bare" title={W.loadRow.removeLoad} icon={Trash2} onPress={() => { activeEntry.value = null; removeLoad(index); }} />
      {open && (
        <div class="entry-body">
          {spread && <Components label={spread.label} vector={spread.vector} quantity={spread.quantity} onChange={(vector) => replaceLoad(index, { ...load, [spread.key]: vector })} />}
          {!twists && !spread && <Components label={W.loadRow.force} vector={mark.force} quantity="force" onChange={(force) => replaceLoad(index, { ...load, force })} />}
          {twists && <Components label={W.loadRow.moment} vector={mark.moment} quantity="moment" onChange={(moment) => replaceLoad(index, { ...load, moment })} />}
          <div class="field">
            {!spread && <Segments label={W.loadRow.amount} value={load.amount ?? 'each'} onPick={(amount) => replaceLoad(index, { ...load, amount })}
              options={[{ value: 'total', title: W.loadRow.total, tip: W.loadRow.sharedByTheNodes }, { value: 'each', title: W.loadRow.each, tip: W.loadRow.appliedToEveryNode }]} />}
            <button type="button" class="chip" onClick={() => selectAgain(load, nodes)}>{W.loadRow.selectNodes}</button>
          </div>
        </div>
      )}
    </li>
  );
}

interface ComponentsProps {
  label: string;
  vector: Vector;
  quantity: Quantity;
  onChange: (vector: Vector) => void;
}
export function Components({ label, vector, quantity, onChange }: ComponentsProps) {
  return (
    <div class="components">
      {(['x', 'y', 'z'] as const).map((axis, i) => (
        <label key={axis}>
          <span>{axis}</span>
          <NumberField narrow id={`${label.toLowerCase()}-${axis}`} label={W.loadRow.along(label, axis)} value={vector[i]} quantity={quantity}
            onChange={(value) => onChange(vector.map((old, c) => (c === i ? value : old)) as Vector)} />
        </label>
      ))}
    </div>
  );
}
