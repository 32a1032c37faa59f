// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds and colours of the legend, files that were open before, and what the camera sees.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { makeProject, openPage, picture, solved, startStudio } from './studio.mjs';

test('the bounds of a legend are typed and go back to the values; another colour map is seen at once', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const highest = () => page.textContent('.legend-ends span:last-child');
  const automatic = await highest();
  await page.click('#legend-edit');
  await page.fill('#legend-high', '12.5');
  await page.press('#legend-high', 'Enter');
  await page.waitForFunction(() => /12\.5/.test(document.querySelector('.legend-ends span:last-child').textContent));
  assert.match(await highest(), /≥/);
  const colours = () => page.evaluate(() => getComputedStyle(document.querySelector('.legend-bar')).backgroundImage);
  const standard = await colours();
  await page.click('[data-value=cividis]');
  assert.notEqual(await colours(), standard);
  await picture(page, '50-legend');
  await page.click('#legend-auto');
  await page.waitForFunction((text) => document.querySelector('.legend-ends span:last-child').textContent === text, automatic);
  await page.click('[data-value=standard]');
  assert.equal(await colours(), standard);
  assert.deepEqual(page.troubles, []);
});

test('Save as asks for a path in the page, and the file is offered when one starts', async (t) => {
  const { address, place } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const path = join(place, 'another.json');
  await page.keyboard.press('Control+Shift+S');
  await page.waitForSelector('#save-as-path:focus');
  await picture(page, '51-save-as', 0);
  await page.fill('#save-as-path', path);
  await page.click('#save-as');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value.name === 'another');
  assert.ok(existsSync(path));
  await page.click('.document-name');
  const offered = await page.$$eval('[data-path]', (buttons) => buttons.map((button) => button.dataset.path));
  assert.equal(offered[0], path);
  assert.equal(offered.length, 2);
  await picture(page, '52-recent', 0);
  await page.click('[data-path]:nth-child(1) >> nth=1');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value.name === 'surface');
  assert.deepEqual(page.troubles, []);
});

test('to fit is to see all of the bent surface', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.keyboard.press('8');
  const { places, width, height } = await page.evaluate(() => {
    const { clientWidth, clientHeight } = document.querySelector('.space canvas');
    const nodes = window.fretwork.store.documentNow.value.interface_nodes.map((_, node) => window.fretwork.nodePlace(node));
    return { places: nodes, width: clientWidth, height: clientHeight };
  });
  assert.ok(places.every((at) => at && at[0] >= 0 && at[0] <= width && at[1] >= 0 && at[1] <= height));
  const across = places.map(([x]) => x);
  const upward = places.map(([, y]) => y);
  const [wide, high] = [across, upward].map((values) => Math.max(...values) - Math.min(...values));
  assert.ok(wide > 0.6 * width || high > 0.5 * height, `${wide} x ${high} of ${width} x ${height}`);
});
