// SPDX-License-Identifier: GPL-3.0-or-later
// The tools of the plane, at its top.

import { BoxSelect, Brush, CircleDashed, Hexagon, Lasso, Maximize, PaintBucket, Pipette, Replace, Spline, SquareDashedMousePointer, TrendingUp } from 'lucide-preact';
import { brushRings, choosesNodes, choosesTiles, designPicks, mode, nodeTool, paintTool, type NodeTool, type PaintTool } from '../../document/ui';
import { retileOpen, toggleRetile } from '../../tiles/retile';
import { Button, Segments } from '../../widgets/widgets';
import { W } from '../../words';
import { fit } from './viewport';

const PAINT_TOOLS: { value: PaintTool; title: string; shortcut: string; icon: typeof Brush }[] = [
  { value: 'brush', title: W.planeBar.brushPaintTilesAlt, shortcut: 'B', icon: Brush },
  { value: 'fill', title: W.planeBar.fillConnectedTilesOf, shortcut: 'G', icon: PaintBucket },
  { value: 'replace', title: W.planeBar.replaceAPatternEverywhere, shortcut: 'R', icon: Replace },
  { value: 'pick', title: W.planeBar.pickThePatternOf, shortcut: 'I', icon: Pipette },
  { value: 'gradient', title: W.planeBar.gradientDragFromSoft, shortcut: 'D', icon: TrendingUp },
  { value: 'select', title: W.planeBar.selectTilesByClick, shortcut: 'V', icon: BoxSelect },
  { value: 'circle', title: W.planeBar.selectTilesInACircle, shortcut: 'K', icon: CircleDashed },
  { value: 'lasso', title: W.planeBar.selectTilesWithA, shortcut: 'L', icon: Lasso },
];
const NODE_TOOLS: { value: NodeTool; title: string; shortcut: string; icon: typeof Brush }[] = [
  { value: 'select', title: W.planeBar.selectNodesByClick, shortcut: 'V', icon: SquareDashedMousePointer },
  { value: 'circle', title: W.planeBar.selectNodesInACircle, shortcut: 'K', icon: CircleDashed },
  { value: 'lasso', title: W.planeBar.selectNodesWithA, shortcut: 'L', icon: Lasso },
  { value: 'rim', title: W.planeBar.selectAlongTheEdge, shortcut: 'E', icon: Spline },
];

export function PlaneBar() {
  const painting = mode.value === 'paint';
  const choosing = choosesNodes.value || (choosesTiles.value && !painting);
  return (
    <div class="plane-bar">
      {painting && <Segments label={W.planeBar.paintingTool} value={paintTool.value} options={PAINT_TOOLS} onPick={(tool) => (paintTool.value = tool)} iconsOnly />}
      {choosing && <Segments label={W.planeBar.selectionTool} value={nodeTool.value} options={NODE_TOOLS} onPick={(tool) => (nodeTool.value = tool)} iconsOnly />}
      {mode.value === 'design' && (
        <Segments label={W.design.picks} value={designPicks.value} options={[{ value: 'nodes', title: W.design.picksNodes }, { value: 'tiles', title: W.design.picksTiles }]}
          onPick={(what) => (designPicks.value = what)} />
      )}
      {painting && paintTool.value === 'brush' && (
        <label class="brush-size" data-tip={W.planeBar.brushWidth} data-key="[ ]">
          <input type="range" aria-label={W.planeBar.brushWidthInRings} min={0} max={5} value={brushRings.value}
            onInput={(event) => (brushRings.value = Number(event.currentTarget.value))} />
          <span>{W.planeBar.rings(brushRings.value)}</span>
        </label>
      )}
      <span class="gap" />
      {painting && <Button kind="bare" id="retile" title={W.retile.tip} icon={Hexagon} pressed={retileOpen.value} onPress={toggleRetile} />}
      <Button kind="bare" title={W.planeBar.fitView} shortcut="0" icon={Maximize} onPress={fit} />
    </div>
  );
}
