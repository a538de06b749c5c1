// SPDX-License-Identifier: MIT
// node browser.mjs CHROMIUM: the golden hashes in a browser without a window. A page of a local server compares them
// and posts the result.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';

const { NKW_PACKAGE, NKW_ROOT } = process.env;
const page = `<!doctype html><meta charset="utf-8"><script type="module">
try {
  const [{ compareGolden }, N] = await Promise.all([import('/tests/golden.mjs'), import('/package/all.js')]);
  const text = path => fetch(path).then(r => r.text());
  await N.ready;
  const result = compareGolden(N, await text('/golden/kernels.h'), await text('/golden/golden.txt'));
  await fetch('/result', { method: 'POST', body: JSON.stringify(result) });
} catch (error) {
  await fetch('/result', { method: 'POST', body: JSON.stringify({ error: String(error) }) });
}
</script>`;
const folders = { package: NKW_PACKAGE, tests: `${NKW_ROOT}/tests/wasm`, golden: `${NKW_ROOT}/tests/golden` };

const profile = mkdtempSync(`${tmpdir()}/nakawari-`);
let browser;
async function end(result) {
  console.log(JSON.stringify(result));
  browser.kill('SIGKILL');
  await new Promise(resolve => browser.exitCode === null && browser.signalCode === null && browser.pid
    ? browser.once('exit', resolve) : resolve());
  try { // children of the browser may write for a moment
    rmSync(profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
  } catch (error) {
    console.log(String(error));
  }
  process.exit(result.rows >= 241 && result.different.length === 0 && result.build === 'simd128' ? 0 : 1);
}

const server = createServer((request, response) => {
  const [, folder, ...path] = request.url.split('/');
  if (request.method === 'POST') {
    let body = '';
    request.on('data', part => { body += part; }).on('end', () => { response.end(); end(JSON.parse(body)); });
  } else if (folder === '') {
    response.setHeader('content-type', 'text/html').end(page);
  } else if (folders[folder] && !path.includes('..')) {
    response.setHeader('content-type', /js$/.test(request.url) ? 'text/javascript' : 'text/plain');
    response.end(readFileSync(`${folders[folder]}/${path.join('/')}`));
  } else {
    response.writeHead(404).end();
  }
});
server.listen(0, '127.0.0.1', () => {
  browser = spawn(process.argv[2], ['--headless', '--no-sandbox', '--disable-gpu', '--no-first-run',
    `--user-data-dir=${profile}`, `http://127.0.0.1:${server.address().port}/`], { stdio: 'ignore' });
  browser.on('error', error => end({ error: String(error), different: [] }));
});
