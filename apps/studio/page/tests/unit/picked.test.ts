// SPDX-License-Identifier: GPL-3.0-or-later
// A selection by a rule is known as that until another selection is made.
import { beforeEach, expect, it } from 'vitest';
import { boxBetween, circleThrough, pickedBy, selectAgain, selectBy, whereChosen } from '../../src/document/picked';
import { selectedNodes } from '../../src/document/ui';
import { selectionWords } from '../../src/panels/selection_words';

beforeEach(() => {
  selectedNodes.value = new Set();
});

it('a side is the side, and not its nodes', () => {
  selectBy({ side: 'left' }, [7, 2]);
  expect([...selectedNodes.value]).toEqual([7, 2]);
  expect(whereChosen()).toEqual({ side: 'left' });
});
it('another selection is none by the rule, even of the same nodes', () => {
  selectBy({ side: 'left' }, [7, 2]);
  selectedNodes.value = new Set([7, 2]);
  expect(pickedBy.value).toBeNull();
  expect(whereChosen()).toEqual({ nodes: [2, 7] });
});
it('an entry that is selected again keeps its rule, and nothing else of it', () => {
  const support = { box: [0, 0, 1, 1] as [number, number, number, number], fixed: ['uz'] };
  selectAgain(support, [1]);
  expect(whereChosen()).toEqual({ box: [0, 0, 1, 1] });
  selectAgain({ nodes: [3] }, [3]);
  expect(whereChosen()).toEqual({ nodes: [3] });
  selectAgain({ tiles: [0] }, [4, 5]);
  expect(whereChosen()).toEqual({ nodes: [4, 5] });
});
it('a box is never smaller than what was drawn, by a micrometre at most larger', () => {
  const [xmin, ymin, xmax, ymax] = boxBetween([0.1234567, 0.3], [0.01, -0.2000004]);
  expect([xmin, ymin, xmax, ymax]).toEqual([0.01, -0.200001, 0.123457, 0.3]);
});
it('a circle is kept as such, and goes through the point that it was drawn to or beyond it', () => {
  const circle = circleThrough([0.1234567, 0.3], [0.1, 0.2999]);
  expect(circle.center).toEqual([0.123457, 0.3]);
  expect(circle.radius).toBeGreaterThanOrEqual(Math.hypot(0.023457, 0.0001));
  expect(circle.radius).toBeLessThan(Math.hypot(0.023457, 0.0001) + 2e-6);
  selectAgain({ circle }, [4, 2]);
  expect(whereChosen()).toEqual({ circle });
  expect(selectionWords({ circle }, 2)).toMatch(/^in a circle, 2.nodes$/);
});
it('a box is called so', () => {
  expect(selectionWords({ box: [0, 0, 1, 1] }, 2)).toMatch(/^in a box, 2.nodes$/);
});
