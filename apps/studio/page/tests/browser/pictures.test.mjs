// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures, videos and moving files from the studio; parallel views; colours of tiles.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { exported, largest, makeProject, openPage, picture, pictures, saved, solved, startStudio } from './studio.mjs';

for (const theme of ['light', 'dark']) {
  test(`a picture has title, legend and scale, and no empty ground, ${theme}`, async (t) => {
    const { address } = await startStudio(t, makeProject('40mm'));
    const page = await openPage(t, address, { theme });
    await solved(page);
    await page.click('#parallel');
    const svg = readFileSync(await exported(page, 'picture-svg', pictures, `60-picture-${theme}.svg`), 'utf8');
    const info = await page.evaluate(() => ({ name: window.fretwork.store.documentNow.value.name, bars: window.fretwork.store.beams.value.beams }));
    for (const words of [info.name, 'Displacement', 'linearGradient', '\u202fmm<']) assert.ok(svg.includes(words), words);
    assert.ok(svg.split('<path').length > 4 * info.bars, 'every bar is there');
    const png = await exported(page, 'png', pictures, `61-picture-${theme}.png`);
    const seen = await page.evaluate(async (base64) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
      const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      const filled = (from, to) => {
        let count = 0;
        for (let y = Math.floor(from * image.height); y < to * image.height; ++y) for (let x = 0; x < image.width; ++x) count += data[4 * (y * image.width + x) + 3] > 20 ? 1 : 0;
        return count;
      };
      const rows = Array.from({ length: image.height }, (_, y) => data.subarray(4 * y * image.width, 4 * (y + 1) * image.width).some((value, i) => i % 4 === 3 && value > 20));
      return { width: image.width, height: image.height, head: filled(0, 0.12), whole: filled(0, 1), rows: rows.filter(Boolean).length };
    }, readFileSync(png).toString('base64'));
    assert.ok(seen.head > 500, 'the title is there');
    assert.ok(seen.rows > 0.8 * seen.height, `${seen.rows} of ${seen.height} rows have something`);
    await picture(page, `62-parallel-${theme}`);
    assert.deepEqual(page.troubles, []);
  });
}

test('a parallel view keeps what is looked at, and turns back', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const spread = () => page.evaluate(() => {
    const places = window.fretwork.store.documentNow.value.interface_nodes.map((_, node) => window.fretwork.nodePlace(node));
    const xs = places.map(([x]) => x);
    return Math.max(...xs) - Math.min(...xs);
  });
  const before = await spread();
  await page.keyboard.press('9');
  await page.waitForSelector('#parallel[aria-pressed=true]');
  const parallel = await spread();
  assert.ok(Math.abs(parallel / before - 1) < 0.25 && parallel !== before, `${before} ${parallel}`);
  await page.keyboard.press('9');
  await page.waitForSelector('#parallel[aria-pressed=false]');
  assert.ok(Math.abs((await spread()) - before) < 0.5);
});

/** What three.js, which did not write it, reads from a moving file: its last state is the solution. */
async function checkMotion(glb, wanted) {
  globalThis.self ??= globalThis;
  const loaded = await new GLTFLoader().parseAsync(glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.byteLength), '');
  assert.equal(loaded.animations[0].tracks[0].times.length, 31);
  let mesh = null;
  loaded.scene.traverse((one) => (mesh = one.isMesh ? one : mesh));
  const last = mesh.geometry.morphAttributes.position.at(-1);
  let most = 0;
  for (let i = 0; i < last.count; ++i) most = Math.max(most, Math.hypot(last.getX(i), last.getY(i), last.getZ(i)));
  const corner = 2e-3; // m: corners lie half a bar away from nodes, and turn with them
  assert.ok(Math.abs(most - wanted) < corner, `${most} ${wanted}`);
}

test('a load path is saved as a moving file and as a video', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.evaluate(() => window.fretwork.ask('set_model', { model: 'corotational' }));
  await page.evaluate(() => window.fretwork.ask('path', { steps: 5 }));
  await page.waitForFunction(() => window.fretwork.store.shapes.value?.shapes.length === 5);
  const glb = readFileSync(await exported(page, 'glb', pictures, '63-moving.glb'));
  assert.equal(glb.toString('latin1', 0, 4), 'glTF');
  const json = JSON.parse(glb.toString('utf8', 20, 20 + glb.readUInt32LE(12)));
  assert.equal(json.meshes[0].primitives[0].targets.length, 30);
  await checkMotion(glb, await largest(page));
  await page.waitForSelector('#record:not([disabled])');
  const video = readFileSync(await saved(page, () => page.click('#record'), pictures, '64-path.webm'));
  assert.equal(video.readUInt32BE(0), 0x1a45dfa3, 'the first bytes of Matroska');
  assert.ok(video.length > 20_000, `${video.length} bytes`);
  assert.ok(await page.isVisible('.play-bar'));
  assert.deepEqual(page.troubles, []);
});

test('a mode has the legend of a mode alone', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  await page.selectOption('#field', 'uz');
  await page.evaluate(() => window.fretwork.ask('modes', { count: 2 }));
  await page.waitForFunction(() => window.fretwork.store.shapes.value?.shapes.length === 2);
  assert.match(await page.textContent('.legend-title'), /normalized/);
  assert.equal(await page.locator('#legend-edit').count(), 0);
});

for (const theme of ['light', 'dark']) {
  test(`tiles are coloured by pattern and by what patterns are like, ${theme}`, async (t) => {
    const { address } = await startStudio(t, makeProject('40mm'));
    const page = await openPage(t, address, { theme });
    await solved(page);
    await page.evaluate(() => window.fretwork.ask('paint', { patterns: 'random:3', palette: '0-1+1-6=3,0-5+5-6,1-6+3-6' }));
    await page.click('[data-value=plane]');
    await page.selectOption('#tile-colour', 'pattern');
    await page.waitForFunction(() => document.querySelectorAll('.tile-swatches [data-pattern]').length === 3);
    const counts = await page.$$eval('.tile-swatches [data-pattern]', (all) => all.map((one) => Number(one.textContent)));
    assert.equal(counts.reduce((a, b) => a + b), (await page.evaluate(() => window.fretwork.store.documentNow.value.tiles.length)));
    await picture(page, `65-tiles-${theme}`, 0);
    await page.selectOption('#tile-colour', 'bending');
    await page.waitForSelector('.tile-scale .legend-ends');
    assert.match(await page.textContent('.tile-scale .legend-ends'), /N/);
    await picture(page, `66-stiffness-${theme}`, 0);
    assert.deepEqual(page.troubles, []);
  });
}
