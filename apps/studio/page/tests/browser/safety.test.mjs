// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is lost, and nothing is shown that is not so.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { drag, drop, edit, fretwork, makeProject, openPage, picture, read, solved, startStudio, startStudioIn } from './studio.mjs';

const SQUARE = '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" viewBox="0 0 200 200"><path d="M0 0H200V200H0Z"/></svg>';
/** Written within half a second of an edit. */
const KEPT_MS = 900;

async function makeSquare(page, name = 'square.svg') {
  await drop(page, name, SQUARE);
  await page.waitForSelector('.outline-preview');
  await page.click('#make');
}
async function saveAs(page, path) {
  await page.waitForSelector('#save-as-path:focus');
  await page.fill('#save-as-path', path);
  await page.press('#save-as-path', 'Enter');
}
const undoLabel = async (page) => (await read(page, 'history')).undo;
const hasDocument = (page, name) => page.waitForFunction((wanted) => window.fretwork.store.documentNow.value?.name === wanted, name);
const paintFirst = (page, pattern = '0-5+5-6') => edit(page, () => page.evaluate((id) => window.fretwork.ask('paint', { tiles: [0], pattern: id }), pattern));

test('after a crash every surface that was not saved is offered, opened, or dropped', async (t) => {
  const project = makeProject('40mm');
  const first = await startStudio(t, project);
  const page = await openPage(t, first.address);
  await solved(page);
  await paintFirst(page);
  await page.waitForTimeout(KEPT_MS);
  await makeSquare(page);
  assert.match(await page.textContent('[role=alertdialog]'), /surface/);
  await page.click('#unsaved-stay');
  assert.equal(await read(page, 'name'), 'surface');
  // Another page does not ask: what it replaces stays recoverable.
  await page.evaluate((text) => window.fretwork.ask('new', { outline: { name: 'square.svg', text_base64: btoa(text) }, tile_size: 0.026 }), SQUARE);
  await hasDocument(page, 'square');
  await page.waitForTimeout(KEPT_MS);
  await first.kill();

  const { address } = await startStudioIn(t, first.place);
  const again = await openPage(t, address);
  await again.waitForSelector('.recover');
  assert.deepEqual((await again.$$eval('.recover b', (names) => names.map((name) => name.textContent))).sort(), ['square', 'surface']);
  assert.match(await again.textContent('.recoverable'), /tiles, today/);
  await picture(again, '17-recover', 0);
  await again.click('[data-tip="Delete square for good"], [aria-label="Delete square for good"]');
  await again.waitForFunction(() => document.querySelectorAll('.recover').length === 1);
  await again.click('.recover');
  await hasDocument(again, 'surface');
  await solved(again);
  assert.equal(await undoLabel(again), 'changes that were not saved');
  await edit(again, () => again.click('#undo'));
  assert.equal(await read(again, 'saved'), true);
});

test('before an unsaved surface is replaced, it is asked about', async (t) => {
  const { address, place } = await startStudio(t);
  const page = await openPage(t, address);
  await page.click('[data-example=bridge]');
  await solved(page);
  await page.click('.document-name');
  await page.click('[data-example=leaf]');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value?.name.includes('eaf'));
  await solved(page);
  await paintFirst(page);
  const name = await read(page, 'name');

  await page.click('.document-name');
  await page.click('[data-example=dome]');
  await page.waitForSelector('#unsaved-save:focus');
  await picture(page, '18-unsaved', 0);
  await page.keyboard.press('Escape');
  await page.waitForSelector('[role=alertdialog]', { state: 'detached' });
  assert.equal(await read(page, 'name'), name);

  const path = join(place, 'kept.json');
  await page.click('[data-example=dome]');
  await page.click('#unsaved-save');
  await saveAs(page, path);
  await page.waitForFunction((old) => window.fretwork.store.documentNow.value.name !== old && window.fretwork.store.documentNow.value.name !== 'kept', name);
  await page.evaluate((file) => window.fretwork.ask('open', { path: file }), path);
  await hasDocument(page, 'kept');

  await solved(page);
  await paintFirst(page, '0-1+1-3+1-6');
  const asked = page.waitForEvent('dialog');
  await page.evaluate(() => void setTimeout(() => location.reload(), 50));
  const dialog = await asked;
  assert.equal(dialog.type(), 'beforeunload');
  await dialog.dismiss();
});

