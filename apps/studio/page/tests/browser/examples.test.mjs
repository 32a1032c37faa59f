// SPDX-License-Identifier: GPL-3.0-or-later
// Each example opens, bends, and has the picture of its answer on its card; and the tour through one of them.
// FRETWORK_DRAW_EXAMPLES=1 draws the pictures of the repository.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pictureOf, VIEWS } from './example_picture.mjs';
import { drag, edit, openPage, picture, read, repository, solved, startStudio, tilePlace } from './studio.mjs';

const PICTURES = join(repository, 'apps/studio/page/src/start/pictures');
/** Rounding may take a number to the next one. */
const NEAR = 1;
const numbersIn = (text) => (text.match(/-?\d+/g) ?? []).map(Number);

/** The answer that the page has, as numbers. */
const answer = (page) => page.evaluate(() => {
  const { live, documentNow } = window.fretwork.store;
  const { solution, beams } = live.value;
  const { rim, setting } = documentNow.value;
  return { place: [...beams.place], displacement: [...solution.displacement], ends: [...beams.ends], rim, width: Math.sqrt(setting.section.area) };
});

async function openExample(page, name) {
  await page.click(`[data-example=${name}]`);
  await page.waitForFunction((wanted) => {
    const { hello, documentNow, live, notTheAnswer } = window.fretwork.store;
    const { title } = hello.value.examples.find((one) => one.name === wanted);
    return documentNow.value?.name === title && live.value && !live.value.info.provisional && notTheAnswer.value === null;
  }, name);
}

test('each card has the picture of its answer', { timeout: 600_000 }, async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  const names = await page.evaluate(() => window.fretwork.store.hello.value.examples.map(({ name }) => name));
  assert.deepEqual([...names].sort(), Object.keys(VIEWS).sort(), 'each example is seen from somewhere');
  for (const [i, name] of names.entries()) {
    if (i > 0) await page.click('.document-name');
    await openExample(page, name);
    const drawn = pictureOf(await answer(page), VIEWS[name]);
    const file = join(PICTURES, `${name}.svg`);
    if (process.env.FRETWORK_DRAW_EXAMPLES === '1') writeFileSync(file, drawn);
    assert.ok(existsSync(file), `${file} is not there: draw it with FRETWORK_DRAW_EXAMPLES=1`);
    const [wanted, found] = [numbersIn(drawn), numbersIn(readFileSync(file, 'utf8'))];
    assert.equal(found.length, wanted.length, `the picture of ${name} is of other bars: draw it again with FRETWORK_DRAW_EXAMPLES=1`);
    const farthest = Math.max(...wanted.map((one, k) => Math.abs(one - found[k])));
    assert.ok(farthest <= NEAR, `the picture of ${name} is off by ${farthest} of 1200: draw it again with FRETWORK_DRAW_EXAMPLES=1`);
  }
  assert.deepEqual(page.troubles, []);
});

for (const theme of ['light', 'dark']) {
  test(`the cards are seen at 1280 x 800, in ${theme}`, async (t) => {
    const { address } = await startStudio(t);
    const page = await openPage(t, address, { theme });
    await page.waitForSelector('[data-example] svg');
    const count = await page.locator('[data-example] .example-picture svg').count();
    assert.equal(count, await page.locator('[data-example]').count());
    await picture(page, `25-examples-${theme}`, 0);
    const { width } = await page.locator('.start-inner').boundingBox();
    for (const card of await page.locator('[data-example]').all()) {
      const box = await card.boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= 1280 && box.width < width / 2, 'several beside one another');
    }
  });
}

const isDone = (page) => page.waitForSelector('.tour[data-done=true]');
const stepIs = (page, number) => page.waitForSelector(`.tour[data-step="${number}"]`);

test('the tour waits for each of its six steps, and can be left', { timeout: 600_000 }, async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  await page.click('#take-tour');
  await stepIs(page, 1);
  await solved(page);
  assert.ok(await page.isDisabled('#tour-next'), 'nothing has been done yet');
  await picture(page, '26-tour-1-light', 1);
  const next = async (number) => {
    await isDone(page);
    await page.click('#tour-next');
    await stepIs(page, number);
    assert.ok(await page.isDisabled('#tour-next'), `step ${number} waits`);
  };
  await page.waitForSelector('[data-pattern]');
  await page.click('[data-pattern]:nth-child(5)');
  await edit(page, async () => page.mouse.click(...(await tilePlace(page, 20))));
  await next(2);
  await page.click('[data-value=hold]');
  await page.click('#choose-right');
  await edit(page, () => page.click('#hold-fixed'));
  await next(3);
  await page.click('[data-value=load]');
  const box = await page.locator('#load-factor').boundingBox();
  await edit(page, () => drag(page, [box.x + box.width / 2, box.y + box.height / 2], [box.x + 0.7 * box.width, box.y + box.height / 2]));
  await next(4);
  await page.click('[data-value=paint]');
  await page.click('#retile');
  await page.fill('#retile-side', '27');
  await page.keyboard.press('Enter');
  const tiles = (await read(page, 'tiles')).length;
  await edit(page, () => page.click('#retile-apply'));
  assert.ok((await read(page, 'tiles')).length < tiles);
  await next(5);
  await page.click('[data-value=look]');
  await solved(page);
  await page.click('#solve-full');
  await next(6);
  await page.click('#export');
  await isDone(page);
  await picture(page, '26-tour-6-light', 0);
  await page.click('#tour-next');
  await page.waitForSelector('.tour', { state: 'detached' });

  await page.click('.document-name');
  await page.click('#take-tour');
  await page.click('#unsaved-discard');
  await stepIs(page, 1);
  await page.click('#tour-leave');
  await page.waitForSelector('.tour', { state: 'detached' });
  assert.deepEqual(page.troubles, []);
});
