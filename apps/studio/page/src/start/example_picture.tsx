// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of an example card: its bent bars, drawn from its answer by tests/browser/examples.test.mjs, which fails
// where a picture is not that of the answer.

const FILES = import.meta.glob<string>('./pictures/*.svg', { query: '?raw', import: 'default', eager: true });

/** Nothing for an example without a picture. */
export const pictureOf = (name: string): string => FILES[`./pictures/${name}.svg`] ?? '';

export function ExamplePicture({ name }: { name: string }) {
  return <span class="example-picture" aria-hidden="true" dangerouslySetInnerHTML={{ __html: pictureOf(name) }} />;
}
