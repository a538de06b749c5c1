// SPDX-License-Identifier: MIT
// Points of a plot that can be dragged: a button above the canvas for each.
import type uPlot from 'uplot';
import { say, type Text } from '../shell/text';
import { onDrag } from './drag';
import { element } from './html';

export interface Handle {
  label: Text | string;
  x: number;
  y: number;
  small?: boolean;
  /** One or two letters on it. */
  text?: string;
  /** The point after a drag or an arrow key, in the plot's units. Without it the point does not move. */
  move?(x: number, y: number): void;
  /** After the Delete key. */
  remove?(): void;
}

type Move = (x: number, y: number) => void;

/** `move` receives the centre of the button in pixels of the plot. */
function dragged(made: HTMLElement, over: HTMLElement, move: Move, end: () => void) {
  const at = (event: PointerEvent) => {
    const box = over.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  onDrag(made, down => {
    const { x, y } = at(down);
    const dx = x - made.offsetLeft - made.offsetWidth / 2, dy = y - made.offsetTop - made.offsetHeight / 2;
    made.dataset.held = '';
    return event => move(at(event).x - dx, at(event).y - dy);
  }, () => {
    delete made.dataset.held;
    end();
  });
}

const arrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Keeps a button for each handle of the list. */
export function pointLayer(plot: uPlot, refresh: () => void): (next: Handle[]) => void {
  const { over } = plot, shown: HTMLButtonElement[] = [];
  let list: Handle[] = [];
  const typed = (i: number, event: KeyboardEvent) => {
    const step = arrows[event.key], size = event.shiftKey ? 0.05 : 0.01, handle = list[i];
    const unit = (name: 'x' | 'y') => (plot.scales[name].max! - plot.scales[name].min!) * size;
    if (step)
      handle.move?.(handle.x + step[0] * unit('x'), handle.y + step[1] * unit('y'));
    if (event.key === 'Delete')
      handle.remove?.();
    if (step || event.key === 'Delete')
      event.preventDefault();
  };
  const make = (i: number) => {
    const made = element('button', { type: 'button', class: 'handle', 'data-handle': String(i) });
    dragged(made, over, (x, y) => list[i].move?.(plot.posToVal(x, 'x'), plot.posToVal(y, 'y')), refresh);
    made.addEventListener('keydown', event => typed(i, event));
    over.append(made);
    return made;
  };
  return next => {
    list = next;
    while (shown.length < next.length)
      shown.push(make(shown.length));
    shown.splice(next.length).forEach(extra => extra.remove());
    next.forEach((handle, i) => {
      shown[i].setAttribute('aria-label', `${say(handle.label)}: ${handle.x.toFixed(2)}, ${handle.y.toFixed(2)}`);
      shown[i].classList.toggle('small', !!handle.small);
      shown[i].classList.toggle('mark', !!handle.text);
      shown[i].textContent = handle.text ?? '';
      shown[i].style.left = `${plot.valToPos(handle.x, 'x')}px`;
      shown[i].style.top = `${plot.valToPos(handle.y, 'y')}px`;
    });
  };
}

/** Calls f with the pixels of a double click or a double tap on the plot, but not on its handles. */
export function onDouble(over: HTMLElement, f: Move) {
  let last = { time: -Infinity, x: 0, y: 0 };
  over.addEventListener('pointerup', event => {
    const box = over.getBoundingClientRect(), time = event.timeStamp;
    const x = event.clientX - box.left, y = event.clientY - box.top;
    const near = Math.hypot(x - last.x, y - last.y) < 24 && time - last.time < 400;
    if ((event.target as HTMLElement).closest('.handle'))
      return;
    last = { time: near ? -Infinity : time, x, y };
    if (near)
      f(x, y);
  });
}
