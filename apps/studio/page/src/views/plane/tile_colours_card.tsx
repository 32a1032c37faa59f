// SPDX-License-Identifier: GPL-3.0-or-later
// What the tiles are coloured by, and what the colours mean.

import { isProperty, patternLegend, propertyGradient, propertyLegend, TILE_COLOURS, tileColour } from '../../document/tile_colours';
import { shown } from '../../document/units';
import { Thumbnail } from '../../gallery/thumbnail';
import { Choice } from '../../widgets/widgets';
import { W } from '../../words';
import { fit } from './viewport';

const MOST_SWATCHES = 5;
const SWATCH = 22;

function PatternSwatches() {
  const all = patternLegend.value;
  return (
    <div class="tile-swatches">
      {all.slice(0, MOST_SWATCHES).map(({ pattern, colour, tiles }) => (
        <span key={pattern} data-pattern={pattern} data-tip={`${pattern}: ${W.tileColours.tiles(tiles)}`}><i style={{ '--swatch': colour }}><Thumbnail id={pattern} size={SWATCH} /></i>{tiles}</span>
      ))}
      {all.length > MOST_SWATCHES && <span>{W.tileColours.more(all.length - MOST_SWATCHES)}</span>}
    </div>
  );
}

function PropertyScale() {
  const range = propertyLegend.value;
  if (!range) return <p class="hint">{W.tileColours.unknown}</p>;
  return (
    <div class="tile-scale">
      <div class="legend-bar" style={{ background: propertyGradient }} />
      <div class="legend-ends"><span>{shown(range.low, range.quantity)}</span><span>{shown(range.high, range.quantity)}</span></div>
    </div>
  );
}

export function TileColoursCard() {
  const colour = tileColour.value;
  return (
    <div class="card tile-colours" role="group" aria-label={W.tileColours.label}>
      <Choice id="tile-colour" label={W.tileColours.label} value={colour} options={TILE_COLOURS.map((value) => ({ value, title: W.tileColours[value] }))}
        onPick={(next) => {
          tileColour.value = next;
          fit();
        }} />
      {colour === 'pattern' && <PatternSwatches />}
      {isProperty(colour) && <PropertyScale />}
    </div>
  );
}
