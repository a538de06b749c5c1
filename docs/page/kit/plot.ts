// SPDX-License-Identifier: MIT
// Plots by uPlot, in the colours of the page, with a line at the present time and points that can be dragged.
import uPlot from 'uplot';
import type { Room } from '../shell/exhibit';
import { say, type Text } from '../shell/text';
import { colour } from './colours';
import { element } from './html';
import { legend, type Legend, type Series } from './legend';
import { onDouble, pointLayer, type Handle } from './points';
import { logTicks, ticks, tickTexts } from './ticks';

interface Data { x: ArrayLike<number>; y: ArrayLike<number>[] }

interface PlotOptions {
  /** What the plot shows, for its title and for screen readers. */
  label: Text;
  /** The label of the abscissa. Without it, the plot shares the axis of the plot below. */
  x?: Text;
  /** The curves, or a legend that several plots share. */
  series: Series[] | Legend;
  /** The abscissae, and for each series its values; NaN is a gap. It is not drawn again if it is the same object. */
  data(): Data;
  /** The range of x; else that of the abscissae. */
  domain?(): [number, number];
  /** The range of y; else that of the handles and of the curves that are shown. */
  range?(): [number, number];
  /** The axis of y is logarithmic. */
  log?: boolean;
  /** Where the vertical line is. */
  time?(): number;
  /** Thin vertical lines, for instance at the keys. */
  lines?(): number[];
  /** Small circles. */
  marks?(): { x: number; y: number; colour: string }[];
  handles?(): Handle[];
  /** A double click or a double tap on the plot. */
  add?(x: number, y: number): void;
  /** In which part of the stage the plot is; else the stage. */
  parent?: HTMLElement;
  /** Its share of the height; 1 without it. */
  share?: number;
}

/* ---- axes ---- */

const look = {
  stroke: () => colour('soft'), font: '12px system-ui, "Noto Sans CJK JP", sans-serif', gap: 4,
  grid: { stroke: () => colour('line'), width: 1 }, ticks: { show: false },
  filter: (_: uPlot, list: number[]) => list,
};

/** The label of the axis has the place of the last tick but one. */
function abscissa(label?: Text): uPlot.Axis {
  const texts = (list: number[]) => tickTexts(list).map((text, i) =>
    label && i === list.length - 2 ? say(label) : text);
  return {
    ...look, size: label ? 20 : 0,
    splits: (u, _, least, most) => ticks(least, most, Math.max(Math.floor(u.width / 80), 4)),
    values: (_, list) => label ? texts(list) : list.map(() => ''),
  };
}

const ordinate = (log = false): uPlot.Axis => ({
  ...look, size: 44,
  splits: (u, _, least, most) => (log ? logTicks : ticks)(least, most, Math.max(Math.floor(u.height / 36), 2)),
  values: (_, list) => tickTexts(list),
});

/** The range of the curves that are shown, with a margin. */
function extent(rows: ArrayLike<number>[], log = false): [number, number] {
  let [least, most] = [Infinity, -Infinity];
  for (const row of rows)
    for (let i = 0; i < row.length; i++)
      if (Number.isFinite(row[i]) && !(log && row[i] <= 0))
        [least, most] = [Math.min(least, row[i]), Math.max(most, row[i])];
  if (!Number.isFinite(least))
    return log ? [0.1, 10] : [0, 1];
  if (log)
    return [least / 1.2, most * 1.2];
  const margin = 0.06 * (most - least) || 1;
  return [least - margin, most + margin];
}

/* ---- what is drawn on the canvas beside the curves ---- */

function paintLines({ ctx, bbox, valToPos }: uPlot, lines: number[]) {
  ctx.save();
  ctx.strokeStyle = colour('soft');
  ctx.lineWidth = devicePixelRatio;
  ctx.setLineDash([devicePixelRatio, 3 * devicePixelRatio]);
  ctx.beginPath();
  for (const x of lines.map(line => valToPos(line, 'x', true))) {
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
  }
  ctx.stroke();
  ctx.restore();
}

function paintMarks({ ctx, valToPos }: uPlot, marks: { x: number; y: number; colour: string }[]) {
  ctx.save();
  for (const mark of marks) {
    ctx.beginPath();
    ctx.arc(valToPos(mark.x, 'x', true), valToPos(mark.y, 'y', true), 4 * devicePixelRatio, 0, 2 * Math.PI);
    ctx.fillStyle = colour(mark.colour);
    ctx.fill();
  }
  ctx.restore();
}

