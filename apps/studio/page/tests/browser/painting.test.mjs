// SPDX-License-Identifier: GPL-3.0-or-later
// Chance, gradients and pictures paint as `fretwork paint` does.

import assert from 'node:assert/strict';
import { copyFileSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { drag, edit, fretwork, makeProject, openPage, picture, read, solved, startStudio, tilePlace } from './studio.mjs';

const PATTERNS = '0-1+1-6,2-4+4-6,0-5+5-6';

async function openPainted(t) {
  const project = makeProject('26mm');
  fretwork('paint', project, '--patterns', 'random:5', '--palette', PATTERNS);
  const { address, place } = await startStudio(t, project);
  const page = await openPage(t, address);
  await page.waitForSelector('[data-pattern]');
  return { page, place, project };
}

/** The pattern of each tile. */
async function painted(page) {
  const palette = await read(page, 'palette');
  return (await read(page, 'painting')).map((index) => palette[index]);
}

/** The palette as chance and gradients take it: from soft to stiff. */
const softToStiff = (page) =>
  page.evaluate(() => {
    const { documentNow, patternTable } = window.fretwork.store;
    const stiffness = new Map(patternTable.value.patterns.map(({ id, bending }) => [id, bending.young]));
    return [...documentNow.value.palette].sort((a, b) => stiffness.get(a) - stiffness.get(b));
  });

/** The result of the command line for the project. */
function paintedByCommand({ place, project }, ...words) {
  const copy = join(place, 'copy.json');
  copyFileSync(project, copy);
  fretwork('paint', copy, ...words);
  const { patterns, tiles } = JSON.parse(readFileSync(copy, 'utf8')).tessellation;
  return tiles.map(({ pattern }) => patterns[pattern]);
}

/** Save a picture that came as base64, and choose it on the page. */
async function paintByPicture(page, file, content) {
  writeFileSync(file, Buffer.from(content, 'base64'));
  const chooser = page.waitForEvent('filechooser');
  await page.click('text=Image');
  await edit(page, async () => (await chooser).setFiles(file));
}

test('one seed is one painting, on the page and on the command line, and one step of undo', async (t) => {
  const opened = await openPainted(t);
  const { page } = opened;
  const before = await painted(page);
  const palette = (await softToStiff(page)).join(',');
  await edit(page, () => page.click('text=Random'));
  const first = await painted(page);
  assert.deepEqual(first, paintedByCommand(opened, '--patterns', 'random:1', '--palette', palette));
  await picture(page, '24-random');
  await edit(page, () => page.click('text=Random'));
  assert.deepEqual(await painted(page), paintedByCommand(opened, '--patterns', 'random:2', '--palette', palette));
  await edit(page, () => page.keyboard.press('Control+z'));
  assert.deepEqual(await painted(page), first);
  await edit(page, () => page.keyboard.press('Control+z'));
  assert.deepEqual(await painted(page), before);
  assert.deepEqual(page.troubles, []);
});

test('a gradient goes from the softest pattern to the stiffest along the line that is drawn', async (t) => {
  const { page } = await openPainted(t);
  const palette = await softToStiff(page);
  const places = [];
  for (let tile = 0; tile < (await read(page, 'tiles')).length; ++tile) places.push(await tilePlace(page, tile));
  const [left, right] = [Math.min(...places.map(([x]) => x)), Math.max(...places.map(([x]) => x))];
  const [from, to] = [left + 0.3 * (right - left), left + 0.7 * (right - left)];
  await page.keyboard.press('d');
  await edit(page, () => drag(page, [from, places[0][1]], [to, places[0][1]]));
  const list = await painted(page);
  places.forEach(([x], tile) => {
    const share = (x - from) / (to - from);
    const part = Math.min(Math.max(share * palette.length, 0), palette.length - 1e-9);
    // The pointer has whole pixels.
    if (Math.abs(part - Math.round(part)) * (to - from) > 2 * palette.length || share < 0 || share > 1) assert.equal(list[tile], palette[Math.floor(part)], `tile ${tile} at ${share}`);
  });
  await solved(page);
  await picture(page, '25-gradient');
});

test('a picture paints as on the command line: dark places get the stiffest patterns', async (t) => {
  const opened = await openPainted(t);
  const { page, place } = opened;
  const palette = await softToStiff(page);
  // Black at the left, white at the right.
  const png = await page.evaluate(() => {
    const canvas = Object.assign(document.createElement('canvas'), { width: 20, height: 10 });
    const context = canvas.getContext('2d');
    for (let x = 0; x < 20; ++x) {
      context.fillStyle = `rgb(${12 * x}, ${12 * x}, ${12 * x})`;
      context.fillRect(x, 0, 1, 10);
    }
    return canvas.toDataURL('image/png').split(',')[1];
  });
  const file = join(place, 'ramp.png');
  await paintByPicture(page, file, png);
  const list = await painted(page);
  assert.deepEqual(list, paintedByCommand(opened, '--patterns', `image:${file}`, '--palette', palette.join(',')));
  const xs = await Promise.all(list.map(async (_, tile) => (await tilePlace(page, tile))[0]));
  assert.equal(list[xs.indexOf(Math.min(...xs))], palette.at(-1));
  assert.equal(list[xs.indexOf(Math.max(...xs))], palette[0]);
});

test('a picture that is no PNG paints, too', async (t) => {
  const { page, place } = await openPainted(t);
  const palette = await softToStiff(page);
  const jpeg = await page.evaluate(() => {
    const canvas = Object.assign(document.createElement('canvas'), { width: 600, height: 30 });
    canvas.getContext('2d').fillRect(0, 0, 600, 30);
    return canvas.toDataURL('image/jpeg').split(',')[1];
  });
  await paintByPicture(page, join(place, 'black.jpg'), jpeg);
  assert.deepEqual([...new Set(await painted(page))], [palette.at(-1)]);
});
