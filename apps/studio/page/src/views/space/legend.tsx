// SPDX-License-Identifier: GPL-3.0-or-later
// What the colours mean, with units; and which model is which when several are laid over each other.

import { documentNow, live, others, shapes } from '../../document/store';
import { showFull } from '../../document/look';
import { shown as inUnits } from '../../document/units';
import { gradientCss } from './colours';
import { interpolated, legend } from './legend_state';

export function LegendCard() {
  const now = legend.value;
  const full = showFull.value && others.value.has('full') && live.value?.info.model !== 'full' && !shapes.value;
  if (!now && !full && !interpolated.value) return null;
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
