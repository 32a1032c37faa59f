// SPDX-License-Identifier: GPL-3.0-or-later
// The tools of the plane, at its top.

import { BoxSelect, Brush, Lasso, Maximize, PaintBucket, Pipette, Replace, Spline, SquareDashedMousePointer, TrendingUp } from 'lucide-preact';
import { brushRings, mode, nodeTool, paintTool, type NodeTool, type PaintTool } from '../../document/ui';
import { Button, Segments } from '../../widgets/widgets';
import { fit } from './viewport';

const PAINT_TOOLS: { value: PaintTool; title: string; shortcut: string; icon: typeof Brush }[] = [
  { value: 'brush', title: 'Brush: paint tile by tile (Alt picks)', shortcut: 'B', icon: Brush },
  { value: 'fill', title: 'Fill the connected tiles of one pattern', shortcut: 'G', icon: PaintBucket },
  { value: 'replace', title: 'Replace a pattern everywhere', shortcut: 'R', icon: Replace },
  { value: 'pick', title: 'Pick the pattern of a tile', shortcut: 'I', icon: Pipette },
  { value: 'gradient', title: 'Gradient: drag from soft to stiff through the palette', shortcut: 'D', icon: TrendingUp },
  { value: 'select', title: 'Select tiles by click or box', shortcut: 'V', icon: BoxSelect },
  { value: 'lasso', title: 'Select tiles with a lasso', shortcut: 'L', icon: Lasso },
];
const NODE_TOOLS: { value: NodeTool; title: string; shortcut: string; icon: typeof Brush }[] = [
  { value: 'select', title: 'Choose nodes by click or box', shortcut: 'V', icon: SquareDashedMousePointer },
  { value: 'lasso', title: 'Choose nodes with a lasso', shortcut: 'L', icon: Lasso },
  { value: 'rim', title: 'Choose a stretch of the rim: drag along it', shortcut: 'E', icon: Spline },
];

export function PlaneBar() {
  const painting = mode.value === 'paint';
  const editing = mode.value === 'hold' || mode.value === 'load';
  return (
    <div class="plane-bar">
      {painting && <Segments label="Painting tool" value={paintTool.value} options={PAINT_TOOLS} onPick={(tool) => (paintTool.value = tool)} iconsOnly />}
      {editing && <Segments label="Choosing tool" value={nodeTool.value} options={NODE_TOOLS} onPick={(tool) => (nodeTool.value = tool)} iconsOnly />}
      {painting && paintTool.value === 'brush' && (
        <label class="brush-size" data-tip="How wide the brush is" data-key="[ ]">
          <input type="range" aria-label="Width of the brush, in rings of tiles" min={0} max={5} value={brushRings.value}
            onInput={(event) => (brushRings.value = Number(event.currentTarget.value))} />
          <span>{brushRings.value === 0 ? '1 tile' : `${brushRings.value} ring${brushRings.value > 1 ? 's' : ''}`}</span>
        </label>
      )}
      <span class="gap" />
      <Button kind="bare" title="See all of it" shortcut="0" icon={Maximize} onPress={fit} />
    </div>
  );
}
