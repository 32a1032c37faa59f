// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes are chosen, and quick ways to choose.

import { X } from 'lucide-preact';
import { boxOfAll, pickedBy, selectBy } from '../document/picked';
import { documentNow } from '../document/store';
import { surface } from '../document/surface';
import { selectedNodes } from '../document/ui';
import type { Side } from '../protocol/messages';
import { Button } from '../widgets/widgets';
import { selectionWords } from './selection_words';
import { W } from '../words';

const SIDES: { title: string; side: Side }[] = [
  { title: W.chosenNodes.left, side: 'left' },
  { title: W.chosenNodes.right, side: 'right' },
  { title: W.chosenNodes.top, side: 'top' },
  { title: W.chosenNodes.bottom, side: 'bottom' },
];

/** The nodes nearer to the middle than 7 % of the box's diagonal, or 1.2 tile sides; else the nearest. */
function middleNodes(): number[] {
  const now = surface.peek();
  if (!now) return [];
  const { min, max } = now.box;
  const [x, y] = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
  const reach = Math.max(0.07 * Math.hypot(max[0] - min[0], max[1] - min[1]), 1.2 * now.side);
  const away = now.nodes.map((node) => Math.hypot(node[0] - x, node[1] - y));
  const near = away.flatMap((distance, node) => (distance < reach ? [node] : []));
  return near.length ? near : [away.indexOf(Math.min(...away))];
}

export function ChosenNodes({ purpose }: { purpose: 'hold' | 'load' | 'design' }) {
  const chosen = selectedNodes.value;
  const take = (nodes: number[]) => (selectedNodes.value = new Set(nodes));
  const now = surface.value;
  if (!now) return null;
  const rule = pickedBy.value;
  const takeAll = () => {
    const box = boxOfAll();
    if (box) selectBy({ box }, now.nodes.map((_, i) => i));
  };
  return (
    <div class="chosen-nodes">
      <div class="foot-head">
        <span id="nodes-chosen">{chosen.size ? W.chosenNodes.selected(chosen.size) : W.chosenNodes.selectNodes}</span>
        {chosen.size > 0 && <Button kind="bare" title={W.chosenNodes.clearSelection} shortcut="Esc" icon={X} onPress={() => take([])} />}
      </div>
      <div class="chips">
        {SIDES.map(({ title, side }) => (
          <button key={side} type="button" class="chip" id={`choose-${side}`} onClick={() => selectBy({ side }, documentNow.peek()?.sides[side] ?? [])}>{title}</button>
        ))}
        <button type="button" class="chip" onClick={() => take([...now.onRim])}>{W.chosenNodes.wholeEdge}</button>
        {purpose !== 'hold' && <button type="button" class="chip" id="choose-middle" onClick={() => take(middleNodes())}>{W.chosenNodes.middle}</button>}
        {purpose !== 'hold' && <button type="button" class="chip" id="choose-all" onClick={takeAll}>{W.chosenNodes.all}</button>}
      </div>
      {chosen.size > 0 && purpose !== 'design' && <p class="hint" id="kept-as">{rule ? W.chosenNodes.keptAsRule(selectionWords(rule, chosen.size)) : W.chosenNodes.keptAsNumbers}</p>}
      {chosen.size === 0 && <p class="hint">{W.chosenNodes.clickOrDragA}</p>}
    </div>
  );
}
