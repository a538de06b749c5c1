// SPDX-License-Identifier: MIT
// The exercise as its program is used: its keys, its handles, its numbers, its layouts.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { after, test } from 'node:test';
import { close, open, printed, root, shown } from './models.mjs';

after(close);
const drawn = tab => tab.waitForSelector('main[data-drawn]', { state: 'attached', timeout: 60000 });
async function exercise(query) {
  const { tab, problems } = await open(`exercise?${query}`);
  await drawn(tab);
  return { tab, problems, field: name => tab.inputValue(`[data-field=${name}]`) };
}
const frame = tab => tab.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));

test('the numbers of docs/coursework.md at 3.25 s', async () => {
  const { tab } = await exercise('scene=1&time=3.25&position=hermite&orientation=quat');
  const numbers = await shown(tab);
  for (const [name, value] of Object.entries({ 'position.0': 0.1958, 'weight.0': 0.84375, 'theta.0': 0.64,
    'matrix.0': -0.5881 }))
    assert.ok(Math.abs(numbers[name] - value) < 1e-4, `${name}: ${numbers[name]}`);
  await tab.close();
});

test('the C program prints the numbers, of every method and of the program of the exercise', async () => {
  for (const [scene, time, position, orientation, program] of [[1, 3.25, 'hermite', 'quat', 0], [1, 6, 'bezier', 'euler', 1],
    [4, 3.5, 'bezier', 'quat', 0], [6, 1.7, 'bspline', 'quat', 1], [9, 2, 'linear', 'euler', 0]]) {
    const query = `scene=${scene}&time=${time}&position=${position}&orientation=${orientation}&program=${program}`;
    const { tab } = await exercise(query), numbers = await shown(tab), of = await printed(tab);
    for (const [name, value] of Object.entries(numbers))
      assert.ok(Object.is(of[name], value), `${query}: ${name}: ${value}, C prints ${of[name]}`);
    await tab.close();
  }
});

test('the keys of the program: scenes, methods, views, keys, axes, playing', async () => {
  const { tab, problems, field } = await exercise('scene=1');
  const press = async (...keys) => {
    for (const key of keys)
      await tab.keyboard.press(key);
    await frame(tab);
  };
  const before = { position: await field('position'), orientation: await field('orientation'), view: await field('view') };
  await press('p', 'o', 'f');
  for (const name of Object.keys(before))
    assert.notEqual(await field(name), before[name], name);
  const count = () => tab.locator('[data-column=x]').count(), keys = await count();
  await press('a');
  assert.equal(await count(), keys + 1);
  await press('d', 'd');
  assert.equal(await count(), keys - 1);
  await press('t');
  assert.ok(await tab.isChecked('[data-field=axes]'));
  await press('2');
  assert.equal(await field('scene'), '2');
  const time = () => tab.textContent('.seconds');
  await press(' ');
  await tab.waitForFunction(() => parseFloat(document.querySelector('.seconds').textContent) > 0.1);
  await press('s');
  const stopped = await time();
  await tab.waitForTimeout(200);
  assert.equal(await time(), stopped);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('a drag of an arrow moves the key along its axis, and the numbers follow', async () => {
  const { tab, problems } = await exercise('scene=1&time=3.25&position=hermite&orientation=quat&selected=3');
  const box = await tab.locator('canvas.space').boundingBox();
  const data = async name => JSON.parse(await tab.getAttribute('canvas.space', `data-${name}`));
  const [arrow] = await data('arrows'), key = (await data('keys'))[3];
  const x = box.x + 0.8 * arrow.x + 0.2 * key.x, y = box.y + 0.8 * arrow.y + 0.2 * key.y;
  const value = column => tab.inputValue(`[data-key="3"][data-column=${column}]`).then(Number);
  const [x0, y0, z0] = await Promise.all(['x', 'y', 'z'].map(value)), numbers = await shown(tab);
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x + 40, y, { steps: 4 });
  await tab.mouse.up();
  await frame(tab);
  assert.ok(Math.abs(await value('x') - x0) > 0.1);
  assert.deepEqual([await value('y'), await value('z')], [y0, z0]);
  assert.notEqual((await shown(tab))['position.0'], numbers['position.0']);
  assert.equal((await shown(tab))['position.1'], numbers['position.1']);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('a saved layout is read again, by the page and by the command', async t => {
  const { tab } = await exercise('scene=6'), folder = mkdtempSync(`${tmpdir()}/nakawari-`);
  try {
    const [download] = await Promise.all([tab.waitForEvent('download'),
      tab.getByRole('button', { name: 'Save the layout' }).click()]);
    const file = `${folder}/layout.json`;
    await download.saveAs(file);
    const keys = () => tab.$$eval('[data-column]', list => list.map(input => input.value));
    const saved = await keys();
    await tab.keyboard.press('1');
    await frame(tab);
    assert.notDeepEqual(await keys(), saved);
    await tab.setInputFiles('[data-field=load]', file);
    await tab.waitForFunction(first => [...document.querySelectorAll('[data-column]')].map(i => i.value).join() === first,
      saved.join());
    const { scene6 } = JSON.parse(readFileSync(file, 'utf8'));
    assert.equal(scene6.length, new Set(scene6.map(key => key.time)).size);
    if (process.env.NKW_COMMAND) {
      const said = execFileSync(process.env.NKW_COMMAND, ['exercise', file, '--trace', '1.5'], { encoding: 'utf8' });
      assert.match(said, /1\.5/);
    } else {
      t.diagnostic('the command is not built: it did not read the layout');
    }
  } finally {
    rmSync(folder, { recursive: true });
    await tab.close();
  }
});

test('a table of the command is read, and a wrong file is refused with a reason', async () => {
  const { tab } = await exercise('scene=1');
  await tab.setInputFiles('[data-field=load]', `${root}/docs/examples/flight.csv`);
  await tab.waitForFunction(() => document.querySelectorAll('[data-column=x]').length === 10);
  await tab.setInputFiles('[data-field=load]', { name: 'a.json', mimeType: 'application/json', buffer: Buffer.from('{"s": [{}]}') });
  await tab.waitForFunction(() => [...document.querySelectorAll('.side [role=status]')].some(p => p.textContent !== ''));
  assert.equal(await tab.locator('[data-column=x]').count(), 10);
  await tab.close();
});
