// SPDX-License-Identifier: MIT
// The keys that a play head passes in a clip that repeats, each exactly once.
import { button, element } from '../../kit/html';
import { numberTable, type Row } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import { remembered, samples } from '../../kit/samples';
import { clamp } from '../../kit/values';
import type { Exhibit, Room } from '../../shell/exhibit';
import { say, type Text } from '../../shell/text';
import { code } from './code';
import { headIn, type PlayHead } from './head';
import { makeLog } from './log';
import { around, bounds, fields, headOf, nearest, passed, rule, shownKeys, type State, timesOf, unrolled, type Wrap,
  withKey, withoutKey, wraps } from './model';
import { ring } from './ring';

const words = {
  wraps: { en: 'At the ends of the clip', ja: 'クリップの両端での動作' },
  once: { en: 'Once', ja: '1回' },
  loop: { en: 'Loop', ja: 'ループ' },
  twice: { en: 'Twice', ja: '2回' },
  pingpong: { en: 'Ping-pong', ja: '往復' },
  clip: { en: 'Time in the clip (s), over the running time', ja: '経過時間に対するクリップ内の時刻（秒）' },
  running: { en: 'time (s)', ja: '時間（秒）' },
  playHead: { en: 'play head', ja: '再生ヘッド' },
  numbers: { en: 'Since the last turn of the head', ja: '再生ヘッドが最後に向きを変えてから' },
  step: { en: 'running time, from and to', ja: '経過時間（始め、終わり）' },
  head: { en: 'time in the clip', ja: 'クリップ内の時刻' },
  cycle: { en: 'cycle', ja: '周回数' },
  passed: { en: 'keys passed, in one step', ja: '通過したキーの数（1ステップで計算）' },
  keys: { en: 'the first of them', ja: 'そのうち最初のもの' },
  frames: { en: 'Keys passed, added up step by step of the screen: ', ja: '画面の更新ごとに数えた、通過したキーの合計：' },
  rule: { en: 'Does a step pass the key nearest to the head? (1: yes; δ: an eighth of the clip)',
    ja: '再生ヘッドに最も近いキーを通過するか（1：通過、δ：クリップの長さの 1/8）' },
  nearest: { en: 'the key', ja: 'キー' },
  at: { en: 'its running time T', ja: 'その経過時間 T' },
  forwards_to: { en: 'forwards to it, (T − δ, T]', ja: '順方向でキーまで (T − δ, T]' },
  forwards_from: { en: 'forwards from it, (T, T + δ]', ja: '順方向でキーから (T, T + δ]' },
  backwards_to: { en: 'backwards to it, [T, T + δ)', ja: '逆方向でキーまで [T, T + δ)' },
  backwards_from: { en: 'backwards from it, [T − δ, T)', ja: '逆方向でキーから [T − δ, T)' },
  controls: { en: 'Clip', ja: 'クリップ' },
  duration: { en: 'duration (s)', ja: '長さ（秒）' },
  friction: { en: 'half-life of a throw (s)', ja: '回したときの速さの半減期（秒）' },
  add: { en: 'Key at the head', ja: '再生ヘッドの位置にキーを追加' },
  remove: { en: 'Delete the last key', ja: '最後のキーを削除' },
  throw: { en: 'Throw', ja: '回す' },
  back: { en: 'Throw backwards', ja: '逆向きに回す' },
  stop: { en: 'Stop', ja: '停止' },
  next: { en: 'To the next key', ja: '次のキーへ' },
  previous: { en: 'To the previous key', ja: '前のキーへ' },
} satisfies Record<string, Text>;
const rules = ['forwards_to', 'forwards_from', 'backwards_to', 'backwards_from'] as const;

const still = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

/** The running times in the plot: the period of the head, and those beside it. */
function windowOf(state: State): [number, number] {
  const { period } = unrolled(state), first = Math.floor(state.to / period) - 1;
  return period ? [first * period, (first + 3) * period] : bounds(state);
}

/** The time in the clip over the running time, with all keys that may be passed. */
function plotHead(room: Room<State>, head: PlayHead) {
  const curve = remembered(({ window, ...state }: State & { window: [number, number] }) =>
    samples(t => [headOf(state, t).time], ...window, 90));
  const data = () => curve({ ...room.state, from: 0, to: 0, window: windowOf(room.state) });
  plot(room, {
    label: words.clip, x: words.running, share: 0.5, data, time: () => room.state.to,
    series: [{ label: words.clip, colour: 'c0', width: 2 }],
    marks: () => {
      const { state } = room, times = timesOf(state), [least, most] = windowOf(state);
      const { list } = passed(state, state.from, state.to), done = new Set(list.map(p => p.at));
      return around(state, state.to).filter(p => p.at >= least && p.at <= most)
        .map(p => ({ x: p.at, y: times[p.key], colour: done.has(p.at) ? 'c1' : 'soft' }));
    },
    handles: () => [{ label: words.playHead, x: room.state.to, y: headOf(room.state, room.state.to).time,
      move: x => { head.go(0); head.to(x); } }],
  });
}

