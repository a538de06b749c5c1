// SPDX-License-Identifier: MIT
// The state of an exhibit, and what changes it by arrow keys.
import { frames } from './models.mjs';

/** The state and the numbers, in the page. */
export const state = `JSON.stringify([...document.querySelectorAll('main [data-value], main input')]
  .map(e => e.dataset.value ?? e.value))`;
export const seen = tab => tab.evaluate(state);

/** Arrow keys on each handle, canvas, number or time until one changes the state; its element has the focus. */
export async function moveByArrows(tab) {
  const before = await seen(tab);
  const targets = 'main .handle, main canvas[tabindex], main .lil-gui input:not([type=checkbox]), .time';
  for (const target of await tab.$$(targets))
    for (const key of ['ArrowRight', 'ArrowUp']) {
      await target.focus();
      await tab.keyboard.press(key);
      await frames(tab, 2);
      if (await seen(tab) !== before)
        return true;
    }
  return false;
}
