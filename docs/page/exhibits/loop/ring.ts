// SPDX-License-Identifier: MIT
// The loop as a ring: one turn is one cycle, clockwise from the top. The head is dragged, and thrown.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import { element } from '../../kit/html';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { headOf, nextKey, timesOf, type State } from './model';

const turn = 2 * Math.PI;
const label = {
  en: 'The loop as a ring. The left and right arrow keys move the play head, with Shift to the next key.',
  ja: 'ループを輪で表示しています。左右の矢印キーで再生ヘッドを移動し、Shift を加えると次のキーまで移動します。',
};
interface Place { x: number; y: number; r: number }

function dot(c: CanvasRenderingContext2D, { x, y, r }: Place, part: number, radius: number, style: string) {
  c.fillStyle = style;
  c.beginPath();
  c.arc(x + r * Math.sin(turn * part), y - r * Math.cos(turn * part), radius, 0, turn);
  c.fill();
}

function circle(c: CanvasRenderingContext2D, { x, y, r }: Place) {
  c.strokeStyle = colour('line');
  c.lineWidth = 10;
  c.beginPath();
  c.arc(x, y, r, 0, turn);
  c.stroke();
}

// The way since the last turn, at most one whole turn of the ring.
function trail(c: CanvasRenderingContext2D, { x, y, r }: Place, { from, to, duration }: State, part: number) {
  const way = Math.min(Math.max((to - from) / duration, -1), 1), end = turn * (part - 0.25);
  c.strokeStyle = colour('c0');
  c.lineWidth = 4;
  c.beginPath();
  c.arc(x, y, r, end - turn * way, end, way < 0);
  c.stroke();
}

function hand(c: CanvasRenderingContext2D, place: Place, part: number) {
  c.strokeStyle = colour('ink');
  c.lineWidth = 2;
  c.beginPath();
  c.moveTo(place.x, place.y);
  c.lineTo(place.x + place.r * Math.sin(turn * part), place.y - place.r * Math.cos(turn * part));
  c.stroke();
  dot(c, place, part, 11, colour('c0'));
}

function names(c: CanvasRenderingContext2D, { x, y, r }: Place, state: State) {
  c.fillStyle = colour('ink');
  c.font = '14px system-ui, sans-serif';
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  state.keys.forEach((part, k) => c.fillText(String(k), x + (r + 26) * Math.sin(turn * part), y - (r + 26) * Math.cos(turn * part)));
}

/** A key that was passed is large for a moment: `lit` has the time in milliseconds when it was. */
function paint(c: CanvasRenderingContext2D, place: Place, state: State, lit: Map<number, number>) {
  const part = headOf(state, state.to)[0] / state.duration, now = performance.now();
  circle(c, place);
  trail(c, place, state, part);
  timesOf(state).forEach((time, k) => {
    const glow = Math.max(0, 1 - (now - (lit.get(k) ?? -1e9)) / 400);
    dot(c, place, time / state.duration, 7 + 8 * glow, colour(glow > 0 ? 'c1' : 'soft'));
  });
  names(c, place, state);
  hand(c, place, part);
}

export interface Head {
  /** Moves the head by seconds, or to a time. */
  by(seconds: number): void;
  to(time: number): void;
  /** The head goes on at a speed; 0 holds it. */
  go(speed: number): void;
}

// The speed at the end of a drag is that of its last fifth of a second.
function pointers(canvas: HTMLCanvasElement, place: () => Place, duration: () => number, head: Head) {
  let angle: number | undefined, past: { since: number; at: number; seconds: number }[] = [], last = 0;
  const angleOf = (event: PointerEvent) => {
    const box = canvas.getBoundingClientRect(), { x, y } = place();
    return Math.atan2(event.clientX - box.left - x, y - (event.clientY - box.top));
  };
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    head.go(0);
    [angle, past, last] = [angleOf(event), [], event.timeStamp];
  });
  canvas.addEventListener('pointermove', event => {
    if (angle === undefined)
      return;
    const next = angleOf(event), seconds = N.wrapAngle(next - angle) / turn * duration();
    angle = next;
    past = [...past.filter(p => p.at > event.timeStamp - 200), { since: last, at: event.timeStamp, seconds }];
    last = event.timeStamp;
    head.by(seconds);
  });
  const end = (event: PointerEvent) => {
    const recent = past.filter(p => p.at > event.timeStamp - 200);
    const [way, time] = recent.reduce(([w, t], p) => [w + p.seconds, t + (p.at - p.since) / 1000], [0, 0]);
    if (angle !== undefined && time > 0 && !matchMedia('(prefers-reduced-motion: reduce)').matches)
      head.go(Math.min(Math.max(way / time, -40), 40));
    angle = undefined;
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
}

export function ring(room: Room<State>, head: Head, lit: Map<number, number>) {
  const canvas = element('canvas', { class: 'space', tabindex: '0', role: 'application', 'aria-label': say(label) });
  room.stage.append(canvas);
  const c = canvas.getContext('2d')!;
  const place = () => {
    const { clientWidth: width, clientHeight: height } = canvas;
    return { x: width / 2, y: height / 2, r: Math.max(Math.min(width, height) / 2 - 44, 40) };
  };
  pointers(canvas, place, () => room.state.duration, head);
  canvas.addEventListener('keydown', event => {
    const way = ({ ArrowLeft: -1, ArrowRight: 1 } as Record<string, number>)[event.key];
    if (!way)
      return;
    event.preventDefault();
    head.go(0);
    if (event.shiftKey)
      head.to(nextKey(room.state, way));
    else
      head.by(way * 0.05);
  });
  room.draw(() => {
    const { clientWidth, clientHeight } = canvas, ratio = devicePixelRatio || 1;
    [canvas.width, canvas.height] = [Math.round(clientWidth * ratio), Math.round(clientHeight * ratio)];
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    paint(c, place(), room.state, lit);
    canvas.dataset.place = JSON.stringify(place()); // for tests
    if ([...lit.values()].some(at => performance.now() - at < 450))
      room.refresh();
  });
}
