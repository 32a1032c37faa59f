// SPDX-License-Identifier: GPL-3.0-or-later
// The strength of the material, from the page to the command line.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { edit, fretwork, makeProject, openPage, picture, read, solved, startStudio } from './studio.mjs';

const STRENGTH = '[aria-label="Material strength, in MPa"]';
const strengthOf = async (page) => (await read(page, 'setting')).material.strength;

/** The largest share of the strength that the command line tells. */
function worstByCommand(project, result, model) {
  fretwork('simulate', project, '--case', 'bridge', '--model', model, '--out', result);
  return Math.max(...JSON.parse(fretwork('beams', project, result, '--json')).beams.map(({ utilization }) => utilization));
}

test('a strength is typed, shown as utilization, undone, saved, and read by the command line', async (t) => {
  const project = makeProject('40mm');
  const { address, place } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);
  await page.selectOption('#field', 'utilization');
  await page.waitForSelector('#lacks-strength');
  await picture(page, '27-no-strength');
  await page.click('[data-value=look]');
  assert.equal(await page.inputValue(STRENGTH), '');
  await page.fill(STRENGTH, '40');
  await edit(page, () => page.press(STRENGTH, 'Enter'));
  assert.equal(await strengthOf(page), 40e6);
  await page.waitForFunction(() => document.querySelector('.legend-title')?.textContent === 'Utilization' && document.querySelector('.legend-ends'));
  await page.locator(STRENGTH).scrollIntoViewIfNeeded();
  await picture(page, '26-utilization');

  await page.click('#save');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value.saved);
  const worst = worstByCommand(project, join(place, 'result.json'), await read(page, 'model'));
  const shown = parseFloat((await page.textContent('.legend-ends span:last-child')).replace('≥', ''));
  assert.ok(Math.abs(shown / 100 - worst) < 0.005 * worst, `${shown} % on the page, ${100 * worst} % on the command line`);

  for (const [text, advice] of [['strong', /Not a number/], ['-3', /At least/]]) {
    await page.fill(STRENGTH, text);
    await page.press(STRENGTH, 'Enter');
    assert.match(await page.textContent('.number-advice'), advice);
    assert.equal(await strengthOf(page), 40e6);
  }
  await page.press(STRENGTH, 'Escape');
  assert.equal(await page.inputValue(STRENGTH), '40');
  await page.fill(STRENGTH, '');
  await edit(page, () => page.press(STRENGTH, 'Enter'));
  assert.equal(await strengthOf(page), undefined);
  await page.waitForSelector('#lacks-strength');
  await edit(page, () => page.click('#undo'));
  assert.equal(await strengthOf(page), 40e6);
  assert.deepEqual(page.troubles, []);
});
