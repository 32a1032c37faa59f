// SPDX-License-Identifier: GPL-3.0-or-later
// Files in and out of the page.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { drop, exported, makeProject, openPage, picture, pictures, read, solved, startStudio } from './studio.mjs';

const WIDTH = 10;
const HEIGHT = 6;
const SIDE = 0.03;

/** A flat mesh of triangles, 300 x 180 mm, with its corners counted from `first`. */
function mesh(first) {
  const places = [];
  const triangles = [];
  for (let y = 0; y <= HEIGHT; ++y) for (let x = 0; x <= WIDTH; ++x) places.push([x * SIDE, y * SIDE, 0]);
  for (let y = 0; y < HEIGHT; ++y) {
    for (let x = 0; x < WIDTH; ++x) {
      const at = first + y * (WIDTH + 1) + x;
      triangles.push([at, at + 1, at + WIDTH + 2], [at, at + WIDTH + 2, at + WIDTH + 1]);
    }
  }
  return { places, triangles };
}

function objText() {
  const { places, triangles } = mesh(1);
  return [...places.map((place) => `v ${place.join(' ')}`), ...triangles.map((corners) => `f ${corners.join(' ')}`)].join('\n');
}

function plyText() {
  const { places, triangles } = mesh(0);
  const head = ['ply', 'format ascii 1.0', `element vertex ${places.length}`, 'property float x', 'property float y', 'property float z', `element face ${triangles.length}`,
    'property list uchar int vertex_indices', 'end_header'];
  return [...head, ...places.map((place) => place.join(' ')), ...triangles.map((corners) => `3 ${corners.join(' ')}`), ''].join('\n');
}

function dxfText() {
  const corners = [[0, 0], [300, 0], [300, 120], [180, 180], [0, 180]];
  const head = [0, 'SECTION', 2, 'HEADER', 9, '$INSUNITS', 70, 4, 0, 'ENDSEC', 0, 'SECTION', 2, 'ENTITIES', 0, 'LWPOLYLINE', 8, 0, 90, corners.length, 70, 1];
  return [...head, ...corners.flatMap(([x, y]) => [10, x, 20, y]), 0, 'ENDSEC', 0, 'EOF', ''].join('\n');
}

const OUTLINES = {
  'blob.svg': '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" viewBox="0 0 300 200"><ellipse cx="150" cy="100" rx="140" ry="90"/></svg>',
  'plate.dxf': dxfText(),
  'sheet.obj': objText(),
  'sheet.ply': plyText(),
};

test('outlines of each kind are dropped and become tiles', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  for (const [name, text] of Object.entries(OUTLINES)) {
    await drop(page, name, text);
    await page.waitForSelector(`text=${name}`);
    const before = await page.evaluate(() => window.fretwork.store.revision.value);
    await page.click('#make');
    if (before > 0) await page.click('#unsaved-discard');
    await page.waitForFunction((old) => window.fretwork.store.revision.value > old, before);
    assert.ok((await read(page, 'tiles')).length > 20, `${name} is covered with tiles`);
  }
  assert.deepEqual(page.troubles, []);
});

test('faces of a dropped mesh become tiles where that is chosen', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  await drop(page, 'two.obj', 'v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n');
  await page.check('label:has-text("Use its faces as tiles") input');
  assert.equal(await page.locator('#tile-size').count(), 0, 'the faces have their own sides');
  await page.click('#make');
  await page.waitForFunction(() => window.fretwork.store.revision.value > 0);
  assert.equal((await read(page, 'tiles')).length, 2);
  assert.deepEqual(page.troubles, []);
});

const TWO_PARTS = '<svg xmlns="http://www.w3.org/2000/svg" width="600mm" height="300mm" viewBox="0 0 600 300"><rect width="200" height="100"/><rect x="300" width="300" height="300"/></svg>';

test('of a drawing with several parts one is chosen, or all are', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  const isWide = (width) => page.waitForFunction((wanted) => document.querySelector('#outline-width')?.value === wanted, width);
  await drop(page, 'two.svg', TWO_PARTS);
  await isWide('300');
  assert.match(await page.textContent('#outline-part'), /the largest, 300\smm × 300\smm.*200\smm × 100(\.0)?\smm.*all 2/);
  await page.selectOption('#outline-part', 'all');
  await isWide('600');
  await page.selectOption('#outline-part', '2');
  await isWide('200');
  await page.fill('#tile-size', '20');
  await page.press('#tile-size', 'Enter');
  await page.click('#make');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value?.name === 'two');
  const places = await read(page, 'vertices');
  const xs = places.map(([x]) => x);
  assert.ok(Math.abs(Math.max(...xs) - Math.min(...xs) - 0.2) < 1e-6);
  assert.deepEqual(page.troubles, []);
});

