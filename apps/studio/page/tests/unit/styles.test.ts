// SPDX-License-Identifier: GPL-3.0-or-later
// Every class and id of the style sheets is on something that the page shows.
import ts from 'typescript';
import { expect, it } from 'vitest';

const SHEETS = import.meta.glob<string>('../../src/**/*.css', { query: '?raw', import: 'default', eager: true });
const SOURCES = import.meta.glob<string>(['../../src/**/*.{ts,tsx}', '!../../src/words.ts'], { query: '?raw', import: 'default', eager: true });
const PICTURES = import.meta.glob<string>('../../src/**/*.svg', { query: '?raw', import: 'default', eager: true });

/** The classes and ids of a sheet's selectors, as ".row" and "#studio". */
function selected(sheet: string): string[] {
  const selectors = sheet.replace(/\/\*.*?\*\//gs, '').replace(/\{[^{}]*\}/g, '{}');
  return [...selectors.matchAll(/[.#][A-Za-z_][\w-]*/g)].map(([name]) => name);
}

/** The words in the texts of a source; those of imports and types are on nothing. */
function wordsIn(name: string, source: string): string[] {
  const words: string[] = [];
  const visit = (node: ts.Node): void => {
    if (ts.isImportDeclaration(node) || ts.isExportDeclaration(node) || ts.isLiteralTypeNode(node)) return;
    if (ts.isStringLiteralLike(node) || ts.isTemplateHead(node) || ts.isTemplateMiddleOrTemplateTail(node)) words.push(...(node.text.match(/[\w-]+/g) ?? []));
    ts.forEachChild(node, visit);
  };
  visit(ts.createSourceFile(name, source, ts.ScriptTarget.Latest, true, ts.ScriptKind.TSX));
  return words;
}

const classesIn = (picture: string): string[] => [...picture.matchAll(/class="([^"]*)"/g)].flatMap(([, names]) => names.split(' '));

it('no rule is left of something that has gone', () => {
  const used = new Set([...Object.entries(SOURCES).flatMap(([name, source]) => wordsIn(name, source)), ...Object.values(PICTURES).flatMap(classesIn)]);
  const dead = Object.entries(SHEETS).flatMap(([sheet, text]) => selected(text).flatMap((name) => (used.has(name.slice(1)) ? [] : [`${sheet}: ${name}`])));
  expect(Object.values(SHEETS).flatMap(selected).length, 'the sheets are read').toBeGreaterThan(200);
  expect(dead).toEqual([]);
});

it('a name is found in a selector, and in a text', () => {
  expect(selected('/* .no */ @media (max-width: .5px) { .row > #one.on, a:hover { margin: .5px; } }')).toEqual(['.row', '#one', '.on']);
  const source = "import { a } from './not-this'; type B = 'nor-this'; const c = <p class={`row ${d ? 'on' : ''} last`} id=\"one\" />;";
  expect(wordsIn('a.tsx', source)).toEqual(['row', 'on', 'last', 'one']);
});
