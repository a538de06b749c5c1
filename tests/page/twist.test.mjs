// SPDX-License-Identifier: MIT
// Twist: the volumes against the formula of the sections, against C, and a drag in the plot.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { close, open, printed, shown } from './models.mjs';

after(close);
const drawn = tab => tab.waitForSelector('main[data-drawn]', { state: 'attached', timeout: 60000 });

// Linear blend with weights 1 - u and u multiplies a section by (1-u)^2 + u^2 + 2 u (1-u) cos angle: its mean over u.
const share = degrees => (2 + Math.cos(degrees * Math.PI / 180)) / 3;

test('volume and thickness, and the C program', async () => {
  for (const [joints, twist] of [[2, 0], [2, 90], [2, 170], [3, 170], [5, 300]]) {
    const { tab, problems } = await open(`twist?joints=${joints}&twist=${twist}`);
    await drawn(tab);
    const numbers = await shown(tab), part = twist / (joints - 1);
    assert.deepEqual(await printed(tab), numbers);
    assert.equal(numbers['volume.0'], 3);
    assert.ok(Math.abs(numbers['volume.1'] / 3 - share(part)) < 0.01, `${joints} ${twist}: ${numbers['volume.1']}`);
    assert.ok(Math.abs(numbers['volume.2'] / 3 - 1) < 0.01, `${joints} ${twist}: ${numbers['volume.2']}`);
    const half = joints === 2 ? Math.cos(part * Math.PI / 360) : 1;
    assert.ok(Math.abs(numbers['radius.1'] / Math.SQRT1_2 - half) < 1e-6, `${numbers['radius.1']}`);
    assert.ok(Math.abs(numbers['radius.2'] / Math.SQRT1_2 - 1) < 1e-6);
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test('the point of the plot is dragged to a smaller twist', async () => {
  const { tab } = await open('twist?lang=en');
  await drawn(tab);
  const before = await shown(tab), { x, y, width, height } = await tab.locator('.handle').boundingBox();
  await tab.mouse.move(x + width / 2, y + height / 2);
  await tab.mouse.down();
  await tab.mouse.move(x + width / 2 - 100, y + height / 2, { steps: 5 });
  await tab.mouse.up();
  await tab.waitForFunction(old => Number(document.querySelector('[data-name="volume.1"]').dataset.value) > old, before['volume.1']);
  const now = await shown(tab);
  assert.equal(now['volume.0'], before['volume.0']);
  assert.ok(now['volume.1'] > 1.1 * before['volume.1'], `${now['volume.1']}`);
  await tab.close();
});
