// SPDX-License-Identifier: MIT
// Every exhibit of the page: it opens in both languages from a file, its numbers are those of C, axe and the console
// have nothing to say, and its frames are short.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { axe, close, open, printed, shown } from './models.mjs';

after(close);
const drawn = tab => tab.waitForSelector('main[data-drawn]:not(:has([data-loading]))', { state: 'attached', timeout: 60000 });
const { tab: first } = await open('');
await drawn(first);
const ids = await first.$$eval('[data-exhibit]', links => [...new Set(links.map(a => a.dataset.exhibit))]);
await first.close();
const own = ['crowd', 'file']; // they have tests of their own, and need three.js

test('there are exhibits', () => assert.ok(ids.length >= 3, `${ids}`));

for (const id of ids.filter(name => !own.includes(name))) {
  test(`${id}: the copied C prints the numbers of the page`, async () => {
    const { tab, problems } = await open(`${id}?time=0.75`);
    await drawn(tab);
    const numbers = await shown(tab);
    assert.ok(Object.keys(numbers).length > 0);
    const of = await printed(tab);
    for (const [name, value] of Object.entries(numbers))
      assert.ok(Object.is(of[name], value), `${name}: ${value}, C prints ${of[name]}`);
    assert.deepEqual(problems, []);
    await tab.close();
  });

  for (const [lang, colorScheme, viewport] of [['en', 'light', { width: 1280, height: 800 }],
    ['ja', 'dark', { width: 390, height: 844 }]])
    test(`${id}: axe, ${lang}, ${colorScheme}, ${viewport.width} pixels wide`, async () => {
      const { tab, problems } = await open(`${id}?lang=${lang}`, { colorScheme, viewport });
      await drawn(tab);
      assert.equal(await tab.getAttribute('html', 'lang'), lang);
      assert.deepEqual(await axe(tab), []);
      assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'it scrolls sideways');
      assert.deepEqual(problems, []);
      await tab.close();
    });

  test(`${id}: the keyboard alone reaches every control`, async () => {
    const { tab } = await open(id);
    await drawn(tab);
    const wanted = await tab.$$eval('main button, main select, main input, main canvas[tabindex]', list =>
      list.filter(e => e.checkVisibility() && e.tabIndex >= 0 && !e.disabled).length);
    await tab.evaluate(() => document.querySelector('.skip').focus());
    const reached = await tab.evaluate(() => [...document.querySelectorAll('main button, main select, main input, ' +
      'main canvas[tabindex]')].filter(e => { e.focus(); return document.activeElement === e; }).length);
    assert.ok(reached >= wanted && wanted > 0, `${reached} of ${wanted}`);
    await tab.close();
  });

  test(`${id}: a frame takes less than a sixtieth of a second`, async t => {
    const { tab } = await open(id);
    await drawn(tab);
    if (await tab.$('.play'))
      await tab.click('.play');
    else
      await tab.evaluate(() => { // a drawing in each frame
        const again = () => { dispatchEvent(new Event('colours')); requestAnimationFrame(again); };
        again();
      });
    await tab.waitForTimeout(1500);
    const work = await tab.evaluate(() => [...globalThis.nakawariWork].sort((a, b) => a - b));
    const median = work[work.length >> 1];
    t.diagnostic(`${work.length} frames, median ${median.toFixed(1)} ms, longest ${work.at(-1).toFixed(1)} ms`);
    assert.ok(median < 1000 / 60, `${median}`);
    await tab.close();
  });
}
