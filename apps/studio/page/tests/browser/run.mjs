// SPDX-License-Identifier: GPL-3.0-or-later
// Runs test files, or says why not: node run.mjs FILE..   (77: what the tests need is not there)

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

const SKIPPED = 77;

function missing() {
  try {
    createRequire(import.meta.url).resolve('playwright-core');
  } catch {
    return 'playwright-core is not installed (npm ci)';
  }
  const page = process.env.FRETWORK_PAGE;
  return page && !existsSync(page) ? `${page} is not built` : null;
}

const why = missing();
if (why) {
  console.log(`skipped: ${why}`);
  process.exit(SKIPPED);
}
const files = process.argv.slice(2).map((name) => fileURLToPath(new URL(name, import.meta.url)));
process.exit(spawnSync(process.execPath, ['--test', ...files], { stdio: 'inherit' }).status ?? 1);
