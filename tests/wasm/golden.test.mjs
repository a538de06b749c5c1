// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compareGolden } from './golden.mjs';
import { both, root, text } from './support.mjs';

const golden = ['kernels.h', 'golden.txt'].map(name => text(`${root}/tests/golden/${name}`));
const rows = golden[0].match(/^K\(/gm).length;

for (const [part, least] of [['math', 142], ['all', 241]])
  for (const [build, module] of await both(part))
    test(`${part}, ${build}: the hashes of golden.txt from the functions of the package`, () => {
      const result = compareGolden(module, ...golden);
      assert.equal(result.build, build);
      assert.deepEqual(result.different, []);
      assert.ok(result.rows >= least, `${result.rows} rows`);
      if (part === 'all')
        assert.match(text(`${root}/docs/web.md`), new RegExp(`\\s${result.rows} of its ${rows} rows`));
    });
