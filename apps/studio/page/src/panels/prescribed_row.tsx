// SPDX-License-Identifier: GPL-3.0-or-later

import { MoveVertical, Trash2 } from 'lucide-preact';
import { dragPrescribed, removePrescribed, replacePrescribed } from '../document/edits';
import type { PrescribedMark } from '../document/marks';
import { DragSlider } from './drag_slider';
import { selectionWords } from './selection_words';
import { surface } from '../document/surface';
import { activeEntry } from '../document/ui';
import { shown } from '../document/units';
import { DOFS, type Dof, type Prescribed } from '../protocol/messages';
import { Button, Choice } from '../widgets/widgets';
import { NumberField } from '../widgets/number';
import { W } from '../words';

/** A displacement or turn that is given: slide it, type it, or drag its diamond in space. */
export function PrescribedRow({ mark }: { mark: PrescribedMark }) {
  const { entry, index, dof, value, nodes } = mark;
  const open = activeEntry.value?.kind === 'prescribed' && activeEntry.value.index === index;
  const turns = dof[0] === 'r';
  const quantity = turns ? 'angle' : 'length';
  const box = surface.value?.box;
  const reach = turns ? Math.PI / 2 : 0.35 * (box ? Math.hypot(box.max[0] - box.min[0], box.max[1] - box.min[1]) : 1);
  const where = () => {
    const rest: Prescribed = { ...entry };
    for (const one of DOFS) delete rest[one];
    return rest;
  };
  return (
    <li class={`entry${open ? ' open' : ''}`}>
      <button type="button" class="entry-title" aria-expanded={open} onClick={() => (activeEntry.value = open ? null : { kind: 'prescribed', index })}>
        <MoveVertical aria-hidden class="tint-move" />
        <span class="entry-words"><b>{dof} = {shown(value, quantity)}</b>, {selectionWords(entry, nodes.length)}</span>
      </button>
      <Button kind="bare" title={W.prescribedRow.remove} icon={Trash2} onPress={() => { activeEntry.value = null; removePrescribed(index); }} />
      {open && (
        <div class="entry-body">
          <DragSlider label={W.prescribedRow.prescribed(dof)} least={-reach} most={reach} step={reach / 500} value={value}
            onSlide={(next, slide) => dragPrescribed(index, { ...where(), [dof]: next }, slide)} />
          <div class="field">
            <Choice label={W.prescribedRow.direction} value={dof} options={DOFS.map((one) => ({ value: one, title: one }))}
              onPick={(one: Dof) => replacePrescribed(index, { ...where(), [one]: turns === (one[0] === 'r') ? value : 0 })} />
            <NumberField label={W.prescribedRow.prescribed(dof)} value={value} quantity={quantity} onChange={(next) => replacePrescribed(index, { ...where(), [dof]: next })} />
          </div>
        </div>
      )}
    </li>
  );
}
