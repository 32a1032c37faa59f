// SPDX-License-Identifier: GPL-3.0-or-later
// A studio that runs, and a browser that looks at it.

import { execFileSync, spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const here = fileURLToPath(new URL('.', import.meta.url));
export const repository = resolve(process.env.FRETWORK_REPOSITORY ?? join(here, '../../../../..'));
export const program = resolve(process.env.FRETWORK_PROGRAM ?? join(repository, 'build/release/apps/fretwork/fretwork'));
const page = resolve(process.env.FRETWORK_PAGE ?? join(here, '../../dist/index.html'));
export const pictures = resolve(process.env.FRETWORK_PICTURES ?? join(here, 'out'));
const PATIENCE_MS = 180_000;
/** Light and shadow can be judged from 5 on; without a graphics card each takes seconds. */
const SAMPLES = Number(process.env.FRETWORK_PICTURE_SAMPLES ?? 1);

for (const file of [program, page]) if (!existsSync(file)) throw new Error(`${file} is not there: build it first, or set FRETWORK_PROGRAM, FRETWORK_PAGE`);
mkdirSync(pictures, { recursive: true });

export const fretwork = (...words) => execFileSync(program, words, { encoding: 'utf8' });
export const folder = () => mkdtempSync(join(tmpdir(), 'fretwork-page-'));

/** Starts `fretwork studio`, and ends it when the test ends. What it keeps lies in a folder of the test's own. */
export async function startStudio(test, ...words) {
  const place = folder();
  test.after(() => rmSync(place, { recursive: true, force: true }));
  return startStudioIn(test, place, ...words);
}

/** The same where a studio has been before. */
export async function startStudioIn(test, place, ...words) {
  const studio = spawn(program, ['studio', '--no-browser', '--page', page, ...words], {
    cwd: place, stdio: ['ignore', 'pipe', 'inherit'], env: { ...process.env, XDG_STATE_HOME: join(place, 'state') },
  });
  const ended = new Promise((done) => studio.on('exit', done));
  /** As a crash ends it. */
  const kill = () => {
    studio.kill('SIGKILL');
    return ended;
  };
  test.after(kill);
  const address = await new Promise((done, fail) => {
    let text = '';
    studio.stdout.on('data', (data) => {
      text += data;
      const found = /http\S+/.exec(text);
      if (found) done(found[0]);
    });
    studio.on('exit', (code) => fail(new Error(`fretwork studio ended with ${code}: ${text}`)));
  });
  return { address, place, kill };
}

/** A page. Without a graphics card drawing takes seconds, so the surface in space is drawn for pictures alone. */
export async function openPage(test, address, { width = 1280, height = 800, theme = 'light', touch = false } = {}) {
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    // WebGL in software, and the page itself put together without it: else every frame of the page waits for it.
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-gpu-compositing'],
  });
  test.after(() => browser.close());
  const page = await browser.newPage({ viewport: { width, height }, colorScheme: theme, hasTouch: touch });
  page.setDefaultTimeout(PATIENCE_MS);
  await page.addInitScript(() => {
    window.fretworkPaused = true;
    window.showSaveFilePicker = undefined; // a dialog of the system, which nobody answers here
  });
  page.troubles = [];
  page.on('pageerror', (error) => page.troubles.push(error.message));
  page.on('console', (message) => message.type() === 'error' && page.troubles.push(message.text()));
  await page.goto(address);
  await page.waitForFunction(() => window.fretwork?.store.hello.value);
  return page;
}

export const solved = (page) => page.waitForFunction(() => window.fretwork.store.live.value !== null);
export async function picture(page, name, samples = SAMPLES) {
  if (samples > 0) await page.evaluate((count) => window.fretwork.drawFine(count), samples);
  await page.screenshot({ path: join(pictures, `${name}.png`), timeout: PATIENCE_MS });
}

/** The file that the browser stores after an action. It gets the name that the page suggests, or another one. */
export async function saved(page, action, place, name) {
  const coming = page.waitForEvent('download');
  await action();
  const download = await coming.catch(async () => {
    throw new Error(`no file came; the page says: ${await page.textContent('.notes')}`);
  });
  const file = join(place, name ?? download.suggestedFilename());
  await download.saveAs(file);
  return file;
}

/** Exports by the menu. */
export const exported = (page, ending, place, name) => saved(page, async () => {
  await page.click('#export');
  await page.click(`[data-export="${ending}"]`);
}, place, name);

/** The largest displacement of the live model, in metres. */
export const largest = (page) => page.evaluate(() => window.fretwork.store.live.value.info.largest_displacement);
export const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** A surface of the repository's own outline and load case. */
export function makeProject(tileSide) {
  const place = folder();
  const project = join(place, 'surface.json');
  fretwork('tile', join(repository, 'experiments/outlines/example_a.svg'), '--edge-length', tileSide, '--patterns', '0-1+1-6', '--out', project);
  fretwork('case', 'add', project, join(repository, 'experiments/cases/bridge.json'));
  return project;
}

/** Where a tile's middle is on the page. */
export const tilePlace = (page, tile) =>
  page.evaluate((index) => {
    const box = document.getElementById('plane').getBoundingClientRect();
    const at = window.fretwork.planePlace(index);
    return [box.left + at[0], box.top + at[1]];
  }, tile);

/** Drops a file on the page. */
export async function drop(page, name, content, selector = '.app') {
  const transfer = await page.evaluateHandle(
    ([text, file]) => {
      const data = new DataTransfer();
      data.items.add(new File([Uint8Array.from(atob(text), (char) => char.charCodeAt(0))], file));
      return data;
    },
    [Buffer.from(content).toString('base64'), name],
  );
  for (const event of ['dragover', 'drop']) await page.dispatchEvent(selector, event, { dataTransfer: transfer });
}

export async function drag(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { steps: 5 });
  await page.mouse.move(...to, { steps: 5 });
  await page.mouse.up();
}

/** Resolves when the effect of an action on the document has come back. */
export async function edit(page, action) {
  const before = await page.evaluate(() => window.fretwork.store.revision.value);
  await action();
  await page.waitForFunction((old) => window.fretwork.store.revision.value > old, before).catch(async () => {
    throw new Error(`nothing changed after ${action}; the page says: ${await page.textContent('.notes')}`);
  });
}

export const read = (page, what) => page.evaluate((key) => window.fretwork.store.documentNow.value[key], what);