test('a file that another program has changed is replaced only by who wants that', async (t) => {
  const project = makeProject('40mm');
  const { address, place } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);
  const cases = () => JSON.parse(readFileSync(project, 'utf8')).load_cases.length;
  const changedElsewhere = () => {
    const before = cases();
    const load = join(place, `case${before}.json`);
    writeFileSync(load, JSON.stringify({ format: 'fretwork/load-case/1', name: `elsewhere ${before}`, supports: [{ side: 'left', fixed: ['ux', 'uy', 'uz', 'rx', 'ry', 'rz'] }], gravity: [0, 0, -1] }));
    fretwork('case', 'add', project, load);
    assert.equal(cases(), before + 1);
  };
  const save = async (choice) => {
    await page.click('#save');
    await page.waitForSelector('#conflict-elsewhere:focus');
    assert.match(await page.textContent('#conflict-title'), /changed elsewhere/);
    await picture(page, `18-conflict-${choice}`, 0);
    await page.click(`#conflict-${choice}`);
    await page.waitForSelector('[role=alertdialog]', { state: 'detached' });
  };

  await paintFirst(page);
  changedElsewhere();
  const theirs = readFileSync(project, 'utf8');
  await save('stay');
  assert.equal(readFileSync(project, 'utf8'), theirs);
  assert.equal(await read(page, 'saved'), false);

  const elsewhere = join(place, 'mine.json');
  await save('elsewhere');
  await saveAs(page, elsewhere);
  await hasDocument(page, 'mine');
  assert.equal(readFileSync(project, 'utf8'), theirs);

  await page.evaluate((path) => window.fretwork.ask('open', { path, discard: true }), project);
  await hasDocument(page, 'surface');
  await solved(page);
  await paintFirst(page);
  changedElsewhere();
  const wanted = cases();
  await save('theirs');
  await page.waitForFunction((count) => window.fretwork.store.documentNow.value.load_cases.length === count, wanted);
  await solved(page);

  await paintFirst(page, '0-1+1-3+1-6');
  changedElsewhere();
  await save('mine');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value.saved);
  assert.equal(cases(), wanted, 'what was written elsewhere is gone, as was wanted');
});

test('an address of an earlier run says so, and is not tried again', async (t) => {
  const project = makeProject('40mm');
  const first = await startStudio(t, project);
  const page = await openPage(t, first.address);
  await solved(page);
  const port = new URL(first.address).port;
  await first.kill();
  await page.waitForSelector('.lost');
  const [bar, notice] = await Promise.all(['.top-bar', '.lost'].map((one) => page.locator(one).boundingBox()));
  assert.ok(notice.y + notice.height <= bar.y + 1, 'the notice stands above the bar and covers nothing');
  await startStudioIn(t, first.place, '--port', port, project);
  await page.waitForSelector('text=earlier session');
  let tries = 0;
  page.on('websocket', () => ++tries);
  await page.waitForTimeout(5000);
  assert.equal(tries, 0);
});

/** The load case with other supports or loads, sent as it is. */
const change = (page, part) =>
  edit(page, () => page.evaluate((more) => {
    const now = window.fretwork.store.documentNow.value;
    return window.fretwork.ask('set_load_case', { index: 0, load_case: { ...now.load_cases[0], ...more } });
  }, part));

test('what is not the answer is not drawn as if it was', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.waitForSelector('.legend-title');
  const supports = (await read(page, 'load_cases'))[0].supports;
  const isAtRest = () => page.evaluate(() => window.fretwork.scene.value.main.factor === 0);
  assert.equal(await isAtRest(), false);

  await change(page, { supports: [{ side: 'left', fixed: ['uz'] }] });
  await page.waitForSelector('.next-step.trouble');
  assert.match(await page.textContent('.next-step'), /not held firmly/);
  assert.equal(await page.locator('.legend-title').count(), 0);
  assert.equal(await isAtRest(), true);
  await picture(page, '19-not-held');

  await change(page, { supports, loads: [{ box: [0.3, -10, 0.42, 10], force: [0, 0, -1e6], amount: 'total' }] });
  await page.waitForSelector('text=The shape shown is not a result');
  assert.equal(await page.locator('.legend-title').count(), 0);
  assert.equal(await isAtRest(), true);

  await edit(page, () => page.click('#undo'));
  await edit(page, () => page.click('#undo'));
  await page.waitForSelector('.legend-title');
  await page.waitForSelector('.next-step', { state: 'detached' });
  assert.equal(await isAtRest(), false);
});

