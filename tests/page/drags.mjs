// SPDX-License-Identifier: MIT
// Drags of handles by a mouse and by a finger.
import assert from 'node:assert/strict';
import { frames, touchDrag } from './models.mjs';

/** Waits until what the state says is drawn. */
export const settled = tab => frames(tab, 3);

/** The middle of the first element of the selector. */
export async function centre(tab, selector) {
  await tab.locator(selector).scrollIntoViewIfNeeded();
  const { x, y, width, height } = await tab.locator(selector).boundingBox();
  return { x: x + width / 2, y: y + height / 2 };
}

async function byMouse(tab, from, to) {
  await tab.mouse.move(from.x, from.y);
  await tab.mouse.down();
  await tab.mouse.move(to.x, to.y, { steps: 3 });
  await tab.mouse.up();
}

/** Drags the first element of the selector; returns how far it has moved. */
export async function drag(tab, selector, dx, dy, pointer = 'mouse') {
  const from = await centre(tab, selector);
  if (pointer === 'touch')
    await touchDrag(tab, tab.locator(selector), [[dx / 3, dy / 3], [dx / 2, dy / 2], [dx, dy]]);
  else
    await byMouse(tab, from, { x: from.x + dx, y: from.y + dy });
  await settled(tab);
  const to = await centre(tab, selector);
  return { dx: to.x - from.x, dy: to.y - from.y };
}

/** The element has followed the pointer. */
export async function follows(tab, selector, dx, dy, pointer) {
  const moved = await drag(tab, selector, dx, dy, pointer);
  assert.ok(Math.hypot(moved.dx - dx, moved.dy - dy) < 1.5, `${pointer} ${selector}: ${JSON.stringify(moved)}`);
}
