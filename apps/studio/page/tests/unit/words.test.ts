// SPDX-License-Identifier: GPL-3.0-or-later
// All texts of the page lie in src/words.ts.
import ts from 'typescript';
import { expect, it } from 'vitest';
import { W } from '../../src/words';

const SOURCES = import.meta.glob<string>('../../src/**/*.tsx', { query: '?raw', import: 'default', eager: true });
const SPOKEN = /^(title|label|tip|aria-label|data-tip|placeholder)$/;

/** Texts between tags and in attributes that people read or hear. */
function textsIn(name: string, source: string): string[] {
  const found: string[] = [];
  const visit = (node: ts.Node): void => {
    if (ts.isJsxText(node) && /\p{L}{2}/u.test(node.text)) found.push(node.text.trim());
    if (ts.isJsxAttribute(node) && SPOKEN.test(node.name.getText()) && node.initializer && ts.isStringLiteral(node.initializer) && /\p{L}{2}/u.test(node.initializer.text))
      found.push(node.initializer.text);
    ts.forEachChild(node, visit);
  };
  visit(ts.createSourceFile(name, source, ts.ScriptTarget.Latest, true, ts.ScriptKind.TSX));
  return found;
}

it('no component has a text of its own', () => {
  expect(Object.keys(SOURCES).length).toBeGreaterThan(30);
  const all = Object.entries(SOURCES).flatMap(([name, source]) => textsIn(name, source).map((text) => `${name}: ${text}`));
  expect(all).toEqual([]);
});

it('a text is found where there is one', () => {
  expect(textsIn('a.tsx', 'const a = <p title="Hold it">Nothing {b} held</p>;')).toEqual(['Hold it', 'Nothing', 'held']);
});

it('one word is used for one thing', () => {
  const texts = JSON.stringify(W, (_, value: unknown) => (typeof value === 'function' ? value.toString() : value));
  for (const old of [/\bLet go\b/, /\bHold\b/, /\bchosen\b/, /in space\b/, /\brim\b/i]) expect(texts).not.toMatch(old);
});
