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
  assert.match(await page.textContent('#problems'), /No problems/);
  assert.equal(await page.textContent('#made-of'), 'Paper, 1 GPa, made');
  await picture(page, '30-new-surface', 0);

  const setting = await read(page, 'setting');
  setting.section.I3 *= 36; // six times as wide
  await edit(page, () => page.evaluate((wide) => window.fretwork.ask('set_setting', { setting: wide }), setting));
  await page.waitForSelector('#problems.bad');
  const count = parseInt(await page.textContent('#problems'), 10);
  const { counts } = await page.evaluate(() => window.fretwork.store.making.value);
  assert.equal(count, counts.overlap + counts.gap + counts.opening);
  await page.click('#problems');
  const zoom = () => page.evaluate(() => { const [a, b] = [window.fretwork.planePlace(0), window.fretwork.planePlace(1)]; return Math.hypot(a[0] - b[0], a[1] - b[1]); });
  const before = await zoom();
  await page.click('.problem-list button');
  assert.match(await page.textContent('.problem-list button i'), /^1 of/);
  assert.ok((await zoom()) > before, 'the plane has come nearer to the place');
  await picture(page, '31-cannot-be-made', 0);
});
