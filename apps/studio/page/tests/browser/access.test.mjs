// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of axe-core on the page: contrast, roles, names, headings; in each of its states, light and dark.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { makeProject, openPage, picture, solved, startStudio } from './studio.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

async function findings(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations } = await window.axe.run(document);
    return violations.flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary }) => `${id} at ${target.join(' ')}: ${failureSummary.replace(/\s+/g, ' ')}`));
  });
}

const mode = (name) => async (page) => {
  await page.click(`[data-value=${name}]`);
  await page.waitForSelector(`.side[data-mode=${name}]`);
};
const STATES = {
  paint: mode('paint'),
  hold: mode('hold'),
  load: mode('load'),
  'a load that is open': (page) => page.click('.entry-title'),
  design: mode('design'),
  'a target': async (page) => {
    await page.click('#choose-right');
    await page.click('#set-target');
  },
  'side view': (page) => page.click('#draw-curve'),
  look: mode('look'),
  plane: (page) => page.click('[data-value=plane]'),
  'tiles by pattern': (page) => page.selectOption('#tile-colour', 'pattern'),
  'tiles by stiffness': (page) => page.selectOption('#tile-colour', 'bending'),
  space: (page) => page.click('[data-value=space]'),
  'both views': (page) => page.click('[data-value=both]'),
  export: (page) => page.click('#export'),
  'for cutting': (page) => page.click('.making summary'),
  'after export': (page) => page.keyboard.press('Escape'),
  folders: async (page) => {
    await page.keyboard.press('Control+Shift+S');
    await page.waitForSelector('.folder-row');
  },
  'after folders': (page) => page.keyboard.press('Escape'),
  keys: (page) => page.click('#help'),
  'after keys': (page) => page.keyboard.press('Escape'),
  'other tiles': async (page) => {
    await mode('paint')(page);
    await page.click('#retile');
    await page.fill('#retile-side', '33');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#retile-tiles');
  },
  chart: async (page) => {
    await page.click('#retile-close');
    await page.keyboard.press('c');
  },
  start: (page) => page.click('.document-name'),
  tour: async (page) => {
    await page.click('#take-tour');
    await page.waitForSelector('.tour');
  },
};

for (const theme of ['light', 'dark']) {
  test(`nothing is found against the page, ${theme}`, async (t) => {
    const { address } = await startStudio(t, makeProject('40mm'));
    const page = await openPage(t, address, { theme });
    await solved(page);
    const all = [];
    for (const [name, enter] of Object.entries(STATES)) {
      await enter(page);
      await page.waitForTimeout(300); // what fades in has its own colour then
      for (const finding of await findings(page)) all.push(`${name}: ${finding}`);
      await picture(page, `access-${theme}-${name.replaceAll(' ', '-')}`, 0);
    }
    assert.deepEqual(all, []);
  });

  test(`nothing is found against a page without a document, ${theme}`, async (t) => {
    const { address } = await startStudio(t);
    const page = await openPage(t, address, { theme });
    await page.waitForSelector('.example');
    assert.deepEqual(await findings(page), []);
  });

  test(`nothing is found against the page of layouts, ${theme}`, async (t) => {
    const { address } = await startStudio(t, '--layout', 'paper8');
    const page = await openPage(t, address, { theme });
    await page.waitForSelector('.layout-fans li');
    await page.focus('[data-node="5"]');
    assert.deepEqual(await findings(page), []);
    await page.focus('#layout-name');
    await page.fill('#layout-name', 'no name');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#layout-trouble');
    assert.deepEqual(await findings(page), []);
  });
}
