// SPDX-License-Identifier: GPL-3.0-or-later
// Folders of the server's machine, and the browser's own dialog.

import assert from 'node:assert/strict';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { makeProject, openPage, picture, solved, startStudio } from './studio.mjs';

test('a project is saved to another folder, by keys alone', async (t) => {
  const project = makeProject('40mm');
  const folder = dirname(project);
  mkdirSync(join(folder, 'chairs'));
  writeFileSync(join(folder, 'notes.txt'), 'no project');
  const { address } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);
  await page.keyboard.press('Control+Shift+S');
  await page.waitForSelector('#save-as-path:focus');
  await page.waitForSelector('[data-kind=file]');
  assert.equal(await page.textContent('#folder-path'), folder);
  assert.deepEqual(await page.$$eval('.folder-row', (rows) => rows.map((row) => row.dataset.path)), [join(folder, 'chairs'), project]);
  await picture(page, '70-folder', 0);
  for (let i = 0; i < 20 && !(await page.evaluate(() => document.activeElement.dataset.kind === 'folder')); ++i) await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter');
  await page.waitForFunction((path) => document.querySelector('#folder-path').textContent === path, join(folder, 'chairs'));
  await page.focus('#save-as-path');
  await page.fill('#save-as-path', 'first');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value.name === 'first');
  assert.ok(existsSync(join(folder, 'chairs/first.json')));
  assert.deepEqual(page.troubles, []);
});

test('a project is opened from a folder, and a folder that cannot be read says so', async (t) => {
  const project = makeProject('40mm');
  const { address } = await startStudio(t, project);
  const page = await openPage(t, address);
  await solved(page);
  await page.click('.document-name');
  await page.click('#browse');
  await page.waitForSelector('[data-kind=file]');
  await page.click('#folder-up');
  await page.waitForFunction((path) => document.querySelector('#folder-path').textContent === path, dirname(dirname(project)));
  const refused = await page.evaluate(() => window.fretwork.ask('folder', { path: '/nowhere/at/all' }).then(() => null, (error) => error.message));
  assert.match(refused, /not a folder/);
  await page.click(`.folder-row[data-path="${dirname(project)}"]`);
  await page.click(`.folder-row[data-path="${project}"]`);
  assert.equal(await page.inputValue('#save-as-path'), project.split('/').at(-1));
  await page.click('#open-path');
  await page.waitForSelector('.start', { state: 'detached' });
  assert.equal(await page.evaluate(() => window.fretwork.store.documentNow.value.path), project);
  assert.deepEqual(page.troubles, []);
});

test('what the page writes goes by the browser’s dialog where there is one', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.evaluate(() => {
    window.written = [];
    window.showSaveFilePicker = async ({ suggestedName }) => ({
      createWritable: async () => ({ write: async (blob) => window.written.push([suggestedName, blob.size]), close: async () => undefined }),
    });
  });
  await page.click('#export');
  await page.click('[data-export=csv]');
  await page.waitForFunction(() => window.written.length === 1);
  const [[name, bytes]] = await page.evaluate(() => window.written);
  assert.match(name, /\.csv$/);
  assert.ok(bytes > 1000);
});

test('nothing asks by a grey box of the browser', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const dialogs = [];
  page.on('dialog', (dialog) => {
    dialogs.push(dialog.message());
    void dialog.dismiss();
  });
  await page.keyboard.press('Control+Shift+S');
  await page.waitForSelector('.folder-sheet');
  await page.keyboard.press('Escape');
  await page.waitForSelector('.folder-sheet', { state: 'detached' });
  assert.deepEqual(dialogs, []);
});
