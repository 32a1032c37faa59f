// SPDX-License-Identifier: GPL-3.0-or-later

import { signal } from '@preact/signals';
import type { FieldRow } from './fields';

/** Whether the insides of tiles are interpolated from their rims, because the model does not know them. */
export const interpolated = signal(false);
/** The present meaning of the colours in the 3D view; null when there are none. */
export const legend = signal<{ row: FieldRow; low: number; high: number; isCut: boolean } | null>(null);
