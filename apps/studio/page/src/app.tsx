// SPDX-License-Identifier: GPL-3.0-or-later

import { computed } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { documentNow, hello } from './document/store';
import { mode, startOpen, type Mode } from './document/ui';
import { wantPatterns } from './pattern/table';
import { HelpSheet } from './manners/help';
import { LineNotice, Notes } from './manners/notes';
import { DesignPanel } from './panels/design_panel';
import { HoldPanel } from './panels/hold_panel';
import { LoadPanel } from './panels/load_panel';
import { LookPanel } from './panels/look_panel';
import { PaintPanel } from './panels/paint_panel';
import { StatusLine } from './panels/status_line';
import { TopBar } from './panels/top_bar';
import { ConflictSheet } from './manners/conflict';
import { FolderSheet } from './manners/folder_sheet';
import { UnsavedSheet } from './manners/unsaved';
import { Start, takeFile } from './start/start';
import { TourCard } from './tour/tour_card';
import { Views } from './views/views';
import { Tooltip } from './widgets/tooltip';
import './panels/panels.css';
import './app.css';

const PANELS: Record<Mode, () => preact.JSX.Element> = { paint: PaintPanel, hold: HoldPanel, load: LoadPanel, design: DesignPanel, look: LookPanel };

const isOpen = computed(() => documentNow.value !== null);
const layoutName = computed(() => documentNow.value?.layout);

export function App() {
  const Panel = PANELS[mode.value];
  const ready = isOpen.value;
  const layout = layoutName.value;
  useEffect(() => void (layout && wantPatterns()), [layout]);
  return (
    <div class="app" onDragOver={(event) => event.preventDefault()}
      onDrop={(event) => {
        event.preventDefault();
        const file = event.dataTransfer?.files[0];
        if (file) void takeFile(file);
      }}>
      <LineNotice />
      <TopBar />
      {ready && (
        <main class="work">
          <aside class="side" aria-label={mode.value} data-mode={mode.value}><Panel /></aside>
          <Views />
        </main>
      )}
      {ready && <StatusLine />}
      {(startOpen.value || (!ready && hello.value)) && <Start />}
      <TourCard />
      <HelpSheet />
      <UnsavedSheet />
      <ConflictSheet />
      <FolderSheet />
      <Notes />
      <Tooltip />
    </div>
  );
}
