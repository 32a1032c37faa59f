// SPDX-License-Identifier: GPL-3.0-or-later
// From a wanted shape to a painting: target by numbers, by dragging and by a curve; run, stop, undo.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drag, edit, openPage, picture, read, solved, startStudio } from './studio.mjs';
import { fretwork, folder } from './studio.mjs';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

/** A strip that is held at its left side and pushed down at its right one. */
function strip() {
  const place = folder();
  const [outline, load, project] = ['outline.json', 'load.json', 'strip.json'].map((name) => join(place, name));
  writeFileSync(outline, JSON.stringify({ format: 'fretwork/outline/1', boundary: [[0, 0], [0.3, 0], [0.3, 0.12], [0, 0.12]] }));
  writeFileSync(load, JSON.stringify({
    format: 'fretwork/load-case/1', name: 'push', supports: [{ side: 'left', fixed: ['ux', 'uy', 'uz', 'rx', 'ry', 'rz'] }], loads: [{ side: 'right', force: [0, 0, -0.02], amount: 'total' }],
  }));
  fretwork('tile', outline, '--edge-length', '26mm', '--patterns', '0-1+1-6', '--out', project);
  fretwork('case', 'add', project, load);
  return project;
}

const state = (page, name) => page.evaluate((key) => window.fretwork.design[key].value, name);
const WANTED_Z = '[aria-label="Wanted displacement along z, in mm"]';

async function setTarget(page, millimetres, nodes = 'right') {
  await page.click('[data-value=design]');
  await page.click(`#choose-${nodes}`);
  await page.fill(WANTED_Z, millimetres);
  await page.press(WANTED_Z, 'Enter');
  await page.click('#set-target');
}

for (const theme of ['light', 'dark'])
  test(`a target is set, the surface is painted towards it, and undo takes that back (${theme})`, async (t) => {
    const { address } = await startStudio(t, strip());
    const page = await openPage(t, address, { theme });
    await solved(page);
    await page.click('[data-value=design]');
    assert.equal(await page.isDisabled('#run-design'), true);
    assert.match(await page.textContent('#design-needs'), /target/);
    const bent = await page.evaluate(() => window.fretwork.store.live.value.info.largest_displacement);
    await setTarget(page, String(-700 * bent));
    await setTarget(page, String(-300 * bent), 'middle'); // no single pattern bends so much more near its support
    const before = parseFloat(await page.textContent('#distance-now'));
    await picture(page, `40-target-${theme}`);
    const painting = await read(page, 'painting');
    await page.click('#run-design');
    await page.waitForFunction(() => window.fretwork.design.designed.value?.sketch === true);
    await picture(page, `41-designing-${theme}`, 0);
    await page.waitForFunction(() => window.fretwork.design.designed.value?.sketch === false);
    await page.waitForFunction(() => window.fretwork.store.answered.value >= window.fretwork.store.revision.value);
    const result = await state(page, 'designed');
    assert.ok(result.error_mean < result.error_best_uniform, JSON.stringify(result));
    assert.ok(Math.abs(parseFloat(await page.textContent('#share-closed')) - 100 * result.share_closed) < 1);
    assert.match(await page.textContent('#design-end'), /The search found no further swap|The solutions were spent/);
    assert.ok(parseFloat(await page.textContent('#distance-now')) < before, 'the live shape has come nearer');
    await picture(page, `42-designed-${theme}`);
    await edit(page, () => page.click('#undo'));
    const back = await page.evaluate(() => { const { palette, painting } = window.fretwork.store.documentNow.value; return painting.map((index) => palette[index]); });
    assert.deepEqual(new Set(back), new Set(['0-1+1-6']));
    assert.equal(back.length, painting.length);
    assert.equal(await state(page, 'designed'), null);
    assert.deepEqual(page.troubles, []);
  });

test('a target is dragged in 3D: up and down', async (t) => {
  const { address } = await startStudio(t, strip());
  const page = await openPage(t, address);
  await solved(page);
  await setTarget(page, '-20');
  const wanted = () => page.evaluate(() => window.fretwork.target.value[0].wanted[0]);
  const [handle] = await page.evaluate(() => window.fretwork.scene.value.handlePlaces());
  const box = await page.locator('.space canvas').boundingBox();
  await drag(page, [box.x + handle[0], box.y + handle[1]], [box.x + handle[0] + 30, box.y + handle[1] - 40]);
  const [x, y, z] = await wanted();
  assert.deepEqual([x, y], [null, null]);
  assert.ok(z > -0.02 && z < 0.3, `${z}`);
});

test('a curve over the side view is a target, and a stop keeps the best painting', async (t) => {
  const { address } = await startStudio(t, strip());
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=design]');
  await page.click('#draw-curve');
  const view = await page.locator('#side-view').boundingBox();
  const at = (x, y) => [view.x + x * view.width, view.y + y * view.height];
  await page.mouse.move(...at(0.13, 0.5));
  await page.mouse.down();
  for (const [x, y] of [[0.3, 0.5], [0.5, 0.54], [0.7, 0.62], [0.86, 0.74]]) await page.mouse.move(...at(x, y), { steps: 6 });
  await picture(page, '43-curve', 0);
  await page.mouse.up();
  const entry = await page.evaluate(() => window.fretwork.target.value[0]);
  assert.ok(entry.nodes.length > 40);
  assert.ok(entry.wanted.every(([x, y, z]) => x !== null && y === null && z < 0.01));
  assert.ok(Math.min(...entry.wanted.map(([, , z]) => z)) < -0.02);
  await picture(page, '44-curve-target');
  await page.click('#run-design');
  await page.waitForFunction(() => window.fretwork.design.designed.value?.sketch === true);
  await page.click('#stop-design');
  await page.waitForFunction(() => window.fretwork.design.designing.value === null);
  assert.match(await page.textContent('#design-end'), /stopped: this is the best painting so far/);
  assert.match(await page.getAttribute('#undo', 'data-tip'), /design/);
  assert.deepEqual(page.troubles, []);
});
