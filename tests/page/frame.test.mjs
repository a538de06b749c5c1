// SPDX-License-Identifier: MIT
// The frame of the page: from a server, the first picture, back and forward, languages, colours, addresses.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { after, before, test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { blank, close, drawn, open, page, shown, url } from './models.mjs';

const types = { html: 'text/html', css: 'text/css', js: 'text/javascript' }, asked = [];
const policy = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; font-src data:; " +
  "script-src 'self' 'wasm-unsafe-eval'";
const server = createServer((request, response) => {
  const name = request.url === '/' ? 'index.html' : request.url.slice(1);
  asked.push(name);
  try {
    const body = gzipSync(readFileSync(`${page}/${name}`));
    response.writeHead(200, { 'content-type': types[name.split('.').pop()], 'content-encoding': 'gzip',
      'content-security-policy': policy });
    response.end(body);
  } catch {
    response.writeHead(404).end();
  }
});
before(() => new Promise(done => { server.listen(0, '127.0.0.1', done); }));
after(() => server.close());
after(close);
const site = address => `http://127.0.0.1:${server.address().port}/#${address}`;

test('from a server, the numbers are those of the file', async () => {
  for (const address of ['exercise?time=0.75', 'keys?time=0.75']) {
    const { tab, problems } = await blank();
    await tab.goto(site(address));
    await drawn(tab);
    const { tab: same } = await open(address);
    await drawn(same);
    assert.deepEqual(await shown(tab), await shown(same));
    assert.deepEqual(problems, []);
    await Promise.all([tab.close(), same.close()]);
  }
});

test('the first picture needs the first script and the part math alone', async t => {
  const { tab } = await blank();
  await tab.addInitScript(() => new MutationObserver((_, observer) => {
    if (document.querySelector('main[data-drawn]')) {
      observer.disconnect();
      performance.mark('drawn');
      globalThis.early = [...document.scripts].map(script => script.src.split('/').pop());
    }
  }).observe(document, { subtree: true, childList: true, attributes: true }));
  asked.length = 0;
  await tab.goto(site(''));
  await drawn(tab);
  assert.deepEqual(await tab.evaluate(() => globalThis.early), ['wasm-math.js']); // page.js has left the document;
  await tab.waitForFunction(() => [...document.scripts].some(script => script.src.endsWith('/wasm-all.js')));
  const times = await tab.evaluate(() => ['first-contentful-paint', 'drawn'].map(name =>
    `${name} ${performance.getEntriesByName(name)[0]?.startTime.toFixed(0)} ms`));
  t.diagnostic(`${times.join(', ')}; ${asked.filter(name => name !== 'favicon.ico').join(' ')}`);
  await tab.close();
});

test('back and forward show the state that was left', async () => {
  const { tab, problems } = await open('exercise?lang=en');
  await drawn(tab);
  await tab.keyboard.press('2');
  await tab.waitForFunction(() => location.hash.includes('scene=2'));
  const scene = await shown(tab);
  await tab.click('nav [data-exhibit="keys"]');
  await drawn(tab, 'keys');
  await tab.focus('main .handle');
  await tab.keyboard.press('ArrowUp'); // the link is clicked before the address is written
  await tab.click('nav [data-exhibit="time"]');
  await drawn(tab, 'time');
  await tab.goBack();
  await drawn(tab, 'keys');
  assert.match(await tab.evaluate(() => location.hash), /^#keys\?.*keys=/);
  await tab.goBack();
  await drawn(tab, 'exercise');
  assert.deepEqual(await shown(tab), scene);
  await tab.goForward();
  await drawn(tab, 'keys');
  assert.deepEqual(problems, []);
  await tab.close();
});

test('the languages and the colours keep the state, and say which they are', async () => {
  const { tab } = await open('keys?lang=en&time=1.25');
  await drawn(tab);
  const numbers = await shown(tab);
  await tab.click('header button[lang=ja]');
  await drawn(tab);
  assert.equal(await tab.getAttribute('html', 'lang'), 'ja');
  assert.equal(await tab.getAttribute('header button[lang=ja]', 'aria-pressed'), 'true');
  assert.match(await tab.title(), /[ぁ-ん]/);
  assert.deepEqual(await shown(tab), numbers);
  const dark = tab.locator('header button:not([lang])'), paper = () => tab.evaluate(() =>
    getComputedStyle(document.body).backgroundColor);
  const before = [await dark.getAttribute('aria-pressed'), await paper()];
  await dark.click();
  assert.equal(before[0], 'false');
  assert.equal(await dark.getAttribute('aria-pressed'), 'true');
  assert.notEqual(await paper(), before[1]);
  assert.deepEqual(await shown(tab), numbers);
  await tab.close();
});

test('the skip link moves the focus and keeps the address', async () => {
  const { tab } = await open('keys?lang=en&time=1.25');
  await drawn(tab);
  const address = tab.url();
  await tab.keyboard.press('Tab');
  assert.ok(await tab.evaluate(() => document.activeElement.matches('.skip')));
  await tab.keyboard.press('Enter');
  assert.equal(await tab.evaluate(() => document.activeElement.id), 'stage');
  assert.equal(tab.url(), address);
  await tab.close();
});

test('addresses that are none open an exhibit', async () => {
  const { tab, problems } = await blank();
  for (const address of ['nothing', 'keys?time=x&scene=%', 'exercise?scene=99&time=-5', '%', 'keys?lang=fr', '?']) {
    await tab.goto('about:blank');
    await tab.goto(url(address));
    await drawn(tab);
  }
  assert.deepEqual(problems, []);
  await tab.close();
});
