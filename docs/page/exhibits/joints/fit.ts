// SPDX-License-Identifier: MIT
// A camera that sees the whole mesh and all joints. It stays while a pointer is down.
import type { Frame } from './frames';
import type { Skinned } from './skin';

/** In a narrow picture the legend is above the mesh: pixels. */
const legendHeight = 70;

export interface Fit { distance: number; aim: number[] }

/** The heights from the lowest to the highest point, and the distance of the farthest one from the axis. */
function extent(now: Skinned, list: Frame[]) {
  const points = [...now.positions, ...list.flatMap(f => f.at)];
  let [low, high, side] = [0, 2.2, 0];
  for (let i = 0; i < points.length; i += 3) {
    low = Math.min(low, points[i + 1]);
    high = Math.max(high, points[i + 1]);
    side = Math.max(side, Math.hypot(points[i], points[i + 2]));
  }
  return { low, high, side };
}

export function fitter(host: HTMLElement, refresh: () => void) {
  let fit: Fit = { distance: 5, aim: [0, 1.5, 0] }, held = false, done = false;
  host.addEventListener('pointerdown', () => { held = true; });
  for (const name of ['pointerup', 'pointercancel'])
    host.addEventListener(name, () => { held = false; refresh(); });
  return (now: Skinned, list: Frame[]): Fit => {
    if (held && done)
      return fit;
    const { low, high, side } = extent(now, list), { clientWidth: width, clientHeight: height } = host;
    const top = width < 480 ? legendHeight : 0, least = Math.min(width, height);
    const pixel = Math.max((high - low + 0.4) / (height - top), (2 * side + 1) / width);
    fit = { distance: pixel * least / 0.828 + 0.8, aim: [0, (low + high + pixel * top) / 2, 0] };
    done = true;
    return fit;
  };
}
