// SPDX-License-Identifier: GPL-3.0-or-later
// The properties by which patterns are filtered, sorted and charted: one row each.

import type { Quantity } from '../document/units';
import type { PatternRow } from '../protocol/messages';
import { W } from '../words';

export type PropertyName =
  | 'edges' | 'mass' | 'bending_young' | 'bending_poisson' | 'bending_shear' | 'membrane_young' | 'membrane_poisson' | 'membrane_shear' | 'error';

export interface Property {
  name: PropertyName;
  title: string;
  short: string;
  quantity: Quantity;
  /** Whether it spans powers of ten. */
  logarithmic: boolean;
  of(row: PatternRow): number | null;
}

export const PROPERTIES: Property[] = [
  { name: 'edges', title: W.properties.edges, short: 'edges', quantity: 'plain', logarithmic: false, of: (row) => row.edges },
  { name: 'mass', title: W.properties.mass, short: 'mass', quantity: 'area_mass', logarithmic: false, of: (row) => row.mass },
  { name: 'bending_young', title: W.properties.bendingStiffness, short: 'bending', quantity: 'bending', logarithmic: true, of: (row) => row.bending?.young ?? null },
  { name: 'bending_poisson', title: W.properties.bendingPoissonSRatio, short: 'ν bending', quantity: 'plain', logarithmic: false, of: (row) => row.bending?.poisson ?? null },
  { name: 'bending_shear', title: W.properties.twistingStiffness, short: 'twisting', quantity: 'bending', logarithmic: true, of: (row) => row.bending?.shear ?? null },
  { name: 'membrane_young', title: W.properties.membraneStiffness, short: 'membrane', quantity: 'membrane', logarithmic: true, of: (row) => row.membrane?.young ?? null },
  { name: 'membrane_poisson', title: W.properties.membranePoissonSRatio, short: 'ν membrane', quantity: 'plain', logarithmic: false, of: (row) => row.membrane?.poisson ?? null },
  { name: 'membrane_shear', title: W.properties.membraneShearStiffness, short: 'shear', quantity: 'membrane', logarithmic: true, of: (row) => row.membrane?.shear ?? null },
  { name: 'error', title: W.properties.calibrationError, short: 'error', quantity: 'plain', logarithmic: false, of: (row) => row.error },
];
export const propertyRow = (name: PropertyName): Property => PROPERTIES.find((row) => row.name === name) as Property;

/** The value on the scale on which differences mean the same everywhere. */
export function onScale(property: Property, row: PatternRow): number | null {
  const value = property.of(row);
  if (value === null || !Number.isFinite(value)) return null;
  return property.logarithmic ? (value > 0 ? Math.log10(value) : null) : value;
}

export function extent(property: Property, rows: readonly PatternRow[]): [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (const row of rows) {
    const value = onScale(property, row);
    if (value === null) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return low <= high ? [low, high] : null;
}
