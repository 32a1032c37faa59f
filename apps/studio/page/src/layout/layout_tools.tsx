// SPDX-License-Identifier: GPL-3.0-or-later

import { Trash2 } from 'lucide-preact';
import type { NodeKind } from '../protocol/requests';
import { Button, Check, Choice } from '../widgets/widgets';
import { W } from '../words';
import { addNode, draft, GRIDS, grid, keepsMirror, selectedNode, trouble } from './draft';
import { removeSelected } from './keys';

const KINDS: readonly NodeKind[] = ['center', 'radial', 'face', 'interface'];

/** Adds and removes nodes, and sets the steps of their moves. */
export function LayoutTools() {
  const hasCenter = draft.value?.layout.center ?? true;
  return (
    <footer class="layout-tools">
      <div class="layout-row">
        <span>{W.layouts.add}</span>
        {KINDS.map((kind) => (
          <Button key={kind} id={`add-${kind}`} title={W.layouts.addTips[kind]} label={W.layouts.addKinds[kind]} disabled={kind === 'center' && hasCenter} onPress={() => void addNode(kind)} />
        ))}
        <Button id="remove-node" title={W.layouts.removeTip} shortcut="Delete" icon={Trash2} label={W.layouts.remove} disabled={selectedNode.value === null} onPress={removeSelected} />
      </div>
      <div class="layout-row">
        <label data-tip={W.layouts.gridTip}><span>{W.layouts.grid}</span>
          <Choice id="layout-grid" label={W.layouts.grid} value={`${grid.value}`} options={GRIDS.map((steps) => ({ value: `${steps}`, title: W.layouts.part(steps) }))} onPick={(steps) => (grid.value = Number(steps))} />
        </label>
        <Check label={W.layouts.mirror} tip={W.layouts.mirrorTip} value={keepsMirror.value} onChange={(value) => (keepsMirror.value = value)} />
      </div>
      {trouble.value ? <p class="trouble" role="alert" id="layout-trouble">{trouble.value}</p> : <p class="hint">{W.layouts.hint}</p>}
    </footer>
  );
}
