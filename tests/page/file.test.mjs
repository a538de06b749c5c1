// SPDX-License-Identifier: MIT
// Your file: what it shows of the example, of files with wrong keys, and of files that are none.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { axe, close, open, printed, root, shown } from './models.mjs';

after(close);
const example = readFileSync(`${root}/docs/examples/character.glb`);

// The file with another JSON, or with other bytes in its binary chunk.
function changed(edit) {
  const length = example.readUInt32LE(12), json = JSON.parse(example.toString('utf8', 20, 20 + length));
  const binary = Buffer.from(example.subarray(20 + length + 8));
  edit(json, binary);
  const text = Buffer.from(JSON.stringify(json)), padded = Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')]);
  const head = Buffer.alloc(20), chunk = Buffer.alloc(8);
  const words = [0x46546c67, 2, 28 + padded.length + binary.length, padded.length, 0x4e4f534a];
  words.forEach((x, i) => head.writeUInt32LE(x, 4 * i));
  [binary.length, 0x4e4942].forEach((x, i) => chunk.writeUInt32LE(x, 4 * i));
  return Buffer.concat([head, padded, chunk, binary]);
}

// The floats of the times or values of channel k of animation a.
function floats(json, binary, a, k, what) {
  const { channels, samplers } = json.animations[a], accessor = json.accessors[samplers[channels[k].sampler][what]];
  const at = (json.bufferViews[accessor.bufferView].byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  return { get: i => binary.readFloatLE(at + 4 * i), set: (i, x) => binary.writeFloatLE(x, at + 4 * i) };
}

async function drop(tab, name, bytes) {
  await tab.setInputFiles('input[type=file]', { name, mimeType: 'model/gltf-binary', buffer: bytes });
  await tab.waitForSelector(`.entrance [data-of="${name}"]`, { timeout: 60000 });
  return tab.textContent('.entrance [role=status]');
}

const findings = tab => tab.evaluate(() => [...document.querySelectorAll('[data-finding]')].map(item =>
  `${item.dataset.finding} ${item.dataset.key}`));

test('the example: channels, sizes, no findings; the C program prints the value of the page', async () => {
  const { tab, problems } = await open('file?lang=en&source=example&clip=2&channel=1&time=0.4');
  await tab.waitForSelector('[data-name="value.0"]', { timeout: 60000 });
  const { 'bytes_file.0': file, 'bytes_float32.0': float32, 'bytes_unorm16.0': unorm16, 'bytes_reduced.0': reduced,
    ...numbers } = await shown(tab);
  assert.equal(file, 1000);
  assert.ok(unorm16 < float32 && reduced < float32, `${unorm16} ${reduced} ${float32}`);
  assert.deepEqual(await printed(tab), numbers);
  assert.equal(await tab.locator('[data-channel]').count(), 13);
  assert.equal(await tab.locator('.curves canvas').count(), 1);
  assert.deepEqual(await findings(tab), []);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('the model moves, and each channel has a curve', async () => {
  const { tab, problems } = await open('file?lang=en&source=example');
  await tab.waitForSelector('[data-name="value.0"]', { timeout: 60000 });
  const picture = () => tab.evaluate(() => document.querySelector('.view3').toDataURL());
  const before = await picture();
  for (const i of (await tab.$$('[data-channel]')).keys()) {
    await tab.click(`[data-channel="${i}"]`);
    await tab.waitForSelector(`[data-channel="${i}"][aria-pressed=true]`);
  }
  assert.equal(await picture(), before);
  await tab.fill('.time', '0.5');
  await tab.waitForFunction(first => document.querySelector('.view3').toDataURL() !== first, before);
  assert.deepEqual(problems, []);
  await tab.close();
});

const { NKW_COMMAND: command, NKW_DATA: data } = process.env, folder = `${data}/gltf`;
const keyFindings = new Set(['unsorted-time', 'duplicate-time', 'short-segment', 'not-finite', 'not-unit',
  'rounded-unit', 'over-half-turn', 'sign-flip', 'half-turn', 'long-way', 'non-positive-scale']);
const json = (...words) => JSON.parse(spawnSync(command, [...words, '--json'], { encoding: 'utf8' }).stdout);

// Sizes differ by the joints: objects of three.js on the page, nodes in the command.
function compareSizes(numbers, clip, where) {
  for (const [name, size] of [['float32', clip.clip_bytes], ['unorm16', clip.compact_bytes],
    ['reduced', clip.reduced_bytes]])
    assert.ok(Math.abs(numbers[`bytes_${name}.0`] - size) < 320 + 0.1 * size, `${where} ${name}: ${size}`);
  assert.equal(numbers['bytes_file.0'], clip.file_bytes, where);
}

const skip = !command || !existsSync(folder);
test('files of the table: channels, findings and sizes are those of the command', { skip }, async () => {
  const { tab, problems } = await open('file?lang=en');
  for (const name of readdirSync(folder).filter(file => /\.gl(b|tf)$/.test(file))) {
    const path = `${folder}/${name}`, bin = path.replace(/gltf$/, 'bin');
    const others = bin !== path && existsSync(bin) ? [bin] : [];
    await tab.setInputFiles('input[type=file]', [path, ...others]);
    await tab.waitForSelector(`.entrance [data-of="${name}"]`);
    const { clips } = json('info', '--reduced', path), { findings: found } = json('check', path);
    for (const { clip, channels, ...sizes } of clips) {
      await tab.selectOption('.details select', String(clip));
      const rows = channels.map(c => `${c.joint}.${c.target} ${c.mode} ${c.keys}`).sort().join();
      await tab.waitForFunction(text => text === [...document.querySelectorAll('.details tbody tr')].map(row =>
        [...row.cells].slice(0, 3).map(cell => cell.textContent).join(' ')).sort().join(), rows);
      compareSizes(await shown(tab), sizes, `${name} ${clip}`);
      assert.deepEqual((await findings(tab)).sort(), found.filter(f => f.clip === clip && keyFindings.has(f.what))
        .map(f => `${f.what} ${f.key}`).sort(), `${name} ${clip}`);
    }
  }
  assert.deepEqual(problems, []);
  await tab.close();
});

const wrong = {
  'unsorted-time': (json, binary) => floats(json, binary, 0, 1, 'input').set(3, 0),
  'duplicate-time': (json, binary) => {
    const times = floats(json, binary, 0, 1, 'input');
    times.set(3, times.get(2));
  },
  'not-finite': (json, binary) => floats(json, binary, 0, 1, 'output').set(13, NaN),
  'not-unit': (json, binary) => floats(json, binary, 0, 1, 'output').set(15, 3),
  'sign-flip': (json, binary) => {
    const values = floats(json, binary, 0, 1, 'output');
    for (let i = 12; i < 16; i++)
      values.set(i, -values.get(i));
  },
  'over-half-turn': (json, binary) => {
    const values = floats(json, binary, 0, 1, 'output');
    [[8, Math.sin(0.1), 0, 0, Math.cos(0.1)], [12, Math.sin(1.9), 0, 0, Math.cos(1.9)]].forEach(([i, ...q]) =>
      q.forEach((x, c) => values.set(i + c, x)));
  },
};

test('wrong keys are found, and the page goes on', async () => {
  const { tab, problems } = await open('file?lang=en');
  for (const [what, edit] of Object.entries(wrong)) {
    assert.equal(await drop(tab, `${what}.glb`, changed(edit)), `${what}.glb`);
    await tab.waitForFunction(name => document.querySelector(`[data-finding="${name}"][data-key="3"]`), what);
  }
  assert.deepEqual(problems, []);
  await tab.close();
});

const hostile = {
  'empty': Buffer.alloc(0),
  'noise': Buffer.from(Array.from({ length: 5000 }, (_, i) => i * 193 % 251)),
  'half': example.subarray(0, example.length >> 1),
  'header': example.subarray(0, 21),
  'json': Buffer.from('{"asset":{}}'),
  'cycle': changed(json => { json.nodes[3].children = [0]; }),
  'itself': changed(json => { json.nodes[19].children = [19]; }),
  'two parents': changed(json => { json.nodes[19].children = [18]; }),
  'no child': changed(json => { json.nodes[19].children = [1e9]; }),
  'nodes': changed(json => { json.nodes = 'nodes'; }),
  'many': changed(json => { json.accessors[0].count = 4e9; }),
  'beyond': changed(json => { json.accessors[0].count = 4e5; }),
  'sampler': changed(json => { json.animations[0].channels[0].sampler = 99; }),
  'outside': changed(json => { json.buffers[0].uri = 'https://example.com/a.bin'; }),
  'skin': changed(json => { json.skins[0].joints[0] = 400; }),
  'matrix': changed(json => { json.nodes[3].rotation = [0, 0, 0, 'x']; }),
};

test('files that are none are refused with a reason', async () => {
  const { tab } = await open('file?lang=en');
  const asked = [];
  tab.on('request', request => /^https?:/.test(request.url()) && asked.push(request.url()));
  for (const [name, bytes] of Object.entries(hostile)) {
    const text = await drop(tab, `${name}.glb`, bytes);
    assert.match(text, /^This file is not shown\. ./, `${name}: ${text}`);
  }
  assert.match(await drop(tab, 'empty.glb', Buffer.alloc(0)), /It is empty\.$/);
  assert.equal(await tab.textContent('.curves .legend'), '');
  assert.equal(await tab.locator('table.numbers:visible').count(), 0);
  assert.deepEqual(asked, []);
  assert.equal(await drop(tab, 'good.glb', example), 'good.glb');
  await tab.waitForSelector('[data-name="value.0"]');
  await tab.close();
});

test('axe, in both languages, with and without a file', async () => {
  for (const address of ['file?lang=en&source=file', 'file?lang=ja']) {
    const { tab } = await open(address);
    await tab.waitForSelector(address.includes('source') ? '.entrance' : '[data-name="value.0"]', { timeout: 60000 });
    assert.deepEqual(await axe(tab), []);
    await tab.close();
  }
});
