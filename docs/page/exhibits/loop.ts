// SPDX-License-Identifier: MIT
// Exhibit 10: the keys that a play head passes in a loop, each exactly once.
import * as N from 'nakawari/all';
import { button, element } from '../kit/html';
import { numberTable } from '../kit/numbers';
import { panel } from '../kit/panel';
import type { Exhibit, Room } from '../shell/exhibit';
import { say } from '../shell/text';
import { code, fields, headOf, moved, nextKey, passed, shownKeys, withKey, withoutKey, type State } from './loop/model';
import { ring, type Head } from './loop/ring';

const words = {
  numbers: { en: 'Since the last turn of the head', ja: 'ヘッドが最後に向きを変えてから' },
  step: { en: 'running time, from and to', ja: '経過時間（始め、終わり）' },
  head: { en: 'time in the clip, cycle', ja: 'クリップ内の時刻、周回数' },
  passed: { en: 'keys passed, in one step', ja: '通過したキーの数（1ステップで計算）' },
  keys: { en: 'the first of them', ja: 'そのうち最初のもの' },
  frames: { en: 'Keys passed, added up step by step of the screen: ', ja: '画面の更新ごとに数えた、通過したキーの合計：' },
  loop: { en: 'Loop', ja: 'ループ' },
  duration: { en: 'duration (s)', ja: '長さ (s)' },
  add: { en: 'Key at the head', ja: 'ヘッドの位置にキーを追加' },
  remove: { en: 'Delete the last key', ja: '最後のキーを削除' },
  throw: { en: 'Throw', ja: '回す' },
  back: { en: 'Throw backwards', ja: '逆向きに回す' },
  stop: { en: 'Stop', ja: '停止' },
  next: { en: 'To the next key', ja: '次のキーへ' },
  previous: { en: 'To the previous key', ja: '前のキーへ' },
};

// The head, its speed in loop seconds a second, and the sum of the keys that the steps of the screen passed.
function headIn(room: Room<State>, lit: Map<number, number>): Head & { counted(): number; recount(): void } {
  let speed = 0, last = 0, sum = 0;
  const recount = () => { sum = passed(room.state, room.state.from, room.state.to).count; };
  const to = (time: number) => {
    const { state } = room, next = moved(state, time), step = passed(state, state.to, next.to!);
    sum = next.from === state.from ? sum + step.count : step.count;
    step.keys.forEach(k => lit.set(k, performance.now()));
    room.set(next);
  };
  room.draw(() => {
    const now = performance.now(), seconds = Math.min((now - last) / 1000, 0.1);
    last = now;
    if (speed === 0)
      return;
    speed = N.damperStep(speed, 0, 1.5, seconds);
    if (Math.abs(speed) < 0.01)
      speed = 0;
    to(room.state.to + speed * seconds);
  });
  const go = (next: number) => {
    [speed, last] = [next, performance.now()];
    room.refresh();
  };
  recount();
  return { to, go, recount, by: seconds => to(room.state.to + seconds), counted: () => sum };
}

function mount(room: Room<State>) {
  const lit = new Map<number, number>(), head = headIn(room, lit);
  ring(room, head, lit);
  const key = (way: number) => { head.go(0); head.to(nextKey(room.state, way)); };
  const runs = [['t', words.throw, () => head.go(6)], ['b', words.back, () => head.go(-6)], ['s', words.stop, () => head.go(0)],
    [',', words.previous, () => key(-1)], ['.', words.next, () => key(1)]] as const;
  room.shortcuts(runs.map(([name, does, run]) => ({ key: name, does, run })));
  room.stage.append(element('div', { class: 'tools' }, runs.map(([name, does, run]) => {
    const made = button(say(does), run);
    made.dataset.run = name;
    return made;
  })));
  numberTable(room, words.numbers, () => {
    const { from, to } = room.state, { count, keys } = passed(room.state, from, to);
    return [
      { name: 'step', label: words.step, values: [Math.fround(from), Math.fround(to)] },
      { name: 'head', label: words.head, values: headOf(room.state, to) },
      { name: 'passed', label: words.passed, values: [count], digits: 0 },
      { name: 'key', label: words.keys, values: keys.slice(0, shownKeys), digits: 0 },
    ];
  });
  const counted = element('output', { class: 'counted' });
  room.side.append(element('p', {}, [say(words.frames), counted]));
  const made = panel(room, words.loop);
  made.slider('duration', words.duration, 0.25, 8, 0.25);
  made.action(words.add, () => room.set(withKey(room.state)));
  made.action(words.remove, () => room.set(withoutKey(room.state)));
  let shape = '';
  room.draw(() => {
    const { keys, duration } = room.state, now = JSON.stringify([keys, duration]);
    if (shape && shape !== now)
      head.recount();
    shape = now;
    counted.textContent = String(head.counted());
  });
}

export const loop: Exhibit<State> = {
  lead: {
    en: 'Drag the head around the ring, and let it go while it moves. A step passes the keys after its start up to and ' +
      'including its end, so however the way is divided into steps, each key is passed exactly once. Stop on a key and ' +
      'turn round: the key is not passed again.',
    ja: 'ヘッドを輪に沿ってドラッグし、動かしながら離してください。1回のステップは、始点を含まず終点を含む区間のキーを通過します。' +
      'そのため、どのようにステップに分けても、各キーはちょうど1回ずつ通過します。キーの上で止めて逆向きに動かすと、' +
      'そのキーをもう一度通過することはありません。',
  },
  fields,
  mount,
  code,
};
