// SPDX-License-Identifier: GPL-3.0-or-later

import { base64 } from '../document/files';
import { W } from '../words';

const LARGEST = 512;

/** A picture file as the program reads it: a PNG stays; what else the browser reads becomes one. */
export async function pngInBase64(file: File): Promise<string> {
  return base64(file.type === 'image/png' ? file : await redrawn(file));
}

async function redrawn(file: File): Promise<Blob> {
  const bitmap = await createImageBitmap(file).catch(() => {
    throw new Error(W.readImage.thisBrowserCannotRead(file.name));
  });
  const shrink = Math.min(1, LARGEST / Math.max(bitmap.width, bitmap.height));
  const canvas = new OffscreenCanvas(Math.max(1, Math.round(bitmap.width * shrink)), Math.max(1, Math.round(bitmap.height * shrink)));
  const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
  context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
  return canvas.convertToBlob({ type: 'image/png' });
}
