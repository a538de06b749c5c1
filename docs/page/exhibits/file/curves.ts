// SPDX-License-Identifier: MIT
// The curves of one channel by uPlot: samples of the library's track as lines, the keys as points.
import uPlot from 'uplot';
import { colour } from '../../kit/colours';
import { element } from '../../kit/html';
import { say } from '../../shell/text';
import type { Channel } from './channels';

const seconds = { en: 'time (s)', ja: '時刻（秒）' };
const most = { samples: 600, keys: 2000, components: 8 };

export const components = ({ property, width }: Channel) => property === 'morphTargetInfluences'
  ? Array.from({ length: width }, (_, i) => String(i)) : ['x', 'y', 'z', 'w'].slice(0, width);

// Ascending times without repetition: the keys, and between them where there is a track.
function timesOf({ times, track }: Channel) {
  const keys = [...times.subarray(0, most.keys)].filter(Number.isFinite);
  const start = Math.min(...keys), step = (Math.max(...keys) - start) / (most.samples - 1);
  const between = track ? Array.from({ length: most.samples }, (_, i) => start + step * i) : [];
  return Float64Array.from(new Set([...keys, ...between])).sort();
}

function dataOf(channel: Channel): uPlot.AlignedData {
  const times = timesOf(channel), out = new Float32Array(channel.width), shown = Math.min(out.length, most.components);
  const lines = Array.from({ length: shown }, () => new Array<number | null>(times.length).fill(null));
  const points = lines.map(line => [...line]);
  const keyAt = new Map([...channel.times.subarray(0, most.keys)].map((time, k) => [time, channel.value(k)]));
  times.forEach((time, i) => {
    const key = keyAt.get(time);
    channel.track?.sample(time, out);
    for (let c = 0; c < shown; c++) {
      if (channel.track)
        lines[c][i] = out[c];
      if (key && Number.isFinite(key[c]))
        points[c][i] = key[c];
    }
  });
  return [times as never, ...lines, ...points];
}

export interface Curves {
  show(channel: Channel | undefined, time: number): void;
  dispose(): void;
}

/** Curves in an element; they are drawn anew for another channel, other colours and another width. */
export function makeCurves(box: HTMLElement): Curves {
  let plot: uPlot | undefined, drawn: Channel | undefined, look = '', now = 0;
  const series = (channel: Channel): uPlot.Series[] => {
    const names = components(channel).slice(0, most.components);
    const stroke = (c: number) => colour(`c${c % 8}`);
    return [{ label: 's' },
      ...names.map((label, c) => ({ label, stroke: stroke(c), width: 1.5, pxAlign: 0, points: { show: false } })),
      ...names.map((label, c) => ({ label: `${label} •`, stroke: stroke(c), paths: () => null,
        points: { show: true, size: 6, fill: stroke(c) } }))];
  };
  const line = ({ ctx, bbox, valToPos }: uPlot) => {
    const x = valToPos(now, 'x', true);
    ctx.save();
    ctx.strokeStyle = colour('ink');
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  };
  const legend = element('p', { class: 'legend' }), host = element('div');
  const area = element('div', { class: 'plot' }, host);
  const make = (channel: Channel, width: number, height: number) => {
    const axis = { stroke: colour('soft'), grid: { stroke: colour('line'), width: 1 }, ticks: { show: false } };
    plot = new uPlot({
      width, height, series: series(channel), legend: { show: false }, cursor: { show: false },
      axes: [{ ...axis, label: say(seconds), labelFont: '12px system-ui', labelSize: 18, labelGap: 0, size: 28 },
        { ...axis, size: 52 }],
      scales: { x: { time: false } }, hooks: { draw: [line] },
    }, dataOf(channel), host);
  };
  box.append(legend, area);
  const explain = (channel?: Channel) => legend.replaceChildren(
    ...(channel ? components(channel) : []).slice(0, most.components).flatMap((name, c) =>
      [element('span', { style: `color: var(--c${c % 8})`, 'aria-hidden': 'true' }, '■'), ` ${name}  `]));
  return {
    show(channel, time) {
      if (channel !== drawn)
        explain(channel);
      const { clientWidth: width, clientHeight: height } = area, next = `${width} ${height} ${colour('ink')}`;
      now = time;
      if (channel === drawn && look === next)
        return plot?.redraw(false, false);
      plot?.destroy();
      [plot, drawn, look] = [undefined, channel, next];
      if (channel && width > 0)
        make(channel, width, height);
    },
    dispose: () => plot?.destroy(),
  };
}
