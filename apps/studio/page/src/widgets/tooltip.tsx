// SPDX-License-Identifier: GPL-3.0-or-later
// One tooltip for everything that has data-tip, also when it is reached with the keyboard.

import { signal } from '@preact/signals';
import { W } from '../words';

interface Tip {
  text: string;
  key?: string;
  x: number;
  y: number;
  above: boolean;
}
const tip = signal<Tip | null>(null);
const PAUSE_MS = 450;
const HALF_WIDTH = 138;
let timer = 0;

export function watchTips(): void {
  document.addEventListener('pointerover', (event) => plan(event.target, PAUSE_MS));
  document.addEventListener('focusin', (event) => (event.target as Element).matches(':focus-visible') && plan(event.target, PAUSE_MS));
  for (const end of ['pointerdown', 'keydown', 'focusout', 'wheel']) document.addEventListener(end, hide, { passive: true });
}

function hide(): void {
  clearTimeout(timer);
  tip.value = null;
}

function plan(target: EventTarget | null, pause: number): void {
  hide();
  const element = (target as Element | null)?.closest?.('[data-tip]') as HTMLElement | null;
  if (!element?.dataset.tip) return;
  timer = window.setTimeout(() => show(element), pause);
}

function show(element: HTMLElement): void {
  const box = element.getBoundingClientRect();
  if (!box.width || !element.dataset.tip) return;
  const above = box.bottom > window.innerHeight - 60;
  tip.value = { text: element.dataset.tip, key: element.dataset.key, x: box.left + box.width / 2, y: above ? box.top - 8 : box.bottom + 8, above };
}

export function Tooltip() {
  const now = tip.value;
  if (!now) return null;
  const x = Math.min(Math.max(now.x, HALF_WIDTH), window.innerWidth - HALF_WIDTH);
  return (
    <aside aria-label={W.tooltip.explanation} class="tooltip" style={{ left: `${x}px`, top: `${now.y}px`, transform: `translate(-50%, ${now.above ? '-100%' : '0'})` }}>
      {now.text}
      {now.key && <kbd>{now.key}</kbd>}
    </aside>
  );
}
