// SPDX-License-Identifier: GPL-3.0-or-later
// Supports and loads that were put on a side, in a box or in a circle stay that.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { drag, edit, fretwork, largest, makeProject, openPage, picture, read, repository, solved, startStudio } from './studio.mjs';

/** The load case of a file on tiles of another size, solved by the command line: its displacements. */
function onOtherTiles(place, loadCase) {
  const [project, file, result] = ['other.json', 'case.json', 'result.json'].map((name) => join(place, name));
  fretwork('tile', join(repository, 'experiments/outlines/example_a.svg'), '--edge-length', '30mm', '--patterns', '0-1+1-6', '--out', project);
  writeFileSync(file, JSON.stringify({ format: 'fretwork/load-case/3', ...loadCase }));
  fretwork('case', 'add', project, file);
  fretwork('simulate', project, '--case', loadCase.name, '--model', 'corotational', '--out', result);
  return JSON.parse(readFileSync(result, 'utf8')).displacements;
}

for (const theme of ['light', 'dark']) {
  test(`sides and boxes are shown, undone and saved as such, in ${theme}`, async (t) => {
    const project = makeProject('40mm');
    const { address, place } = await startStudio(t, project);
    const page = await openPage(t, address, { theme });
    await solved(page);
    const before = (await read(page, 'load_cases'))[0];

    await page.click('[data-value=hold]');
    await page.click('#choose-left');
    assert.match(await page.textContent('#kept-as'), /^Saved by place: left side, \d+.nodes\.$/);
    await picture(page, `23-by-place-${theme}`, 1);
    await edit(page, () => page.click('#hold-fixed'));
    const supports = (await read(page, 'load_cases'))[0].supports;
    assert.deepEqual(supports.at(-1).side, 'left');
    assert.equal(supports.at(-1).nodes, undefined);

    await page.click('[data-value=load]');
    const view = await page.locator('#plane').boundingBox();
    await drag(page, [view.x + 0.55 * view.width, view.y + 0.2 * view.height], [view.x + 0.8 * view.width, view.y + 0.8 * view.height]);
    assert.match(await page.textContent('#kept-as'), /in a box, \d+.nodes/);
    const chosen = Number((await page.textContent('#nodes-chosen')).match(/\d+/)[0]);
    await edit(page, () => page.click('#add-force'));
    const after = (await read(page, 'load_cases'))[0];
    const index = after.loads.length - 1;
    assert.equal(after.loads[index].box.length, 4);
    assert.equal(after.marks.loads[index].nodes.length, chosen, 'the program finds the nodes that were shown');

    await edit(page, () => page.click('#undo'));
    await edit(page, () => page.click('#undo'));
    assert.deepEqual((await read(page, 'load_cases'))[0].supports, before.supports);
    await edit(page, () => page.keyboard.press('Control+Shift+z'));
    await edit(page, () => page.keyboard.press('Control+Shift+z'));
    await edit(page, () => page.keyboard.press('Control+s'));
    const saved = JSON.parse(readFileSync(project, 'utf8')).load_cases[0];
    assert.deepEqual(saved.supports.at(-1), { side: 'left', fixed: ['ux', 'uy', 'uz', 'rx', 'ry', 'rz'] });
    assert.deepEqual(saved.loads[index].box, after.loads[index].box);
    const moved = onOtherTiles(place, saved);
    assert.ok(moved.some((row) => Math.abs(row[2]) > 0), 'it acts on other tiles, too');
    assert.deepEqual(page.troubles, []);
  });
}

test('a circle that is dragged from its middle is shown, saved and found again as such', async (t) => {
  const project = makeProject('40mm');
  const { address } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=load]');
  await page.keyboard.press('k');
  const view = await page.locator('#plane').boundingBox();
  const middle = [view.x + 0.5 * view.width, view.y + 0.5 * view.height];
  await drag(page, middle, [middle[0] + 0.2 * Math.min(view.width, view.height), middle[1]]);
  assert.match(await page.textContent('#kept-as'), /in a circle, \d+.nodes?/);
  const chosen = Number((await page.textContent('#nodes-chosen')).match(/\d+/)[0]);
  assert.ok(chosen > 0);
  await edit(page, () => page.click('#add-force'));
  const after = (await read(page, 'load_cases'))[0];
  assert.ok(after.loads.at(-1).circle.radius > 0);
  assert.equal(after.marks.loads.at(-1).nodes.length, chosen, 'the program finds the nodes that were shown');
  await edit(page, () => page.keyboard.press('Control+s'));
  const saved = JSON.parse(readFileSync(project, 'utf8')).load_cases[0];
  assert.equal(saved.format, 'fretwork/load-case/4');
  assert.deepEqual(saved.loads.at(-1).circle, after.loads.at(-1).circle);
  await page.click('[data-value=paint]');
  await page.keyboard.press('k');
  await drag(page, middle, [middle[0] + 0.2 * Math.min(view.width, view.height), middle[1]]);
  assert.match(await page.textContent('#tiles-chosen'), /tiles? selected/);
  assert.deepEqual(page.troubles, []);
});

test('nodes that were picked one by one are saved by number, and the page says so', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=load]');
  await page.click('#choose-middle');
  assert.equal(await page.textContent('#kept-as'), 'Saved by node number.');
  await edit(page, () => page.click('#add-force'));
  const load = (await read(page, 'load_cases'))[0].loads.at(-1);
  assert.ok(load.nodes.length > 0);
});

test('a bar height that slides bends the surface less or more, and is one step of undo', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const section = async () => (await read(page, 'setting')).section;
  const [atFirst, sectionAtFirst] = [await largest(page), await section()];
  await page.click('[data-value=look]');
  const slider = page.locator('#bar-height');
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  await edit(page, () => drag(page, [box.x + 0.2 * box.width, box.y + box.height / 2], [box.x + 0.6 * box.width, box.y + box.height / 2]));
  await page.waitForFunction((before) => window.fretwork.store.live.value.info.largest_displacement < before / 2, atFirst);
  assert.ok((await section()).I2 > sectionAtFirst.I2);
  await picture(page, '24-bar-height', 1);
  await page.waitForTimeout(1200);
  await edit(page, () => page.click('#undo'));
  assert.deepEqual(await section(), sectionAtFirst);
  assert.deepEqual(page.troubles, []);
});
