// SPDX-License-Identifier: MIT
// Drags by mouse, pen or finger.

/** `begin` returns what the moves do until the pointer is released; `end` follows. */
export function onDrag(target: HTMLElement, begin: (event: PointerEvent) => (event: PointerEvent) => void,
  end: (event: PointerEvent) => void = () => {}) {
  let move: ((event: PointerEvent) => void) | undefined;
  target.addEventListener('pointerdown', event => {
    target.setPointerCapture(event.pointerId);
    move = begin(event);
  });
  target.addEventListener('pointermove', event => move?.(event));
  for (const name of ['pointerup', 'pointercancel'] as const)
    target.addEventListener(name, event => {
      if (move)
        end(event);
      move = undefined;
    });
}
