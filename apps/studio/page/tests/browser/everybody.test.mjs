// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is cut on a small screen, all is reached by keys, and fingers do on a tablet what a mouse does.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { edit, makeProject, openPage, picture, read, solved, startStudio, tilePlace } from './studio.mjs';

/** Controls that are cut by the window or by something around them, and choices whose words are. */
const cutControls = (page) =>
  page.evaluate(() => {
    const isBeyond = (inner, outer) => inner.left < outer.left - 1 || inner.top < outer.top - 1 || inner.right > outer.right + 1 || inner.bottom > outer.bottom + 1;
    const name = (control) => control.id || control.getAttribute('aria-label') || control.textContent.trim() || control.dataset.tip;
    const measure = document.createElement('canvas').getContext('2d');
    const lacksRoom = (select) => {
      const style = getComputedStyle(select);
      measure.font = style.font;
      const words = Math.max(...[...select.options].map((option) => measure.measureText(option.textContent).width));
      const arrow = 20;
      return words > select.clientWidth - parseFloat(style.paddingLeft) - Math.max(arrow, parseFloat(style.paddingRight)) + 1;
    };
    const scrolls = (element) => /auto|scroll/.test(getComputedStyle(element).overflow);
    const isCut = (control) => {
      const box = control.getBoundingClientRect();
      if (isBeyond(box, { left: 0, top: 0, right: innerWidth, bottom: innerHeight })) return true;
      for (let around = control.parentElement; around; around = around.parentElement) {
        if (scrolls(around)) return false;
        if (getComputedStyle(around).overflow !== 'visible' && isBeyond(box, around.getBoundingClientRect())) return true;
      }
      return false;
    };
    const inScroll = (control) => {
      for (let around = control.parentElement; around; around = around.parentElement) if (scrolls(around)) return true;
      return false;
    };
    return [...document.querySelectorAll('button, select, input')]
      .filter((control) => control.checkVisibility({ checkVisibilityCSS: true }) && control.getBoundingClientRect().width > 0)
      .filter((control) => (!inScroll(control) && isCut(control)) || (control instanceof HTMLSelectElement && lacksRoom(control)) || (control instanceof HTMLButtonElement && control.scrollWidth > control.clientWidth + 1))
      .map(name);
  });

const MODES = ['paint', 'hold', 'load', 'design', 'look'];
for (const [width, height] of [[1280, 800], [820, 1180]]) {
  test(`no control is cut at ${width} x ${height}`, async (t) => {
    const { address } = await startStudio(t, makeProject('40mm'));
    const page = await openPage(t, address, { width, height });
    await solved(page);
    const found = [];
    for (const mode of MODES) {
      await page.click(`[data-value=${mode}]`);
      await page.waitForSelector(`.side[data-mode=${mode}]`);
      for (const view of ['plane', 'both', 'space']) {
        await page.click(`[data-value=${view}]`);
        await page.waitForTimeout(150);
        for (const control of await cutControls(page)) found.push(`${mode}, ${view}: ${control}`);
      }
      await page.click('[data-value=both]');
      await picture(page, `80-${width}-${mode}`, 3);
    }
    assert.deepEqual([...new Set(found)], []);
  });
}

test('by keys alone tiles are painted, nodes held and loaded, and the view turned', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address);
  await solved(page);
  const tabTo = async (isThere) => {
    for (let i = 0; i < 120; ++i) {
      if (await page.evaluate(isThere)) return;
      await page.keyboard.press('Tab');
    }
    assert.fail(`not reached by Tab: ${isThere}`);
  };
  await page.keyboard.press('1');
  await page.keyboard.press('b');
  await edit(page, () => page.evaluate(() => window.fretwork.ask('paint', { patterns: '0-5+5-6' }))); // another than the brush's
  await tabTo(() => document.activeElement.id === 'plane');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  const before = await read(page, 'painting');
  await edit(page, () => page.keyboard.press('Enter'));
  const after = await read(page, 'painting');
  assert.equal(after.filter((pattern, tile) => pattern !== before[tile]).length, 1, 'one tile is painted');
  await page.keyboard.press('2');
  await page.waitForSelector('.side[data-mode=hold]');
  await page.focus('#plane');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /1 node selected/.test(document.querySelector('.side').textContent));
  await edit(page, () => page.keyboard.press('p'));
  await page.keyboard.press('3');
  await page.waitForSelector('.side[data-mode=load]');
  await edit(page, () => page.keyboard.press('x'));
  await page.focus('.space canvas');
  const place = () => page.evaluate(() => window.fretwork.nodePlace(0));
  const first = await place();
  await page.keyboard.press('ArrowLeft');
  const turned = await place();
  assert.ok(Math.hypot(turned[0] - first[0], turned[1] - first[1]) > 3);
  await page.keyboard.press('+');
  assert.notDeepEqual(await place(), turned);
  assert.deepEqual(page.troubles, []);
});

