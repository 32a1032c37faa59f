// SPDX-License-Identifier: GPL-3.0-or-later

import { render } from 'preact';
import { App } from './app';
import { takeLatencies } from './document/latency';
import * as store from './document/store';
import { start } from './document/studio';
import { watchKeys } from './manners/shortcuts';
import { watchTips } from './widgets/tooltip';
import './styles/tokens.css';
import './styles/widgets.css';

render(<App />, document.getElementById('studio') as HTMLElement);
watchKeys();
watchTips();
start();

/** What the browser tests read. */
declare global {
  interface Window {
    fretwork: { takeLatencies: typeof takeLatencies; store: typeof store };
  }
}
window.fretwork = { takeLatencies, store };
