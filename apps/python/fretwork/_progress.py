# SPDX-License-Identifier: GPL-3.0-or-later
"""The bar that `progress=True` shows in a terminal or a notebook: one line, redrawn in place."""

import sys
import time


class Bar:
    """Draw the progress of a task. Nothing is drawn for a task of less than half a second."""

    def __init__(self, stream=None):
        self._stream = stream or sys.stderr
        self._task = None
        self._started = 0.0
        self._is_drawn = False

    def __call__(self, task, done, total):
        if done == 0 or task != self._task:
            self._task, self._started = task, time.monotonic()
        elapsed = time.monotonic() - self._started
        if elapsed < 0.5 and not self._is_drawn:
            return
        self._draw(task, done, total, elapsed)

    def _draw(self, task, done, total, elapsed):
        share = done / total if total else 1.0
        rest = f", {elapsed * (1 - share) / share:.0f} s left" if 0 < share < 1 else ""
        filled = int(30 * share)
        self._stream.write(f"\r{task} [{'#' * filled}{'.' * (30 - filled)}] {share:4.0%}{rest}\x1b[K")
        self._is_drawn = done < total
        if not self._is_drawn:
            self._stream.write("\n")
        self._stream.flush()