/** Fingers as the browser's engine takes them. */
async function touches(page) {
  const session = await page.context().newCDPSession(page);
  const send = (type, points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  return {
    /** Each finger from one place to another, at once. */
    async drag(paths, steps = 6) {
      await send('touchStart', paths.map(([from]) => from));
      for (let i = 1; i <= steps; ++i) await send('touchMove', paths.map(([from, to]) => [0, 1].map((c) => from[c] + ((to[c] - from[c]) * i) / steps)));
      await send('touchEnd', []);
      await page.waitForTimeout(120);
    },
  };
}

test('on a tablet fingers paint, pinch and pan in 2D, and orbit and zoom in 3D', async (t) => {
  const { address } = await startStudio(t, makeProject('40mm'));
  const page = await openPage(t, address, { width: 820, height: 1180, touch: true });
  await solved(page);
  const fingers = await touches(page);
  await page.evaluate(() => window.fretwork.ask('paint', { patterns: '0-5+5-6' }));
  await page.tap('[data-value=paint]');
  await page.waitForFunction(() => window.fretwork.store.documentNow.value.history.undo !== null);
  const places = () => Promise.all([0, 1].map((tile) => tilePlace(page, tile)));
  const [one, other] = await places();
  await edit(page, () => page.touchscreen.tap(...one));
  await edit(page, () => fingers.drag([[one, other]]));

  const painting = (await read(page, 'painting')).join();
  const box = await page.locator('#plane').boundingBox();
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  const aside = (dx) => [middle[0] + dx, middle[1]];
  const apart = async () => {
    const [a, b] = await places();
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };
  const before = await apart();
  await fingers.drag([[aside(-40), aside(-80)], [aside(40), aside(80)]]);
  assert.ok((await apart()) > 1.6 * before, 'a pinch zooms');
  const [start] = await places();
  await fingers.drag([[aside(-40), [middle[0] - 40, middle[1] + 60]], [aside(40), [middle[0] + 40, middle[1] + 60]]]);
  const [end] = await places();
  assert.ok(Math.abs(end[1] - start[1] - 60) < 15, `two fingers pan: ${start} ${end}`);
  assert.equal((await read(page, 'painting')).join(), painting, 'nothing was painted by two fingers');

  const canvas = await page.locator('.space canvas').boundingBox();
  const at = (x, y) => [canvas.x + x * canvas.width, canvas.y + y * canvas.height];
  const nodes = () => page.evaluate(() => [0, 5].map((node) => window.fretwork.nodePlace(node)));
  const seen = await nodes();
  await fingers.drag([[at(0.15, 0.8), at(0.4, 0.75)]]);
  const turned = await nodes();
  assert.ok(Math.hypot(turned[0][0] - seen[0][0], turned[0][1] - seen[0][1]) > 5, 'one finger orbits');
  const width = ([a, b]) => Math.hypot(a[0] - b[0], a[1] - b[1]);
  await fingers.drag([[at(0.4, 0.8), at(0.2, 0.8)], [at(0.6, 0.8), at(0.8, 0.8)]]);
  assert.ok(width(await nodes()) > 1.15 * width(turned), 'two fingers zoom');
  await picture(page, '81-tablet', 3);
  assert.deepEqual(page.troubles, []);
});
