// SPDX-License-Identifier: GPL-3.0-or-later
// The list of files that were open before.
import { expect, it, vi } from 'vitest';
import { documentNow } from '../../src/document/store';
import { documentWith } from './document_of_tests';

const kept = new Map<string, string>([['fretwork.recent', '["/b.json", 7, "/a.json"]']]);
vi.stubGlobal('localStorage', { getItem: (key: string) => kept.get(key) ?? null, setItem: (key: string, text: string) => void kept.set(key, text) });
const { forgetRecent, recent, withRecent } = await import('../../src/document/recent');

it('has each file once, the newest first, and six at most', () => {
  expect(withRecent(['/a', '/b'], '/b')).toEqual(['/b', '/a']);
  expect(withRecent(['1', '2', '3', '4', '5', '6'], '7')).toEqual(['7', '1', '2', '3', '4', '5']);
});

it('begins with what the browser has kept, and takes the file of the document', () => {
  expect(recent.value).toEqual(['/b.json', '/a.json']);
  documentNow.value = { ...documentWith(), path: '/c.json' };
  expect(recent.value).toEqual(['/c.json', '/b.json', '/a.json']);
  expect(JSON.parse(kept.get('fretwork.recent') ?? '')).toEqual(recent.value);
});

it('loses a file that cannot be opened', () => {
  forgetRecent('/b.json');
  expect(recent.value).toEqual(['/c.json', '/a.json']);
});
