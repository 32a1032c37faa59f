// SPDX-License-Identifier: GPL-3.0-or-later

import { signal } from '@preact/signals';
import type { SceneView } from './scene_view';

/** The 3D view that is there, for what acts on it from outside: pictures, named views. */
export const currentScene = signal<SceneView | null>(null);