test('a drawing of one part gives no choice', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  await drop(page, 'one.svg', '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" viewBox="0 0 200 200"><rect width="200" height="200"/></svg>');
  await page.waitForSelector('.outline-preview');
  assert.equal(await page.locator('#outline-part').count(), 0);
});

test('an icon of four millimetres is shown, and becomes a surface of a useful size', async (t) => {
  const { address } = await startStudio(t);
  const page = await openPage(t, address);
  await drop(page, 'icon.svg', '<svg xmlns="http://www.w3.org/2000/svg" width="16" height="16" viewBox="0 0 16 16"><path d="M8 1L10 6L15 6L11 9L13 15L8 11L3 15L5 9L1 6L6 6Z"/></svg>');
  await page.waitForSelector('.outline-preview');
  assert.match(await page.inputValue('#outline-width'), /^300$/);
  await picture(page, '14-outline', 0);
  await page.click('#make');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value);
  const tiles = (await read(page, 'tiles')).length;
  assert.ok(tiles > 30 && tiles < 300, `${tiles} tiles`);
  assert.equal(await read(page, 'name'), 'icon');
});

/** The first bytes of each kind of file. */
const BEGINNINGS = { json: /^\{/, html: /^<!doctype html/i, svg: /<svg/, 'picture-svg': /<svg/, glb: /^glTF/, dxf: /SECTION/, stl: /^[^]{84}/, '3mf': /^PK/, obj: /^(#|v )/m, ply: /^ply/, vtu: /<VTKFile/, txt: /^Facts/, csv: /,/ };

test('every kind of file is exported', async (t) => {
  const { address, place } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('#export');
  const endings = await page.$$eval('[data-export]', (buttons) => buttons.map((button) => button.dataset.export));
  await page.keyboard.press('Escape');
  for (const ending of endings) {
    if (ending === 'png') continue;
    const file = await exported(page, ending, place);
    assert.match(readFileSync(file, 'latin1').slice(0, 4000), BEGINNINGS[ending], ending);
  }
});

test('what is cut has the frame and the kerf that are written in the menu', async (t) => {
  const { address, place } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const widths = [];
  for (const frame of ['', '12']) {
    await page.click('#export');
    await page.click('.making summary');
    await page.fill('[data-making=frame]', frame);
    if (frame) await page.screenshot({ path: join(pictures, '23-making.png') });
    await page.keyboard.press('Escape');
    const text = readFileSync(await exported(page, 'dxf', place), 'latin1');
    const xs = [...text.matchAll(/\n *10\r?\n([-\d.e]+)/g)].map(([, x]) => Number(x));
    widths.push(Math.max(...xs) - Math.min(...xs));
  }
  assert.ok(widths[1] > widths[0] + 2, widths.join(' '));
  await page.click('#export');
  await page.click('.making summary');
  await page.fill('[data-making=kerf]', 'wide');
  await page.click('[data-export=dxf]');
  await page.waitForFunction(() => /kerf/.test(document.querySelector('.notes')?.textContent ?? ''));
});

test('a fillet that does not fit is reported beside the file', async (t) => {
  const { address, place } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.click('#export');
  await page.click('.making summary');
  await page.fill('[data-making=fillet]', '9');
  await page.keyboard.press('Escape');
  const text = readFileSync(await exported(page, 'dxf', place), 'latin1');
  assert.match(text, BEGINNINGS.dxf);
  await page.waitForFunction(() => /The fillet of 9 mm does not fit/.test(document.querySelector('.notes')?.textContent ?? ''));
});

test('the exported page shows supports and loads, and needs nothing else', async (t) => {
  const { address, place } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const file = await exported(page, 'html', place);
  await page.goto(`file://${file}`);
  const shown = await page.evaluate(() => {
    const { loads, supports } = JSON.parse(document.getElementById('data').textContent);
    return { loads: loads.length, supports: supports.length };
  });
  assert.ok(shown.loads > 0 && shown.supports > 0, JSON.stringify(shown));
  await page.waitForTimeout(1500);
  await picture(page, '21-view-page', 0);
  assert.deepEqual(page.troubles, []);
});

test('a picture has a transparent ground and a surface on it', async (t) => {
  const { address, place } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const file = await exported(page, 'png', place);
  const alpha = await page.evaluate(async (text) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${text}`)).blob());
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    let solid = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] === 255) ++solid;
    return { corner: data[3], solid: solid / (data.length / 4) };
  }, readFileSync(file).toString('base64'));
  assert.equal(alpha.corner, 0);
  assert.ok(alpha.solid > 0.005, `${alpha.solid} of the picture is solid`);
});
