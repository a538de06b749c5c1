// SPDX-License-Identifier: MIT
// Canvases for pointers and keys, in CSS pixels.
import { say, type Text } from '../shell/text';
import { element } from './html';

/** A canvas at the end of `parent`. `clear` fits it to the pixels of the screen, before each drawing. */
export function makeCanvas(parent: HTMLElement, label: Text) {
  const canvas = element('canvas', { class: 'space', tabindex: '0', role: 'application', 'aria-label': say(label) });
  const c = canvas.getContext('2d')!;
  parent.append(canvas);
  const clear = () => {
    const { clientWidth: width, clientHeight: height } = canvas, ratio = devicePixelRatio || 1;
    const [w, h] = [width, height].map(size => Math.round(size * ratio));
    if (canvas.width !== w || canvas.height !== h)
      [canvas.width, canvas.height] = [w, h];
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
  };
  return { canvas, c, clear };
}