/* ---- the plot ---- */

/** The title, the legend of several curves unless it has another place, and the box of the plot. */
function frame<S>(room: Room<S>, options: PlotOptions, curves: Legend) {
  const host = element('div', { role: 'group', 'aria-label': say(options.label) });
  const box = element('div', { class: 'plot', style: `--share: ${options.share ?? 1}` }, host);
  const caption = element('div', { class: 'caption' }, say(options.label));
  if (curves.series.length > 1 && !curves.element.parentElement)
    caption.append(curves.element);
  (options.parent ?? room.stage).append(caption, box);
  return { host, box };
}

interface Ranges { x: [number, number]; y: [number, number] }

function make(options: PlotOptions, series: Series[], ranges: Ranges, host: HTMLElement): uPlot {
  return new uPlot({
    width: 400, height: 120, legend: { show: false }, cursor: { show: false }, pxAlign: 0,
    padding: [8, 14, options.x ? 0 : 8, 0],
    scales: { x: { time: false, range: () => ranges.x }, y: { range: () => ranges.y, distr: options.log ? 3 : 1 } },
    axes: [abscissa(options.x), ordinate(options.log)],
    series: [{}, ...series.map(s => ({
      stroke: () => colour(s.colour), width: s.width ?? 1.5, dash: s.dash, points: { show: false } }))],
    hooks: {
      drawAxes: [u => paintLines(u, options.lines?.() ?? [])],
      draw: [u => paintMarks(u, options.marks?.() ?? [])],
    },
  }, [[0, 1], ...series.map(() => [0, 0])] as uPlot.AlignedData, host);
}

const gaps = (values: ArrayLike<number>, log?: boolean) =>
  Array.from(values, v => Number.isFinite(v) && !(log && v <= 0) ? v : null);

/** The ranges that show all of the data. */
function fit(options: PlotOptions, { x, y }: Data, shown: boolean[], handles: Handle[]): Ranges {
  return {
    x: options.domain?.() ?? [x[0], x[x.length - 1]],
    y: options.range?.() ?? extent([...y.filter((_, i) => shown[i]), handles.map(handle => handle.y)], options.log),
  };
}

/** A plot that follows the state. While a handle is held, the ranges of the axes stay. */
export function plot<S>(room: Room<S>, options: PlotOptions): uPlot {
  const curves = Array.isArray(options.series) ? legend(room, options.series) : options.series;
  const { host, box } = frame(room, options, curves), ranges: Ranges = { x: [0, 1], y: options.log ? [1, 10] : [0, 1] };
  const made = make(options, curves.series, ranges, host), points = pointLayer(made, room.refresh);
  const now = element('div', { class: 'now' });
  if (options.time)
    made.over.append(now);
  if (options.add)
    onDouble(made.over, (x, y) => options.add?.(made.posToVal(x, 'x'), made.posToVal(y, 'y')));
  const redraw = ({ x, y }: Data, shown: boolean[]) => made.batch(() => {
    if (box.clientWidth !== made.width || box.clientHeight !== made.height)
      made.setSize({ width: box.clientWidth, height: box.clientHeight });
    shown.forEach((show, i) => made.setSeries(i + 1, { show }));
    made.setData([Array.from(x), ...y.map(row => gaps(row, options.log))] as uPlot.AlignedData);
  });
  let before: Data | undefined, key = '';
  room.draw(() => {
    const data = options.data(), handles = options.handles?.() ?? [];
    const shown = curves.series.map((_, i) => curves.shows(i));
    if (!made.over.querySelector('[data-held]'))
      Object.assign(ranges, fit(options, data, shown, handles));
    const next = JSON.stringify([box.clientWidth, box.clientHeight, colour('ink'), shown, ranges, options.lines?.(),
      options.marks?.()]);
    if (data !== before || next !== key)
      redraw(data, shown);
    [before, key] = [data, next];
    points(handles);
    now.style.left = `${made.valToPos(options.time?.() ?? 0, 'x')}px`;
  });
  room.closed(() => made.destroy());
  return made;
}
