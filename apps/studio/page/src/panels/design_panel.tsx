// SPDX-License-Identifier: GPL-3.0-or-later
// From a wanted shape to a painting: target, tiles that may change, the search, its result.

import { PenLine, Target as TargetIcon, Trash2 } from 'lucide-preact';
import { signal } from '@preact/signals';
import { addTarget, commonWish, displacementOf, removeTarget, replaceTarget, target, type TargetEntry } from '../document/target';
import { live } from '../document/store';
import { activeEntry, selectedNodes, sideViewOpen } from '../document/ui';
import { shown } from '../document/units';
import type { FreeVector } from '../protocol/messages';
import { Button } from '../widgets/widgets';
import { NumberField } from '../widgets/number';
import { W } from '../words';
import { CaseBar } from './case_bar';
import { ChosenNodes } from './chosen_nodes';
import { DesignResult } from './design_result';
import { DesignSearch } from './design_search_fields';

const AXES = ['x', 'y', 'z'] as const;
const typedWish = signal<FreeVector>([null, null, null]);

/** The typed displacement. If none is typed, the present one along z, from which a drag begins. */
function wishFor(nodes: readonly number[]): FreeVector[] {
  const typed = typedWish.peek();
  if (typed.some((value) => value !== null)) return nodes.map(() => typed);
  const displacement = live.peek()?.solution.displacement ?? null;
  return nodes.map((node) => [null, null, displacementOf(displacement, node)[2]]);
}

function setTarget(): void {
  const nodes = [...selectedNodes.peek()].sort((a, b) => a - b);
  addTarget({ nodes, wanted: wishFor(nodes) });
  activeEntry.value = { kind: 'target', index: target.peek().length - 1 };
  selectedNodes.value = new Set();
}

export function DesignPanel() {
  const some = selectedNodes.value.size > 0;
  return (
    <>
      <CaseBar />
      <div class="panel-scroll">
        <ChosenNodes purpose="design" />
        {some && <p class="hint">{W.design.displacement}</p>}
        {some && <WishFields value={typedWish.value} onChange={(value) => (typedWish.value = value)} />}
        <div class="row">
          <Button id="set-target" title={W.design.addTip} icon={TargetIcon} label={W.design.add} disabled={!some} onPress={setTarget} />
          <Button id="draw-curve" title={W.design.curveTip} icon={PenLine} label={W.design.curve} pressed={sideViewOpen.value} onPress={() => (sideViewOpen.value = !sideViewOpen.value)} />
        </div>
        <h2>{W.design.target}</h2>
        {target.value.length === 0 && <p class="hint">{W.design.none}</p>}
        <ul class="entries">{target.value.map((entry, index) => <TargetRow key={index} entry={entry} index={index} />)}</ul>
        <DesignSearch />
        <DesignResult />
      </div>
    </>
  );
}

function WishFields({ value, onChange }: { value: FreeVector; onChange: (value: FreeVector) => void }) {
  const changed = (axis: number, to: number | null) => onChange(value.map((one, c) => (c === axis ? to : one)) as FreeVector);
  return (
    <div class="components">
      {AXES.map((name, axis) => (
        <label key={name}>{name}
          <NumberField label={W.design.component(name)} value={value[axis] ?? undefined} quantity="length" onChange={(next) => changed(axis, next)} onClear={() => changed(axis, null)} empty={W.design.noWish} />
        </label>
      ))}
      <p class="hint">{W.design.freeHint}</p>
    </div>
  );
}

const wishWords = (wanted: FreeVector): string =>
  AXES.flatMap((name, c) => (wanted[c] === null ? [] : [`u${name} = ${shown(wanted[c], 'length')}`])).join(', ') || W.design.noWish;

function TargetRow({ entry, index }: { entry: TargetEntry; index: number }) {
  const common = commonWish(entry);
  const open = activeEntry.value?.kind === 'target' && activeEntry.value.index === index;
  const toggle = () => (activeEntry.value = open ? null : { kind: 'target', index });
  return (
    <li class={`entry${open ? ' open' : ''}`}>
      <button type="button" class="entry-title" aria-expanded={open} onClick={toggle}>
        <TargetIcon aria-hidden class="tint-target" />
        <span class="entry-words"><b>{common ? wishWords(common) : W.design.varies}</b>, {W.design.nodes(entry.nodes.length)}</span>
      </button>
      <Button kind="bare" title={W.design.remove} icon={Trash2} onPress={() => { activeEntry.value = null; removeTarget(index); }} />
      {open && (
        <div class="entry-body">
          {common && <WishFields value={common} onChange={(value) => replaceTarget(index, { ...entry, wanted: entry.nodes.map(() => value) })} />}
          <Button title={W.design.choose} label={W.design.choose} onPress={() => (selectedNodes.value = new Set(entry.nodes))} />
        </div>
      )}
    </li>
  );
}
