// SPDX-License-Identifier: GPL-3.0-or-later
// The few controls that everything is made of.

import type { ComponentChildren, JSX } from 'preact';

type Icon = (props: { 'aria-hidden'?: boolean }) => JSX.Element | unknown;

interface ButtonProps {
  title: string;
  shortcut?: string;
  icon?: Icon;
  label?: ComponentChildren;
  onPress: () => void;
  pressed?: boolean;
  disabled?: boolean;
  kind?: 'plain' | 'bare' | 'main';
  wide?: boolean;
  id?: string;
}

export function Button({ title, shortcut, icon, label, onPress, pressed, disabled, kind = 'plain', wide, id }: ButtonProps) {
  const Picture = icon as ((props: object) => JSX.Element) | undefined;
  const classes = ['button', kind === 'plain' ? '' : kind, label === undefined ? 'icon' : '', wide ? 'wide' : ''].join(' ').trim();
  return (
    <button type="button" id={id} class={classes} aria-label={label === undefined ? title : undefined} aria-pressed={pressed} disabled={disabled}
      data-tip={title} data-key={shortcut} onClick={onPress}>
      {Picture && <Picture aria-hidden />}
      {label}
    </button>
  );
}

interface SegmentsProps<T extends string> {
  label: string;
  value: T;
  options: { value: T; title: string; tip?: string; shortcut?: string; icon?: Icon }[];
  onPick: (value: T) => void;
  full?: boolean;
  iconsOnly?: boolean;
}

export function Segments<T extends string>({ label, value, options, onPick, full, iconsOnly }: SegmentsProps<T>) {
  const move = (event: KeyboardEvent, index: number) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const next = (index + step + options.length) % options.length;
    onPick(options[next].value);
    ((event.currentTarget as HTMLElement).parentElement?.children[next] as HTMLElement).focus();
  };
  return (
    <div class={`segments${full ? ' full' : ''}`} role="radiogroup" aria-label={label}>
      {options.map((option, index) => {
        const Picture = option.icon as ((props: object) => JSX.Element) | undefined;
        return (
          <button type="button" role="radio" aria-checked={option.value === value} key={option.value} tabIndex={option.value === value ? 0 : -1}
            data-value={option.value} data-tip={option.tip ?? (iconsOnly ? option.title : undefined)} data-key={option.shortcut}
            aria-label={iconsOnly || !option.title ? option.title || option.tip : undefined} onClick={() => onPick(option.value)} onKeyDown={(event) => move(event, index)}>
            {Picture && <Picture aria-hidden />}
            {!iconsOnly && option.title}
          </button>
        );
      })}
    </div>
  );
}

interface CheckProps {
  label: ComponentChildren;
  value: boolean;
  onChange: (value: boolean) => void;
  tip?: string;
}
export function Check({ label, value, onChange, tip }: CheckProps) {
  return (
    <label class="check" data-tip={tip}>
      <input type="checkbox" checked={value} onChange={(event) => onChange(event.currentTarget.checked)} />
      {label}
    </label>
  );
}

interface ChoiceProps<T extends string> {
  label: string;
  value: T;
  options: { value: T; title: string; disabled?: boolean }[];
  onPick: (value: T) => void;
  id?: string;
}
export function Choice<T extends string>({ label, value, options, onPick, id }: ChoiceProps<T>) {
  return (
    <select id={id} class="choice" aria-label={label} value={value} onChange={(event) => onPick(event.currentTarget.value as T)}>
      {options.map((option) => (
        <option key={option.value} value={option.value} disabled={option.disabled}>{option.title}</option>
      ))}
    </select>
  );
}
