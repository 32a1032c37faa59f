// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns as thumbnails. Only those in view are there, so that thousands scroll as easily as ten.

import { useEffect, useRef, useState } from 'preact/hooks';
import { brush, brushOrFirst } from '../document/ui';
import type { PatternRow } from '../protocol/messages';
import { shown } from '../document/units';
import { propertyRow } from './properties';
import { sortBy } from './filters';
import { Thumbnail } from './thumbnail';
import { W } from '../words';

const CELL = 68;
const SPARE_ROWS = 2;

export function Grid({ rows }: { rows: readonly PatternRow[] }) {
  const host = useRef<HTMLDivElement>(null);
  const [view, setView] = useState({ top: 0, width: 280, height: 600 });
  useEffect(() => {
    const element = host.current as HTMLDivElement;
    const read = () => setView({ top: element.scrollTop, width: element.clientWidth, height: element.clientHeight });
    const resized = new ResizeObserver(read);
    resized.observe(element);
    element.addEventListener('scroll', read, { passive: true });
    return () => resized.disconnect();
  }, []);
  const columns = Math.max(1, Math.floor(view.width / CELL));
  const width = view.width / columns;
  const first = Math.max(0, Math.floor(view.top / CELL) - SPARE_ROWS) * columns;
  const last = Math.min(rows.length, (Math.ceil((view.top + view.height) / CELL) + SPARE_ROWS) * columns);
  const move = (event: KeyboardEvent) => {
    const step = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns, ArrowUp: -columns }[event.key];
    if (!step) return;
    event.preventDefault();
    const at = rows.findIndex(({ id }) => id === brushOrFirst.value);
    const next = Math.min(Math.max(at + step, 0), rows.length - 1);
    brush.value = rows[next]?.id ?? null;
    const y = Math.floor(next / columns) * CELL;
    const element = host.current as HTMLDivElement;
    if (y < element.scrollTop) element.scrollTop = y;
    if (y + CELL > element.scrollTop + element.clientHeight) element.scrollTop = y + CELL - element.clientHeight;
  };
  return (
    <div class="grid" ref={host} role="listbox" aria-label={W.grid.patterns} tabIndex={0} onKeyDown={move}>
      <div style={{ height: `${Math.ceil(rows.length / columns) * CELL}px` }}>
        {rows.slice(first, last).map((row, i) => {
          const at = first + i;
          return (
            <Cell key={row.id} row={row} left={(at % columns) * width} top={Math.floor(at / columns) * CELL} width={width} />
          );
        })}
      </div>
    </div>
  );
}

function Cell({ row, left, top, width }: { row: PatternRow; left: number; top: number; width: number }) {
  const property = propertyRow(sortBy.value);
  const value = property.name === 'edges' ? '' : ` · ${property.short} ${shown(property.of(row), property.quantity)}`;
  return (
    <button type="button" role="option" tabIndex={-1} class="cell" aria-selected={brushOrFirst.value === row.id} aria-label={W.grid.pattern(row.id)} data-pattern={row.id}
      data-tip={W.grid.edges(row.edges, value)} style={{ left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${CELL}px` }}
      onClick={() => (brush.value = row.id)}>
      <Thumbnail id={row.id} size={CELL - 14} />
    </button>
  );
}
