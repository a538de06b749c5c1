// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { axe, close, long, open, printed, shown } from './models.mjs';

after(close);
const drawn = tab => tab.waitForSelector('[data-name="position.2"]', { timeout: 60000 });

test('the C program prints the matrix of the page, of each clip and of all three', long, async () => {
  for (const [clip, character] of [['walk', 0], ['wave', 33], ['hop', 5], ['mixed', 36]]) {
    const { tab, problems } = await open(`crowd?count=37&clip=${clip}&character=${character}&joint=9&time=3.7`);
    await drawn(tab);
    const numbers = await shown(tab);
    assert.equal(Object.keys(numbers).length, 13);
    assert.deepEqual(await printed(tab), numbers, clip);
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test('both ways are measured, and their matrices agree', async t => {
  const { tab, problems } = await open('crowd?count=200&time=1');
  await drawn(tab);
  await tab.evaluate(() => { location.hash = '#crowd?count=200&time=1&by=mixer'; });
  await tab.waitForFunction(() => document.querySelector('[data-cost="mixer.frames"]')?.textContent !== '0');
  const difference = Number((await tab.textContent('[data-difference]')).split(': ')[1]);
  assert.ok(difference < 1e-4, `${difference}`);
  assert.match(await tab.textContent('.verdict'), /^Not measured yet/);
  await tab.getByRole('button', { name: 'Measure both' }).click();
  await tab.waitForFunction(() => Number(document.querySelector('[data-cost="mixer.frames"]').textContent) === 60);
  assert.match(await tab.textContent('.verdict'), /^In this browser, a character takes [\d.]+ µs by Crowd/);
  const [crowd, mixer] = await Promise.all(['crowd', 'mixer'].map(by => tab.textContent(`[data-cost="${by}.each"]`)));
  assert.ok(Number(crowd) < Number(mixer), `${crowd} ${mixer}`);
  t.diagnostic(`microseconds a character: Crowd ${crowd}, AnimationMixer ${mixer}; difference ${difference}`);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('characters are drawn: pixels differ from the background, and from another time', async () => {
  const pictures = [];
  for (const time of [0, 0.5]) {
    const { tab } = await open(`crowd?count=16&distance=8&time=${time}`);
    await drawn(tab);
    pictures.push(await tab.locator('.view3').screenshot());
    await tab.close();
  }
  assert.notDeepEqual(pictures[0], pictures[1]);
});

test('axe, in both languages', async () => {
  for (const lang of ['en', 'ja']) {
    const { tab } = await open(`crowd?lang=${lang}&count=9`);
    await drawn(tab);
    assert.deepEqual(await axe(tab), []);
    await tab.close();
  }
});
