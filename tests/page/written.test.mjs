// SPDX-License-Identifier: MIT
// What the command writes, by the validator of Khronos: a sample of each format, converted and reduced.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { after, test } from 'node:test';

const { NKW_BUILD: build, NKW_COMMAND: command, NKW_ROOT: root } = process.env;
const validator = createRequire(`${build}/`)('gltf-validator');
const work = mkdtempSync(join(tmpdir(), 'nakawari-'));
after(() => rmSync(work, { recursive: true }));

const run = (...words) => spawnSync(command, words, { encoding: 'utf8', cwd: work });

// The errors of a file as "CODE at POINTER".
async function errors(file) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(join(work, file))), {
    uri: file,
    maxIssues: 0,
    externalResourceFunction: async uri => new Uint8Array(readFileSync(join(work, decodeURIComponent(uri)))),
  });
  return report.issues.messages.filter(m => m.severity === 0).map(m => `${m.code} at ${m.pointer}: ${m.message}`);
}

// Formats of the library; the others are read where Assimp was found.
const own = ['.bvh', '.obj', '.csv', '.json', '.gltf', '.glb'];
const kinds = /\.(bvh|dae|fbx|md5mesh|x|obj)$/;
const folders = ['tests/data/import', 'tests/data/import/fbx', 'tests/data/import/collada'];
const files = [
  ...folders.flatMap(f => readdirSync(`${root}/${f}`).map(n => `${f}/${n}`)).filter(n => kinds.test(n)),
  ...['character.glb', 'scenes.json', 'flight.csv', 'car.obj'].map(n => `docs/examples/${n}`)];

test('the validator finds errors', { skip: !command }, async () => {
  const nodes = [{ rotation: [0, 0, 0, 2] }], animations = [{ channels: [], samplers: [] }];
  const bad = { asset: { version: '2.0' }, nodes, animations };
  const report = await validator.validateString(JSON.stringify(bad));
  assert.ok(report.issues.numErrors >= 2, JSON.stringify(report.issues.messages));
});

const skip = !command && 'skipped: the command is not built';
test('files that convert and reduce write have no error', { skip }, async t => {
  assert.ok(files.length >= 24, `${files.length} files`);
  const reads = run('info', `${root}/tests/data/import/arm.fbx`).status === 0;
  if (!reads)
    t.diagnostic('skipped: formats that only Assimp reads');
  let checked = 0;
  for (const file of files.filter(f => reads || own.includes(extname(f))))
    for (const form of ['glb', 'gltf', 'embedded']) {
      const end = form === 'glb' ? 'glb' : 'gltf', converted = `converted.${end}`, reduced = `reduced.${end}`;
      const made = run('convert', `${root}/${file}`, '--form', form, '-o', converted);
      assert.equal(made.status, 0, `${file}: ${made.stderr}`);
      assert.deepEqual(await errors(converted), [], `convert --form ${form} ${file}`);
      for (const options of [[], ['--lossless', '--fewest']]) {
        const less = run('reduce', converted, ...options, '--form', form, '-o', reduced);
        assert.equal(less.status, 0, `${file}: ${less.stderr}`);
        assert.deepEqual(await errors(reduced), [], `reduce ${options} ${file}`);
      }
      checked += 3; // the file of convert, and two of reduce
    }
  assert.ok(checked >= (reads ? 216 : 54), `${checked} files`);
});
