// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { test } from 'node:test';
import { packageFolder, root, text } from './support.mjs';

test('the example of docs/web.md runs in a project that has the package', () => {
  const [, code] = text(`${root}/docs/web.md`).match(/```js\n([\s\S]*?)```/);
  const folder = mkdtempSync(`${tmpdir()}/nakawari-`);
  try {
    mkdirSync(`${folder}/node_modules`);
    symlinkSync(packageFolder, `${folder}/node_modules/nakawari`);
    writeFileSync(`${folder}/example.mjs`, code);
    const printed = execFileSync(process.execPath, [`${folder}/example.mjs`], { encoding: 'utf8' });
    const column = printed.match(/\[([^\]]*)\]/)[1].split(',').map(Number);
    assert.deepEqual(column.map(x => Math.round(x * 1e6) / 1e6 + 0), [0, 1, 0, 0]);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
