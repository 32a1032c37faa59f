// SPDX-License-Identifier: GPL-3.0-or-later
// Files that the page itself writes: by the browser's own dialog where it has one, else as a download.

interface PickerOptions {
  suggestedName: string;
  types: { accept: Record<string, string[]> }[];
}
interface Picked {
  /** Not in all browsers. */
  remove?(): Promise<void>;
  createWritable(): Promise<{ write(blob: Blob): Promise<void>; close(): Promise<void> }>;
}
type SavePicker = (options: PickerOptions) => Promise<Picked>;

const TYPES: Record<string, string> = {
  png: 'image/png', svg: 'image/svg+xml', json: 'application/json', html: 'text/html', csv: 'text/csv', txt: 'text/plain', webm: 'video/webm', glb: 'model/gltf-binary',
};

/** What the dialog is asked for. Browsers refuse types that they do not know, so that other endings go as bytes. */
export function pickerOptions(name: string): PickerOptions {
  const ending = name.split('.').at(-1) ?? '';
  return { suggestedName: name, types: [{ accept: { [TYPES[ending] ?? 'application/octet-stream']: [`.${ending}`] } }] };
}

function downloadAs(blob: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** The dialog asks at once, while the browser still sees the press of a button; `make` may take its time. Where somebody closes the dialog, nothing is made. */
export async function giveFile(name: string, make: () => Promise<Blob | null>): Promise<void> {
  const picker = (window as { showSaveFilePicker?: SavePicker }).showSaveFilePicker;
  const picked = picker ? await picker(pickerOptions(name)).catch(refusal) : 'download';
  if (picked === 'closed') return;
  const blob = await make().catch(async (error: unknown) => {
    await leaveNothing(picked);
    throw error;
  });
  if (!blob) return leaveNothing(picked);
  if (picked === 'download') return downloadAs(blob, name);
  const file = await picked.createWritable();
  await file.write(blob);
  await file.close();
}

/** Removes the empty file that the dialog has made. */
async function leaveNothing(picked: Picked | 'download'): Promise<void> {
  if (picked !== 'download') await picked.remove?.();
}

/** Whoever closes the dialog wants no file. If it may not be shown, the file becomes a download. */
function refusal(error: unknown): 'closed' | 'download' {
  return error instanceof DOMException && error.name === 'AbortError' ? 'closed' : 'download';
}
