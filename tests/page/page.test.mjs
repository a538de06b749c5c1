// SPDX-License-Identifier: MIT
// Every exhibit of the page. With a mouse and a keyboard: its numbers are those of C, axe and the console have nothing
// to say, nothing is cut at four sizes of the window, the keyboard alone opens, changes and plays it. With a finger: it
// opens, is dragged, and nothing moves by itself.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { moveByArrows, seen, state } from './arrows.mjs';
import { axe, close, drawn as drawnOnce, frames, open, printed, shown, touchDrag, url } from './models.mjs';

after(close);
const { tab: first } = await open('');
await drawnOnce(first);
const ids = await first.$$eval('nav [data-exhibit]', links => links.map(a => a.dataset.exhibit));
await first.close();
const other = id => ids.find(name => name !== id);
const addresses = { crowd: 'crowd?count=64&', file: 'file?' };

/** Also waits for what three.js shows. */
async function drawn(tab, id) {
  await drawnOnce(tab, id);
  if (id in addresses)
    await tab.waitForSelector('main [data-value]', { timeout: 60000 });
}

test('there are thirteen exhibits', () => assert.equal(ids.length, 13));

const changed = (tab, before) => tab.waitForFunction(`${state} !== ${JSON.stringify(before)}`);

/** Presses Tab until the focus is on an element that matches; returns the number of presses, or -1 after 120. */
async function tabTo(tab, selector) {
  for (let presses = 1; presses <= 120; presses++) {
    await tab.keyboard.press('Tab');
    if (await tab.evaluate(s => document.activeElement.matches(s), selector))
      return presses;
  }
  return -1;
}

const controls = 'main button, main select, main input, main canvas[tabindex]';
/** The controls that Tab does not reach. */
async function unreached(tab) {
  await tab.evaluate(list => {
    document.querySelector('h1').focus();
    globalThis.missed = new Set([...document.querySelectorAll(list)].filter(e => e.checkVisibility() &&
      e.tabIndex >= 0 && !e.disabled && getComputedStyle(e).visibility !== 'hidden'));
    document.addEventListener('focusin', event => globalThis.missed.delete(event.target));
  }, controls);
  const count = await tab.evaluate(() => globalThis.missed.size);
  for (let i = 0; i < 3 * count + 10 && await tab.evaluate(() => globalThis.missed.size > 0); i++)
    await tab.keyboard.press('Tab');
  return tab.evaluate(() => [...globalThis.missed].map(e => e.outerHTML));
}

/** What is cut, covered or too wide. */
const faults = tab => tab.evaluate(() => {
  const box = selector => document.querySelector(selector).getBoundingClientRect(), list = [];
  if (document.documentElement.scrollWidth > innerWidth)
    list.push(`it scrolls sideways: ${document.documentElement.scrollWidth}`);
  for (const part of ['main', '#stage', '.side'])
    if (box(part).bottom > box('footer').top + 0.5)
      list.push(`${part} is over the footer`);
  document.querySelector('.play')?.scrollIntoView({ block: 'nearest' });
  if (document.querySelector('.play')) {
    const { x, y, width, height } = box('.play'), top = document.elementFromPoint(x + width / 2, y + height / 2);
    if (!top?.matches('.play'))
      list.push(`the play button is under ${top?.className}`);
  }
  scrollTo(0, 0);
  return list;
});

for (const id of ids)
  test(`${id}: with a mouse and a keyboard`, async t => {
    const { tab, problems } = await open(`${addresses[id] ?? `${id}?`}lang=en&time=0.75`);
    await drawn(tab, id);
    await t.test(`${id}: the copied C prints the numbers of the page`, async () => {
      const of = await printed(tab);
      const numbers = Object.entries(await shown(tab)).filter(([name]) => !/^bytes_/.test(name));
      assert.ok(numbers.length > 0);
      for (const [name, value] of numbers)
        assert.ok(Object.is(of[name], value), `${name}: ${value}, C prints ${of[name]}`);
    });
    await t.test(`${id}: axe, en, light, 1280 pixels wide`, async () => assert.deepEqual(await axe(tab), []));
    await t.test(`${id}: nothing is cut or covered`, async () => {
      for (const [width, height] of [[1920, 1080], [390, 844], [320, 640], [1280, 720]]) {
        await tab.setViewportSize({ width, height });
        await frames(tab, 2);
        assert.deepEqual(await faults(tab), [], `${width} x ${height}`);
      }
    });
    await t.test(`${id}: the keyboard alone opens it and reaches every control`, async () => {
      await tab.goto('about:blank');
      await tab.goto(url(`${other(id)}?lang=en`));
      await drawn(tab);
      assert.ok(await tabTo(tab, `nav [data-exhibit="${id}"]`) > 0);
      await tab.keyboard.press('Enter');
      await drawn(tab, id);
      assert.equal(await tab.evaluate(() => document.activeElement.tagName), 'H1');
      assert.deepEqual(await unreached(tab), []);
      if (id in addresses) { // fewer characters, which SwiftShader draws
        await tab.goto(url(`${addresses[id]}lang=en`));
        await drawn(tab, id);
      }
    });
    await t.test(`${id}: the keyboard alone changes it`, async () => assert.ok(await moveByArrows(tab)));
    await t.test(`${id}: it plays by the keyboard, if it plays`, async () => {
      if (!await tab.$('.play'))
        return;
      await tab.evaluate(() => document.querySelector('h1').focus());
      assert.ok(await tabTo(tab, '.play') > 0);
      const time = await tab.inputValue('.time');
      await tab.keyboard.press('Space');
      await tab.waitForFunction(before => document.querySelector('.time').value !== before, time);
    });
    assert.deepEqual(problems, []);
    await tab.close();
  });

for (const id of ids)
  test(`${id}: with a finger, in Japanese, dark, with reduced motion`, async t => {
    const { tab, problems } = await open(`${other(id)}?lang=ja`, { colorScheme: 'dark',
      viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, reducedMotion: 'reduce' });
    await drawn(tab);
    await t.test(`${id}: a tap opens it`, async () => {
      await tab.tap('nav summary');
      await tab.tap(`nav [data-exhibit="${id}"]`);
      await drawn(tab, id);
      assert.equal(await tab.$eval('nav details', e => e.open), false);
    });
    await t.test(`${id}: nothing moves by itself`, async () => {
      const picture = () => tab.evaluate(() => [[...document.querySelectorAll('canvas')].map(c => c.toDataURL()),
        document.getAnimations().length, document.querySelector('.time')?.value]);
      await frames(tab, 3);
      const before = [await picture(), await seen(tab)];
      await tab.evaluate(() => new Promise(resolve => { setTimeout(resolve, 500); }));
      assert.deepEqual([await picture(), await seen(tab)], before);
    });
    await t.test(`${id}: axe, ja, dark, 390 pixels wide`, async () => {
      assert.equal(await tab.getAttribute('html', 'lang'), 'ja');
      assert.deepEqual(await axe(tab), []);
    });
    await t.test(`${id}: a finger drags a handle`, async d => {
      const handle = await tab.$('main .handle');
      if (!handle)
        return d.skip('it has no handle');
      await handle.scrollIntoViewIfNeeded();
      const before = await seen(tab);
      await touchDrag(tab, handle, [[6, 4], [14, 10], [24, 18]]);
      await changed(tab, before);
    });
    assert.deepEqual(problems, []);
    await tab.close();
  });
