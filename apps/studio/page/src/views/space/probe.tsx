// SPDX-License-Identifier: GPL-3.0-or-later
// A node's motion and supports; a bar's forces, at both of its ends.

import { X } from 'lucide-preact';
import { shown, type Shown } from '../../document/shown';
import { beams, live, shapes, strength } from '../../document/store';
import { heldNodes } from '../../document/marks';
import { probed } from '../../document/ui';
import { shown as inUnits } from '../../document/units';
import { FIELDS, utilization, type FieldRow } from './fields';
import { W } from '../../words';

const AXES = ['x', 'y', 'z'];

export function ProbeCard() {
  const at = probed.value;
  if (!at) return null;
  return at.kind === 'beam' ? <BarCard bar={at.index} /> : <NodeCard at={at} />;
}

const Head = ({ title }: { title: string }) => (
  <header>
    <strong>{title}</strong>
    <button type="button" class="button bare icon small" aria-label={W.probe.close} onClick={() => (probed.value = null)}><X aria-hidden /></button>
  </header>
);

const valuesOf = (row: FieldRow, { solution, fields }: Shown): Float32Array | null =>
  row.name === 'utilization' ? utilization(solution, fields, strength.value) : (solution.beamFields[fields.indexOf(row.name)] ?? null);

function BarCard({ bar }: { bar: number }) {
  const now = shown.value;
  const tile = beams.value?.tile[bar];
  const rows = FIELDS.filter(({ on }) => on === 'bars').flatMap((row) => {
    const values = now && valuesOf(row, now);
    return values && 2 * bar + 1 < values.length ? [{ row, ends: [values[2 * bar], values[2 * bar + 1]] }] : [];
  });
  return (
    <div class="card probe" data-bar={bar}>
      <Head title={tile === undefined ? W.probe.bar(bar) : W.probe.barInTile(tile + 1)} />
      {rows.length === 0 && <p class="hint">{now ? W.probe.thisModelGivesNo : W.probe.noResultYet}</p>}
      <table>
        <tbody>
          {rows.map(({ row, ends }) => (
            <tr key={row.name} class="bar-row"><th scope="row">{row.title}</th>{ends.map((value, i) => <td key={i} data-field={row.name} data-value={value}>{inUnits(value, row.quantity)}</td>)}</tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function NodeCard({ at }: { at: { index: number } }) {
  const now = shown.value;
  const held = heldNodes.value.find(({ node }) => node === at.index);
  const reaction = shapes.value ? undefined : live.value?.info.reactions?.find(({ node }) => node === at.index);
  const three = (array: Float32Array | undefined) => [0, 1, 2].map((c) => array?.[3 * at.index + c] ?? NaN);
  const moved = three(now?.solution.displacement);
  const turned = three(now?.solution.rotation);
  return (
    <div class="card probe" data-node={at.index}>
      <Head title={W.probe.node(at.index)} />
      {now ? (
        <table>
          <tbody>
            <Row title={W.probe.displacement} id="probe-displacement" values={moved} quantity="length" />
            <Row title={W.probe.rotation} values={turned} quantity="angle" />
            {reaction && <Row title={W.probe.reaction} values={reaction.force} quantity="force" />}
          </tbody>
        </table>
      ) : (
        <p class="hint">{W.probe.noResultYet}</p>
      )}
      {held && <p class="hint">{W.probe.fixed(held.fixed.join(' '))}</p>}
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
