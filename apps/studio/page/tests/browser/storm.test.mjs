// SPDX-License-Identifier: GPL-3.0-or-later
// Each action of a page followed by each other one, in an order that a seed decides, on two pages and the command line
// that share one file. After each pair: what is shown, what is saved and what is exported is one state.
// FRETWORK_STORM_SECONDS (600 if left out) is how long it lasts, FRETWORK_STORM_SEED (1) where the order starts.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { isDeepStrictEqual } from 'node:util';
import { fretwork, makeProject, openPage, read, solved, startStudio, tilePlace } from './studio.mjs';

const SECONDS = Number(process.env.FRETWORK_STORM_SECONDS ?? 600);
const SEED = Number(process.env.FRETWORK_STORM_SEED ?? 1);
/** An answer that rests is another one by rounding alone: files have all digits. */
const SAME = 1e-12;
const PATIENCE_MS = 30_000;

/** mulberry32: the next number in [0, 1) of a seed. */
function randomFrom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}
const oneOf = (things, random) => things[Math.floor(random() * things.length)];
function shuffled(things, random) {
  const all = [...things];
  for (let i = all.length - 1; i > 0; --i) {
    const j = Math.floor(random() * (i + 1));
    [all[i], all[j]] = [all[j], all[i]];
  }
  return all;
}

/** The project as the studio would save it, once it has answered all that the page has asked before. */
const download = (page) => page.evaluate(() => window.fretwork.ask('download')).then(({ text }) => text);
const go = (page, mode) => page.click(`[data-value=${mode}]`);
const pressIfAble = async (page, button) => (await page.isEnabled(button)) && page.click(button);

/** Saves; where the file was changed elsewhere, one of the two goes. */
async function save(page, { random }) {
  await page.keyboard.press('Control+s');
  await download(page);
  await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => drawn())));
  const question = page.locator('[role=alertdialog]');
  if ((await question.count()) === 0) return;
  await page.click(oneOf(['#conflict-mine', '#conflict-theirs', '#conflict-stay'], random));
  await question.waitFor({ state: 'detached' });
}

/** A load case more in the file, or the same again with another load. */
async function changeFile(_, storm) {
  const loadCase = { format: 'fretwork/load-case/3', name: 'elsewhere', supports: [{ side: 'bottom', fixed: ['ux', 'uy', 'uz', 'rx', 'ry', 'rz'] }], loads: [{ side: 'top', force: [0, 0, -0.01 - 0.01 * storm.random()], amount: 'total' }] };
  const file = join(storm.place, 'case.json');
  writeFileSync(file, JSON.stringify(loadCase));
  fretwork('case', 'add', storm.project, file, '--replace');
}

/** Every row: what a person does, by name. */
const ACTIONS = {
  async paint(page, { random }) {
    await go(page, 'paint');
    await page.keyboard.press('b');
    await page.click(`[data-pattern]:nth-child(${1 + Math.floor(10 * random())})`);
    const tiles = (await read(page, 'tiles')).length;
    await page.mouse.click(...(await tilePlace(page, Math.floor(tiles * random()))));
  },
  async scatter(page) {
    await go(page, 'paint');
    await page.click('.panel-foot >> text=Random');
  },
  undo: (page) => pressIfAble(page, '#undo'),
  redo: (page) => pressIfAble(page, '#redo'),
  async support(page, { random }) {
    await go(page, 'hold');
    await page.click(`#choose-${oneOf(['left', 'right', 'top', 'bottom'], random)}`);
    await page.click(`#hold-${oneOf(['fixed', 'pinned', 'roller'], random)}`);
  },
  async release(page, { random }) {
    await go(page, 'hold');
    await page.click(`#choose-${oneOf(['left', 'right'], random)}`);
    await page.click('.row >> text=Release');
  },
  async force(page, { random }) {
    await go(page, 'load');
    await page.click(`#choose-${oneOf(['top', 'right', 'middle'], random)}`);
    await page.click('#add-force');
  },
  async areaLoad(page) {
    await go(page, 'load');
    await page.click('#add-area-load');
  },
  async weight(page) {
    await go(page, 'load');
    await page.locator('.gravity input[type=checkbox]').first().click();
  },
  async anotherCase(page, { random }) {
    await go(page, 'load');
    const count = (await read(page, 'load_cases')).length;
    await page.selectOption('#load-case', String(Math.floor(count * random())));
  },
  async newCase(page) {
    await go(page, 'load');
    await page.click('[aria-label="New load case"]');
  },
  async model(page, { random }) {
    await go(page, 'look');
    await page.click(`[data-model=${oneOf(['condensed', 'corotational', 'full'], random)}]`);
  },
  async loadFactor(page, { random }) {
    await go(page, 'load');
    const slider = page.locator('#load-factor');
    if ((await slider.count()) === 0) return;
    await slider.focus();
    await page.keyboard.press(oneOf(['ArrowLeft', 'ArrowRight', 'PageDown'], random));
  },
  async retile(page, { random }) {
    await go(page, 'paint');
    await page.click('#retile');
    await page.fill('#retile-side', (55 + 12 * random()).toFixed(2));
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('#retile-tiles, #retile-trouble') && document.querySelector('.retile').dataset.busy === 'false');
    if (await page.isEnabled('#retile-apply')) await page.click('#retile-apply');
    await page.waitForFunction(() => document.querySelector('.retile').dataset.busy === 'false');
    await page.click('#retile-close');
  },
  save,
  commandLine: changeFile,
  async reload(page) {
    await page.reload();
    await page.waitForFunction(() => window.fretwork?.store.documentNow.value);
  },
};

