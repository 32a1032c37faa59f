// SPDX-License-Identifier: GPL-3.0-or-later

import { brush } from '../document/ui';
import { shown } from '../document/units';
import { patternEdges } from '../pattern/pattern_id';
import { relation } from './filters';
import { rowsById } from './order';
import { propertyRow, type PropertyName } from './properties';
import { RELATIONS } from './similar';
import { Thumbnail } from './thumbnail';
import { W } from '../words';

const SHOWN: PropertyName[] = ['mass', 'bending_young', 'bending_poisson', 'membrane_young', 'membrane_poisson', 'error'];

/** The pattern that is painted with: its picture, what it does, and where to go from it. */
export function ChosenPattern({ id }: { id: string }) {
  const row = rowsById.value.get(id);
  return (
    <div class="chosen">
      <Thumbnail id={id} size={92} bar={0.062} />
      <dl>
        <dt>{W.chosenPattern.edges}</dt>
        <dd>{patternEdges(id).length}</dd>
        {row && SHOWN.map((name) => {
          const property = propertyRow(name);
          const value = property.of(row);
          return value === null ? null : [<dt key={name}>{property.short}</dt>, <dd key={`${name}-value`}>{shown(value, property.quantity)}</dd>];
        })}
      </dl>
      <div class="relations">
        {RELATIONS.map(({ relation: kind, title, tip }) => (
          <button key={kind} type="button" class="chip" data-tip={tip} disabled={!row} aria-pressed={relation.value?.to === id && relation.value.relation === kind}
            onClick={() => {
              const same = relation.value?.to === id && relation.value.relation === kind;
              relation.value = same ? null : { to: id, relation: kind };
              brush.value = id;
            }}>{title}</button>
        ))}
      </div>
    </div>
  );
}
