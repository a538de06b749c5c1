// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compareGolden } from './golden.mjs';
import { both, root, text } from './support.mjs';

for (const [build, math] of [...await both('math'), ...await both('all')])
  test(`${build}: the hashes of golden.txt from the functions of the package`, () => {
    const result = compareGolden(math, text(`${root}/tests/golden/kernels.h`), text(`${root}/tests/golden/golden.txt`));
    assert.equal(result.build, build);
    assert.deepEqual(result.different, []);
    assert.ok(result.rows >= 160, `${result.rows} rows`);
  });
