// SPDX-License-Identifier: GPL-3.0-or-later

import { signal } from '@preact/signals';
import type { FieldRow } from './fields';

/** What the colours in the 3D view say right now; null when there are none. */
export const legend = signal<{ row: FieldRow; low: number; high: number } | null>(null);
