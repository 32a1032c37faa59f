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
import { W } from '../words';
import './gallery.css';

export function Gallery() {
  const rows = shownPatterns.value;
  const table = patternTable.value;
  return (
    <section class="gallery" aria-label={W.gallery.patterns}>
      {brushOrFirst.value && <ChosenPattern id={brushOrFirst.value} />}
      <div class="gallery-tools">
        <input class="text-input" type="search" placeholder={W.gallery.findEdgesEG} aria-label={W.gallery.findAPatternBy} value={search.value}
          onInput={(event) => (search.value = event.currentTarget.value)} onKeyDown={(event) => event.stopPropagation()} />
        <Button kind="bare" title={W.gallery.mirrorSymmetricPatternsOnly} icon={FlipHorizontal2} pressed={symmetricOnly.value} onPress={() => (symmetricOnly.value = !symmetricOnly.value)} />
        <Button kind="bare" title={W.gallery.chartOfTwoProperties} shortcut="C" icon={ChartScatter} pressed={galleryWide.value} onPress={() => (galleryWide.value = !galleryWide.value)} />
      </div>
      <div class="gallery-tools">
        <Choice label={W.gallery.sortBy} value={sortBy.value} onPick={(name) => (sortBy.value = name)} options={PROPERTIES.map(({ name, title }) => ({ value: name, title }))} />
        <Button kind="bare" title={descending.value ? W.gallery.largestFirst : W.gallery.smallestFirst} icon={descending.value ? ArrowDownWideNarrow : ArrowUpNarrowWide}
          onPress={() => (descending.value = !descending.value)} />
      </div>
      {galleryWide.value && <Chart />}
      <div class="gallery-count">
        <span aria-live="polite" id="gallery-count">{table ? W.gallery.ofPatterns(rows.length.toLocaleString('en'), table.patterns.length.toLocaleString('en')) : W.gallery.loading}</span>
        <Choice label={W.gallery.filter} value={scope.value} onPick={(value) => (scope.value = value)}
          options={[{ value: 'all', title: W.gallery.allPatterns }, { value: 'palette', title: W.gallery.inThePalette }, { value: 'calibrated', title: W.gallery.calibrated }]} />
        {filtering.value && <Button kind="bare" title={W.gallery.showAll} icon={X} onPress={clearFilters} />}
      </div>
      {table && rows.length === 0 ? (
        <div class="empty"><p>{W.gallery.noMatchingPattern}</p><Button title={W.gallery.showAll} label={W.gallery.showAll} onPress={clearFilters} /></div>
      ) : (
        <Grid rows={rows} />
      )}
    </section>
  );
}
