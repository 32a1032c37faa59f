// SPDX-License-Identifier: GPL-3.0-or-later
// What a node does: where it went, how it turned, what holds it.

import { X } from 'lucide-preact';
import { shown } from '../../document/shown';
import { live, shapes } from '../../document/store';
import { heldNodes } from '../../document/marks';
import { probed } from '../../document/ui';
import { shown as inUnits } from '../../document/units';

const AXES = ['x', 'y', 'z'];

export function ProbeCard() {
  const at = probed.value;
  const now = shown.value;
  if (!at) return null;
  const held = heldNodes.value.find(({ node }) => node === at.index);
  const reaction = shapes.value ? undefined : live.value?.info.reactions?.find(({ node }) => node === at.index);
  const three = (array: Float32Array | undefined) => [0, 1, 2].map((c) => array?.[3 * at.index + c] ?? NaN);
  const moved = three(now?.solution.displacement);
  const turned = three(now?.solution.rotation);
  return (
    <div class="card probe" data-node={at.index}>
      <header>
        <strong>Node {at.index}</strong>
        <button type="button" class="button bare icon small" aria-label="Close" onClick={() => (probed.value = null)}><X aria-hidden /></button>
      </header>
      {now ? (
        <table>
          <tbody>
            <Row title="moved" id="probe-displacement" values={moved} quantity="length" />
            <Row title="turned" values={turned} quantity="angle" />
            {reaction && <Row title="reaction" values={reaction.force} quantity="force" />}
          </tbody>
        </table>
      ) : (
        <p class="hint">Nothing is computed yet.</p>
      )}
      {held && <p class="hint">held: {held.fixed.join(' ')}</p>}
    </div>
  );
}

interface RowProps {
  title: string;
  values: readonly number[];
  quantity: 'length' | 'angle' | 'force';
  id?: string;
}
function Row({ title, values, quantity, id }: RowProps) {
  return (
    <>
      <tr class="sum">
        <th scope="row">{title}</th>
        <td colSpan={3} id={id} data-value={Math.hypot(...values)}>{inUnits(Math.hypot(...values), quantity)}</td>
      </tr>
      <tr class="parts">
        <th />
        {values.map((value, i) => <td key={AXES[i]}><i>{AXES[i]}</i> {inUnits(value, quantity)}</td>)}
      </tr>
    </>
  );
}
