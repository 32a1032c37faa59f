// SPDX-License-Identifier: GPL-3.0-or-later
// Files and messages are in SI. People read and type millimetres, or metres if they switch.

import { effect, signal } from '@preact/signals';

/** m/s², as the program has it. */
export const STANDARD_GRAVITY = 9.80665;

export type UnitSystem = 'mm' | 'SI';
export const unitSystem = signal<UnitSystem>(localStorage.getItem('fretwork.units') === 'SI' ? 'SI' : 'mm');
effect(() => localStorage.setItem('fretwork.units', unitSystem.value));

export type Quantity = 'share' | 'factor' | 'area_load' | 'line_load' | 'length' | 'angle' | 'force' | 'moment' | 'stress' | 'plain' | 'membrane' | 'bending' | 'area_mass' | 'frequency' | 'density' | 'acceleration';

interface Unit {
  name: string;
  /** How many of them make one SI unit. */
  per: number;
}

const BOTH: Partial<Record<Quantity, Unit>> = {
  force: { name: 'N', per: 1 },
  plain: { name: '', per: 1 },
  share: { name: '%', per: 100 },
  factor: { name: '×', per: 1 },
  membrane: { name: 'N/mm', per: 1e-3 },
  area_mass: { name: 'kg/m²', per: 1 },
  area_load: { name: 'N/m²', per: 1 },
  line_load: { name: 'N/m', per: 1 },
  frequency: { name: 'Hz', per: 1 },
  density: { name: 'kg/m³', per: 1 },
  acceleration: { name: 'm/s²', per: 1 },
};
const UNITS: Record<UnitSystem, Partial<Record<Quantity, Unit>>> = {
  mm: {
    ...BOTH,
    length: { name: 'mm', per: 1e3 },
    angle: { name: '°', per: 180 / Math.PI },
    moment: { name: 'N mm', per: 1e3 },
    stress: { name: 'MPa', per: 1e-6 },
    bending: { name: 'N mm', per: 1e3 },
  },
  SI: {
    ...BOTH,
    length: { name: 'm', per: 1 },
    angle: { name: 'rad', per: 1 },
    moment: { name: 'N m', per: 1 },
    stress: { name: 'Pa', per: 1 },
    membrane: { name: 'N/m', per: 1 },
    bending: { name: 'N m', per: 1 },
  },
};

export const unitOf = (quantity: Quantity, system = unitSystem.value): Unit => UNITS[system][quantity] as Unit;

/** Three significant digits, without exponents where people do not need them. */
export function digits(value: number, significant = 3): string {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size === 0) return '0';
  if (size >= 1e6 || size < 1e-4) return value.toExponential(significant - 1).replace('e+', 'e');
  const decimals = Math.max(0, significant - 1 - Math.floor(Math.log10(size)));
  return value.toFixed(Math.min(decimals, 7));
}

export function shown(value: number | null | undefined, quantity: Quantity, system = unitSystem.value): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const { name, per } = unitOf(quantity, system);
  const space = name === '°' || name === '' ? '' : '\u202f';
  return `${digits(value * per)}${space}${name}`;
}

/** A text of the program, with its lengths (m or mm) and points (m) converted to the shown units. */
export function inShownUnits(text: string): string {
  const length = (value: string, unit = 'm'): string => shown(Number(value) / (unit === 'mm' ? 1e3 : 1), 'length');
  return text
    .replace(/(?<![\w.])(\d[\d.]*(?:e[-+]?\d+)?) (mm?)(?![\w²/])/g, (whole, value: string, unit: string) => (unit === 'mm' && unitSystem.value === 'mm' ? whole : length(value, unit)))
    .replace(/\((-?[\d.]+(?:e[-+]?\d+)?), (-?[\d.]+(?:e[-+]?\d+)?)\)/g, (_, x: string, y: string) => `(${length(x)}, ${length(y)})`);
}

/** A text in which `{0}` becomes the first value, `{1}` the second, each (in SI) in the shown units. */
export function withShownValues(text: string, values: { value: number; quantity: Quantity }[]): string {
  return text.replace(/\{(\d+)\}/g, (mark, place: string) => {
    const own = values[Number(place)];
    return own ? shown(own.value, own.quantity) : mark;
  });
}

/** A typed number, in SI. It has a comma or a point, and may end in a unit. null if the text is no number. */
export function typed(text: string, quantity: Quantity, system = unitSystem.value): number | null {
  const match = /^\s*([-+−]?[\d.,]+(?:e[-+]?\d+)?)\s*([^\d\s].*)?$/i.exec(text);
  if (!match) return null;
  const value = Number(match[1].replace(',', '.').replace('−', '-'));
  const given = match[2]?.trim();
  const units = [UNITS[system][quantity], UNITS.mm[quantity], UNITS.SI[quantity]] as Unit[];
  const unit = given ? units.find(({ name }) => name.toLowerCase() === given.toLowerCase()) : units[0];
  return unit && Number.isFinite(value) ? value / unit.per : null;
}
