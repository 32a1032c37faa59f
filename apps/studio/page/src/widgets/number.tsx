// SPDX-License-Identifier: GPL-3.0-or-later

import { useLayoutEffect, useState } from 'preact/hooks';
import { digits, typed, unitOf, type Quantity } from '../document/units';
import { W } from '../words';

const MOST_DIGITS = 4;
const short = (value: number): string => digits(value, MOST_DIGITS).replace(/(\.\d*?)0+$/, '$1').replace(/\.$/, '');

interface NumberProps {
  label: string;
  /** undefined: there is none. */
  value: number | undefined;
  quantity: Quantity;
  onChange: (value: number) => void;
  /** The field may be empty, and was emptied. */
  onClear?: () => void;
  /** Shown in an empty field. */
  empty?: string;
  narrow?: boolean;
  least?: number;
  most?: number;
  /** Called with whether the text of the field can be read. */
  onReadable?: (isReadable: boolean) => void;
  id?: string;
}

const isBeyond = (read: number | undefined, least = -Infinity, most = Infinity): boolean => read !== undefined && (read < least || read > most);

/**
 * A number with its unit. Enter or leaving the field takes it; an invalid entry stays, with a message. Escape
 * puts the old one back, arrow keys change its second significant digit by one.
 */
export function NumberField({ label, value, quantity, onChange, onClear, empty = W.number.none, narrow, least, most, onReadable, id }: NumberProps) {
  const [draft, setDraft] = useState<string | null>(null);
  const unit = unitOf(quantity);
  const inUnit = (one: number | undefined) => (one === undefined ? '' : short(one * unit.per));
  const text = draft ?? inUnit(value);
  const isEmptied = onClear !== undefined && draft?.trim() === '';
  const read = draft === null ? value : isEmptied ? undefined : typed(draft, quantity);
  const wrong = read === null || isBeyond(read, least, most);
  useLayoutEffect(() => onReadable?.(!wrong), [wrong]); // before anything else can be pressed
  const commit = () => {
    if (wrong) return;
    if (isEmptied && value !== undefined) onClear();
    if (draft !== null && typeof read === 'number' && read !== value) onChange(read);
    setDraft(null);
  };
  const bound = (limit: number) => `${short(limit * unit.per)} ${unit.name}`;
  const advice = typeof read !== 'number' ? W.number.notANumber(unit.name) : most !== undefined && read > most ? W.number.notAbove(bound(most)) : W.number.notBelow(bound(least ?? 0));
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Enter') commit();
    if (event.key === 'Escape') setDraft(null);
    if ((event.key === 'ArrowUp' || event.key === 'ArrowDown') && !wrong && read !== undefined) {
      event.preventDefault();
      const step = 10 ** Math.floor(Math.log10(Math.abs(read * unit.per) || 1)) / 10 / unit.per;
      setDraft(null);
      onChange(Math.min(Math.max(read + (event.key === 'ArrowUp' ? step : -step), least ?? -Infinity), most ?? Infinity));
    }
    event.stopPropagation();
  };
  return (
    <span class={`number${narrow ? ' narrow' : ''}`}>
      <input id={id} inputMode="decimal" aria-label={`${label}${unit.name ? W.number.inWords(unit.name) : ''}`} class={wrong ? 'wrong' : ''} aria-invalid={wrong} value={text} placeholder={onClear && empty} style={{ width: `${(narrow ? 52 : 66) + 8 * unit.name.length + 12}px`, paddingRight: `${17 + 8 * unit.name.length}px` }}
        onFocus={(event) => event.currentTarget.select()} onInput={(event) => setDraft(event.currentTarget.value)} onBlur={commit} onKeyDown={keys} />
      <i>{unit.name}</i>
      {wrong && <b class="number-advice" role="alert">{W.number.withEscape(advice, value === undefined ? undefined : inUnit(value))}</b>}
    </span>
  );
}
