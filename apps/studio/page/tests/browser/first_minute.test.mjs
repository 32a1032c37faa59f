// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody new, with an outline.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openPage, picture, startStudio } from './studio.mjs';

const OUTLINE = `<svg xmlns="http://www.w3.org/2000/svg" width="260mm" height="180mm" viewBox="0 0 260 180"><path d="M10 10H250V90L160 170H10Z"/></svg>`;

test('the first minute: an outline becomes a surface that is held, loaded and bent', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  await page.waitForSelector('[data-example]');
  await picture(page, '1-start');
  const began = Date.now();
  const chooser = page.waitForEvent('filechooser');
  await page.click('#choose-outline');
  await (await chooser).setFiles({ name: 'corner.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(OUTLINE) });
  await page.click('#make');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value);
  await page.click('#next-step');
  await page.click('#choose-left');
  await page.click('#hold-fixed');
  await page.click('#next-step');
  await page.click('#choose-right');
  await page.click('#add-force');
  await page.waitForFunction(() => window.fretwork.store.live.value?.info.largest_displacement > 0);
  console.log(`from outline to bent surface: ${((Date.now() - began) / 1000).toFixed(1)} s, by a script on this machine`);
  const moved = await page.evaluate(() => window.fretwork.store.live.value.info.largest_displacement);
  assert.ok(moved > 1e-4, `it moved by ${moved} m`);
  await picture(page, '2-bent', 1);
  assert.deepEqual(page.troubles, []);
});
