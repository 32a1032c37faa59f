// SPDX-License-Identifier: GPL-3.0-or-later
// Cross-sections of bars.

import type { Section } from '../protocol/messages';

/** The sides of the box around a section, in metres: in the plane, and across it. */
export function sizeOf(section: Section): { width: number; height: number } {
  switch (section.type) {
    case 'circle':
      return { width: section.diameter, height: section.diameter };
    case 'tube':
      return { width: section.outer_diameter, height: section.outer_diameter };
    case 'I':
      return { width: section.width, height: section.height };
    default:
      return { width: Math.sqrt((12 * section.I3) / section.area), height: Math.sqrt((12 * section.I2) / section.area) };
  }
}
