// SPDX-License-Identifier: GPL-3.0-or-later
// Files that the page writes, and names of files on the server's machine.
import { afterEach, expect, it, vi } from 'vitest';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
vi.stubGlobal('location', { search: '', protocol: 'http:', host: 'localhost' });
vi.stubGlobal('window', {});
const { giveFile, pickerOptions } = await import('../../src/document/own_files');
const { pathOf } = await import('../../src/document/folders');

afterEach(() => vi.stubGlobal('window', {}));
const blob = new Blob(['a']);

function pickerThat(outcome: () => unknown) {
  const log: string[] = [];
  const file = {
    createWritable: async () => ({ write: async () => void log.push('write'), close: async () => void log.push('close') }),
    remove: async () => void log.push('remove'),
  };
  vi.stubGlobal('window', { showSaveFilePicker: async () => outcome() ?? file });
  return log;
}

it('the dialog knows the kind of file', () => {
  expect(pickerOptions('chair.png')).toEqual({ suggestedName: 'chair.png', types: [{ accept: { 'image/png': ['.png'] } }] });
  expect(pickerOptions('chair.dxf').types[0].accept).toEqual({ 'application/octet-stream': ['.dxf'] });
});

it('a file goes where the dialog says', async () => {
  const log = pickerThat(() => null);
  await giveFile('a.png', async () => blob);
  expect(log).toEqual(['write', 'close']);
});

it('who closes the dialog gets nothing, and nothing is made', async () => {
  const log = pickerThat(() => {
    throw new DOMException('', 'AbortError');
  });
  const make = vi.fn(async () => blob);
  await giveFile('a.png', make);
  expect(make).not.toHaveBeenCalled();
  expect(log).toEqual([]);
});

it('where it cannot be made, no empty file is left', async () => {
  const log = pickerThat(() => null);
  await expect(giveFile('a.png', () => Promise.reject(new Error('no')))).rejects.toThrow('no');
  expect(log).toEqual(['remove']);
});

it('a typed name lies in the folder that is shown, a path stays a path, and projects end with .json', () => {
  expect(pathOf('chair', '/home/me')).toBe('/home/me/chair.json');
  expect(pathOf(' chair.json ', '/home/me/')).toBe('/home/me/chair.json');
  expect(pathOf('/tmp/a.JSON', '/home/me')).toBe('/tmp/a.JSON');
  expect(pathOf('sub/a', '/')).toBe('/sub/a.json');
  expect(pathOf('  ', '/home/me')).toBeNull();
  expect(pathOf('a', undefined)).toBe('a.json');
});
