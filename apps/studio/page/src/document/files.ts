// SPDX-License-Identifier: GPL-3.0-or-later
// Files in and out: the browser's machine gives and takes, the server's machine keeps the project.

import { currentScene } from '../views/space/current';
import { pngPicture, svgPicture } from '../views/pictures/picture';
import { record } from '../views/pictures/record';
import type { Discarding } from '../protocol/requests';
import { stem } from './names';
import { giveFile } from './own_files';
import { ask, tryAsk } from './studio';
import { makingQuery, type Made } from './making';
import { shapeIndex } from './look';
import { hello, shapes } from './store';
import { tell } from './tell';
import { W } from '../words';

export async function base64(file: Blob): Promise<string> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = '';
  const piece = 0x8000;
  for (let at = 0; at < bytes.length; at += piece) text += String.fromCharCode(...bytes.subarray(at, at + piece));
  return btoa(text);
}

/** Gives a file, or shows why not. */
async function give(name: string, make: () => Promise<Blob | null>): Promise<void> {
  try {
    await giveFile(name, make);
  } catch (error) {
    tell((error as Error).message, 'error');
  }
}

export async function savePicture(ending: 'png' | 'svg' = 'png'): Promise<void> {
  const scene = currentScene.peek();
  if (!scene) return tell(W.files.pictureNeeds3D, 'error');
  if (ending === 'png') return give(`${stem()}.png`, () => pngPicture(scene));
  return give(`${stem()}-3d.svg`, () => Promise.resolve(new Blob([svgPicture(scene)], { type: 'image/svg+xml' })));
}

export async function saveVideo(): Promise<void> {
  const scene = currentScene.peek();
  if (scene) await give(`${stem()}.webm`, () => record(scene));
}

export const openUpload = async (file: File, more: Discarding): Promise<boolean> =>
  (await tryAsk('upload', { name: file.name, text_base64: await base64(file), ...more })) !== null;

export const download = (): Promise<void> =>
  give(`${stem()}.json`, async () => new Blob([(await ask('download')).text], { type: 'application/json' }));

export interface ExportRow {
  ending: string;
  title: string;
  words: string;
  made?: Made;
}
/** Our words for kinds of file that people know; others have the program's words. */
const KNOWN: ExportRow[] = [
  { ending: 'html', title: W.files.webPage, words: W.files.theBentSurfaceIn },
  { ending: 'glb', title: W.files.gltf, words: W.files.movingForSlides },
  { ending: 'svg', title: W.files.svg, words: W.files.drawing },
  { ending: 'dxf', title: W.files.dxf, words: W.files.forLaserCutters, made: 'cut' },
  { ending: 'stl', title: W.files.stl, words: W.files.solidForDPrinting, made: 'solid' },
  { ending: '3mf', title: W.files.mf, words: W.files.solidWithUnits, made: 'solid' },
  { ending: 'txt', title: W.files.fabricationReport, words: W.files.massLengthsNarrowGaps, made: 'facts' },
  { ending: 'json', title: W.files.reportAsJson, words: W.files.machineReadable, made: 'facts' },
  { ending: 'obj', title: W.files.obj, words: W.files.centrelines },
  { ending: 'ply', title: W.files.ply, words: W.files.centrelines },
  { ending: 'vtu', title: W.files.vtu, words: W.files.forParaview },
  { ending: 'csv', title: W.files.csv, words: W.files.tableOfDisplacements },
];

/** The kinds of files that the server writes, the known ones first; pictures have a menu of their own. */
export function offered(): ExportRow[] {
  const rows = (hello.value?.exports ?? []).map(({ ending: dotted, summary }) => {
    const ending = dotted.replace(/^\./, '');
    return KNOWN.find((row) => row.ending === ending) ?? { ending, title: ending.toUpperCase(), words: summary };
  });
  const place = (row: ExportRow): number => (KNOWN.includes(row) ? KNOWN.indexOf(row) : KNOWN.length);
  return rows.filter(({ ending }) => ending !== 'png').sort((a, b) => place(a) - place(b));
}

/** Animated files show the whole load path. */
const MOVES = 'glb';
const STEPS = '30';

/** Files hold the result under the full load: modes, and steps on the way to it, are only shown here. */
function isAnotherShape(ending: string, made?: Made): boolean {
  const now = shapes.peek();
  if (ending === MOVES && now?.kind === 'path') return false;
  if (!now || now.shapes.length === 0 || made === 'cut' || made === 'solid') return false;
  return now.kind !== 'path' || shapeIndex.peek() < now.shapes.length - 1;
}

/** The server writes it as the command line does. Refusals come with a reason. */
export async function exportTo({ ending, made }: ExportRow): Promise<void> {
  if (isAnotherShape(ending, made)) {
    tell(W.files.filesContainTheResult, 'error');
    return;
  }
  // The page's address may hold more than the token. Only the token belongs to the request.
  const query = new URLSearchParams({ token: new URLSearchParams(location.search).get('token') ?? '' });
  query.set('to', `${stem()}.${ending}`);
  if (ending === MOVES) query.set('steps', STEPS);
  for (const [name, text] of Object.entries(made ? makingQuery(made) : {})) query.set(name, text);
  await give(`${stem()}.${ending}`, async () => {
    const answer = await fetch(`/export?${query}`);
    if (!answer.ok) throw new Error((await answer.text()).trim() || W.files.theExportFailed(answer.status));
    const remark = answer.headers.get('Fretwork-Remark');
    if (remark) tell(`${remark[0]!.toUpperCase()}${remark.slice(1)}.`, 'warning');
    return answer.blob();
  });
}
