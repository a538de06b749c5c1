// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { blank, close, page, root } from './models.mjs';
import { readFileSync } from 'node:fs';

after(close);

test('the quick reference of core prints on two pages of A4, with every line', async () => {
  const { tab, problems } = await blank();
  await tab.goto(`file://${page}/reference.html`);
  const pdf = await tab.pdf({ preferCSSPageSize: true });
  const sheets = pdf.toString('latin1').match(/\/Type\s*\/Page\b(?!s)/g).length;
  assert.equal(sheets, 2);
  const size = await tab.$eval('div code', e => parseFloat(getComputedStyle(e).fontSize) * 72 / 96);
  assert.ok(Math.abs(size - 7) < 0.01, `${size} points`);
  const lines = readFileSync(`${root}/docs/reference.md`, 'utf8').match(/^.*nkw_\w+\(.*;.*$/gm).length;
  assert.equal(await tab.$$eval('div:not(.variables)', all => all.length), lines);
  assert.ok(lines > 150, `${lines} lines`);
  assert.deepEqual(problems, []);
  await tab.close();
});
