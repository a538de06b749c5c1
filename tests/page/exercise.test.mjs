// SPDX-License-Identifier: MIT
// The exercise as its program is used: its keys, its handles, its numbers, its layouts.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { after, test } from 'node:test';
import { close, long, printed, root, shown, start } from './models.mjs';

after(close);
async function exercise(query, options) {
  const { tab, problems } = await start(`exercise?lang=en&${query}`, options);
  return { tab, problems, field: name => tab.inputValue(`[data-field=${name}]`) };
}
const frame = tab => tab.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
const cell = (tab, key, column) => tab.locator(`[data-key="${key}"][data-column=${column}]`);
const value = (tab, key, column) => cell(tab, key, column).inputValue().then(Number);
const count = tab => tab.locator('[data-column=x]').count();
const text = (tab, selector) => tab.textContent(selector);

/* ---- the numbers ---- */

test('the numbers of docs/coursework.md at 3.25 s', async () => {
  const { tab } = await exercise('scene=1&time=3.25&position=hermite&orientation=quat');
  const numbers = await shown(tab);
  for (const [name, expected] of Object.entries({ 'position.0': 0.1958456, 'weight.0': 0.84375, 'weight.3': -0.046875,
    'dot.0': -0.8020958, 'q1key.0': 0.1055979, 'q1.0': -0.1055979, 'theta.0': 0.64, 'share.0': 0.7732463,
    'q.1': 0.8908672, 'matrix.0': -0.5881267 }))
    assert.ok(Math.abs(numbers[name] - expected) < 1e-6, `${name}: ${numbers[name]}`);
  assert.match(await text(tab, '.place'), /t = \(3\.25 − 3\) \/ \(4 − 3\) = 0\.25/);
  await tab.close();
});

test('the C program prints the numbers, of every method and of the program of the exercise', long, async () => {
  for (const [scene, time, position, orientation, program] of [[1, 3.25, 'hermite', 'quat', 0],
    [1, 6, 'bezier', 'euler', 1], [4, 3.5, 'bezier', 'quat', 0], [6, 1.7, 'bspline', 'quat', 1],
    [9, 2, 'linear', 'euler', 0], [2, 0.3, 'bezier', 'none', 1], [7, 2.4, 'centripetal', 'nlerp', 0]]) {
    const query = `scene=${scene}&time=${time}&position=${position}&orientation=${orientation}&program=${program}`;
    await prints(query);
  }
});

async function prints(query) {
  const { tab } = await exercise(query), numbers = await shown(tab), of = await printed(tab);
  assert.ok(Object.keys(numbers).length > 20, query);
  for (const [name, x] of Object.entries(numbers))
    assert.ok(Object.is(of[name], x), `${query}: ${name}: ${x}, C prints ${of[name]}`);
  await tab.close();
  return numbers;
}

/** A picture that is drawn fast, for many frames. */
const small = { viewport: { width: 480, height: 240 } };

/** The rows of the table of the exercise, computed in binary64 by other code (tests/data). */
const [head, ...lines] = readFileSync(`${root}/tests/data/coursework_expected.csv`, 'utf8').trim().split('\n');
const columns = head.split(',');
const table = lines.map(line => line.split(',')).map(row => ({
  scene: row[0], position: row[2], orientation: row[3], time: Number(row[4]),
  matrix: row.slice(columns.indexOf('m0')).map(Number),
}));

/** The matrices that the page shows while its slider is moved through the times. */
const matrices = (tab, times) => tab.evaluate(async list => {
  const slider = document.querySelector('.bar .time'), result = [];
  for (const time of list) {
    slider.value = time;
    slider.dispatchEvent(new Event('input'));
    await new Promise(requestAnimationFrame);
    result.push(Array.from({ length: 16 }, (_, i) =>
      Number(document.querySelector(`[data-name="matrix.${i}"]`).dataset.value)));
  }
  return result;
}, times);

const furthest = (a, b) => Math.max(...a.map((x, i) => Math.abs(x - b[i])));

/** The largest difference between the page and the rows; the page has their scene and methods. */
async function difference(tab, rows) {
  const got = await matrices(tab, rows.map(row => row.time));
  return Math.max(...rows.map((row, i) => furthest(row.matrix, got[i])));
}

/** The rows inside the keys, every 0.3 s. */
const rowsOf = (scene, position, orientation, end) => table.filter(row => row.scene === scene &&
  row.position === position && row.orientation === orientation && row.time >= 0 && row.time <= end &&
  Math.round(10 * row.time) % 3 === 0);
const curves = ['linear', 'hermite', 'bezier', 'bspline'];
const methods = [...curves.flatMap(p => [[p, 'euler'], [p, 'quat']]), ['linear', 'none']];

for (const [scene, end] of [[1, 6], [2, 1]])
  test(`scene ${scene} by every method: an independent table`, async t => {
    const { tab, problems } = await exercise(`scene=${scene}&view=plain`, small);
    let worst = 0, compared = 0;
    for (const program of [false, true]) {
      await tab.setChecked('[data-field=program]', program);
      for (const [position, orientation] of methods) {
        await tab.selectOption('[data-field=position]', position);
        await tab.selectOption('[data-field=orientation]', orientation);
        // Without interpolation, the program and the library differ on the keys.
        const rows = rowsOf(`scene${scene}`, position, orientation, end)
          .filter(row => program || orientation !== 'none' || row.time % 1 !== 0);
        const far = await difference(tab, rows);
        assert.ok(far < 1e-6, `${position}, ${orientation}, program ${program}: ${far}`);
        [worst, compared] = [Math.max(worst, far), compared + rows.length];
      }
    }
    assert.ok(compared > 50 * end, `${compared}`);
    t.diagnostic(`${compared} matrices, largest difference of an element ${worst.toExponential(1)}`);
    assert.deepEqual(problems, []);
    await tab.close();
  });

