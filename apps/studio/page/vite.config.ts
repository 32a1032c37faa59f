// SPDX-License-Identifier: GPL-3.0-or-later
import { defineConfig } from 'vitest/config';
import { viteSingleFile } from 'vite-plugin-singlefile';

// One self-contained page: the server has one file to serve, and nothing is fetched from anywhere else.
export default defineConfig({
  plugins: [viteSingleFile()],
  build: { target: 'es2022', modulePreload: false, chunkSizeWarningLimit: 2000 },
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact', legalComments: 'none' },
  // Tests read style sheets as text; what they import is left out.
  test: { include: ['tests/unit/**/*.test.ts'], css: { include: [/[?&]raw/] }, testTimeout: 60_000 }, // nothing is timed
});
