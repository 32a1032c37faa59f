// SPDX-License-Identifier: GPL-3.0-or-later
// What stands around a saved picture: a title, the legend, a scale bar. One SVG for both kinds of file.

export interface FrameLegend {
  title: string;
  /** Colours from the lowest to the highest value, at equal distances. */
  colours: readonly string[];
  /** The values at both ends and in the middle. */
  values: readonly [string, string, string];
}
export interface ScaleBar {
  /** Pixels of the picture. */
  length: number;
  words: string;
}
export interface Frame {
  title: string;
  caption: string;
  legend: FrameLegend | null;
  /** null: lengths differ across the picture, as in perspective. */
  scaleBar: ScaleBar | null;
  ink: string;
  /** Around the letters, so that they are read on any ground. */
  halo: string;
}

const FONT = "system-ui, 'Segoe UI', Roboto, 'Noto Sans', 'DejaVu Sans', sans-serif";
export const PICTURE_PAD = 20;
const HEAD = 52;
const FOOT = 66;
const BAR = { width: 240, height: 10 };
const LEAST_WIDTH = 560;

export const escaped = (text: string): string => text.replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);

/** One, two or five times a power of ten, at most `most`. */
export function roundLength(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  const step = [5, 2, 1].find((digit) => digit * power <= most) ?? 1;
  return step * power;
}

interface Place {
  at: readonly [number, number];
  size?: number;
  anchor?: 'start' | 'middle' | 'end';
  weight?: number;
}
const lettered = (text: string, { at, size = 13, anchor = 'start', weight = 400 }: Place): string =>
  `<text x="${at[0]}" y="${at[1]}" font-size="${size}" font-weight="${weight}" text-anchor="${anchor}">${escaped(text)}</text>`;

function legendDrawn({ title, colours, values }: FrameLegend, [x, y]: readonly [number, number]): string {
  const stops = colours.map((colour, i) => `<stop offset="${i / Math.max(1, colours.length - 1)}" stop-color="${colour}"/>`).join('');
  const ends = values.map((value, i) => lettered(value, { at: [x + (i / 2) * BAR.width, y + 38], anchor: (['start', 'middle', 'end'] as const)[i] }));
  return (
    `<defs><linearGradient id="colours">${stops}</linearGradient></defs>${lettered(title, { at: [x, y], weight: 550 })}` +
    `<rect x="${x}" y="${y + 9}" width="${BAR.width}" height="${BAR.height}" rx="4" fill="url(#colours)" stroke="none"/>${ends.join('')}`
  );
}

function barDrawn({ length, words }: ScaleBar, [right, y]: readonly [number, number], { ink, halo }: Frame): string {
  const left = right - length;
  return (
    [`${halo}" stroke-width="4`, `${ink}" stroke-width="1.5`].map((stroke) => `<path d="M${left} ${y + 10}v8h${length}v-8" fill="none" stroke="${stroke}"/>`).join('') +
    lettered(words, { at: [left + length / 2, y + 38], anchor: 'middle' })
  );
}

export interface FramedPicture {
  text: string;
  width: number;
  height: number;
}

/** A drawing of some size with all that stands around it; the rest of the ground is transparent. */
export function framed(drawing: string, size: { width: number; height: number }, frame: Frame): FramedPicture {
  const width = Math.ceil(Math.max(size.width + 2 * PICTURE_PAD, LEAST_WIDTH));
  const foot = frame.legend || frame.scaleBar ? FOOT : 0;
  const height = Math.ceil(HEAD + size.height + PICTURE_PAD + foot);
  const below = HEAD + size.height + PICTURE_PAD + 8;
  const parts = [
    lettered(frame.title, { at: [PICTURE_PAD, 24], size: 17, weight: 600 }),
    lettered(frame.caption, { at: [PICTURE_PAD, 43] }),
    frame.legend ? legendDrawn(frame.legend, [PICTURE_PAD, below]) : '',
    frame.scaleBar ? barDrawn(frame.scaleBar, [width - PICTURE_PAD, below], frame) : '',
  ];
  const text =
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"><title>${escaped(frame.title)}</title>` +
    `<g transform="translate(${(width - size.width) / 2} ${HEAD})">${drawing}</g>` +
    `<g font-family="${FONT}" fill="${frame.ink}" stroke="${frame.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke">${parts.join('')}</g></svg>`;
  return { text, width, height };
}
