// SPDX-License-Identifier: MIT
// Blend and change: the velocity at the beginning of the change, and a drag of the new motion.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { close, open, shown } from './models.mjs';

after(close);
const numbers = async query => {
  const { tab } = await open(`blend?${query}`);
  await tab.waitForSelector('main[data-drawn]', { state: 'attached' });
  return { tab, n: await shown(tab) };
};
const near = (a, b, error = 1e-4) => assert.ok(Math.abs(a - b) < error, `${a} ${b}`);

test('blend: inertialisation keeps the velocity at the beginning, and the cross-fade does not', async () => {
  const { tab, n } = await numbers('at=0.5&time=0.50001&duration=0.25'); // the curves at 0.5 by hand
  near(n['from.0'], 2 * 0.5 + 4 * -0.125, 1e-3); // h01 2 + h11 4
  near(n['from.1'], 2 * 1.5 + 4 * -0.25, 1e-3);
  near(n['inertia.0'], n['from.0'], 1e-3);
  near(n['inertia.1'], n['from.1'], 1e-2);
  near(n['fade.1'], n['from.1'] + (n['to.0'] - n['from.0']) / 0.25, 1e-2);
  await tab.close();
});

test('blend: both end in the new motion', async () => {
  const { tab, n } = await numbers('time=0.9');
  for (const name of ['fade', 'inertia'])
    for (const k of [0, 1])
      near(n[`${name}.${k}`], n[`to.${k}`]);
  await tab.close();
});

test('blend: a drag of an end of the new motion changes the numbers', async () => {
  const { tab, n } = await numbers('');
  await tab.hover('[data-handle="0"]'); // waits until the plot has its size
  const box = await (await tab.$('[data-handle="0"]')).boundingBox();
  await tab.mouse.down();
  await tab.mouse.move(box.x + box.width / 2, box.y + box.height / 2 + 40, { steps: 4 });
  await tab.mouse.up();
  await tab.waitForFunction(before => Number(document.querySelector('[data-name="to.0"]').dataset.value) < before, n['to.0']);
  await tab.close();
});
