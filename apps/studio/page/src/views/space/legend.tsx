// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of the colours, with units; and which model is which when several are laid over each other.

import { computed, signal } from '@preact/signals';
import { SlidersHorizontal } from 'lucide-preact';
import { documentNow, live, others, shapes, strength } from '../../document/store';
import { liveError } from '../../document/target';
import { mode } from '../../document/ui';
import { field, showFull } from '../../document/look';
import { shown as inUnits } from '../../document/units';
import { Button } from '../../widgets/widgets';
import { gradientCss } from './colours';
import { fieldRow } from './fields';
import { LegendEditor } from './legend_editor';
import { W } from '../../words';
import { interpolated, legend } from './legend_state';

/** The colours of utilization are wanted, but no strength is known. */
const lacksStrength = computed(() => live.value !== null && field.value === 'utilization' && strength.value === null);

const LacksStrength = () => (
  <>
    <div class="legend-title">{fieldRow('utilization').title}</div>
    <p class="hint legend-hint" id="lacks-strength">{W.legend.aShareOfThe}</p>
  </>
);

const targetError = computed(() => (mode.value === 'design' ? liveError.value : null));

function TargetLegend({ largest }: { largest: number }) {
  return (
    <div class="legend-target">
      <div class="legend-title">{W.design.legend}</div>
      <div class="legend-bar" style={{ background: gradientCss('sizes') }} />
      <div class="legend-ends"><span>{inUnits(0, 'length')}</span><span>{inUnits(largest, 'length')}</span></div>
    </div>
  );
}

const editing = signal(false);
/** A mode has no size. */
const isEditable = computed(() => !shapes.value || shapes.value.kind === 'path');

function FieldLegend({ now }: { now: NonNullable<typeof legend.value> }) {
  const { row, low, high, isCut } = now;
  return (
    <>
      <div class="legend-title">{row.title}
        {isEditable.value && <Button kind="bare" id="legend-edit" title={W.colours.edit} icon={SlidersHorizontal} pressed={editing.value} onPress={() => (editing.value = !editing.value)} />}
      </div>
      <div class="legend-bar" style={{ background: gradientCss(row.map) }} />
      <div class="legend-ends">
        <span>{isCut && low < 0 && '≤ '}{inUnits(low, row.quantity)}</span>
        <span>{inUnits((low + high) / 2, row.quantity)}</span>
        <span>{isCut && '≥ '}{inUnits(high, row.quantity)}</span>
      </div>
      {editing.value && isEditable.value && <LegendEditor now={now} />}
    </>
  );
}

export function LegendCard() {
  const now = legend.value;
  const full = showFull.value && others.value.has('full') && live.value?.info.model !== 'full' && !shapes.value;
  const wanted = targetError.value;
  if (!now && !full && !interpolated.value && !lacksStrength.value && !wanted) return null;
  return (
    <div class="card legend" role="group" aria-label={W.legend.legend}>
      {now && <FieldLegend now={now} />}
      {wanted && <TargetLegend largest={wanted.largest} />}
      {!now && lacksStrength.value && <LacksStrength />}
      {interpolated.value && <p class="hint legend-hint">{W.legend.insideTilesTheShape}</p>}
      {full && (
        <div class="legend-models">
          <span><i style={{ background: '#9b9fa5' }} />{W.legend.fullModel}</span>
          {!now && <span><i style={{ background: '#4a8ee0' }} />{documentNow.value?.model}</span>}
        </div>
      )}
    </div>
  );
}
