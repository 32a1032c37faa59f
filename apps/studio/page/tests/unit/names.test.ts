// SPDX-License-Identifier: GPL-3.0-or-later
// Names of files.
import { beforeEach, expect, it } from 'vitest';
import { documentNow } from '../../src/document/store';
import { nameOf, projectName, stem } from '../../src/document/names';
import { documentWith } from './document_of_tests';

const named = (name: string, path: string | null = null): void => {
  documentNow.value = { ...documentWith(), name, path };
};
beforeEach(() => (documentNow.value = null));

it('a path ends with its name, on each kind of machine', () => {
  expect(['/a/b.json', 'C:\\a\\b.json', 'b.json'].map(nameOf)).toEqual(['b.json', 'b.json', 'b.json']);
});
it('a document whose name ends like a file gets the ending once', () => {
  named('a.json');
  expect([stem(), projectName()]).toEqual(['a', 'a.json']);
  named('chair');
  expect(projectName()).toBe('chair.json');
});
it('a document keeps the name of its file, and one without a name gets one', () => {
  named('chair', '/somewhere/else.json');
  expect(projectName()).toBe('else.json');
  named('');
  expect(projectName()).toBe('surface.json');
});
