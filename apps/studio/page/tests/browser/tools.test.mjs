// SPDX-License-Identifier: GPL-3.0-or-later
// Each tool of the plane, and each kind of load, does what it says.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drag, edit, openPage, picture, read, startStudio } from './studio.mjs';

const undoLabel = async (page) => (await read(page, 'history')).undo;

test('an example opens, bends, and every tool works on it', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  await page.click('[data-example]:nth-of-type(2)');
  await page.waitForFunction(() => window.fretwork.store.live.value);
  await picture(page, '11-example');
  await page.waitForSelector('[data-pattern]');
  const box = await page.locator('#plane').boundingBox();
  const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
  const place = (tile) => page.evaluate((index) => window.fretwork.planePlace(index), tile).then(([x, y]) => [box.x + x, box.y + y]);

  await page.click('[data-pattern]:nth-child(11)');
  for (const key of ['b', 'g', 'r']) {
    await page.click('[data-pattern]:nth-child(' + { b: 11, g: 12, r: 13 }[key] + ')');
    await page.keyboard.press(key);
    await edit(page, async () => page.mouse.click(...(await place(12))));
    assert.match(await undoLabel(page), /paint/);
  }
  await page.keyboard.press('d');
  await edit(page, () => drag(page, at(0.3, 0.5), at(0.7, 0.5)));
  await page.keyboard.press('v');
  await drag(page, at(0.02, 0.2), at(0.98, 0.98));
  assert.match(await page.textContent('#tiles-chosen'), /tiles selected/);
  await edit(page, () => page.click('text=Random'));
  const palette = (await read(page, 'palette')).length;
  assert.ok(palette > 1);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+z');

  await page.click('[data-value=load]');
  const [first] = await page.evaluate(() => [0].map(() => window.fretwork.planePlace(20)));
  await drag(page, [box.x + first[0] - 25, box.y + first[1] - 25], [box.x + first[0] + 25, box.y + first[1] + 25]);
  assert.match(await page.textContent('#nodes-chosen'), /nodes? selected/);
  await edit(page, () => page.click('text=Moment'));
  await page.click('#choose-middle');
  await edit(page, () => page.click('.row >> text=Displace'));
  await edit(page, () => page.locator('.entry.open input[type=range]').fill('0.004').catch(() => page.locator('.entry.open input[type=range]').press('ArrowRight')));
  const loadCase = (await read(page, 'load_cases'))[0];
  assert.ok(loadCase.prescribed.length > 0 && loadCase.loads.some(({ moment }) => moment));
  await picture(page, '12-moved');

  await page.keyboard.press('2');
  await page.keyboard.press('e');
  await drag(page, await place(3), await place(9));
  assert.match(await page.textContent('#nodes-chosen'), /nodes? selected/);
  await edit(page, () => page.keyboard.press('p'));
  await page.click('text=mm');
  assert.match(await page.locator('.legend-ends').textContent(), / ?m/);
  await page.click('#help');
  await page.keyboard.press('Escape');
  assert.deepEqual(page.troubles, []);
});
