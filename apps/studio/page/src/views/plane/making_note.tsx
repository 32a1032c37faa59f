// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacles to making the surface, and their places.

import { making, makingPlace } from '../../document/store';
import { inShownUnits } from '../../document/units';
import { seePlace } from './viewport';

/** The worst one first, then the next ones. */
function showNext(): void {
  const places = making.peek()?.places ?? [];
  if (!places.length) return;
  makingPlace.value = (makingPlace.peek() + 1) % places.length;
  seePlace(places[makingPlace.peek()].place);
}

export function MakingNote() {
  const now = making.value;
  if (!now || now.words.length === 0) return null;
  const at = makingPlace.value;
  return (
    <div class="card making-note" role="status" id="making-note">
      {now.words.map((words) => <p key={words}>{inShownUnits(words)}.</p>)}
      <button type="button" class="chip" id="making-where" data-tip="The worst place first" onClick={showNext}>
        {at < 0 ? 'Show where' : `Place ${at + 1} of ${now.places.length}; next`}
      </button>
    </div>
  );
}
