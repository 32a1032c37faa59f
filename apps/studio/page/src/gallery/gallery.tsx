// SPDX-License-Identifier: GPL-3.0-or-later
// All patterns of the layout: find one, and paint with it.

import { ArrowDownWideNarrow, ArrowUpNarrowWide, ChartScatter, FlipHorizontal2, X } from 'lucide-preact';
import { patternTable } from '../document/store';
import { brushOrFirst, galleryWide } from '../document/ui';
import { Button, Choice } from '../widgets/widgets';
import { Chart } from './chart';
import { ChosenPattern } from './chosen_pattern';
import { clearFilters, descending, filtering, scope, search, shownPatterns, sortBy, symmetricOnly } from './filters';
import { Grid } from './grid';
import { PROPERTIES } from './properties';
import './gallery.css';

export function Gallery() {
  const rows = shownPatterns.value;
  const table = patternTable.value;
  return (
    <section class="gallery" aria-label="Patterns">
      {brushOrFirst.value && <ChosenPattern id={brushOrFirst.value} />}
      <div class="gallery-tools">
        <input class="text-input" type="search" placeholder="Find edges, as 0-1+1-6" aria-label="Find a pattern by its id" value={search.value}
          onInput={(event) => (search.value = event.currentTarget.value)} onKeyDown={(event) => event.stopPropagation()} />
        <Button kind="bare" title="Mirror-symmetric patterns only" icon={FlipHorizontal2} pressed={symmetricOnly.value} onPress={() => (symmetricOnly.value = !symmetricOnly.value)} />
        <Button kind="bare" title="Chart of two properties" shortcut="C" icon={ChartScatter} pressed={galleryWide.value} onPress={() => (galleryWide.value = !galleryWide.value)} />
      </div>
      <div class="gallery-tools">
        <Choice label="Which patterns" value={scope.value} onPick={(value) => (scope.value = value)}
          options={[{ value: 'all', title: 'All patterns' }, { value: 'palette', title: 'In the palette' }, { value: 'calibrated', title: 'Calibrated' }]} />
        <Choice label="Sort by" value={sortBy.value} onPick={(name) => (sortBy.value = name)} options={PROPERTIES.map(({ name, title }) => ({ value: name, title }))} />
        <Button kind="bare" title={descending.value ? 'Largest first' : 'Smallest first'} icon={descending.value ? ArrowDownWideNarrow : ArrowUpNarrowWide}
          onPress={() => (descending.value = !descending.value)} />
      </div>
      {galleryWide.value && <Chart />}
      <div class="gallery-count">
        <span aria-live="polite" id="gallery-count">{table ? `${rows.length.toLocaleString('en')} of ${table.patterns.length.toLocaleString('en')} patterns` : 'loading …'}</span>
        {filtering.value && <Button kind="bare" title="Show all again" icon={X} onPress={clearFilters} />}
      </div>
      {table && rows.length === 0 ? (
        <div class="empty"><p>No pattern is like that.</p><Button title="Show all again" label="Show all" onPress={clearFilters} /></div>
      ) : (
        <Grid rows={rows} />
      )}
    </section>
  );
}