function ruleRows(state: State): Row[] {
  const near = nearest(state, state.to)!, counts = rule(state, near);
  return [{ name: 'nearest', label: words.nearest, values: [near.key], digits: 0 },
    { name: 'at', label: words.at, values: [near.at], digits: 3 },
    ...rules.map((name, i) => ({ name, label: words[name], values: [counts[i]], digits: 0 }))];
}

function stepRows(state: State): Row[] {
  const { from, to } = state, { count, list } = passed(state, from, to), { time, cycle } = headOf(state, to);
  return [
    { name: 'step', label: words.step, values: [Math.fround(from), Math.fround(to)] },
    { name: 'head', label: words.head, values: [time] },
    { name: 'cycle', label: words.cycle, values: [cycle], digits: 0 },
    { name: 'passed', label: words.passed, values: [count], digits: 0 },
    { name: 'key', label: words.keys, values: list.slice(0, shownKeys).map(p => p.key),
      digits: 0 },
  ];
}

/** Buttons with keys; returns them by name. */
function tools(room: Room<State>, label: Text, list: readonly (readonly [string, string, Text, () => void])[]) {
  room.shortcuts(list.map(([key, , does, run]) => ({ key, does, run })));
  const made = list.map(([, name, does, run]) => {
    const one = button(say(does), run);
    one.dataset.run = name;
    return one;
  });
  room.stage.append(element('div', { class: 'tools', role: 'group', 'aria-label': say(label) }, made));
  return made;
}

/** The sum over the steps of the screen begins anew when the clip becomes another. */
function sum(room: Room<State>, head: PlayHead) {
  const counted = element('output', { class: 'counted' });
  room.side.append(element('p', {}, [say(words.frames), counted]));
  let shape = '';
  room.draw(() => {
    const { keys, duration, wrap } = room.state, now = JSON.stringify([keys, duration, wrap]);
    if (shape && shape !== now)
      head.recount();
    shape = now;
    counted.textContent = String(head.counted());
  });
}

function mount(room: Room<State>) {
  const lit = new Map<number, number>();
  const head: PlayHead = headIn(room, still, (list, way) => {
    list.forEach(p => lit.set(p.key, performance.now()));
    if (list.length)
      log.add(list, way);
  });
  const turnTo = (wrap: Wrap) => {
    head.go(0);
    const [least, most] = bounds({ ...room.state, wrap }), to = clamp(room.state.to, least, most);
    room.set({ wrap, to, from: clamp(room.state.from, least, most) });
  };
  const choices = tools(room, words.wraps, wraps.map((wrap, i) =>
    [String(i + 1), wrap, words[wrap], () => turnTo(wrap)]));
  room.draw(() => choices.forEach((one, i) =>
    one.setAttribute('aria-pressed', String(wraps[i] === room.state.wrap))));
  ring(room, head, lit, still);
  plotHead(room, head);
  const key = (way: number) => {
    head.go(0);
    head.to(nearest(room.state, room.state.to, way)?.at ?? room.state.to);
  };
  tools(room, words.playHead, [['t', 'throw', words.throw, () => head.go(6)],
    ['b', 'back', words.back, () => head.go(-6)], ['s', 'stop', words.stop, () => head.go(0)],
    [',', 'previous', words.previous, () => key(-1)],
    ['.', 'next', words.next, () => key(1)]]);
  numberTable(room, words.numbers, () => stepRows(room.state));
  sum(room, head);
  const made = panel(room, words.controls);
  made.slider('duration', words.duration, 0.25, 8, 0.25);
  made.slider('friction', words.friction, 0.1, 4, 0.1);
  made.action(words.add, () => room.set(withKey(room.state)));
  made.action(words.remove, () => room.set(withoutKey(room.state)));
  numberTable(room, words.rule, () => ruleRows(room.state));
  const log = makeLog(room);
}

export const loop: Exhibit<State> = {
  lead: {
    en: 'Drag the head, and let it go while it moves. A step passes the keys after its start, up to and including ' +
      'its end: each key exactly once, however the way is divided. Stop on a key and turn round: it is not ' +
      'passed again.',
    ja: '再生ヘッドをドラッグし、動かしながら離してください。1回のステップは、始点を含まず終点を含む区間のキーを通過します。' +
      'どのように分けても、各キーはちょうど1回ずつ通過します。キーの上で止めて逆向きに動かすと、そのキーはもう通過しません。',
  },
  fields,
  mount,
  code,
};
