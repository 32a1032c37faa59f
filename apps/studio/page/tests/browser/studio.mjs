// SPDX-License-Identifier: GPL-3.0-or-later
// A studio that runs, and a browser that looks at it.

import { execFileSync, spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const here = fileURLToPath(new URL('.', import.meta.url));
export const repository = resolve(here, '../../../../..');
export const program = resolve(process.env.FRETWORK_PROGRAM ?? join(repository, 'build/release/apps/fretwork/fretwork'));
const page = resolve(process.env.FRETWORK_PAGE ?? join(here, '../../dist/index.html'));
export const pictures = join(here, 'out');
const PATIENCE_MS = 180_000;
/** Enough to judge light and shadow by; each takes up to a second without a graphics card. */
const SAMPLES = 5;

for (const file of [program, page]) if (!existsSync(file)) throw new Error(`${file} is not there: build it first, or set FRETWORK_PROGRAM, FRETWORK_PAGE`);
mkdirSync(pictures, { recursive: true });

export const fretwork = (...words) => execFileSync(program, words, { encoding: 'utf8' });
export const folder = () => mkdtempSync(join(tmpdir(), 'fretwork-page-'));

/** Starts `fretwork studio`, and ends it when the test ends. */
export async function startStudio(test, ...words) {
  const place = folder();
  const process = spawn(program, ['studio', '--no-browser', '--page', page, ...words], { cwd: place, stdio: ['ignore', 'pipe', 'inherit'] });
  test.after(() => {
    process.kill();
    rmSync(place, { recursive: true, force: true });
  });
  const address = await new Promise((done, fail) => {
    let text = '';
    process.stdout.on('data', (data) => {
      text += data;
      const found = /http\S+/.exec(text);
      if (found) done(found[0]);
    });
    process.on('exit', (code) => fail(new Error(`fretwork studio ended with ${code}: ${text}`)));
  });
  return { address, place };
}

/** A page. Without a graphics card drawing takes seconds, so the surface in space is drawn for pictures alone. */
export async function openPage(test, address, { width = 1280, height = 800, theme = 'light' } = {}) {
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    // WebGL in software, and the page itself put together without it: else every frame of the page waits for it.
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-gpu-compositing'],
  });
  test.after(() => browser.close());
  const page = await browser.newPage({ viewport: { width, height }, colorScheme: theme });
  page.setDefaultTimeout(PATIENCE_MS);
  await page.addInitScript(() => (window.fretworkPaused = true));
  page.troubles = [];
  page.on('pageerror', (error) => page.troubles.push(error.message));
  page.on('console', (message) => message.type() === 'error' && page.troubles.push(message.text()));
  await page.goto(address);
  await page.waitForFunction(() => window.fretwork?.store.hello.value);
  return page;
}

export const solved = (page) => page.waitForFunction(() => window.fretwork.store.live.value !== null);
export async function picture(page, name) {
  await page.evaluate((samples) => window.fretwork.drawFine(samples), SAMPLES);
  await page.screenshot({ path: join(pictures, `${name}.png`), timeout: PATIENCE_MS });
}
export const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
