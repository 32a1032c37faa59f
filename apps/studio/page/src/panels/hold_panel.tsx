// SPDX-License-Identifier: GPL-3.0-or-later

import { Trash2 } from 'lucide-preact';
import { hold, removeSupport, replaceSupport } from '../document/edits';
import { HOLD_COLOURS, holdKind, supportNodes } from '../document/marks';
import { chosenNodes, selectAgain, whereChosen } from '../document/picked';
import { selectionWords } from './selection_words';
import { loadCase } from '../document/store';
import { selectedNodes } from '../document/ui';
import { DOFS, type Dof, type Support } from '../protocol/messages';
import { Button } from '../widgets/widgets';
import { CaseBar } from './case_bar';
import { ChosenNodes } from './chosen_nodes';
import { W } from '../words';

const KINDS: { title: string; tip: string; fixed: Dof[]; colour: string; key: string }[] = [
  { title: W.holdPanel.fixed, tip: W.holdPanel.clampedNoMovementNo, fixed: [...DOFS], colour: '--fixed', key: 'X' },
  { title: W.holdPanel.pinned, tip: W.holdPanel.noMovementFreeRotation, fixed: ['ux', 'uy', 'uz'], colour: '--pinned', key: 'P' },
  { title: W.holdPanel.roller, tip: W.holdPanel.restsOnATable, fixed: ['uz'], colour: '--partly', key: 'O' },
];

export function holdChosen(fixed: Dof[]): void {
  const nodes = chosenNodes();
  if (nodes.length) hold({ where: whereChosen(), nodes }, fixed, supportNodes.peek());
}

export function HoldPanel() {
  const supports = loadCase.value?.supports ?? [];
  const some = selectedNodes.value.size > 0;
  return (
    <>
      <CaseBar />
      <div class="panel-scroll">
        <ChosenNodes purpose="hold" />
        <div class="row">
          {KINDS.map(({ title, tip, fixed, colour, key }) => (
            <Button key={title} id={`hold-${title.toLowerCase()}`} title={tip} shortcut={key} disabled={!some} label={<><i class="ball" style={{ background: `var(${colour})` }} />{title}</>}
              onPress={() => holdChosen(fixed)} />
          ))}
          <Button title={W.holdPanel.releaseTheSelectedNodes} disabled={!some} label={W.holdPanel.release} onPress={() => holdChosen([])} />
        </div>
        <h2>{W.holdPanel.supports}</h2>
        {supports.length === 0 && <p class="hint">{W.holdPanel.noSupportsYetSelect}</p>}
        <ul class="entries">{supports.map((support, index) => <SupportRow key={index} support={support} index={index} />)}</ul>
      </div>
    </>
  );
}

function SupportRow({ support, index }: { support: Support; index: number }) {
  const nodes = supportNodes.value[index] ?? [];
  const toggle = (dof: Dof) => {
    const fixed = DOFS.filter((one) => (one === dof ? !support.fixed.includes(dof) : support.fixed.includes(one)));
    if (fixed.length) replaceSupport(index, { ...support, fixed });
    else removeSupport(index);
  };
  return (
    <li class="entry">
      <button type="button" class="entry-title" data-tip={W.holdPanel.selectTheseNodes} onClick={() => selectAgain(support, nodes)}>
        <i class="ball" style={{ background: `var(${HOLD_COLOURS[holdKind(support.fixed)]})` }} />
        {selectionWords(support, nodes.length)}
      </button>
      <Button kind="bare" title={W.holdPanel.removeSupport} icon={Trash2} onPress={() => removeSupport(index)} />
      <div class="dofs" role="group" aria-label={W.holdPanel.fixedDirections}>
        {DOFS.map((dof) => (
          <button key={dof} type="button" class="dof" aria-pressed={support.fixed.includes(dof)} data-tip={`${dof[0] === 'u' ? W.holdPanel.translationAlong : W.holdPanel.rotationAbout} ${dof[1]}`}
            onClick={() => toggle(dof)}>{dof}</button>
        ))}
      </div>
    </li>
  );
}
