// SPDX-License-Identifier: MIT
// node browser.mjs FILE: starts the Chromium that all tests of the page share. FILE has its address while it runs; it
// ends when FILE is removed, or after half an hour.
import { spawn } from 'node:child_process';
import { existsSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { setTimeout as wait } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';

const [file, serve] = process.argv.slice(2), { NKW_BUILD: build, NKW_CHROMIUM: chromium } = process.env;

/** Waits until `done` is true; false after so many seconds. */
async function until(seconds, done) {
  for (const end = Date.now() + 1000 * seconds; Date.now() < end && !done();)
    await wait(100);
  return done();
}

if (serve) {
  // Without a GPU, pages are painted by the processor and WebGL by SwiftShader.
  const server = await createRequire(`${build}/`)('playwright-core').chromium.launchServer({
    executablePath: chromium, args: ['--no-sandbox', '--disable-gpu', '--enable-unsafe-swiftshader'] });
  writeFileSync(`${file}.new`, server.wsEndpoint());
  renameSync(`${file}.new`, file);
  await until(1800, () => !existsSync(file));
  rmSync(file, { force: true });
  await server.close();
} else {
  rmSync(file, { force: true });
  spawn(process.execPath, [fileURLToPath(import.meta.url), file, 'serve'], { detached: true, stdio: 'ignore' }).unref();
  if (!await until(60, () => existsSync(file)))
    throw new Error('Chromium has not started');
}