test('the first 3 to 6 keys of scene 1, deleted by d: Bézier as in an independent table', async () => {
  const { tab } = await exercise('scene=1&view=plain&position=bezier&orientation=quat', small);
  for (let keys = 6; keys >= 3; keys--) {
    await tab.keyboard.press('d');
    await frame(tab);
    assert.equal(await count(tab), keys);
    const far = await difference(tab, rowsOf(`scene1_first${keys}`, 'bezier', 'quat', keys - 1));
    assert.ok(far < 1e-6, `${keys} keys: ${far}`);
  }
  await tab.close();
});

test('at first the rule is that of the exercise: at 2 s, the orientation of key 1', async () => {
  const { tab } = await exercise('scene=1&time=2&orientation=none'), numbers = await shown(tab);
  assert.ok(await tab.isChecked('[data-field=program]'));
  const { matrix } = table.find(row => row.scene === 'scene1' && row.orientation === 'none' && row.time === 2);
  for (const i of [0, 1, 2, 4, 5, 6, 8, 9, 10])
    assert.ok(Math.abs(numbers[`matrix.${i}`] - matrix[i]) < 1e-6, `${i}`);
  await tab.close();
});

test('outside the keys, the numbers with the switch are those of the exercise', async () => {
  for (const row of table.filter(r => r.scene === 'scene1' && r.orientation === 'euler' &&
    [-0.5, 6.5].includes(r.time) && r.position.startsWith('bezier'))) {
    const program = row.position === 'bezier' ? 1 : 0;
    const { tab } = await exercise(`scene=1&time=${row.time}&position=bezier&orientation=euler&program=${program}`);
    const numbers = await shown(tab), far = furthest(row.matrix, row.matrix.map((_, i) => numbers[`matrix.${i}`]));
    assert.ok(far < 1e-6, `${row.position} at ${row.time}: ${far}`);
    await tab.close();
  }
});

/** R = Ry Rx Rz as a quaternion, angles in degrees, in binary64. */
function quaternion(...degrees) {
  const [y, x, z] = degrees.map(d => d * Math.PI / 360), { sin, cos } = Math;
  return [cos(y) * sin(x) * cos(z) + sin(y) * cos(x) * sin(z), sin(y) * cos(x) * cos(z) - cos(y) * sin(x) * sin(z),
    cos(y) * cos(x) * sin(z) - sin(y) * sin(x) * cos(z), cos(y) * cos(x) * cos(z) + sin(y) * sin(x) * sin(z)];
}

test('at a pitch of 90 degrees, the program loses the rotation and the library keeps it', long, async () => {
  for (const [pitch, lost] of [[90, true], [-90, true], [80, false]]) {
    const keys = [0, 0, 0, 0, ...quaternion(30, pitch, 40), 1, 1, 0, 0, ...quaternion(0, 0, 0)].join('_');
    const query = `keys=${keys}&time=0&orientation=`;
    const [whole, kept, other] = [await prints(`${query}quat`), await prints(`${query}euler&program=0`),
      await prints(`${query}euler&program=1`)];
    const of = numbers => Array.from({ length: 16 }, (_, i) => numbers[`matrix.${i}`]);
    assert.ok(furthest(of(whole), of(kept)) < 1e-6, `${pitch}`);
    assert.equal(furthest(of(whole), of(other)) > 0.5, lost, `${pitch}: ${furthest(of(whole), of(other))}`);
  }
});

/* ---- the blanks of the report ---- */

/** The numbers of a line of the trace in docs/ja/coursework.md. */
const numbersIn = line => [...line.matchAll(/-?\d+\.\d+|-?\b\d+\b/g)].map(([x]) => Number(x));

