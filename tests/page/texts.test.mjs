// SPDX-License-Identifier: MIT
// The texts of the sources, { en, ja }: each Japanese one is Japanese. Those that are equal are listed here.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createRequire } from 'node:module';

const require = createRequire(`${process.env.NKW_BUILD}/`), ts = require('typescript');
const root = `${process.env.NKW_ROOT}/docs/page`;
const files = ['exhibits', 'kit', 'shell'].flatMap(folder => readdirSync(`${root}/${folder}`, { recursive: true })
  .filter(name => /\.ts$/.test(name)).map(name => `${folder}/${name}`));

// The text of a literal, of a template without what is inserted, of a sum of them.
function textOf(node) {
  if (ts.isStringLiteralLike(node))
    return node.text;
  if (ts.isTemplateExpression(node))
    return node.head.text + node.templateSpans.map(span => span.literal.text).join('');
  if (ts.isTaggedTemplateExpression(node))
    return '';
  if (ts.isBinaryExpression(node))
    return textOf(node.left) + textOf(node.right);
  return ts.isParenthesizedExpression(node) ? textOf(node.expression) : '';
}

function textsOf(file) {
  const source = ts.createSourceFile(file, readFileSync(`${root}/${file}`, 'utf8'), ts.ScriptTarget.Latest), list = [];
  const visit = node => {
    if (ts.isObjectLiteralExpression(node)) {
      const member = name => node.properties.find(p => ts.isPropertyAssignment(p) && p.name.getText?.(source) === name);
      const [en, ja] = ['en', 'ja'].map(member);
      assert.equal(!en, !ja, `${file}: ${node.getText(source).slice(0, 80)}`);
      if (en)
        list.push({ file, en: textOf(en.initializer), ja: textOf(ja.initializer) });
    }
    ts.forEachChild(node, visit);
  };
  visit(source);
  return list;
}

const texts = files.flatMap(textsOf), japanese = /[\u3040-\u30ff\u4e00-\u9fff]/;
const plain = text => text.replace(/<[^>]*>|&\w+;/g, '');

test('there are texts', () => assert.ok(texts.length > 300, `${texts.length}`));

test('an English text has no Japanese', () =>
  assert.deepEqual(texts.filter(({ en }) => japanese.test(en)), []));

// Names and units that are the same in both languages, but for brackets and marks.
const letters = text => plain(text).replace(/[^\p{L}\p{N}]+/gu, ' ').trim();
const same = ['AnimationMixer (three.js)', 'Catmull-Rom', 'squad', 'TCB (Kochanek-Bartels)', 'WebAssembly', 'ω, rad/s']
  .map(letters);

test('a Japanese text is Japanese', () => {
  const left = texts.filter(({ ja }) =>
    !japanese.test(ja) && /\p{L}{2}/u.test(plain(ja)) && !same.includes(letters(ja)));
  assert.deepEqual(left.map(({ file, en, ja }) => `${file}: ${en} | ${ja}`), []);
});

test('a Japanese sentence has no English punctuation', () => {
  const left = texts.filter(({ ja }) => /[\u3040-\u30ff\u4e00-\u9fff]([,;!?]|\.(\s|$))/.test(plain(ja)));
  assert.deepEqual(left.map(({ file, ja }) => `${file}: ${ja}`), []);
});
