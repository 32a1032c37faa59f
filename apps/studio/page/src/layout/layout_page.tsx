// SPDX-License-Identifier: GPL-3.0-or-later
// The page of node layouts: the triangle to drag nodes on, and what comes of it.

import { useEffect } from 'preact/hooks';
import { hello } from '../document/store';
import { ConflictSheet } from '../manners/conflict';
import { FolderSheet } from '../manners/folder_sheet';
import { LineNotice, Notes } from '../manners/notes';
import { Tooltip } from '../widgets/tooltip';
import { W } from '../words';
import { DiscardSheet } from './discard_sheet';
import { draft } from './draft';
import { openFirst } from './kept';
import { LayoutBar } from './layout_bar';
import { LayoutPanel } from './layout_panel';
import { LayoutTools } from './layout_tools';
import { TriangleView } from './triangle_view';
import '../panels/panels.css';
import '../manners/help.css';
import '../gallery/gallery.css';
import '../app.css';
import './layout.css';

export function LayoutPage() {
  const line = hello.value;
  useEffect(() => {
    document.title = W.layouts.title;
    if (line && !draft.peek()) void openFirst();
  }, [line]);
  return (
    <div class="app">
      <LineNotice />
      <LayoutBar />
      <main class="layout-work">
        <section class="layout-stage" aria-label={W.layouts.triangle}>
          {draft.value ? <TriangleView /> : <p class="hint">{W.layouts.loading}</p>}
          <LayoutTools />
        </section>
        <LayoutPanel />
      </main>
      <ConflictSheet />
      <FolderSheet />
      <DiscardSheet />
      <Notes />
      <Tooltip />
    </div>
  );
}
