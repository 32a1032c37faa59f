// SPDX-License-Identifier: GPL-3.0-or-later
// Loads on areas, and load cases that act together.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { edit, fretwork, makeProject, openPage, picture, read, solved, startStudio } from './studio.mjs';

const answer = (page) => page.evaluate(() => window.fretwork.store.live.value.info);
async function answered(page, action) {
  const before = await page.evaluate(() => window.fretwork.store.answered.value);
  await edit(page, action);
  await page.waitForFunction((old) => window.fretwork.store.answered.value > old, before);
  assert.equal(await page.evaluate(() => window.fretwork.store.problem.value), null);
}
const held = ({ reactions }) => reactions.reduce((sum, { force }) => sum + force[2], 0);

test('what a load on an area adds up to is held by the supports', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=load]');
  const before = held(await answer(page));
  await answered(page, () => page.click('#add-area-load'));
  const [load] = (await read(page, 'load_cases'))[0].loads.filter(({ per_area }) => per_area);
  const area = await page.evaluate(() => {
    const { tiles, vertices } = window.fretwork.store.documentNow.value;
    const twice = tiles.map(({ vertices: corners }) => corners.reduce((sum, corner, i) => {
      const [[x, y], [u, v]] = [vertices[corner], vertices[corners[(i + 1) % corners.length]]];
      return sum + x * v - u * y;
    }, 0));
    return twice.reduce((sum, one) => sum + Math.abs(one) / 2, 0);
  });
  const more = held(await answer(page)) - before;
  // The solver ends where what is left is a ten-millionth of the loads.
  assert.ok(Math.abs(more + load.per_area[2] * area) < 1e-5 * area, `${more} N held, ${-load.per_area[2] * area} N loaded`);
  await picture(page, '15-area-load');
});

test('load cases act together, each times its factor', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=load]');
  const single = held(await answer(page));
  await answered(page, () => page.click('[aria-label="New load case"]')).catch(() => undefined);
  const field = page.getByLabel('Factor of bridge');
  await field.fill('2');
  await answered(page, () => field.press('Enter'));
  assert.deepEqual((await read(page, 'load_cases'))[1].combines, [{ load_case: 'bridge', factor: 2 }]);
  const twice = held(await answer(page));
  assert.ok(Math.abs(twice - 2 * single) < 1e-4 * Math.abs(single), `${twice} N, and ${single} N once`);
  await picture(page, '16-combination');
});

test('a load on a line is shown, edited and kept, with a load on an area beside it', async (t) => {
  const project = makeProject('40mm');
  const file = `${project}.rail.json`;
  const rail = { format: 'fretwork/load-case/3', name: 'rail', supports: [{ side: 'left', fixed: ['ux', 'uy', 'uz', 'rx', 'ry', 'rz'] }], loads: [{ side: 'right', per_length: [0, 0, -0.5] }] };
  writeFileSync(file, JSON.stringify(rail));
  fretwork('case', 'add', project, file);
  const { address } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=load]');
  await answered(page, () => page.selectOption('#load-case', '1'));
  const before = held(await answer(page));
  assert.ok(before > 0);
  assert.match(await page.textContent('.entry-words'), /^0\.500\sN\/m = [0-9.]+\sN, right side, [0-9]+ nodes$/);
  await page.click('.entry-title');
  const field = page.getByLabel('Line along z');
  await field.fill('-1');
  await answered(page, () => field.press('Enter'));
  const after = held(await answer(page));
  assert.ok(Math.abs(after - 2 * before) < 1e-4 * before, `${after} N, and ${before} N before`);
  await answered(page, () => page.click('#add-area-load'));
  await edit(page, () => page.keyboard.press('Control+s'));
  const kept = JSON.parse(readFileSync(project, 'utf8')).load_cases[1];
  assert.deepEqual(kept.loads[0], { side: 'right', per_length: [0, 0, -1] });
  assert.deepEqual(kept.loads[1].per_area, [0, 0, -2]);
  await picture(page, '17-line-load');
});
