// SPDX-License-Identifier: GPL-3.0-or-later
// Keys, names of controls, units, notes and their places; and the words of the views about the surface.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drag, edit, makeProject, openPage, picture, read, solved, startStudio, tilePlace } from './studio.mjs';

/** Controls that a screen reader could not name. */
const nameless = (page) =>
  page.$$eval('button, input, select, canvas[tabindex]', (controls) =>
    controls
      .filter((control) => {
        const label = control.getAttribute('aria-label') || control.textContent.trim() || control.closest('label')?.textContent.trim() || control.labels?.[0]?.textContent;
        return !label;
      })
      .map((control) => control.outerHTML.slice(0, 120)),
  );

test('every control has a name, in every mode', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.keyboard.press('c');
  for (const mode of ['paint', 'hold', 'load', 'look']) {
    await page.click(`[data-value=${mode}]`);
    await page.waitForSelector(`.side[data-mode=${mode}]`);
    assert.deepEqual(await nameless(page), [], mode);
  }
});

test('controls are reached with the Tab key, and it is seen where one is', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const seen = new Set();
  for (let i = 0; i < 45; ++i) {
    await page.keyboard.press('Tab');
    const focus = await page.evaluate(() => {
      const element = document.activeElement;
      const { outlineStyle, outlineWidth } = getComputedStyle(element);
      return { name: element === document.body ? '' : element.getAttribute('aria-label') || element.textContent.trim().slice(0, 40), isSeen: outlineStyle !== 'none' && parseFloat(outlineWidth) > 0 };
    });
    if (focus.name) assert.ok(focus.isSeen, `focus is not seen on ${focus.name}`);
    seen.add(focus.name);
  }
  assert.ok(seen.size > 25, [...seen].join(', '));
});

test('units are switched, and stay so', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  assert.match(await page.textContent('.legend-ends'), /mm/);
  await page.click('[aria-label^=Millimetres], [data-tip^=Millimetres]');
  assert.doesNotMatch(await page.textContent('.legend-ends'), /mm/);
  await page.reload();
  await solved(page);
  assert.doesNotMatch(await page.textContent('.legend-ends'), /mm/);
});

test('the gallery finds patterns by relation and by a box in the chart', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await page.waitForSelector('[data-pattern]');
  const count = async () => Number((await page.textContent('#gallery-count')).split(' of')[0].replace(',', ''));
  const all = await count();
  const firsts = new Set();
  for (const relation of ['Similar', 'Stiffer', 'Softer', 'Other geometry']) {
    await page.click(`text=${relation}`);
    firsts.add(await page.getAttribute('[data-pattern]', 'data-pattern'));
    assert.ok((await count()) < all, relation);
    await page.click(`text=${relation}`);
  }
  assert.ok(firsts.size >= 3, 'relations lead to different patterns');
  await page.keyboard.press('c');
  const box = await page.locator('.chart canvas').boundingBox();
  await drag(page, [box.x + 0.3 * box.width, box.y + 0.3 * box.height], [box.x + 0.6 * box.width, box.y + 0.7 * box.height]);
  const brushed = await count();
  assert.ok(brushed > 0 && brushed < all, `${brushed} of ${all}`);
  await picture(page, '13-brushed');
  await page.click('[aria-label="Show all"]');
  assert.equal(await count(), all);
});

test('lassos and stretches of the rim choose what lies in them', async (t) => {
  const { address } = await startStudio(t, makeProject('26mm'));
  const page = await openPage(t, address);
  await solved(page);
  const around = async (tile, radius) => {
    const [x, y] = await tilePlace(page, tile);
    await page.mouse.move(x + radius, y);
    await page.mouse.down();
    for (let i = 1; i <= 16; ++i) await page.mouse.move(x + radius * Math.cos((Math.PI * i) / 8), y + radius * Math.sin((Math.PI * i) / 8));
    await page.mouse.up();
  };
  await page.keyboard.press('l');
  await around(60, 40);
  const tiles = Number((await page.textContent('#tiles-chosen')).split(' ')[0]);
  assert.ok(tiles > 1 && tiles < 60, `${tiles} tiles`);
  await page.click('[data-value=hold]');
  await page.keyboard.press('e');
  const [from, to] = await page.evaluate(() => {
    const { rim, tiles } = window.fretwork.store.documentNow.value;
    const tileOf = (node) => tiles.findIndex((tile) => tile.interface.includes(node));
    return [tileOf(rim[0][0]), tileOf(rim[0][Math.floor(rim[0].length / 3)])];
  });
  await drag(page, await tilePlace(page, from), await tilePlace(page, to));
  const nodes = Number((await page.textContent('#nodes-chosen')).split(' ')[0]);
  assert.ok(nodes > 1, `${nodes} nodes`);
  await edit(page, () => page.keyboard.press('p'));
});

test('forces, moments and displacements are dragged in space, and the surface follows', async (t) => {
  const { address } = await startStudio(t, makeProject('26mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=load]');
  for (const button of ['Moment', 'Displace']) {
    await page.click('#choose-middle');
    await edit(page, () => page.click(`.row >> text=${button}`));
  }
  const places = () => page.evaluate(() => window.fretwork.scene.value.handlePlaces());
  const count = (await places()).length;
  assert.equal(count, 3, 'a force, a moment and a displacement can be taken');
  const box = await page.locator('.space canvas').boundingBox();
  for (let handle = 0; handle < count; ++handle) {
    const [x, y] = (await places())[handle];
    const before = JSON.stringify((await read(page, 'load_cases'))[0]);
    await drag(page, [box.x + x, box.y + y], [box.x + x + 12, box.y + y - 45]);
    const changed = (old) => JSON.stringify(window.fretwork.store.documentNow.value.load_cases[0]) !== old;
    await page.waitForFunction(changed, before).catch(() => assert.fail(`handle ${handle} at ${x}, ${y} was not taken`));
    await solved(page);
  }
});

test('load paths and modes play, and the answer names reactions', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=look]');
  const reactions = await page.evaluate(() => window.fretwork.store.live.value.info.reactions);
  assert.ok(reactions.length > 0 && reactions.every(({ force, moment }) => force.length === 3 && moment.length === 3));
  for (const [button, kind] of [['Load path', 'path'], ['Modes', 'vibration'], ['Buckling', 'buckling']]) {
    await page.click(`text=${button}`);
    await page.waitForFunction((wanted) => {
      const shapes = window.fretwork.store.shapes.value;
      return shapes?.kind === wanted && shapes.shapes.length === shapes.expected && shapes.shapes.length > 0;
    }, kind);
    await page.waitForSelector('.play-bar');
    await page.click('.play-bar [aria-label="Close"]');
  }
  await page.selectOption('#field', 'von_mises');
  await page.waitForFunction(() => document.querySelector('.legend-title')?.textContent === 'Von Mises stress');
  assert.deepEqual(page.troubles, []);
});

test('the help sheet opens with a key and closes with another', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.keyboard.press('?');
  await page.waitForSelector('.help');
  await page.keyboard.press('Escape');
  await page.waitForSelector('.help', { state: 'detached' });
});
