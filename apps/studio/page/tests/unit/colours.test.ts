// SPDX-License-Identifier: GPL-3.0-or-later
// The colour maps that can be chosen.
import { expect, it, vi } from 'vitest';
import { hello } from '../../src/document/store';
import type { Hello } from '../../src/protocol/messages';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
const { chooseColours, colourAt } = await import('../../src/views/space/colours');

hello.value = { colours: { sizes: ['#000000', '#ff0000'], signed: ['#0000ff', '#ffffff', '#ff0000'] } } as Hello;

it('the standard one is that of drawings', () => {
  chooseColours('standard');
  expect([colourAt('sizes', 0), colourAt('sizes', 0.5), colourAt('sizes', 1)]).toEqual([[0, 0, 0], [128, 0, 0], [255, 0, 0]]);
});

it.each(['cividis', 'grey'] as const)('%s becomes lighter from the lowest to the highest value, as one sees it without some colours', (choice) => {
  chooseColours(choice);
  const lightness = (share: number): number => {
    const [r, g, b] = colourAt('sizes', share);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  for (let i = 1; i <= 50; ++i) expect(lightness(i / 50)).toBeGreaterThan(lightness((i - 1) / 50));
});

it('values of both signs keep their scale', () => {
  chooseColours('cividis');
  expect(colourAt('signed', 0.5)).toEqual([255, 255, 255]);
});
