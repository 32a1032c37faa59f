// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacles to making a surface are shown with their places; a new surface has none.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drop, edit, openPage, picture, read, startStudio } from './studio.mjs';

const SQUARE = JSON.stringify({ format: 'fretwork/outline/1', boundary: [[0, 0], [0.3, 0], [0.3, 0.2], [0, 0.2]] });
const checked = (page) => page.waitForFunction(() => window.fretwork.store.making.value !== null);

test('a new surface can be made, one with many bars cannot, and the page leads to the place', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  await drop(page, 'plate.json', SQUARE);
  await page.waitForSelector('#make:not([disabled])');
  await page.fill('#tile-size', '18');
  await page.press('#tile-size', 'Enter');
  await page.click('#make');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value !== null);
  await checked(page);
  assert.equal((await read(page, 'palette')).length, 1);
  assert.equal(await page.locator('#making-note').count(), 0);
  await picture(page, '30-new-surface', 0);

  const setting = await read(page, 'setting');
  setting.section.I3 *= 36; // six times as wide
  await edit(page, () => page.evaluate((wide) => window.fretwork.ask('set_setting', { setting: wide }), setting));
  await page.waitForSelector('#making-note');
  assert.match(await page.textContent('#making-note'), /overlap|narrower/);
  await page.click('#making-where');
  assert.match(await page.textContent('#making-where'), /^Place 1 of/);
  await picture(page, '31-cannot-be-made', 0);
});
