// SPDX-License-Identifier: MIT
// Points in a space that are dragged by a pointer and moved by arrow keys: buttons above the canvas.
import * as N from 'nakawari/all';
import { say, type Text } from '../shell/text';
import { onDrag } from './drag';
import type { Ray, View } from './eye';
import { element } from './html';
import { clamp } from './values';

export interface Grip {
  label: Text;
  /** One or two letters. */
  mark: string;
  /** A CSS variable. */
  colour: string;
  at: number[];
  /** It is behind something, and drawn paler. */
  behind?: boolean;
  small?: boolean;
  /** The ray through the place to which the point is dragged. */
  move(ray: Ray): void;
}

const steps: Record<string, [number, number]> = {
  ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -6], ArrowDown: [0, 6],
};

function place(made: HTMLElement, grip: Grip, view: View) {
  const p = view.project(grip.at), inside = (x: number, size: number) => `${clamp(x, 11, size - 11)}px`;
  made.hidden = !p;
  made.setAttribute('aria-label', say(grip.label));
  made.textContent = grip.mark;
  made.classList.toggle('small', !!grip.small);
  Object.assign(made.style, { left: inside(p?.x ?? 0, view.width), top: inside(p?.y ?? 0, view.height), // within reach
    background: `var(--${grip.colour})`, opacity: grip.behind ? '0.7' : '1' });
}

/** Returns a function that shows the grips; call it for each drawing of the space. */
export function grips(host: HTMLElement) {
  const shown: HTMLButtonElement[] = [];
  let list: Grip[] = [], seen: View;
  const make = (i: number) => {
    const made = element('button', { type: 'button', class: 'handle mark', 'data-handle': String(i) });
    onDrag(made, down => {
      const dx = parseFloat(made.style.left) - down.clientX, dy = parseFloat(made.style.top) - down.clientY;
      return event => list[i].move(seen.ray({ x: event.clientX + dx, y: event.clientY + dy }));
    });
    made.addEventListener('keydown', event => {
      const step = steps[event.key];
      if (!step)
        return;
      event.preventDefault();
      event.stopPropagation();
      const p = seen.project(list[i].at)!, size = event.shiftKey ? 5 : 1;
      list[i].move(seen.ray({ x: p.x + size * step[0], y: p.y + size * step[1] }));
    });
    host.append(made);
    return made;
  };
  return (view: View, next: Grip[]) => {
    [list, seen] = [next, view];
    while (shown.length < next.length)
      shown.push(make(shown.length));
    shown.splice(next.length).forEach(extra => extra.remove());
    next.forEach((grip, i) => place(shown[i], grip, view));
  };
}

/** The point of the unit sphere on a ray, on the side of `before`; beside the sphere, the nearest one. */
export function onSphere({ origin, direction }: Ray, before: number[]): number[] {
  const along = -N.vec3Dot(origin, direction), foot = N.vec3AddScaled([0, 0, 0], origin, direction, along);
  const half = Math.sqrt(Math.max(1 - N.vec3Dot(foot, foot), 0));
  const side = N.vec3Dot(before, direction) > 0 ? half : -half;
  return N.vec3Normalize([0, 0, 0], N.vec3AddScaled([0, 0, 0], foot, direction, side));
}
