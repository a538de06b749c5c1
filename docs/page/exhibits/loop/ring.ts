// SPDX-License-Identifier: MIT
// One period as a ring, clockwise from the top; a clip that ends is an open ring. The head is dragged, and thrown.
import * as N from 'nakawari/all';
import { makeCanvas } from '../../kit/canvas';
import { colour } from '../../kit/colours';
import { onDrag } from '../../kit/drag';
import { circle, path } from '../../kit/picture';
import { clamp } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { headOf, nearest, timesOf, type State } from './model';

const turn = 2 * Math.PI;
const label = {
  en: 'One period as a ring. The left and right arrow keys move the play head, with Shift to the next key.',
  ja: '1周期を輪で表示しています。左右の矢印キーで再生ヘッドを移動し、Shift を加えると次のキーまで移動します。',
};
interface Place { x: number; y: number; r: number }

/* ---- places on the ring, as parts of a turn ---- */

const closed = ({ wrap }: State) => wrap === 'loop' || wrap === 'pingpong';
const gap = (state: State) => closed(state) ? 0 : 0.06;
/** Seconds of the running time in a whole turn. */
const seconds = (state: State) => state.duration * (state.wrap === 'pingpong' ? 2 : 1) / (1 - 2 * gap(state));
const placeOf = (state: State, time: number) => gap(state) + time / seconds(state);
/** Both places of a time of the clip in a ping-pong. */
const placesOf = (state: State, time: number) => state.wrap !== 'pingpong' ? [placeOf(state, time)]
  : time > 0 ? [placeOf(state, time), 1 - placeOf(state, time)] : [0];

function headPlace(state: State, running: number): number {
  const { time, cycle } = headOf(state, running), odd = state.wrap === 'pingpong' && Math.abs(cycle % 2) === 1;
  return odd ? 1 - placeOf(state, time) : placeOf(state, time);
}

/* ---- drawing ---- */

type Context = CanvasRenderingContext2D;
const at = ({ x, y, r }: Place, part: number, out = 0) =>
  ({ x: x + (r + out) * Math.sin(turn * part), y: y - (r + out) * Math.cos(turn * part) });

function dot(c: Context, place: Place, part: number, radius: number, style: string) {
  circle(c, at(place, part), radius);
  c.fillStyle = style;
  c.fill();
}

function arc(c: Context, { x, y, r }: Place, from: number, to: number, style: string, width: number) {
  c.strokeStyle = style;
  c.lineWidth = width;
  c.beginPath();
  c.arc(x, y, r, turn * (from - 0.25), turn * (to - 0.25), to < from);
  c.stroke();
}

/** The way since the last turn of the head, at most the whole ring. */
function trail(state: State): [number, number] {
  const { from, to } = state, end = headPlace(state, to);
  if (closed(state))
    return [end - clamp((to - from) / seconds(state), -1, 1), end];
  const first = headPlace(state, from);
  if (headOf(state, from).cycle === headOf(state, to).cycle)
    return [first, end];
  return [to > from ? gap(state) : 1 - gap(state), end];
}

function hand(c: Context, place: Place, part: number) {
  c.strokeStyle = colour('ink');
  c.lineWidth = 2;
  path(c, [place, at(place, part)]);
  c.stroke();
  dot(c, place, part, 11, colour('c0'));
}

/** A key that was passed is large for a moment: `lit` has the time in milliseconds when it was. */
function keys(c: Context, place: Place, state: State, lit: Map<number, number>) {
  const now = performance.now(), [rest, bright, ink] = ['soft', 'c1', 'ink'].map(colour);
  c.font = '14px system-ui, sans-serif';
  [c.textAlign, c.textBaseline] = ['center', 'middle'];
  timesOf(state).forEach((time, k) => {
    const glow = Math.max(0, 1 - (now - (lit.get(k) ?? -1e9)) / 400);
    for (const part of placesOf(state, time)) {
      dot(c, place, part, 7 + 6 * glow, glow > 0 ? bright : rest);
      c.fillStyle = ink;
      const { x, y } = at(place, part, 26);
      c.fillText(String(k), x, y);
    }
  });
}

function paint(c: Context, place: Place, state: State, lit: Map<number, number>) {
  arc(c, place, gap(state), 1 - gap(state), colour('line'), 10);
  arc(c, place, ...trail(state), colour('c0'), 4);
  keys(c, place, state, lit);
  hand(c, place, headPlace(state, state.to));
}

/* ---- pointers and keys ---- */

export interface Head {
  /** Moves the head by seconds, or to a time. */
  by(seconds: number): void;
  to(time: number): void;
  /** Throws the head at a speed; 0 holds it. */
  go(speed: number): void;
}

/** The speed at the end of a drag is that of its last fifth of a second. */
function pointers(canvas: HTMLCanvasElement, place: () => Place, perTurn: () => number, head: Head,
  still: () => boolean) {
  let past: { since: number; at: number; way: number }[] = [];
  const angleOf = (event: PointerEvent) => {
    const box = canvas.getBoundingClientRect(), { x, y } = place();
    return Math.atan2(event.clientX - box.left - x, y - (event.clientY - box.top));
  };
  const recent = (event: PointerEvent) => past.filter(p => p.at > event.timeStamp - 200);
  onDrag(canvas, down => {
    let angle = angleOf(down), since = down.timeStamp;
    head.go(0);
    past = [];
    return event => {
      const next = angleOf(event), way = N.wrapAngle(next - angle) / turn * perTurn();
      past = [...recent(event), { since, at: event.timeStamp, way }];
      [angle, since] = [next, event.timeStamp];
      head.by(way);
    };
  }, event => {
    const [way, time] = recent(event).reduce(([w, t], p) => [w + p.way, t + (p.at - p.since) / 1000], [0, 0]);
    if (time > 0 && !still())
      head.go(clamp(way / time, -40, 40));
  });
}

export function ring(room: Room<State>, head: Head, lit: Map<number, number>, still: () => boolean) {
  const { canvas, c, clear } = makeCanvas(room.stage, label);
  const place = () => {
    const { clientWidth: width, clientHeight: height } = canvas;
    return { x: width / 2, y: height / 2, r: Math.max(Math.min(width, height) / 2 - 40, 40) };
  };
  pointers(canvas, place, () => seconds(room.state), head, still);
  canvas.addEventListener('keydown', event => {
    const way = ({ ArrowLeft: -1, ArrowRight: 1 } as Record<string, number>)[event.key];
    if (!way)
      return;
    event.preventDefault();
    head.go(0);
    head.to(event.shiftKey ? nearest(room.state, room.state.to, way)?.at ?? room.state.to : room.state.to + way * 0.05);
  });
  room.draw(() => {
    clear();
    paint(c, place(), room.state, lit);
    canvas.dataset.place = JSON.stringify(place()); // for tests
    if ([...lit.values()].some(time => performance.now() - time < 450))
      room.refresh();
  });
}
