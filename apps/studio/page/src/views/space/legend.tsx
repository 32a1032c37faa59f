// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of the colours, with units; and which model is which when several are laid over each other.

import { computed } from '@preact/signals';
import { documentNow, live, others, shapes, strength } from '../../document/store';
import { field, showFull } from '../../document/look';
import { shown as inUnits } from '../../document/units';
import { gradientCss } from './colours';
import { fieldRow } from './fields';
import { interpolated, legend } from './legend_state';

/** Colours are asked for that are a share of what is not known. */
const lacksStrength = computed(() => live.value !== null && field.value === 'utilization' && strength.value === null);

const LacksStrength = () => (
  <>
    <div class="legend-title">{fieldRow('utilization').title}</div>
    <p class="hint legend-hint" id="lacks-strength">A share of the material’s strength, which is not given: it is a field under Look.</p>
  </>
);

export function LegendCard() {
  const now = legend.value;
  const full = showFull.value && others.value.has('full') && live.value?.info.model !== 'full' && !shapes.value;
  if (!now && !full && !interpolated.value && !lacksStrength.value) return null;
  return (
    <div class="card legend" role="img" aria-label="Legend">
      {now && (
        <>
          <div class="legend-title">{now.row.title}</div>
          <div class="legend-bar" style={{ background: gradientCss(now.row.map) }} />
          <div class="legend-ends">
            <span>{now.isCut && now.low < 0 && '≤ '}{inUnits(now.low, now.row.quantity)}</span>
            <span>{inUnits((now.low + now.high) / 2, now.row.quantity)}</span>
            <span>{now.isCut && '≥ '}{inUnits(now.high, now.row.quantity)}</span>
          </div>
        </>
      )}
      {!now && lacksStrength.value && <LacksStrength />}
      {interpolated.value && <p class="hint legend-hint">This model knows how the rims of tiles move; what lies inside follows them.</p>}
      {full && (
        <div class="legend-models">
          <span><i style={{ background: '#9b9fa5' }} />full model</span>
          {!now && <span><i style={{ background: '#4a8ee0' }} />{documentNow.value?.model}</span>}
        </div>
      )}
    </div>
  );
}
