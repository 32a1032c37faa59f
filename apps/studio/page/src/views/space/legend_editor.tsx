// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds of the colours, and their map, to be set.

import { ranges } from '../../document/look';
import { Button, Segments } from '../../widgets/widgets';
import { NumberField } from '../../widgets/number';
import { W } from '../../words';
import { chooseColours, colourChoice } from './colours';
import type { legend } from './legend_state';

type Legend = NonNullable<typeof legend.value>;

export function LegendEditor({ now }: { now: Legend }) {
  const { row, low, high } = now;
  const set = (range: { low: number; high: number }) => (ranges.value = { ...ranges.peek(), [row.name]: range });
  const isSet = ranges.value[row.name] !== undefined;
  const free = () => (ranges.value = { ...ranges.peek(), [row.name]: undefined });
  return (
    <div class="legend-editor">
      <div class="field">
        <NumberField narrow id="legend-low" label={W.colours.low} value={low} quantity={row.quantity} most={high} onChange={(value) => set({ low: value, high })} />
        <NumberField narrow id="legend-high" label={W.colours.high} value={high} quantity={row.quantity} least={low} onChange={(value) => set({ low, high: value })} />
      </div>
      {isSet && <Button id="legend-auto" title={W.colours.auto} label={W.colours.auto} onPress={free} />}
      {row.map === 'sizes' && (
        <Segments full label={W.colours.label} value={colourChoice.value} onPick={chooseColours}
          options={[{ value: 'standard', title: W.colours.standard }, { value: 'cividis', title: W.colours.cividis }, { value: 'grey', title: W.colours.grey }]} />
      )}
    </div>
  );
}