test('while a load is dragged, its first positions come before the answer', async (t) => {
  const { address } = await startStudio(t, makeProject('26mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=load]');
  await page.evaluate(() => {
    window.seen = [];
    window.fretwork.store.live.subscribe((live) => live && window.seen.push([live.info.revision, live.info.provisional === true, window.fretwork.store.notTheAnswer.value]));
  });
  const [tip] = await page.evaluate(() => window.fretwork.scene.value.handlePlaces());
  const box = await page.locator('.space canvas').boundingBox();
  await drag(page, [box.x + tip[0], box.y + tip[1]], [box.x + tip[0], box.y + tip[1] + 40]);
  await page.waitForFunction(() => window.seen.length > 2 && !window.seen.at(-1)[1]);
  const seen = await page.evaluate(() => window.seen);
  const first = seen.findIndex(([, isProvisional]) => isProvisional);
  assert.ok(first >= 0, JSON.stringify(seen));
  const [revision] = seen[first];
  assert.ok(seen.slice(first + 1).some(([of, isProvisional]) => of >= revision && !isProvisional), 'the answer follows');
  assert.ok(seen.every(([, , why]) => why === null), 'what is on its way is not called wrong');
});

test('a bar that is pointed at tells what it bears', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=look]');
  const box = await page.locator('.space canvas').boundingBox();
  const places = await page.evaluate(() => [3, 40, 80, 120].map((bar) => window.fretwork.barPlace(bar)));
  await page.mouse.click(box.x + places[1][0], box.y + places[1][1]);
  await page.waitForSelector('[data-bar] [data-field=stress]');
  const values = await page.$$eval('[data-bar] [data-field]', (cells) => cells.map((cell) => [cell.dataset.field, Number(cell.dataset.value)]));
  assert.equal(values.length, 16, 'six section forces and two stresses at both ends');
  assert.ok(values.every(([, value]) => Number.isFinite(value)));
  await picture(page, '22-bar', 1);
  await page.keyboard.press('Escape');
  await page.waitForSelector('[data-bar]', { state: 'detached' });
});

test('a mode has a legend without a size', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=look]');
  await page.click('text=Modes');
  await page.waitForSelector('.play-bar');
  await page.waitForSelector('text=Mode shape (normalized)');
  assert.doesNotMatch(await page.textContent('.legend-ends'), /mm/);
  await picture(page, '20-mode', 1);
});

test('models that cannot be used say why, and the share of a mixed one is chosen', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('[data-value=look]');
  for (const model of ['paper6', 'ring10']) {
    assert.ok(await page.isDisabled(`[data-model=${model}]`), model);
    assert.match(await page.textContent(`[data-model=${model}]`), /Requires calibrated patterns/);
  }
  const chosen = await read(page, 'model');
  await page.click(`[data-model=${chosen}]`);
  await page.click('[data-model=mixed]');
  await page.waitForFunction(() => window.fretwork.store.live.value?.info.model === 'mixed:0.1');
  assert.equal((await read(page, 'history')).undo, 'model mixed:0.1');
  await page.fill('#mixed-share', '25');
  await page.press('#mixed-share', 'Enter');
  await page.waitForFunction(() => window.fretwork.store.live.value?.info.model === 'mixed:0.25');
  await edit(page, () => page.click('#undo'));
  await edit(page, () => page.click('#undo'));
  assert.equal(await undoLabel(page), null, 'to choose the model that is chosen is no step');
});

test('invalid sizes are reported in the units of the page, and kept', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  await drop(page, 'square.svg', SQUARE);
  await page.waitForSelector('.outline-preview');
  for (const [text, words] of [['0.2', /At least 1\smm/], ['wide', /Not a number in mm/]]) {
    await page.fill('#tile-size', text);
    await page.press('#tile-size', 'Tab');
    assert.match(await page.textContent('.number-advice'), words);
    assert.equal(await page.inputValue('#tile-size'), text);
    await page.waitForSelector('#make:disabled');
  }
  await page.fill('#tile-size', '9000');
  await page.press('#tile-size', 'Enter');
  assert.match(await page.textContent('#size-advice'), /large for this surface.*mm/);
  await page.click('#make');
  await page.waitForSelector('#start-trouble');
  await page.fill('#tile-size', '30');
  await page.press('#tile-size', 'Enter');
  await page.click('#make');
  await hasDocument(page, 'square');
});

test('changes to a drawing are shown', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  await drop(page, 'bow.svg', '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" viewBox="0 0 300 200"><path d="M10 10L290 190L290 10L10 190Z"/></svg>');
  await page.waitForSelector('.remark');
  assert.match(await page.textContent('.remark'), /part 1 of 2/);
  await page.click('#make');
  await page.waitForSelector('.note.warning');
  assert.match(await page.textContent('.note.warning'), /part 1 of 2/);
});
