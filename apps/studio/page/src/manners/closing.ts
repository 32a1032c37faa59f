// SPDX-License-Identifier: GPL-3.0-or-later

/** The browser asks in its own words before a tab with unsaved changes is closed or loaded again. */
export function watchClosing(isUnsaved: () => boolean): void {
  window.addEventListener('beforeunload', (event) => {
    if (!isUnsaved()) return;
    event.preventDefault();
    event.returnValue = true; // what browsers before 2023 look at
  });
}
