// SPDX-License-Identifier: GPL-3.0-or-later
// A node layout is drawn: nodes are dragged with their twins, patterns are counted, the file is what `fretwork enumerate` reads.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { folder, fretwork, openPage, picture, startStudio } from './studio.mjs';

const draft = (page) => page.evaluate(() => window.fretwork.layout.draft.value);
/** The numbers beside the triangle, once the count is at its end. */
async function numbers(page) {
  await page.waitForFunction(() => !window.fretwork.layout.isCounting.value && window.fretwork.layout.counted.value);
  return [await page.textContent('#layout-edges'), await page.textContent('#layout-patterns')];
}
async function ready(page) {
  await page.waitForSelector('.layout-node');
  return numbers(page);
}
/** The middle of a node on the page. */
const nodeAt = (page, node) => page.$eval(`[data-node="${node}"] circle`, (circle) => {
  const { left, top, width, height } = circle.getBoundingClientRect();
  return [left + width / 2, top + height / 2];
});
const changed = (page, before) => page.waitForFunction((old) => JSON.stringify(window.fretwork.layout.draft.value.layout) !== old, JSON.stringify(before));

test('a node is dragged with its twin, patterns are counted, and the file is saved', async (t) => {
  const { address, place } = await startStudio(t, '--layout');
  const page = await openPage(t, address);
  assert.deepEqual(await ready(page), ['17', '1,824'], 'as experiments/layouts/README.md has it');
  assert.equal((await page.$$('.layout-fans li')).length, 12);
  await picture(page, '80-layout-light', 0);

  const { layout } = await draft(page);
  const [from, to] = [await nodeAt(page, 1), await nodeAt(page, 2)];
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let i = 1; i <= 10; ++i) await page.mouse.move(from[0] + (0.04 * i * (to[0] - from[0])), from[1] + 0.04 * i * (to[1] - from[1]));
  await page.mouse.up();
  await changed(page, layout);
  await page.waitForFunction(() => window.fretwork.layout.draft.value.layout.radial[0] === '7/15');
  const { nodes } = await draft(page);
  assert.deepEqual([nodes[1].exact, nodes[3].exact], [['8/15', '7/15', '0'], ['8/15', '0', '7/15']]);
  const after = await numbers(page);

  await page.focus('[data-node="5"]');
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => window.fretwork.layout.draft.value.layout.face[0][1] === '7/15');
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => window.fretwork.layout.draft.value.layout.face[0][1] === '9/20');
  assert.deepEqual(await numbers(page), after);

  await page.fill('#layout-name', 'drawn');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => window.fretwork.layout.draft.value.layout.name === 'drawn');
  await page.keyboard.press('Control+s');
  await page.waitForSelector('#save-as-path:focus');
  assert.equal(await page.inputValue('#save-as-path'), 'drawn.json');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.layout-names .unsaved', { state: 'detached' });
  const file = join(place, 'drawn.json');
  assert.equal(fretwork('enumerate', '--layout', file, '--count').trim(), after[1].replaceAll(',', ''), 'the command counts the same');
  assert.deepEqual(page.troubles, []);
});

test('nodes are added and removed by keys, with what depends on them', async (t) => {
  const { address } = await startStudio(t, '--layout', 'spider4');
  const page = await openPage(t, address, { theme: 'dark' });
  assert.deepEqual(await ready(page), ['5', '11']);
  // One in the middle of the triangle, a pair, and a pair.
  for (const [kind, nodes] of [['face', 5], ['radial', 7], ['interface', 9]]) {
    await page.focus(`#add-${kind}`);
    await page.keyboard.press('Enter');
    await page.waitForFunction((count) => window.fretwork.layout.draft.value.nodes.length === count, nodes);
  }
  await picture(page, '81-layout-dark', 0);
  await page.focus('[data-node="0"]');
  await page.keyboard.press('Delete');
  await page.waitForFunction(() => window.fretwork.layout.draft.value.layout.center === false);
  for (let i = 0; i < 4; ++i) {
    const { layout } = await draft(page);
    await page.keyboard.press('Control+z');
    await changed(page, layout);
  }
  assert.deepEqual(await numbers(page), ['5', '11']);
  await page.click('#add-center', { force: true, timeout: 2000 }).catch(() => undefined);
  assert.ok(await page.isDisabled('#add-center'), 'there is one');
  assert.deepEqual(page.troubles, []);
});

test('a layout of many patterns says so, and a new one does not wait for it', async (t) => {
  const { address } = await startStudio(t, '--layout', 'fifths12');
  const page = await openPage(t, address);
  await page.waitForSelector('.layout-node');
  await page.selectOption('#layout-begin', 'doors6');
  await page.waitForFunction(() => window.fretwork.layout.draft.value?.layout.name === 'my-doors6');
  assert.deepEqual(await numbers(page), ['13', '188']);
  assert.deepEqual(page.troubles, []);
});

test('a file that somebody else has changed is not replaced without a question', async (t) => {
  const file = join(folder(), 'mine.json');
  const text = '{"format": "fretwork/layout/1", "name": "mine", "radial": ["1/2"], "interface": ["1/2"]}';
  writeFileSync(file, text);
  const { address } = await startStudio(t, '--layout', file);
  const page = await openPage(t, address);
  await ready(page);
  await page.click('#add-radial');
  await page.waitForSelector('.layout-names .unsaved');
  writeFileSync(file, `${text}\n`);
  await page.keyboard.press('Control+s');
  await page.waitForSelector('#conflict-mine');
  assert.match(await page.textContent('#conflict-title'), /mine\.json.*changed elsewhere/);
  assert.equal(readFileSync(file, 'utf8'), `${text}\n`);
  await page.click('#conflict-mine');
  await page.waitForSelector('.layout-names .unsaved', { state: 'detached' });
  assert.equal(JSON.parse(readFileSync(file, 'utf8')).radial.length, 2);
  assert.deepEqual(page.troubles, []);
});

test('a layout that was not saved is there again when the page is loaded again', async (t) => {
  const { address } = await startStudio(t, '--layout', 'spider4');
  const page = await openPage(t, address);
  const asked = [];
  page.on('dialog', (dialog) => {
    asked.push(dialog.type());
    void dialog.accept();
  });
  assert.deepEqual(await ready(page), ['5', '11']);
  await page.click('#add-radial');
  await page.waitForSelector('.layout-names .unsaved');
  const { layout } = await draft(page);
  await page.reload();
  await page.waitForSelector('.layout-names .unsaved');
  assert.deepEqual(asked, ['beforeunload']);
  assert.deepEqual((await draft(page)).layout, layout);
  await page.keyboard.press('Control+z');
  await page.waitForSelector('.layout-names .unsaved', { state: 'detached' });
  assert.deepEqual(await numbers(page), ['5', '11']);
  assert.deepEqual(page.troubles, []);
});
