// SPDX-License-Identifier: GPL-3.0-or-later

import { render } from 'preact';
import { App } from './app';
import { designed, designing } from './document/design';
import { takeLatencies } from './document/latency';
import * as store from './document/store';
import { ask, cut, start } from './document/studio';
import { surface } from './document/surface';
import { target } from './document/target';
import { drawsLayouts } from './layout/address';
import { counted, isCounting } from './layout/count';
import { draft, isUnsaved as isLayoutUnsaved } from './layout/draft';
import { keepUnsaved } from './layout/kept';
import { watchLayoutKeys } from './layout/keys';
import { LayoutPage } from './layout/layout_page';
import { watchClosing } from './manners/closing';
import { watchKeys } from './manners/shortcuts';
import { isUnsaved } from './manners/unsaved';
import type { Point } from './protocol/messages';
import { toScreen, viewport } from './views/plane/viewport';
import { currentScene } from './views/space/current';
import { nodePlace, probedPlace } from './views/space/placed';
import { watchTips } from './widgets/tooltip';
import './styles/tokens.css';
import './styles/widgets.css';

const host = document.getElementById('studio') as HTMLElement;
if (drawsLayouts()) {
  render(<LayoutPage />, host);
  watchLayoutKeys();
  keepUnsaved();
  watchClosing(() => isLayoutUnsaved.peek());
} else {
  render(<App />, host);
  watchKeys();
  watchClosing(isUnsaved);
}
watchTips();
start();

/** The interface of the browser tests. */
const forTests = {
  takeLatencies,
  store,
  design: { designed, designing },
  target,
  layout: { draft, counted, isCounting },
  scene: currentScene,
  cut,
  ask,
  /** Draws the 3D view, which does not draw by itself in a test that has paused it. */
  drawFine: (samples: number) => currentScene.value?.stage.drawFine(samples),
  /** The middle of a bar on the canvas of the surface in space. */
  barPlace: (bar: number) => currentScene.value?.placeOnCanvas(probedPlace({ kind: 'beam', index: bar })) ?? null,
  /** A node of the bent surface on the same canvas. */
  nodePlace: (node: number) => currentScene.value?.placeOnCanvas(nodePlace(node)) ?? null,
  planePlace: (tile: number): Point => toScreen(viewport.value, surface.value?.centers[tile] ?? [0, 0]),
};
declare global {
  interface Window {
    fretworkPaused?: boolean;
    fretwork: typeof forTests;
  }
}
window.fretwork = forTests;
