// SPDX-License-Identifier: MIT
// Drags of handles by a mouse and by a finger.
import assert from 'node:assert/strict';

/** Waits until what the state says is drawn. */
export const settled = tab => tab.evaluate(() =>
  new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));

export async function centre(tab, selector) {
  const { x, y, width, height } = await tab.locator(selector).boundingBox();
  return { x: x + width / 2, y: y + height / 2 };
}

async function byMouse(tab, from, to) {
  await tab.mouse.move(from.x, from.y);
  await tab.mouse.down();
  await tab.mouse.move(to.x, to.y, { steps: 3 });
  await tab.mouse.up();
}

async function byTouch(tab, from, to) {
  const session = await tab.context().newCDPSession(tab);
  const send = (type, touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints });
  await send('touchStart', [from]);
  for (const t of [1 / 3, 2 / 3, 1])
    await send('touchMove', [{ x: from.x + t * (to.x - from.x), y: from.y + t * (to.y - from.y) }]);
  await send('touchEnd', []);
  await session.detach();
}

/** Drags the first element of the selector; returns how far it has moved. */
export async function drag(tab, selector, dx, dy, pointer = 'mouse') {
  await tab.locator(selector).scrollIntoViewIfNeeded();
  const from = await centre(tab, selector);
  await (pointer === 'touch' ? byTouch : byMouse)(tab, from, { x: from.x + dx, y: from.y + dy });
  await settled(tab);
  const to = await centre(tab, selector);
  return { dx: to.x - from.x, dy: to.y - from.y };
}

/** The element has followed the pointer. */
export async function follows(tab, selector, dx, dy, pointer) {
  const moved = await drag(tab, selector, dx, dy, pointer);
  assert.ok(Math.hypot(moved.dx - dx, moved.dy - dy) < 1.5, `${pointer} ${selector}: ${JSON.stringify(moved)}`);
}
