// SPDX-License-Identifier: GPL-3.0-or-later

import { Question } from '../widgets/question';
import { Button } from '../widgets/widgets';
import { W } from '../words';
import { draft } from './draft';
import { discardAsked } from './save';

/** Asks before another layout takes the place of one with changes. */
export function DiscardSheet() {
  const answer = discardAsked.value;
  if (!answer) return null;
  return (
    <Question id="discard" title={W.layouts.unsavedTitle(draft.value?.layout.name ?? '')} words={W.layouts.unsaved} onEscape={() => answer(false)}>
      <Button id="discard-stay" kind="main" title={W.layouts.stayTip} label={W.layouts.stay} onPress={() => answer(false)} />
      <Button id="discard-replace" title={W.layouts.replaceTip} label={W.layouts.replace} onPress={() => answer(true)} />
    </Question>
  );
}
