// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of an example card: the bent bars of the example's result. tests/browser/examples.test.mjs
// draws it, and fails if a picture does not match the result.

const FILES = import.meta.glob<string>('./pictures/*.svg', { query: '?raw', import: 'default', eager: true });

/** Nothing for an example without a picture. */
export const pictureOf = (name: string): string => FILES[`./pictures/${name}.svg`] ?? '';

export function ExamplePicture({ name }: { name: string }) {
  return <span class="example-picture" aria-hidden="true" dangerouslySetInnerHTML={{ __html: pictureOf(name) }} />;
}
