// SPDX-License-Identifier: MIT
// Exhibit 12: a hash of results in this browser, and the processors on which the library returns the same bits.
import * as N from 'nakawari/all';
import { element, html } from '../kit/html';
import { literal, program } from '../kit/code';
import { numberTable } from '../kit/numbers';
import { panel } from '../kit/panel';
import type { Exhibit, Room } from '../shell/exhibit';
import { number } from '../shell/state';
import { say } from '../shell/text';
import { processors, reference } from './bits/processors';

interface State { count: number; start: number }

const words = {
  hashes: { en: 'FNV-1a over the bits of the results (the same numbers, decimal)',
    ja: '計算結果のビット列の FNV-1a ハッシュ値（同じ値の10進表記）' },
  sequence: { en: 'The sequence', ja: '計算する数列' },
  count: { en: 'steps', ja: 'ステップ数' },
  start: { en: 'start value', ja: '初期値' },
  here: { en: 'This browser', ja: 'このブラウザ' },
  same: { en: 'the same bits as the C program on ', ja: '次の環境で実行した C のプログラムと同じビット列です：' },
  other: { en: 'not the bits of the C program', ja: 'C のプログラムと異なるビット列です' },
  open: { en: 'compare with the C program (Copy as C)', ja: 'C のプログラムの出力と比べてください（C のコードにする）' },
  table: {
    en: 'Targets on which every function is run and compared with one table of hashes (docs/determinism.md)',
    ja: 'ライブラリのすべての関数を実行し、1つのハッシュ表と照合している環境（docs/determinism.md）',
  },
  target: { en: 'target', ja: '環境' },
  compiler: { en: 'compiler', ja: 'コンパイラ' },
  runs: { en: 'runs on', ja: '実行' },
  rows: {
    sine: { en: 'sin, each of the last', ja: 'sin（前の値から順に）' },
    curve: { en: 'Hermite curve', ja: 'Hermite 曲線' },
    slerp: { en: 'slerp', ja: '球面線形補間' },
    spring: { en: 'spring', ja: 'ばね' },
  },
};

/** FNV-1a over the bytes of the floats, the lowest first. */
function hashOf() {
  const word = new DataView(new ArrayBuffer(4));
  let hash = 0x811c9dc5;
  return {
    add(values: ArrayLike<number>) {
      for (const x of Array.from(values)) {
        word.setFloat32(0, x, true);
        for (let b = 0; b < 4; b++)
          hash = Math.imul(hash ^ word.getUint8(b), 0x01000193) >>> 0;
      }
    },
    value: () => hash,
  };
}

/** The sequences: each step takes the result of the step before, so one other bit changes all that follow. */
function hashes({ count, start }: State): Record<keyof typeof words.rows, number> {
  const [sine, curve, slerp, spring] = [hashOf(), hashOf(), hashOf(), hashOf()];
  const constants = N.springFromHalfLife([0, 0], 0.25, 0.5);
  let x = Math.fround(start), q: number[] = [0, 0, 0, 1], motion: number[] = [start, 0];
  for (let i = 0; i < count; i++) {
    const t = (i % 64) / 64;
    x = N.sin(N.lerp(x, 3, t));
    const p = N.hermite(x, 1, t, -2, t);
    q = N.quatSlerp([0, 0, 0, 0], q, N.quatExp([0, 0, 0, 0], [x, p, t]), t);
    motion = N.springStep([0, 0], constants, motion, [p, 0], 0.015625);
    sine.add([x]);
    curve.add([p]);
    slerp.add(q);
    spring.add(motion);
  }
  return { sine: sine.value(), curve: curve.value(), slerp: slerp.value(), spring: spring.value() };
}

const hex = (list: number[]) => list.map(x => x.toString(16).padStart(8, '0')).join(' ');