test('a student: the trace of docs/ja/coursework.md, number by number, in three steps from the start', async () => {
  const page = readFileSync(`${root}/docs/ja/coursework.md`, 'utf8').match(/\$ .*--orientation quat\n([^`]*)```/)[1];
  const lines = page.split('\n').map(line => line.trim());
  const values = start => numbersIn(lines.find(line => line.startsWith(start)).split('=').slice(1).join());
  const { tab, field } = await exercise('');
  await tab.keyboard.press('p');
  await tab.keyboard.press('o');
  await tab.fill('[data-field=time]', '3.25');
  await tab.press('[data-field=time]', 'Enter');
  await frame(tab);
  assert.deepEqual([await field('position'), await field('orientation')], ['hermite', 'quat']);
  const numbers = await shown(tab);
  const same = (name, list) => list.forEach((x, i) =>
    assert.ok(Math.abs(numbers[`${name}.${i}`] - x) <= 1e-8 * Math.max(Math.abs(x), 0.1), `${name}.${i}: ${x}`));
  ['p0', 'v0', 'p1', 'v1'].forEach((name, i) => {
    const [x, y, z, , weight] = values(`${name} =`);
    same(`control${i}`, [x, y, z]);
    assert.ok(Math.abs(numbers[`weight.${i}`] - weight) < 1e-8, name);
  });
  same('position', values('p ='));
  ['q0', 'q1'].forEach((name, i) => {
    same(name, values(`${name} = `).slice(0, 4));
    assert.ok(Math.abs(numbers[`share.${i}`] - values(`${name} = `)[4]) < 1e-8, name);
  });
  same('dot', values('q0 . q1').slice(0, 1));
  same('theta', values('theta').slice(0, 1));
  same('q', values('q  ='));
  const rows = lines.filter(line => /^( *-?\d\.\d{9}){4}$/.test(line)).map(numbersIn);
  assert.equal(rows.length, 4);
  rows.forEach((row, r) => row.forEach((x, c) => assert.ok(Math.abs(numbers[`matrix.${4 * c + r}`] - x) < 1e-8)));
  await tab.close();
});

const blankMethods = [['hermite', 'ABCDE'], ['bezier', 'ABCDE'], ['bspline', 'ABCDE']];

test('every blank has its letter, its number and its code, and the code computes the number', async () => {
  const { tab } = await exercise('scene=1&time=3.25&orientation=quat');
  const page = readFileSync(`${root}/docs/coursework.md`, 'utf8');
  const letters = selector => tab.$$eval(`${selector} tr:has(.blank)`, rows => rows.map(row =>
    [row.querySelector('.blank').textContent, row.querySelectorAll('[data-name]').length]));
  for (const [position, names] of blankMethods) {
    await tab.selectOption('[data-field=position]', position);
    await frame(tab);
    const tables = '.report table:nth-of-type';
    assert.deepEqual((await letters(`${tables}(1)`)).map(([letter]) => letter).join(''), names);
    assert.deepEqual((await letters(`${tables}(2)`)).map(([letter]) => letter).join(''), 'AABCD');
    assert.ok((await letters('.report table')).every(([, numbers]) => numbers > 0));
    const code = (await text(tab, '.answers pre')).split('\n').filter(line => /^[A-E] /.test(line))
      .map(line => line.slice(3));
    assert.equal(code.length, 9);
    for (const line of code.map(line => line.replace(/;$/, '')))
      assert.ok(page.includes(`\`${line}\``), line);
    const numbers = await shown(tab), order = position === 'hermite' ? [0, 2, 1, 3] : [0, 1, 2, 3];
    order.forEach((weight, i) => {
      const formula = new Function('t', 's', `return ${code[i].split('=')[1]}`);
      const x = formula(numbers['t.0'], numbers['parameter.0']);
      assert.ok(Math.abs(x - numbers[`weight.${weight}`]) < 1e-6, `${position} ${code[i]} ${x}`);
    });
  }
  await tab.close();
});

for (const [lang, width, height] of [['en', 1280, 720], ['ja', 1280, 720], ['ja', 1920, 1080]])
  test(`the blanks are beside the picture without scrolling, ${lang}, ${width} x ${height}`, async () => {
    const { tab } = await start(`exercise?lang=${lang}&time=3.25&orientation=quat`, { viewport: { width, height } });
    for (const [position] of blankMethods) {
      await tab.selectOption('[data-field=position]', position);
      await frame(tab);
      const hidden = await tab.evaluate(() => {
        const side = document.querySelector('.side').getBoundingClientRect();
        const end = Math.min(side.bottom, innerHeight);
        const inside = ({ top, bottom, right }) => top >= side.top && bottom <= end && right <= side.right;
        return [...document.querySelectorAll('.report [data-name], .report th, .reason')]
          .filter(e => !inside(e.getBoundingClientRect())).map(e => e.textContent);
      });
      assert.deepEqual(hidden, [], position);
      const { width: w, height: h } = await tab.locator('canvas.space').boundingBox();
      assert.ok(w >= 0.4 * width && h >= 0.5 * height, `the picture has ${w} x ${h}`);
    }
    await tab.close();
  });

/* ---- the keyboard ---- */

test('1 to 9 set a scene; the help has the reason of each', async () => {
  const { tab, problems, field } = await exercise('scene=1');
  const help = await tab.$$eval('.keys dd', list => list.map(dd => dd.textContent)), reasons = new Set();
  for (let scene = 9; scene >= 1; scene--) {
    await tab.keyboard.press(String(scene));
    await frame(tab);
    assert.equal(await field('scene'), String(scene));
    const reason = await text(tab, '.reason');
    assert.ok(reason.length > 60 && help[scene - 1].endsWith(reason), `${scene}: ${help[scene - 1]}`);
    reasons.add(reason);
  }
  assert.equal(reasons.size, 9);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('p, o, f, t, a, d: methods, views, axes, keys', async () => {
  const { tab, problems, field } = await exercise('scene=1');
  const cycle = async (key, name, length) => {
    const words = [];
    for (let i = 0; i < length; i++) {
      await tab.keyboard.press(key);
      await frame(tab);
      words.push(await field(name));
    }
    return words;
  };
  assert.deepEqual(await cycle('p', 'position', 4), ['hermite', 'bezier', 'bspline', 'linear']);
  assert.deepEqual(await cycle('o', 'orientation', 2), ['quat', 'euler']);
  assert.deepEqual(await cycle('f', 'view', 3), ['frames', 'plain', 'trajectory']);
  for (const on of [true, false]) {
    await tab.keyboard.press('t');
    await frame(tab);
    assert.equal(await tab.isChecked('[data-field=axes]'), on);
  }
  for (const [key, keys] of [['a', 8], ['a', 9], ['d', 8], ['d', 7], ['d', 6]]) {
    await tab.keyboard.press(key);
    await frame(tab);
    assert.equal(await count(tab), keys);
  }
  assert.deepEqual(problems, []);
  await tab.close();
});

test('the keys work after a click on any control; a field of text keeps them', async () => {
  const { tab, problems, field } = await exercise('scene=1');
  for (const [selector, act] of [['.time', 'click'], ['[data-field=scene]', 'focus'], ['[data-field=axes]', 'focus'],
    ['main button', 'focus'], ['.time', 'focus']]) {
    await tab.locator(selector).first()[act]();
    const before = await field('position');
    await tab.keyboard.press('p');
    await frame(tab);
    assert.notEqual(await field('position'), before, selector);
  }
  await tab.keyboard.press('4');
  await frame(tab);
  assert.equal(await field('scene'), '4');
  const [time, scene] = [await tab.inputValue('.time'), await field('scene')];
  await tab.keyboard.press('ArrowRight');
  await frame(tab);
  assert.notEqual(await tab.inputValue('.time'), time, 'an arrow is the slider\'s');
  await tab.keyboard.press('P');
  await tab.keyboard.press(' ');
  await frame(tab);
  assert.ok(await tab.evaluate(() => new Promise(done => {
    const from = document.querySelector('.time').value;
    setTimeout(() => done(document.querySelector('.time').value !== from), 300);
  })), 'space plays while the slider has the focus');
  await tab.keyboard.press('s');
  await cell(tab, 0, 'x').focus();
  const before = await field('position');
  await tab.keyboard.press('p');
  await frame(tab);
  assert.deepEqual([await field('position'), await field('scene')], [before, scene]);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('space plays from the start, s stops and resumes', async () => {
  const { tab, field } = await exercise('scene=1&time=5&view=frames');
  const time = async () => parseFloat(await text(tab, '.seconds'));
  const later = than => tab.waitForFunction(x => {
    const seconds = parseFloat(document.querySelector('.seconds').textContent);
    return seconds > x && seconds < 5;
  }, than);
  await tab.keyboard.press(' ');
  await later(0.1);
  assert.equal(await field('view'), 'plain');
  await tab.keyboard.press('s');
  await frame(tab);
  const stopped = await time();
  await frame(tab);
  assert.equal(await time(), stopped);
  await tab.keyboard.press('s');
  await later(stopped);
  await tab.keyboard.press(' ');
  await frame(tab);
  const again = await time();
  await frame(tab);
  assert.equal(await time(), again);
  await tab.close();
});

test('the canvas by keyboard alone: a key is chosen, moved, turned, and gets another time', async () => {
  const { tab, problems } = await exercise('scene=1');
  const press = async (...keys) => {
    for (const key of keys)
      await tab.keyboard.press(key);
    await frame(tab);
  };
  const row = () => Promise.all(['time', 'x', 'y', 'z', 'yaw', 'pitch', 'roll'].map(name => value(tab, 5, name)));
  await tab.focus('canvas.space');
  await press(...Array(7).fill('Tab'), 'Shift+Tab');
  assert.equal(await tab.locator('[aria-pressed=true][aria-label="Key 5"]').count(), 1);
  assert.deepEqual(await row(), [5, 1.5, 0.6, 0, 0, 0, 0]);
  await press('ArrowRight', 'ArrowRight', 'PageUp', 'ArrowDown');
  assert.deepEqual(await row(), [5, 1.7, 0.7, 0.1, 0, 0, 0]);
  await press('ArrowLeft', 'PageDown', 'ArrowUp', 'Shift+ArrowLeft');
  assert.deepEqual(await row(), [5, 1.6, 0.6, 0, 5, 0, 0]);
  await press('+', '+', '+', '-');
  assert.deepEqual(await row(), [5.2, 1.6, 0.6, 0, 5, 0, 0]);
  for (const [key, seconds] of [['.', 0.1], ['.', 0.2], [',', 0.1], [',', 0], [',', 0]]) {
    await press(key);
    assert.equal(parseFloat(await text(tab, '.seconds')), seconds);
  }
  await press('Escape', 'Shift+Tab'); // leaves the canvas
  assert.equal(await tab.evaluate(() => document.activeElement.tagName), 'INPUT');
  assert.deepEqual(problems, []);
  await tab.close();
});

test('a lecturer: after a choice by the pointer, the keys are those of the exercise again', async () => {
  const { tab, field } = await exercise('scene=1');
  await tab.locator('[data-field=scene]').dispatchEvent('pointerdown');
  await tab.selectOption('[data-field=scene]', '4');
  for (const [key, name, word] of [['p', 'position', 'hermite'], ['3', 'scene', '3']]) {
    await tab.keyboard.press(key);
    await frame(tab);
    assert.equal(await field(name), word);
  }
  await tab.close();
});

/* ---- the handles ---- */

const data = async (tab, name) => JSON.parse(await tab.getAttribute('canvas.space', `data-${name}`));

/** The place on the screen where the page says that a handle is, and no other is nearer. */
async function gripOf(tab, name) {
  const box = await tab.locator('canvas.space').boundingBox();
  for (const p of (await data(tab, 'grips'))[name].filter(Boolean)) {
    await tab.mouse.move(box.x + p.x, box.y + p.y);
    if (await tab.getAttribute('canvas.space', 'data-handle') === name)
      return { x: box.x + p.x, y: box.y + p.y };
  }
  assert.fail(`no place of ${name}`);
}

async function byMouse(tab, { x, y }, dx, dy) {
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x + dx, y + dy, { steps: 4 });
  await tab.mouse.up();
}

async function byTouch(tab, { x, y }, dx, dy) {
  const session = await tab.context().newCDPSession(tab);
  const send = (type, points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
  await send('touchStart', [{ x, y }]);
  for (const s of [0.25, 0.5, 0.75, 1])
    await send('touchMove', [{ x: x + s * dx, y: y + s * dy }]);
  await send('touchEnd', []);
  await session.detach();
}

/** Position and rotation (by columns) of key 3 of scene 1, which is at 3 s. */
async function placement(tab) {
  const numbers = await shown(tab), m = Array.from({ length: 16 }, (_, i) => numbers[`matrix.${i}`]);
  return { at: m.slice(12, 15), turn: [0, 4, 8].map(i => m.slice(i, i + 3)) };
}

/** The axis e of the turn from one rotation to another: the part of `to from^T` that is not symmetric. */
function axisOf(from, to) {
  const r = (i, j) => [0, 1, 2].reduce((sum, k) => sum + to[k][i] * from[k][j], 0);
  const v = [r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)], length = Math.hypot(...v);
  return length > 1e-3 ? v.map(x => x / length) : undefined;
}

const handles = ['axis', 'plane', 'ring'].flatMap(kind => [0, 1, 2].map(axis => [kind, axis]));

function changed([kind, axis], before, now) {
  const by = now.at.map((x, i) => x - before.at[i]), turn = axisOf(before.turn, now.turn);
  const others = [0, 1, 2].filter(i => i !== axis);
  if (kind === 'ring')
    return Math.hypot(...by) === 0 && turn && Math.abs(Math.abs(turn[axis]) - 1) < 1e-5;
  const still = kind === 'axis' ? others : [axis], moves = kind === 'axis' ? [axis] : others;
  return !turn && still.every(i => Math.abs(by[i]) < 1e-6) && moves.some(i => Math.abs(by[i]) > 0.01);
}

for (const [device, drag, options] of [['the mouse', byMouse, {}], ['a finger', byTouch, { hasTouch: true }]])
  test(`each arrow, square and ring is dragged by ${device}: the key moves or turns about the axis`, async () => {
    const { tab, problems } = await exercise('scene=1&time=3&orientation=quat&selected=3', options);
    for (const [kind, axis] of handles) {
      const before = await placement(tab);
      await drag(tab, await gripOf(tab, `${kind} ${axis}`), 30, 18);
      await frame(tab);
      const now = await placement(tab);
      assert.ok(changed([kind, axis], before, now), `${kind} ${axis}: ${JSON.stringify([before, now])}`);
      await tab.keyboard.press('1');
      await frame(tab);
      await tab.getByRole('button', { name: 'Key 3', exact: true }).click();
      await tab.locator('.bar .time').evaluate(slider => {
        slider.value = 3;
        slider.dispatchEvent(new Event('input'));
      });
      await frame(tab);
    }
    assert.deepEqual(problems, []);
    await tab.close();
  });

test('with the axes of the object, an arrow moves the key along its own axis', async () => {
  const { tab } = await exercise('scene=1&time=3&orientation=quat&selected=3&local=1');
  const before = await placement(tab), axis = before.turn[0];
  await byMouse(tab, await gripOf(tab, 'axis 0'), 25, -10);
  await frame(tab);
  const by = (await placement(tab)).at.map((x, i) => x - before.at[i]), length = Math.hypot(...by);
  assert.ok(length > 0.05, `${by}`);
  assert.ok(Math.abs(Math.abs(by.reduce((sum, x, i) => sum + x * axis[i], 0)) - length) < 1e-5, `${by}, ${axis}`);
  await tab.close();
});

test('clicks choose a key, change its axes, choose none; a drag beside the keys turns the camera', async () => {
  const { tab, field } = await exercise('scene=1'), chosen = '[aria-pressed=true][aria-label="Key 2"]';
  const box = await tab.locator('canvas.space').boundingBox(), at = (await data(tab, 'keys'))[2];
  for (const local of [false, true, false]) {
    await tab.mouse.click(box.x + at.x, box.y + at.y);
    await frame(tab);
    assert.equal(await tab.locator(chosen).count(), 1);
    assert.equal(await tab.isChecked('[data-field=local]'), local);
  }
  const yaw = Number(await field('yaw'));
  await byMouse(tab, { x: box.x + 15, y: box.y + 15 }, 20, 0);
  await frame(tab);
  assert.equal(Number(await field('yaw')), (yaw + 340) % 360);
  assert.equal(await tab.locator(chosen).count(), 1);
  await tab.mouse.click(box.x + 15, box.y + 15);
  await frame(tab);
  assert.equal(await tab.locator(chosen).count(), 0);
  const distance = Number(await field('distance'));
  await tab.mouse.move(box.x + 15, box.y + 15);
  await tab.mouse.wheel(0, 250);
  await tab.waitForFunction(x => Number(document.querySelector('[data-field=distance]').value) > x, distance);
  await tab.close();
});

/* ---- the program's clicks and its texts ---- */

/** From now on the texts at the left of the picture are kept, those of one drawing. */
async function watchTexts(tab) {
  await tab.evaluate(() => {
    const { fillText, clearRect } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.clearRect = function (...box) {
      globalThis.texts = [];
      return clearRect.apply(this, box);
    };
    CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
      if (this.textAlign === 'left')
        globalThis.texts.push(text);
      return fillText.call(this, text, ...place);
    };
  });
  await tab.keyboard.press('t');
  await tab.keyboard.press('t');
  await frame(tab);
}
const drawnTexts = tab => tab.evaluate(() => globalThis.texts);
const inAddress = (tab, word) => tab.waitForFunction(w => location.hash.includes(w), word);

/** The order of the document: moves in the world, turns of the object, moves of the object, turns in the world. */
const operations = [['World Translation', false, ['axis', 'plane'], 'ワールド座標系での移動'],
  ['Model Rotation', true, ['ring'], 'ローカル座標系での回転'],
  ['Model Translation', true, ['axis', 'plane'], 'ローカル座標系での移動'],
  ['World Rotation', false, ['ring'], 'ワールド座標系での回転'], ['World Translation', false, ['axis', 'plane'], '']];

test('with the exercise\'s clicks, each click on a key is the next operation, and only its handles are there', async () => {
  const { tab, problems } = await exercise('scene=1');
  const box = await tab.locator('canvas.space').boundingBox(), at = (await data(tab, 'keys'))[2];
  await watchTexts(tab);
  await tab.locator('[data-field=clicks]').check();
  await inAddress(tab, 'clicks=1');
  for (const [name, local, kinds] of operations) {
    await tab.mouse.click(box.x + at.x, box.y + at.y);
    await frame(tab);
    assert.ok((await drawnTexts(tab)).includes(name), `${name}: ${await drawnTexts(tab)}`);
    assert.equal(await tab.isChecked('[data-field=local]'), local, name);
    const shown = Object.keys(await data(tab, 'grips'));
    assert.deepEqual(shown.toSorted(), kinds.flatMap(kind => [0, 1, 2].map(axis => `${kind} ${axis}`)), name);
  }
  await tab.mouse.click(box.x + at.x, box.y + at.y);
  await frame(tab);
  const other = (await data(tab, 'keys'))[4];
  await tab.mouse.click(box.x + other.x, box.y + other.y);
  await frame(tab);
  assert.ok((await drawnTexts(tab)).includes('Model Rotation'), `another key: ${await drawnTexts(tab)}`);
  await inAddress(tab, 'turns=1');
  assert.deepEqual(problems, []);
  await tab.close();
});

test('each operation moves or turns the key along its own axes or those of the world', async () => {
  for (const [turns, local] of [[0, 0], [1, 1], [0, 1], [1, 0]]) {
    const { tab } = await exercise(
      `scene=1&time=3&orientation=quat&selected=3&clicks=1&turns=${turns}&local=${local}&program=0`);
    const before = await placement(tab);
    await byMouse(tab, await gripOf(tab, `${turns ? 'ring' : 'axis'} 0`), 25, 12);
    await frame(tab);
    const now = await placement(tab), along = local ? before.turn[0] : [1, 0, 0];
    const by = turns ? axisOf(before.turn, now.turn) : now.at.map((x, i) => x - before.at[i]);
    const length = Math.hypot(...by), inner = by.reduce((sum, x, i) => sum + x * along[i], 0);
    assert.ok(length > 0.05 && Math.abs(Math.abs(inner) - length) < 1e-5, `${turns} ${local}: ${by}, ${along}`);
    await tab.close();
  }
});

test('m switches the clicks on and is the next operation; in a turn, the arrow keys turn', async () => {
  const { tab } = await exercise('scene=1&selected=5');
  await watchTexts(tab);
  const texts = [];
  for (let i = 0; i < 5; i++) {
    await tab.keyboard.press('m');
    await frame(tab);
    texts.push((await drawnTexts(tab)).at(-1));
  }
  assert.deepEqual(texts, operations.map(([name]) => name));
  await tab.keyboard.press('m');
  await tab.focus('canvas.space');
  await tab.keyboard.press('ArrowLeft');
  await frame(tab);
  assert.deepEqual([await value(tab, 5, 'x'), await value(tab, 5, 'yaw')], [1.5, 5]);
  await tab.keyboard.press('m');
  await tab.keyboard.press('ArrowRight');
  await frame(tab);
  assert.ok(Math.abs(Math.hypot(await value(tab, 5, 'x') - 1.5, await value(tab, 5, 'z')) - 0.1) < 2e-3);
  await tab.close();
});

test('the picture has the texts of the program: its mode, methods, operation, time', async () => {
  const { tab } = await exercise('scene=1');
  await watchTexts(tab);
  assert.deepEqual(await drawnTexts(tab), ['Layout Mode', 'Position: Linear, Orientation: Euler']);
  const words = [];
  for (const key of ['p', 'p', 'p', 'o']) {
    await tab.keyboard.press(key);
    await frame(tab);
    words.push((await drawnTexts(tab))[1]);
  }
  assert.deepEqual(words, ['Position: Hermit, Orientation: Euler', 'Position: Bezier, Orientation: Euler',
    'Position: B-Spline, Orientation: Euler', 'Position: B-Spline, Orientation: Quat']);
  await tab.keyboard.press(' ');
  await frame(tab);
  const [mode, methods, time] = await drawnTexts(tab);
  assert.deepEqual([mode, methods], ['Animation Mode', 'Position: B-Spline, Orientation: Quat']);
  assert.match(time, /^Time: \d\.\d\d$/);
  await tab.close();
  const normal = await exercise('scene=1&view=plain&clicks=1');
  await watchTexts(normal.tab);
  assert.deepEqual(await drawnTexts(normal.tab), ['Layout Mode', 'World Translation']);
  await normal.tab.close();
});

test('in Japanese, the operations have the words of the document too', async () => {
  const { tab } = await start('exercise?lang=ja&scene=1&selected=2&clicks=1');
  await watchTexts(tab);
  for (const [name, , , words] of operations.slice(0, 4)) {
    assert.equal((await drawnTexts(tab)).at(-1), `${name}（${words}）`);
    await tab.keyboard.press('m');
    await frame(tab);
  }
  await tab.close();
});

test('two fingers that part bring the camera closer', async () => {
  const { tab, field } = await exercise('scene=1', { hasTouch: true });
  const { x, y } = await tab.locator('canvas.space').boundingBox(), distance = Number(await field('distance'));
  const session = await tab.context().newCDPSession(tab);
  const send = (type, points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
  const finger = (id, dx) => ({ x: x + 100 + dx, y: y + 30, id });
  await send('touchStart', [finger(0, 0)]);
  await send('touchStart', [finger(0, 0), finger(1, 60)]);
  await send('touchMove', [finger(0, 0), finger(1, 110)]);
  await send('touchEnd', []);
  await frame(tab);
  assert.ok(Math.abs(Number(await field('distance')) - (distance - 1)) < 1e-3, await field('distance'));
  await tab.close();
});

/* ---- times and layouts ---- */

test('a time is edited, and one that does not ascend is refused', async () => {
  const { tab } = await exercise('scene=1&time=3.25&position=hermite');
  await cell(tab, 4, 'time').fill('4.5');
  await cell(tab, 4, 'time').press('Enter');
  await frame(tab);
  assert.match(await text(tab, '.place'), /\(3\.25 − 3\) \/ \(4\.5 − 3\)/);
  assert.ok(Math.abs((await shown(tab))['t.0'] - 0.25 / 1.5) < 1e-6);
  await cell(tab, 4, 'time').fill('2');
  await cell(tab, 4, 'time').press('Enter');
  await frame(tab);
  assert.equal(await cell(tab, 4, 'time').getAttribute('aria-invalid'), 'true');
  assert.match(await text(tab, '.keys-message'), /refused/);
  assert.ok(Math.abs((await shown(tab))['t.0'] - 0.25 / 1.5) < 1e-6);
  await tab.close();
});

/** Presses Save, and returns the file's place. */
async function saved(tab, folder) {
  const [download] = await Promise.all([tab.waitForEvent('download'),
    tab.getByRole('button', { name: 'Save', exact: true }).click()]);
  await download.saveAs(`${folder}/layout.json`);
  return `${folder}/layout.json`;
}

test('a changed layout is saved, loaded again, and read by the command with the same numbers', async t => {
  const { tab } = await exercise('scene=6&position=hermite&orientation=quat');
  const folder = mkdtempSync(`${tmpdir()}/nakawari-`);
  try {
    await cell(tab, 1, 'x').fill('-1.25');
    await cell(tab, 1, 'x').press('Enter');
    await cell(tab, 2, 'time').fill('2.5');
    await cell(tab, 2, 'time').press('Enter');
    await frame(tab);
    const file = await saved(tab, folder);
    const keys = () => tab.$$eval('[data-column]', list => list.map(input => input.value));
    const before = await keys();
    await tab.keyboard.press('Escape');
    await tab.locator('h1').click();
    await tab.keyboard.press('1');
    await frame(tab);
    assert.notDeepEqual(await keys(), before);
    await tab.setInputFiles('[data-field=load]', file);
    await tab.waitForFunction(list => [...document.querySelectorAll('[data-column]')].map(i => i.value).join() === list,
      before.join());
    assert.equal(JSON.parse(readFileSync(file, 'utf8')).scene6[1].pos[0], -1.25);
    if (!process.env.NKW_COMMAND)
      return t.diagnostic('the command is not built: it did not read the layout');
    const said = execFileSync(process.env.NKW_COMMAND,
      ['exercise', file, '--trace', '1.5', '--position', 'hermite', '--orientation', 'quat'], { encoding: 'utf8' });
    const [point] = await matrices(tab, [1.5]), [, list] = said.match(/^ {2}p = \((.*)\)$/m);
    assert.deepEqual(list.split(', ').map(x => Math.fround(x)), point.slice(12, 15));
  } finally {
    rmSync(folder, { recursive: true });
    await tab.close();
  }
});

test('a table of the command is read, and a wrong file is refused with a reason', async () => {
  const { tab } = await exercise('scene=1');
  await tab.setInputFiles('[data-field=load]', `${root}/docs/examples/flight.csv`);
  await tab.waitForFunction(() => document.querySelectorAll('[data-column=x]').length === 10);
  const buffer = Buffer.from('{"s": [{}]}');
  await tab.setInputFiles('[data-field=load]', { name: 'a.json', mimeType: 'application/json', buffer });
  await tab.waitForFunction(() => /a\.json: .*no time or position/.test(document.querySelector('.layout').textContent));
  assert.equal(await count(tab), 10);
  await tab.close();
});

/* ---- a model in place of the dart ---- */

const example = name => ({ name, text: readFileSync(`${root}/docs/examples/${name}`, 'utf8') });
const car = [example('car.obj'), example('car.mtl')];

/** Drops files on the page. */
const dropFiles = (tab, files) => tab.evaluate(list => {
  const dataTransfer = new DataTransfer();
  list.forEach(({ name, text }) => dataTransfer.items.add(new File([text], name)));
  document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
}, files);

const saysOf = (tab, words) => tab.waitForFunction(w => document.querySelector('.layout').textContent.includes(w), words);

/** The triangles of an .obj with their materials, read here: v, usemtl and f only. */
function trianglesIn(text) {
  const points = [], list = [];
  let material = '';
  for (const [word, ...rest] of text.split('\n').map(line => line.split(' ')))
    if (word === 'v')
      points.push(rest.map(Number));
    else if (word === 'usemtl')
      [material] = rest;
    else if (word === 'f')
      rest.slice(2).forEach((_, i) => list.push({ material, at: [rest[0], rest[i + 1], rest[i + 2]].map(k => points[k - 1]) }));
  return list;
}

const minus = (a, b) => a.map((x, i) => x - b[i]);
const inner = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const outer = (a, b) => [0, 1, 2].map(i => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);

/** The material of the front that a ray meets first; '' for none (Moeller, Trumbore). */
function met(triangles, from, way) {
  let least = Infinity, material = '';
  for (const { material: own, at: [a, b, c] } of triangles) {
    const [u, v, w] = [minus(b, a), minus(c, a), minus(from, a)], p = outer(way, v), q = outer(w, u), det = inner(u, p);
    const [x, y, t] = [inner(w, p) / det, inner(way, q) / det, inner(v, q) / det];
    if (det > 0 && Math.min(x, y, 1 - x - y) >= 0 && t < least)
      [least, material] = [t, own];
  }
  return material;
}

/** From the eye to the world: the camera of kit/eye.ts, T(0, 0, -distance) Rx(-pitch) Ry(-yaw) T(-aim). */
function toWorld([yaw, pitch], [x, y, z]) {
  const [a, b] = [yaw, pitch].map(d => d * Math.PI / 180), { sin, cos } = Math;
  const [y1, z1] = [cos(b) * y - sin(b) * z, sin(b) * y + cos(b) * z];
  return [cos(a) * x + sin(a) * z1, y1, -sin(a) * x + cos(a) * z1];
}

const isOf = {
  paint: ([r, g, b]) => r > 1.8 * g && r > 1.8 * b, glass: ([r, g, b]) => b > 1.3 * r && b > g,
  tyre: rgb => Math.max(...rgb) < 70, lamp: ([r, g, b]) => r > 1.8 * b && g > 1.5 * b,
};

/** At 0.5 s the object is at the aim, not turned; its keys are far away. */
const alone = 'keys=0_-50_0.5_0_0_0_0_1_1_50_0.5_0_0_0_0_1&time=0.5&view=plain&aim=0_0.5_0';

/** The colours of the middle of the picture on white, every 6 pixels, and its size. */
const middle = tab => tab.evaluate(() => {
  const canvas = document.querySelector('canvas.space'), { width, height } = canvas, list = [];
  const { data: all } = canvas.getContext('2d').getImageData(0, 0, width, height);
  for (let y = Math.round(height / 2) - 150; y < height / 2 + 150; y += 6)
    for (let x = Math.round(width / 2) - 150; x < width / 2 + 150; x += 6)
      list.push({ x: x + 0.5, y: y + 0.5, rgba: [...all.slice(4 * (width * y + x), 4 * (width * y + x) + 4)] });
  const onWhite = ([r, g, b, a]) => [r, g, b].map(c => 255 + (c - 255) * a / 255);
  return { width, height, list: list.map(({ x, y, rgba }) => ({ x, y, rgb: onWhite(rgba) })) };
});

test('a dropped car is drawn in place of the dart: from each eye, at each pixel its nearest face', async t => {
  const all = trianglesIn(car[0].text), points = all.flatMap(({ at }) => at);
  const box = [0, 1, 2].map(i => [Math.min(...points.map(p => p[i])), Math.max(...points.map(p => p[i]))]);
  const side = Math.max(...box.map(([low, high]) => high - low));
  const triangles = all.map(({ material, at }) => ({ material,
    at: at.map(p => p.map((x, i) => (x - (box[i][0] + box[i][1]) / 2) / side + (i === 1 ? 0.5 : 0))) }));
  const seen = new Map();
  for (const camera of [[200, -30], [150, -10], [20, -60], [300, 20], [180, -5], [0, -90]]) {
    const { tab, problems } = await exercise(`${alone}&yaw=${camera[0]}&pitch=${camera[1]}&distance=2&fov=45`);
    await dropFiles(tab, car);
    await saysOf(tab, `car.obj: ${all.length} triangles`);
    await frame(tab);
    const { width, height, list } = await middle(tab), scale = Math.min(width, height) / 2 / Math.tan(Math.PI / 8);
    const from = toWorld(camera, [0, 0, 2]).map((x, i) => x + (i === 1 ? 0.5 : 0));
    for (const { x, y, rgb } of list) {
      const around = [[0, 0], [2, 0], [-2, 0], [0, 2], [0, -2]].map(([dx, dy]) => met(triangles, from,
        toWorld(camera, [(x + dx - width / 2) / scale, (height / 2 - y - dy) / scale, -1])));
      if (new Set(around).size > 1)
        continue; // an edge
      const [material] = around;
      if (material)
        assert.ok(isOf[material](rgb), `${camera} at ${x} ${y}: ${rgb}, not ${material}`);
      else if (!isOf.tyre(rgb)) // a shadow is as dark
        assert.ok(!Object.values(isOf).some(is => is(rgb)), `${camera} at ${x} ${y}: ${rgb}, not the floor`);
      seen.set(material, (seen.get(material) ?? 0) + 1);
    }
    assert.deepEqual(problems, []);
    await tab.close();
  }
  for (const material of Object.keys(isOf))
    assert.ok(seen.get(material) > 5, `${material}: ${seen.get(material)}`);
  t.diagnostic(JSON.stringify([...seen]));
});

test('a model is chosen by Load, kept when the language changes, and left for the dart by the keyboard', async () => {
  const { tab, problems } = await exercise('scene=1');
  await tab.setInputFiles('[data-field=load]', `${root}/docs/examples/car.obj`);
  await saysOf(tab, 'Its colours are in car.mtl: choose both files.');
  await tab.setInputFiles('[data-field=load]', ['car.obj', 'car.mtl'].map(name => `${root}/docs/examples/${name}`));
  await tab.waitForFunction(() => /^car\.obj: \d+ triangles\. ?The dart/.test(document.querySelector('.layout').textContent));
  await tab.getByRole('button', { name: '日本語' }).click();
  await saysOf(tab, 'car.obj：三角形');
  await tab.getByRole('button', { name: '元の物体に戻す' }).focus();
  await tab.keyboard.press('Enter');
  await tab.waitForFunction(() => document.querySelector('.layout').textContent.trim() === '');
  assert.deepEqual(problems, []);
  await tab.close();
});

test('files that are no model are refused with a reason, in both languages; what is shown stays', async () => {
  const corners = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n', wrong = [
    [[{ name: 'a.obj', text: `${corners}f 1 2 4\n` }], 'a.obj: line 4: vertex 4 does not exist: there are 3'],
    [[{ name: 'a.obj', text: `${corners}f 1 2\n` }], 'a.obj: line 4: a face has three corners or more'],
    [[{ name: 'a.obj', text: 'v 1 two 3\n' }], 'a.obj: line 1: three numbers are expected'],
    [[{ name: 'a.obj', text: 'not a model' }], 'a.obj: no faces'],
    [[{ name: 'a.obj', text: 'v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n' }], 'a.obj: its faces have no size'],
    [[{ name: 'a.obj', text: corners + 'f 1 2 3\n'.repeat(4001) }], 'a.obj: 4001 triangles; at most 4000 are drawn'],
    [[car[1]], 'car.mtl: a file .mtl is chosen together with its .obj'],
    [[{ name: 'a.txt', text: 'x' }], 'a.txt: neither a scene of keys nor a table of keys nor a model'],
  ];
  const { tab, problems } = await exercise('scene=1');
  for (const [files, words] of wrong) {
    await dropFiles(tab, files);
    await saysOf(tab, words);
  }
  await dropFiles(tab, [example('flight.csv')]);
  await tab.waitForFunction(() => document.querySelectorAll('[data-column=x]').length === 10);
  assert.deepEqual(problems, []);
  await tab.close();
  const { tab: japanese } = await start('exercise?lang=ja&scene=1');
  await dropFiles(japanese, wrong[0][0]);
  await saysOf(japanese, '4 行目：頂点 4 はありません（3 個）');
  await japanese.close();
});
