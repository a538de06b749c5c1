// SPDX-License-Identifier: MIT
// The lesson's capsule on four joints: T J T^-1 in numbers, and the classic mistakes.
import type { View } from '../../kit/eye';
import { grips } from '../../kit/grips';
import { element } from '../../kit/html';
import { rampStyle, vertex } from '../../kit/skinned';
import { space } from '../../kit/space';
import type { Exhibit, Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { code } from './code';
import { choices, shortcuts, sliders } from './controls';
import { equation } from './equation';
import { fitter, type Fit } from './fit';
import { frames, handles, type Frame } from './frames';
import { around, joints } from './mesh';
import { fields, type State } from './model';
import { paint } from './picture';
import { skinner, type Skinned } from './skin';
import { labels } from './words';
import { vertexTable } from './vertex';

/** The ramp of a weight from 0 to 1, or the colours of the joints. */
function legend(room: Room<State>) {
  const title = element('span'), ticks = element('div', { class: 'ticks' }, ['0', '¼', '½', '¾', '1'].map(t =>
    element('span', {}, t)));
  const one = element('div', {}, [title, element('div', { class: 'ramp', style: `background: ${rampStyle}` }), ticks]);
  const all = element('div', { class: 'pairs' }, Array.from({ length: joints }, (_, j) => element('div', {}, [
    element('span', { class: 'patch', style: `background: var(--c${j})` }), say(labels.joint(j))])));
  room.draw(() => {
    title.textContent = say(labels.weightOf(room.state.joint));
    one.hidden = room.state.paint !== 'one';
    all.hidden = !one.hidden;
  });
  return element('div', { class: 'corner', 'aria-hidden': 'true' }, [one, all]);
}

/** The vertex that a pixel shows: the nearest to the eye of those within 14 pixels. */
function pick(view: View, now: Skinned, x: number, y: number): number | undefined {
  const all = Array.from({ length: now.positions.length / 3 }, (_, v) => ({ v, at: vertex(now.positions, v) }));
  const close = all.filter(({ at }) => {
    const p = view.project(at);
    return p && Math.hypot(p.x - x, p.y - y) < 14;
  });
  return close.sort((a, b) => view.distance(a.at) - view.distance(b.at))[0]?.v;
}

/** A click that is not a drag chooses a vertex. */
function picking(room: Room<State>, canvas: HTMLCanvasElement, at: (x: number, y: number) => number | undefined) {
  let from = { x: 0, y: 0 };
  canvas.addEventListener('pointerdown', event => { from = { x: event.offsetX, y: event.offsetY }; });
  canvas.addEventListener('click', ({ offsetX: x, offsetY: y }) => {
    const v = Math.hypot(x - from.x, y - from.y) < 5 ? at(x, y) : undefined;
    if (v !== undefined)
      room.set({ ring: Math.floor(v / around), column: v % around });
  });
}

/** The arrow keys turn the joint of a handle. */
function keys(host: HTMLElement, step: (joint: number, by: number) => void) {
  const signs: Record<string, number> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };
  host.addEventListener('keydown', event => {
    const { handle } = (event.target as HTMLElement).dataset, by = signs[event.key];
    if (handle === undefined || !by)
      return;
    event.preventDefault();
    event.stopPropagation();
    step(Number(handle), by);
  }, true);
}

function mount(room: Room<State>) {
  const skin = skinner(room), host = element('div', { class: 'scene' }, legend(room)), show = grips(host);
  const fit = fitter(host, room.refresh);
  let now: Skinned, list: Frame[], camera: Fit, seen: View;
  room.draw(() => {
    now = skin();
    list = frames(room.state, now.list);
    camera = fit(now, list);
  });
  room.stage.append(host);
  const canvas = space(room, {
    label: labels.picture, parent: host,
    get distance() { return camera.distance; },
    get aim() { return camera.aim; },
    paint(c, view) {
      seen = view;
      show(view, handles(room, list));
      return paint(c, view, room.state, now, list);
    },
  });
  picking(room, canvas, (x, y) => pick(seen, now, x, y));
  keys(host, (joint, by) => handles(room, list)[joint].step(by));
  choices(room);
  vertexTable(room, () => now);
  sliders(room);
  shortcuts(room);
  equation(room, () => now);
}

export const jointChain: Exhibit<State> = {
  lead: {
    en: 'Turn the joints by their handles 0 to 3, click a vertex, play the timer of the lesson. The equation below ' +
      'is the product of the chosen joint. Does your program show something else? Choose a mistake and compare.',
    ja: '0 から 3 のハンドルで関節を回し、頂点をクリックし、授業のタイマーを再生してみてください。下の式は、' +
      '選んだ関節の行列の積です。自分のプログラムの表示と違うときは、よくある間違いを選んで見比べてください。',
  },
  fields,
  range: () => ({ start: 0, end: 4 }),
  mount,
  code,
};
