// SPDX-License-Identifier: MIT
// Points in a space that are dragged by a pointer and moved by arrow keys: buttons above the canvas.
import * as N from 'nakawari/all';
import { say, type Text } from '../shell/text';
import type { Ray, View } from './eye';
import { element } from './html';

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

/** A part of the stage: on the left a space with its grips, on the right (below in a narrow page) what explains it. */
export function scene(stage: HTMLElement, share = 3) {
  const host = element('div', { class: 'spot' }), beside = element('div', { class: 'beside' });
  stage.append(element('div', { class: 'scene', style: `flex: ${share}` }, [host, beside]));
  return { host, beside };
}

const steps: Record<string, [number, number]> = {
  ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -6], ArrowDown: [0, 6],
};

/** Returns a function that shows the grips; call it for each drawing of the space. */
export function grips(host: HTMLElement) {
  const shown: HTMLButtonElement[] = [];
  let list: Grip[] = [], seen: View;
  const make = (i: number) => {
    const made = element('button', { type: 'button', class: 'handle mark', 'data-handle': String(i) });
    let held: { dx: number; dy: number } | undefined;
    made.addEventListener('pointerdown', event => {
      made.setPointerCapture(event.pointerId);
      held = { dx: parseFloat(made.style.left) - event.clientX, dy: parseFloat(made.style.top) - event.clientY };
    });
    made.addEventListener('pointermove', event => {
      if (held)
        list[i].move(seen.ray({ x: event.clientX + held.dx, y: event.clientY + held.dy }));
    });
    for (const name of ['pointerup', 'pointercancel'])
      made.addEventListener(name, () => { held = undefined; });
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
    next.forEach((grip, i) => {
      const p = view.project(grip.at);
      shown[i].hidden = !p;
      shown[i].setAttribute('aria-label', say(grip.label));
      shown[i].textContent = grip.mark;
      shown[i].classList.toggle('small', !!grip.small);
      const inside = (x: number, size: number) => `${Math.min(Math.max(x, 11), size - 11)}px`; // it can be grasped
      Object.assign(shown[i].style, { left: inside(p?.x ?? 0, view.width), top: inside(p?.y ?? 0, view.height),
        background: `var(--${grip.colour})`, opacity: grip.behind ? '0.7' : '1' });
    });
  };
}

/** The point of the unit sphere on a ray, on the side of `before`; beside the sphere, the nearest one. */
export function onSphere({ origin, direction }: Ray, before: number[]): number[] {
  const along = -N.vec3Dot(origin, direction), foot = N.vec3AddScaled([0, 0, 0], origin, direction, along);
  const half = Math.sqrt(Math.max(1 - N.vec3LengthSquared(foot), 0));
  const side = N.vec3Dot(before, direction) > 0 ? half : -half;
  return N.vec3Normalize([0, 0, 0], N.vec3AddScaled([0, 0, 0], foot, direction, side));
}