const code = ({ count, start }: State) => program(`
const nkw_spring constants = nkw_spring_from_half_life(0.25f, 0.5f);
float x = ${literal(start)};
nkw_quat q = {0.0f, 0.0f, 0.0f, 1.0f};
nkw_state motion = {x, 0.0f};
unsigned long hashes[4] = {0x811c9dc5, 0x811c9dc5, 0x811c9dc5, 0x811c9dc5};
for (int i = 0; i < ${count}; i++) {
    const float t = (float)(i % 64) / 64.0f;
    x = nkw_sin(nkw_lerp(x, 3.0f, t));
    const float p = nkw_hermite(x, 1.0f, t, -2.0f, t);
    const nkw_vec3 v = {x, p, t};
    q = nkw_quat_slerp(q, nkw_quat_exp(v), t);
    const nkw_state goal = {p, 0.0f};
    motion = nkw_spring_step(constants, motion, goal, 0.015625f);
    const float values[8] = {x, p, q.x, q.y, q.z, q.w, motion.value, motion.velocity};
    const int of[8] = {0, 1, 2, 2, 2, 2, 3, 3};
    for (int k = 0; k < 8; k++) {
        union { float number; unsigned bits; } word = {values[k]};
        for (int b = 0; b < 4; b++)
            hashes[of[k]] = ((hashes[of[k]] ^ (word.bits >> 8 * b & 0xff)) * 0x01000193) & 0xffffffff;
    }
}
show("sine", 0, (double)hashes[0]);
show("curve", 0, (double)hashes[1]);
show("slerp", 0, (double)hashes[2]);
show("spring", 0, (double)hashes[3]);
`);

function processorTable() {
  const head = element('tr', {}, [words.target, words.compiler, words.runs].map(text =>
    element('th', { scope: 'col' }, say(text))));
  const rows = processors.map(({ target, compilers, on }) => element('tr', {}, [
    element('th', { scope: 'row' }, say(target)), element('td', {}, compilers), element('td', {}, say(on))]));
  return element('table', { class: 'numbers words' }, [html('caption', say(words.table)), element('thead', {}, head),
    element('tbody', {}, rows)]);
}

function mount(room: Room<State>) {
  const initial = { count: fields.count.initial, start: fields.start.initial };
  let last: State | undefined, values = hashes(room.state);
  const current = () => {
    if (last !== room.state)
      [last, values] = [room.state, hashes(room.state)];
    return values;
  };
  const hash = element('output', { class: 'hash' }), verdict = element('p', { class: 'verdict' });
  room.stage.append(element('h2', {}, `${say(words.here)} (WebAssembly, ${N.build()})`), hash, verdict);
  const box = element('div', { class: 'targets', tabindex: '0', role: 'region', 'aria-label': say(words.table) },
    processorTable());
  room.stage.append(box);
  numberTable(room, words.hashes, () => Object.entries(current()).map(([name, value]) =>
    ({ name, label: words.rows[name as keyof typeof words.rows], values: [value], digits: 0 })));
  const made = panel(room, words.sequence);
  made.slider('count', words.count, 1, 4096, 1);
  made.slider('start', words.start, -1, 1, 0.001);
  room.draw(() => {
    const { count, start } = room.state, shown = hex(Object.values(current()));
    hash.textContent = shown;
    const known = count === initial.count && start === initial.start;
    verdict.textContent = !known ? say(words.open) : shown === reference.hash ? say(words.same) + say(reference.on)
      : say(words.other);
  });
}

const fields = { count: number(1024, 1, 4096), start: number(0.5, -1, 1) };

export const bits: Exhibit<State> = {
  lead: {
    en: 'Your browser computes sines, curves, rotations and springs, each from the result before, and hashes all ' +
      'bits. Drag a slider: if one bit of a result changes, so does the hash. The copied C program computes ' +
      'the same hashes; the table has the processors on which the library is tested for equal bits.',
    ja: 'お使いのブラウザで正弦、曲線、回転、ばねを前の結果から順に計算し、すべてのビットのハッシュ値を求めます。' +
      'スライダーを動かしてください。1 ビットでも異なれば、ハッシュ値も変わります。' +
      'コピーした C のプログラムは同じハッシュ値を計算します。表は、ライブラリの結果がビット単位で一致することを確かめている環境です。',
  },
  fields,
  mount,
  code,
};