/** A CSV export: its largest displacement, or why there is none. */
async function exportedTable(address) {
  const { origin, searchParams } = new URL(address);
  const answer = await fetch(`${origin}/export?token=${searchParams.get('token')}&to=storm.csv`);
  const text = await answer.text();
  if (!answer.ok) return { refused: text };
  const rows = text.trim().split('\n').slice(1).map((row) => row.split(',').map(Number));
  return { largest: Math.max(...rows.map(([, , , , ux, uy, uz]) => Math.hypot(ux, uy, uz))) };
}

/** The document as the page has it, in the words of a project file. */
const shown = (page) => page.evaluate(() => {
  const { store } = window.fretwork;
  const now = store.documentNow.value;
  const live = store.live.value;
  return {
    patterns: now.painting.map((index) => now.palette[index] ?? null),
    loadCases: now.load_cases.map(({ name, supports, loads, gravity }) => ({ name, supports, loads, gravity })),
    section: now.setting.section,
    saved: now.saved,
    revision: store.revision.value,
    largest: live?.info.provisional ? null : (live?.info.largest_displacement ?? null),
    problem: store.notTheAnswer.value,
  };
});
const projectOf = (text) => JSON.parse(text);
const patternsIn = ({ tessellation: { patterns, tiles } }) => tiles.map(({ pattern }) => (typeof pattern === 'number' ? (patterns[pattern] ?? null) : (pattern ?? null)));

const isSameLength = (a, b) => a !== null && Math.abs(a - b) <= SAME * Math.abs(b);

const showsAnswer = (now, { largest, refused }) => (refused === undefined ? isSameLength(now.largest, largest) && !now.problem : now.problem !== null);

/** Waits until both pages show what was exported, and the same; throws what differs if they do not come to that. */
async function bothShow(pages, file) {
  const deadline = Date.now() + PATIENCE_MS;
  for (;;) {
    const [one, other] = [await shown(pages[0]), await shown(pages[1])];
    if (isDeepStrictEqual(one, other) && showsAnswer(one, file)) return one;
    if (Date.now() > deadline) {
      assert.deepEqual(one, other, 'both pages show the same');
      throw new Error(`the pages show ${one.largest} m (${one.problem}), the export has ${file.largest} m (${file.refused})`);
    }
    await pages[0].waitForTimeout(20);
  }
}

async function isOneState(pages, storm) {
  const file = await exportedTable(storm.address);
  const one = await bothShow(pages, file);
  const project = projectOf(await download(pages[0]));
  assert.deepEqual(one.patterns, patternsIn(project), 'the painting that is shown is the one in the project');
  assert.deepEqual(one.loadCases.map(({ name }) => name), project.load_cases.map(({ name }) => name));
  for (const [i, { supports = [], loads = [], gravity = [0, 0, 0] }] of one.loadCases.entries()) {
    assert.deepEqual(gravity, project.load_cases[i].gravity ?? [0, 0, 0], 'the weight that is shown is that in the project');
    assert.deepEqual(supports, project.load_cases[i].supports ?? [], 'the supports that are shown are those in the project');
    assert.deepEqual(loads, project.load_cases[i].loads ?? [], 'the loads that are shown are those in the project');
  }
  const onDisk = readFileSync(storm.project, 'utf8');
  if (one.saved && onDisk !== storm.writtenElsewhere) assert.deepEqual(projectOf(onDisk), project, 'what is called saved lies in the file');
  return file.refused === undefined;
}

/** The first file again: a surface that has been let go altogether says little about answers. */
async function beginAgain(pages, storm) {
  writeFileSync(storm.project, storm.first);
  storm.writtenElsewhere = null;
  await pages[0].evaluate((path) => window.fretwork.ask('open', { path, discard: true }), storm.project);
  assert.ok(await isOneState(pages, storm), 'the first surface bends again');
}

async function doOne(name, pages, storm) {
  const page = oneOf(pages, storm.random);
  await page.keyboard.press('Escape');
  await ACTIONS[name](page, storm);
  // Requests of a page are answered in their order: the action has been done once this one is answered.
  await download(page);
  if (name === 'commandLine') storm.writtenElsewhere = readFileSync(storm.project, 'utf8');
}

test('after each pair of actions what is shown, saved and exported is one state', { timeout: 1000 * (SECONDS + 240) }, async (t) => {
  const random = randomFrom(SEED);
  const project = makeProject('60mm');
  const { address, place } = await startStudio(t, project);
  const storm = { random, project, place, address, first: readFileSync(project, 'utf8'), writtenElsewhere: null };
  const pages = [await openPage(t, address), await openPage(t, address)];
  for (const page of pages) {
    page.on('dialog', (dialog) => dialog.accept());
    await solved(page);
  }
  const names = Object.keys(ACTIONS);
  const pairs = names.flatMap((first) => names.map((second) => [first, second]));
  const end = Date.now() + 1000 * SECONDS;
  let [done, answered, unanswered] = [0, 0, 0];
  for (let rest = []; Date.now() < end; ++done) {
    if (rest.length === 0) rest = shuffled(pairs, random);
    const pair = rest.pop();
    try {
      for (const name of pair) await doOne(name, pages, storm);
      unanswered = (await isOneState(pages, storm)) ? 0 : unanswered + 1;
      if (unanswered === 0) ++answered;
      if (unanswered === 3) await beginAgain(pages, storm);
    } catch (error) {
      throw new Error(`pair ${done + 1} of seed ${SEED}, ${pair.join(' then ')}: ${error.message}`, { cause: error });
    }
  }
  t.diagnostic(`${done} of ${pairs.length} pairs, ${answered} with an answer`);
  assert.ok(answered > done / 2, 'most pairs leave a surface that bends');
  for (const page of pages) assert.deepEqual(page.troubles, []);
});
