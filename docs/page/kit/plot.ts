// SPDX-License-Identifier: MIT
// Plots by uPlot, in the colours of the page, with a line at the present time and points that can be dragged.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Room } from '../shell/exhibit';
import { say, type Text } from '../shell/text';
import { colour } from './colours';
import { element } from './html';

export interface Series {
  label: Text | string;
  /** A CSS variable: c0 to c7, x, y, z, ink. */
  colour: string;
  width?: number;
  dash?: number[];
}

export interface Handle {
  label: Text | string;
  x: number;
  y: number;
  small?: boolean;
  /** The point after a drag or an arrow key, in the plot's units. Without it the point does not move. */
  move?(x: number, y: number): void;
}

export interface PlotOptions {
  /** What the plot shows, for its title and for screen readers. */
  label: Text;
  x?: Text;
  series: Series[];
  /** The abscissae, and for each series its values; null or NaN is a gap. Called for each drawing. */
  data(): { x: ArrayLike<number>; y: ArrayLike<number>[] };
  /** The range of y; else that of the data. */
  range?(): [number, number];
  /** Where the vertical line is. */
  time?(): number;
  handles?(): Handle[];
  /** In which part of the stage the plot is; else the stage. */
  parent?: HTMLElement;
}

const gaps = (values: ArrayLike<number>) => Array.from(values, v => Number.isFinite(v) ? v : null);

function extent(rows: ArrayLike<number>[]): [number, number] {
  const all = rows.flatMap(row => Array.from(row).filter(Number.isFinite));
  const least = Math.min(...all), most = Math.max(...all);
  if (!(most > least))
    return Number.isFinite(least) ? [least - 1, least + 1] : [0, 1];
  return [least - 0.06 * (most - least), most + 0.06 * (most - least)];
}

// A button above the canvas for each handle: it is dragged by a pointer, and moved by arrow keys.
function handleLayer(over: HTMLElement, at: () => uPlot, refresh: () => void) {
  const shown: HTMLButtonElement[] = [];
  let list: Handle[] = [];
  const make = (i: number) => {
    const made = element('button', { type: 'button', class: 'handle', 'data-handle': String(i) });
    let held: { dx: number; dy: number } | undefined;
    made.addEventListener('pointerdown', event => {
      made.setPointerCapture(event.pointerId);
      const box = over.getBoundingClientRect();
      held = { dx: event.clientX - box.left - made.offsetLeft, dy: event.clientY - box.top - made.offsetTop };
    });
    made.addEventListener('pointermove', event => {
      if (!held)
        return;
      const box = over.getBoundingClientRect(), plot = at();
      const x = event.clientX - box.left - held.dx + made.offsetWidth / 2;
      const y = event.clientY - box.top - held.dy + made.offsetHeight / 2;
      list[i].move?.(plot.posToVal(x, 'x'), plot.posToVal(y, 'y'));
    });
    for (const name of ['pointerup', 'pointercancel'])
      made.addEventListener(name, () => { held = undefined; refresh(); });
    made.addEventListener('keydown', event => {
      const step = ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as
        Record<string, [number, number]>)[event.key];
      if (!step)
        return;
      event.preventDefault();
      event.stopPropagation();
      const { scales } = at(), size = event.shiftKey ? 0.05 : 0.01;
      const unit = (name: 'x' | 'y') => (scales[name].max! - scales[name].min!) * size;
      list[i].move?.(list[i].x + step[0] * unit('x'), list[i].y + step[1] * unit('y'));
    });
    over.append(made);
    return made;
  };
  return {
    show(next: Handle[]) {
      list = next;
      while (shown.length < next.length)
        shown.push(make(shown.length));
      shown.splice(next.length).forEach(extra => extra.remove());
      next.forEach((handle, i) => {
        const plot = at();
        shown[i].setAttribute('aria-label', `${say(handle.label)}: ${handle.x.toFixed(2)}, ${handle.y.toFixed(2)}`);
        shown[i].classList.toggle('small', !!handle.small);
        shown[i].style.left = `${plot.valToPos(handle.x, 'x')}px`;
        shown[i].style.top = `${plot.valToPos(handle.y, 'y')}px`;
      });
    },
  };
}

/** A plot that follows the state. While a handle is held, the range of the axes stays. */
export function plot<S>(room: Room<S>, options: PlotOptions) {
  const host = element('div', { role: 'group', 'aria-label': say(options.label) });
  const box = element('div', { class: 'plot' }, host);
  const legend = element('div', { class: 'legend', 'aria-hidden': 'true' }, options.series.map(s => {
    const mark = element('span', {}, `${s.dash ? '╍' : '━'} ${say(s.label)}`);
    mark.style.color = `var(--${s.colour})`;
    return mark;
  }));
  (options.parent ?? room.stage).append(element('div', { class: 'legend' }, say(options.label)), legend, box);
  const line = (u: uPlot) => {
    if (!options.time)
      return;
    const x = u.valToPos(options.time(), 'x', true), { ctx, bbox } = u;
    ctx.strokeStyle = colour('ink');
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([]);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
  };
  let range: [number, number] = [0, 1];
  const axis = (size: number, label?: Text): uPlot.Axis => ({
    stroke: () => colour('soft'), grid: { stroke: () => colour('line'), width: 1 }, ticks: { show: false }, size,
    ...(label ? { label: say(label), labelSize: 16 } : {}),
  });
  const made = new uPlot({
    width: 400, height: 120, legend: { show: false }, cursor: { show: false },
    scales: { x: { time: false }, y: { range: () => range } },
    axes: [axis(options.x ? 44 : 28, options.x), axis(52)],
    series: [{}, ...options.series.map(s => ({
      stroke: () => colour(s.colour), width: s.width ?? 1.5, dash: s.dash, points: { show: false } }))],
    hooks: { draw: [line] },
  }, [[0, 1], ...options.series.map(() => [0, 0])] as uPlot.AlignedData, host);
  const handles = handleLayer(made.over, () => made, room.refresh);
  room.draw(() => {
    const { x, y } = options.data(), held = made.over.querySelector('.handle:active');
    if (!held)
      range = options.range?.() ?? extent(y);
    if (box.clientWidth !== made.width || box.clientHeight !== made.height)
      made.setSize({ width: box.clientWidth, height: box.clientHeight });
    made.setData([Array.from(x), ...y.map(gaps)] as uPlot.AlignedData);
    handles.show(options.handles?.() ?? []);
  });
  room.closed(() => made.destroy());
  return made;
}
