// SPDX-License-Identifier: GPL-3.0-or-later
// Other tiles for the surface that is open, and one factor on all of its loads.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drag, edit, largest, makeProject, openPage, picture, read, solved, startStudio } from './studio.mjs';

/** Types a side, and waits for the tiles that would come. */
async function wantSide(page, millimetres) {
  await page.fill('#retile-side', millimetres);
  await page.keyboard.press('Enter');
  await page.waitForSelector('#retile-tiles');
}
/** The surface bends on the tiles that it has now. */
const bends = (page) => page.waitForFunction(() => {
  const { live, documentNow, answered, revision } = window.fretwork.store;
  return live.value && answered.value === revision.value && live.value.info.largest_displacement > 0 && documentNow.value.load_cases.length > 0;
});

for (const theme of ['light', 'dark']) {
  test(`a surface gets other tiles and keeps what lies on sides, in ${theme}`, async (t) => {
    const { address } = await startStudio(t, makeProject('40mm'));
    const page = await openPage(t, address, { theme });
    await solved(page);
    const [tilesAtFirst, bentAtFirst] = [(await read(page, 'tiles')).length, await largest(page)];

    // A side, which stays, and nodes that are selected by hand, which cannot.
    await page.click('[data-value=hold]');
    await page.click('#choose-left');
    await edit(page, () => page.click('#hold-pinned'));
    await page.click('[data-value=load]');
    await page.click('#choose-middle');
    await edit(page, () => page.click('#add-force'));
    const supports = (await read(page, 'load_cases'))[0].supports;

    await page.click('[data-value=paint]');
    await page.click('#retile');
    await wantSide(page, '30');
    const count = Number(await page.textContent('#retile-tiles'));
    assert.ok(count > 1.5 * tilesAtFirst, 'smaller tiles are more');
    assert.match(await page.textContent('#retile-dropped'), /^1 load is on nodes selected by hand and will be removed\./);
    assert.equal((await read(page, 'tiles')).length, tilesAtFirst, 'nothing has been done');
    await picture(page, `27-retile-${theme}`, 1);
    await edit(page, () => page.click('#retile-apply'));
    assert.equal((await read(page, 'tiles')).length, count);
    const after = (await read(page, 'load_cases'))[0];
    assert.deepEqual(after.supports, supports.filter(({ nodes }) => nodes === undefined));
    assert.ok(after.marks.supports.every((nodes) => nodes.length > 0));
    assert.ok((after.loads ?? []).every(({ nodes }) => nodes === undefined));
    await bends(page);
    await picture(page, `28-retiled-${theme}`, 1);

    await edit(page, () => page.click('#undo'));
    assert.equal((await read(page, 'tiles')).length, tilesAtFirst, 'one step of undo');
    assert.deepEqual((await read(page, 'load_cases'))[0].supports, supports);
    await edit(page, () => page.click('#undo'));
    await edit(page, () => page.click('#undo'));
    await bends(page);
    assert.ok(Math.abs((await largest(page)) - bentAtFirst) <= 1e-9 * bentAtFirst, 'as it was at first');
    assert.deepEqual(page.troubles, []);
  });
}

test('a slider gives tiles when it is let go, and a gradient is painted again on them', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.waitForSelector('[data-pattern]');
  await page.keyboard.press('d');
  const view = await page.locator('#plane').boundingBox();
  await edit(page, () => drag(page, [view.x + 0.2 * view.width, view.y + 0.5 * view.height], [view.x + 0.8 * view.width, view.y + 0.5 * view.height]));
  const palette = await read(page, 'palette');
  assert.ok(palette.length > 2);
  await page.click('#retile');
  const slider = await page.locator('#retile-slider').boundingBox();
  const middle = slider.y + slider.height / 2;
  await drag(page, [slider.x + 0.5 * slider.width, middle], [slider.x + 0.35 * slider.width, middle]);
  await page.waitForSelector('#retile-tiles');
  const count = Number(await page.textContent('#retile-tiles'));
  assert.ok((await page.textContent('.retile')).includes(`The gradient is painted again on ${count} tiles.`));
  await edit(page, () => page.click('#retile-apply'));
  assert.equal((await read(page, 'painting')).length, count);
  assert.ok(new Set(await read(page, 'painting')).size > 2);

  await page.selectOption('#retile-layout', 'paper8');
  await wantSide(page, '45');
  assert.ok((await page.textContent('.retile')).includes('All tiles get one pattern.'));
  await edit(page, () => page.click('#retile-apply'));
  assert.equal(await read(page, 'layout'), 'paper8');
  await page.click('#retile-close');
  await page.waitForSelector('[data-pattern]');
  assert.deepEqual(page.troubles, []);
});

test('a side that cannot be tiled is refused in the panel', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('#retile');
  await page.fill('#retile-side', '0.2');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#retile-trouble');
  assert.match(await page.textContent('#retile-trouble'), /tiles/);
  assert.ok(await page.isDisabled('#retile-apply'));
  await wantSide(page, '50');
  assert.equal(await page.locator('#retile-trouble').count(), 0);
});

test('a load factor slides all loads at once, and back from nothing', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const before = (await read(page, 'load_cases'))[0];
  const bentAtFirst = await largest(page);
  await page.click('[data-value=load]');
  const box = await page.locator('#load-factor').boundingBox();
  const at = (share) => [box.x + 7 + share * (box.width - 14), box.y + box.height / 2];
  await edit(page, () => drag(page, at(0.5), at(0)));
  await page.waitForFunction((old) => window.fretwork.store.live.value?.info.largest_displacement < old / 100, bentAtFirst);
  await picture(page, '29-load-factor', 1);
  await page.fill('#load-factor-number', '1');
  await edit(page, () => page.keyboard.press('Enter'));
  await page.waitForFunction((old) => Math.abs(window.fretwork.store.live.value?.info.largest_displacement - old) <= 1e-9 * old, bentAtFirst);
  assert.deepEqual((await read(page, 'load_cases'))[0].loads, before.loads);
  await edit(page, () => page.click('#undo'));
  await edit(page, () => page.click('#undo'));
  assert.equal((await read(page, 'history')).undo, null, 'one slide is one step');
  assert.deepEqual(page.troubles, []);
});
