// SPDX-License-Identifier: GPL-3.0-or-later
// Everyday work with the studio, in a real browser against the real program.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { exported, fretwork, makeProject, median, openPage, picture, solved, startStudio, tilePlace } from './studio.mjs';

test('what is edited on the page is saved, and the command line computes the same', async (t) => {
  const project = makeProject('26mm');
  const { address, place } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);

  const [x, y] = await tilePlace(page, 40);
  await page.click('[data-pattern]:nth-child(9)');
  const before = await page.evaluate(() => window.fretwork.store.revision.value);
  await page.mouse.click(x, y);
  await page.waitForFunction((old) => window.fretwork.store.live.value?.info.revision > old, before);
  assert.equal(await page.evaluate(() => window.fretwork.store.documentNow.value.history.undo), 'paint 1 tile');

  await page.click('[data-value=hold]');
  await page.click('#choose-top');
  await page.click('#hold-pinned');
  await page.click('[data-value=load]');
  await page.click('#choose-middle');
  const supported = await page.evaluate(() => window.fretwork.store.revision.value);
  await page.click('#add-force');
  await page.waitForFunction((old) => window.fretwork.store.live.value?.info.revision > old, supported);

  await page.click('[data-value=look]');
  await page.click('[data-model=condensed]');
  await page.waitForFunction(() => window.fretwork.store.live.value?.info.model === 'condensed');
  await picture(page, '3-edited');
  await page.keyboard.press('Control+s');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value.saved);
  fretwork('simulate', project, '--case', 'bridge', '--model', 'condensed', '--out', join(place, 'result.json'));
  const { displacements } = JSON.parse(readFileSync(join(place, 'result.json'), 'utf8'));
  const shown = await page.evaluate(() => [...window.fretwork.store.live.value.solution.displacement]);
  const largest = Math.max(...displacements.map(([ux, uy, uz]) => Math.hypot(ux, uy, uz)));
  displacements.forEach(([ux, uy, uz], node) => {
    const away = Math.hypot(ux - shown[3 * node], uy - shown[3 * node + 1], uz - shown[3 * node + 2]);
    // The page has single precision: seven digits of the largest.
    assert.ok(away < 1e-6 * largest, `node ${node}: ${away} m of ${largest} m apart`);
  });

  const held = () => page.evaluate(() => window.fretwork.store.documentNow.value.load_cases[0].supports.length);
  assert.equal(await held(), 3);
  for (let i = 0; i < 3; ++i) await page.click('#undo');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value.load_cases[0].supports.length === 2);
  await page.reload();
  await solved(page);
  assert.equal(await held(), 2);
  assert.ok(await page.isEnabled('#redo'), 'what was undone before a reload can be redone after it');

  const file = await exported(page, 'svg', place);
  assert.match(readFileSync(file, 'utf8'), /<svg/);
  assert.deepEqual(page.troubles, []);
});

test('a server that goes and comes back is noticed, and nothing is lost', async (t) => {
  const project = makeProject('40mm');
  const { address } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);
  const revision = await page.evaluate(() => window.fretwork.store.revision.value);
  await page.evaluate(() => window.fretwork.cut());
  await page.waitForSelector('.lost');
  await page.waitForSelector('.lost', { state: 'detached' });
  await page.waitForFunction(() => window.fretwork.store.live.value !== null);
  assert.equal(await page.evaluate(() => window.fretwork.store.revision.value), revision);
});

test('latency from the input event to new positions in the page', async (t) => {
  const project = makeProject('12.1mm');
  const { address } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);
  const tiles = await page.evaluate(() => window.fretwork.store.documentNow.value.tiles.length);
  let other = 7;
  for (const model of await page.evaluate(() => window.fretwork.store.hello.value.models.map(({ name }) => name))) {
    if (model !== 'condensed' && model !== 'corotational') continue;
    await page.click('[data-value=look]');
    await page.click(`[data-model=${model}]`);
    await page.waitForFunction((name) => window.fretwork.store.live.value?.info.model === name, model);
    const drag = await dragLoad(page);
    const paint = await paintTiles(page, other++);
    const seconds = await page.evaluate(() => window.fretwork.store.live.value.info.seconds);
    console.log(`${tiles} tiles, ${model}, which solves in ${(1000 * seconds).toFixed(0)} ms: a dragged load ${words(drag)}; a painted tile ${words(paint)}`);
    assert.ok(drag.length > 5 && paint.length > 5, 'new positions came for dragged loads and painted tiles');
  }
});

const words = (samples) => samples.length === 0 ? 'no samples' : `${median(samples).toFixed(0)} ms in the median, ${Math.max(...samples).toFixed(0)} ms at most (${samples.length} samples)`;

async function dragLoad(page) {
  await page.click('[data-value=load]');
  const [tip] = await page.evaluate(() => window.fretwork.scene.value.handlePlaces());
  const box = await page.locator('.space canvas').boundingBox();
  await page.mouse.move(box.x + tip[0], box.y + tip[1]);
  await page.evaluate(() => window.fretwork.takeLatencies());
  await page.mouse.down();
  for (let step = 1; step <= 40; ++step) {
    await page.mouse.move(box.x + tip[0], box.y + tip[1] + 1.5 * step);
    await page.waitForTimeout(25);
  }
  await page.mouse.up();
  await page.waitForTimeout(500);
  return page.evaluate(() => window.fretwork.takeLatencies());
}

/** With a pattern that they do not have yet. */
async function paintTiles(page, place) {
  await page.click('[data-value=paint]');
  await page.click(`[data-pattern]:nth-child(${place})`);
  await page.evaluate(() => window.fretwork.takeLatencies());
  for (let tile = 20; tile < 40; ++tile) {
    await page.mouse.click(...(await tilePlace(page, tile * 10)));
    await page.waitForTimeout(250);
  }
  return page.evaluate(() => window.fretwork.takeLatencies());
}

test('a wrong outline is explained where it is chosen', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  const chooser = page.waitForEvent('filechooser');
  await page.click('#choose-outline');
  await (await chooser).setFiles({ name: 'broken.svg', mimeType: 'image/svg+xml', buffer: Buffer.from('<svg><path d="M0 0L1"/></svg>') });
  const trouble = await page.textContent('#outline-trouble');
  assert.match(trouble, /broken\.svg/);
});

for (const theme of ['dark', 'light'])
  test(`pictures of a large ${theme} screen`, async (t) => {
    const { address } = await startStudio(t, makeProject('26mm'));
    const page = await openPage(t, address, { width: 1920, height: 1080, theme });
    await solved(page);
    await page.waitForSelector('[data-pattern]');
    await picture(page, `10-large-${theme}`);
    await page.click('[data-value=load]');
    await picture(page, `11-large-${theme}-load`);
    assert.deepEqual(page.troubles, []);
  });

test('pictures of the main views', async (t) => {
  const project = makeProject('26mm');
  const { address } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);
  await page.waitForSelector('[data-pattern]');
  await picture(page, '4-paint');
  await page.keyboard.press('c');
  await page.click('text=Softer');
  await picture(page, '4-gallery');
  await page.click('[data-value=hold]');
  await picture(page, '5-hold');
  await page.click('[data-value=load]');
  await picture(page, '6-load');
  await page.click('[data-value=look]');
  await picture(page, '7-look');
  await page.click('#solve-full');
  await page.waitForFunction(() => window.fretwork.store.others.value.has('full'));
  await page.selectOption('#field', 'plain');
  await picture(page, '8-overlay');
  await page.keyboard.press('?');
  await picture(page, '9-help');
  assert.deepEqual(page.troubles, []);
});
