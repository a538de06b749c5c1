// SPDX-License-Identifier: MIT
// A crowd: many characters of one skeleton, each at its own time and place, and what that costs beside three.js.
import { element } from '../kit/html';
import { numberTable } from '../kit/numbers';
import { panel } from '../kit/panel';
import { type Camera, cameraFields, type Library, openView, type View } from '../kit/view3';
import type { Exhibit, Room } from '../shell/exhibit';
import { part } from '../shell/part';
import { choice, number, whole } from '../shell/state';
import { say, type Text } from '../shell/text';
import { type Cast, loadCast } from './crowd/cast';
import { crowdCode } from './crowd/code';
import { makeMixers, type Mixers } from './crowd/mixers';
import { type Group, makeGroup } from './crowd/ours';

type By = 'crowd' | 'mixer';
interface State extends Camera {
  count: number;
  clip: string;
  by: By;
  character: number;
  joint: number;
  time: number;
}

const clips = ['walk', 'wave', 'hop'];
const words = {
  loading: { en: 'Loading three.js and the character …', ja: 'three.js とキャラクターを読み込んでいます…' },
  failed: { en: 'The crowd does not load: ', ja: '群衆を読み込めません：' },
  view: { en: 'The crowd on a floor', ja: '床の上の群衆' },
  controls: { en: 'Crowd', ja: '群衆' },
  count: { en: 'characters', ja: 'キャラクター数' },
  clip: { en: 'clip', ja: 'クリップ' },
  by: { en: 'animated by', ja: '計算の方法' },
  character: { en: 'character', ja: 'キャラクター' },
  joint: { en: 'joint', ja: '関節' },
  crowd: { en: 'Crowd (this library)', ja: 'Crowd（このライブラリ）' },
  mixer: { en: 'AnimationMixer (three.js)', ja: 'AnimationMixer（three.js）' },
  cost: { en: 'Time of the animation, median of frames', ja: 'アニメーションの計算時間（フレームの中央値）' },
  frame: { en: 'ms per frame', ja: 'ミリ秒/フレーム' },
  each: { en: 'µs per character', ja: 'マイクロ秒/体' },
  frames: { en: 'frames', ja: 'フレーム数' },
  measure: { en: 'Measure both, 60 frames', ja: '両方を60 フレーム測定' },
  unmeasured: { en: 'Not measured yet: press “Measure both”.', ja: '未測定です。「両方を60 フレーム測定」を押してください。' },
  note: {
    en: 'Measured: sampling, model matrices and joint matrices of all characters. Not measured: times, drawing and ' +
      'textures, and both have the same skeleton and clips, without morph targets. A browser’s clock has ' +
      'steps of 5 to 100 µs.',
    ja: '測定するのは、全キャラクターのサンプリング、モデル行列、関節行列の計算です。時刻の計算、描画、' +
      'テクスチャの更新は含みません。どちらもスケルトンとクリップは同じで、' +
      'モーフターゲットは使いません。ブラウザの時計の刻みは 5〜100 マイクロ秒です。',
  },
  numbers: { en: 'Joint matrix of the ringed character', ja: '輪で示したキャラクターの関節行列' },
  apart: { en: 'largest difference of the two, of any element', ja: '2つの方法の差の最大値（全要素）' },
};

// What the medians say.
const result = (count: number, crowd: number, mixer: number): Text => {
  const [a, b, ratio] = [1000 * crowd / count, 1000 * mixer / count, mixer / crowd].map(x => x.toPrecision(2));
  return {
    en: `In this browser, a character takes ${+a} µs by Crowd and ${+b} µs by AnimationMixer: ${+ratio} times ` +
      `as long, for the same ${count} × 18 joint matrices.`,
    ja: `このブラウザでは、1体あたり Crowd が ${+a} µs、AnimationMixer が ${+b} µs（${+ratio}倍）でした。` +
      `どちらも同じ${count} 体 × 18 関節の関節行列を計算しています。`,
  };
};

const median = (list: number[]) => [...list].sort((a, b) => a - b)[list.length >> 1];

// What was measured for the present characters, and its table.
function meter(room: Room<State>) {
  const took: Record<By, number[]> = { crowd: [], mixer: [] };
  const cells: Record<string, HTMLTableCellElement> = {};
  const row = (by: By) => element('tr', {}, [element('th', { scope: 'row' }, say(words[by])),
    ...['frame', 'each', 'frames'].map(name => {
      cells[by + name] = element('td', { 'data-cost': `${by}.${name}` });
      return cells[by + name];
    })]);
  const verdict = element('p', { role: 'status', class: 'verdict' }, say(words.unmeasured));
  const head = element('tr', {}, [element('td'), ...[words.frame, words.each, words.frames].map(text =>
    element('th', { scope: 'col' }, say(text)))]);
  room.side.append(element('table', { class: 'numbers' }, [element('caption', {}, say(words.cost)),
    element('thead', {}, head), element('tbody', {}, [row('crowd'), row('mixer')])]),
  verdict, element('p', { class: 'note' }, say(words.note)));
  return {
    clear: () => { took.crowd.length = took.mixer.length = 0; },
    add(by: By, milliseconds: number) {
      took[by].push(milliseconds);
      took[by].splice(0, took[by].length - 60);
    },
    show() {
      for (const by of ['crowd', 'mixer'] as By[]) {
        const list = took[by], middle = median(list), none = list.length === 0;
        cells[`${by}frame`].textContent = none ? '–' : middle.toFixed(2);
        cells[`${by}each`].textContent = none ? '–' : (1000 * middle / room.state.count).toFixed(1);
        cells[`${by}frames`].textContent = String(list.length);
      }
      const { crowd, mixer } = took, enough = Math.min(crowd.length, mixer.length) >= 20;
      verdict.textContent = say(!enough ? words.unmeasured : result(room.state.count, median(crowd), median(mixer)));
    },
  };
}

interface Parts {
  clip: number;
  from: number;
  step: number;
}
// Which characters play which clip.
const partsOf = ({ clip }: State): Parts[] => clip === 'mixed'
  ? clips.map((_, k) => ({ clip: k, from: k, step: clips.length }))
  : [{ clip: clips.indexOf(clip), from: 0, step: 1 }];
const partOf = (state: State, character: number) => partsOf(state).find(p => (character - p.from) % p.step === 0)!;
const chosen = (state: State) => Math.min(state.character, state.count - 1);

let cast: Cast | undefined, measure: (() => void) | undefined;

// The groups of the present characters; they are made again when these change.
function stageOf(three: Library, view: View, actors: Cast) {
  let groups: Group[] = [], mixers: Mixers[] = [], made = '';
  const clear = () => {
    groups.forEach(group => group.dispose());
    [groups, mixers] = [[], []];
  };
  return {
    clear,
    /** Returns whether the characters are new. */
    follow(state: State, both: boolean) {
      const next = `${state.count} ${state.clip}`, fresh = next !== made;
      if (fresh) {
        clear();
        groups = partsOf(state).filter(p => p.from < state.count)
          .map(p => makeGroup(three, actors, p.clip, p.from, p.step, state.count));
        view.scene.add(...groups.flatMap(group => group.meshes));
        made = next;
      }
      if (both && mixers.length === 0)
        mixers = groups.map(group => makeMixers(three, actors, group));
      return fresh;
    },
    setTimes: (time: number) => groups.forEach(group => group.setTimes(time)),
    play: () => groups.forEach(group => group.crowd.play(actors.clips[group.clip], group.times, group.roots)),
    fill: () => groups.forEach(group => group.fill(group.crowd)),
    playMixers: () => mixers.forEach(mixer => mixer.play()),
    /** Shows the matrices of the mixers; returns their largest difference from those of the crowds. */
    fillMixers: () => Math.max(...groups.map((group, g) => {
      const array = mixers[g].copy(), ours = group.crowd.array;
      group.fill({ array });
      return array.reduce((most, x, i) => Math.max(most, Math.abs(x - ours[i])), 0);
    })),
    /** The time and the joint matrix of a character. */
    of(character: number, joint: number) {
      const group = groups.find(g => g.members.includes(character))!, k = group.members.indexOf(character);
      const at = 16 * (k * group.crowd.jointCount + joint);
      const { times, crowd, roots } = group;
      return { time: times[k], matrix: crowd.array.slice(at, at + 16), root: roots.slice(16 * k, 16 * k + 16) };
    },
  };
}

function ring(three: Library) {
  const made = new three.Mesh(new three.RingGeometry(0.36, 0.44, 40).rotateX(-Math.PI / 2),
    new three.MeshBasicMaterial({ color: 0xe07000, depthTest: false, transparent: true }));
  made.position.y = 0.01;
  return made;
}

function open(room: Room<State>, three: Library, actors: Cast) {
  const view = openView(room, three, words.view);
  if (!view)
    return;
  const cost = meter(room), stage = stageOf(three, view, actors), mark = ring(three);
  const difference = element('p', { class: 'note', 'data-difference': '' });
  const frames = 60;
  let shown = { time: 0, matrix: new Float32Array(16) }, left = 0;
  measure = () => {
    cost.clear();
    left = frames;
    room.refresh();
  };
  view.aim(0, 0.8, 0);
  view.scene.add(mark);
  room.closed(stage.clear);
  room.draw(() => {
    const { state } = room, both = state.by === 'mixer' || left > 0;
    if (stage.follow(state, both))
      cost.clear();
    stage.setTimes(state.time + left / frames); // the last frame has the time of the state again
    const start = performance.now();
    stage.play();
    const middle = performance.now();
    cost.add('crowd', middle - start);
    if (both) {
      stage.playMixers();
      cost.add('mixer', performance.now() - middle);
      const most = stage.fillMixers();
      difference.textContent = `${say(words.apart)}: ${most.toExponential(1)}`;
    } else {
      stage.fill();
      difference.textContent = '';
    }
    const { time, matrix, root } = stage.of(chosen(state), state.joint);
    shown = { time, matrix };
    mark.position.set(root[12], 0.01, root[14]);
    if (left === 0) {
      cost.show();
      view.render();
    } else if (--left >= 0)
      room.refresh();
  });
  const column = (k: number) => shown.matrix.slice(4 * k, 4 * k + 3);
  numberTable(room, words.numbers, () => [
    { name: 'time', label: { en: 'time in the clip', ja: 'クリップ内の時刻' }, values: [shown.time] },
    { name: 'x', label: { en: 'x axis', ja: 'x 軸' }, values: column(0) },
    { name: 'y', label: { en: 'y axis', ja: 'y 軸' }, values: column(1) },
    { name: 'z', label: { en: 'z axis', ja: 'z 軸' }, values: column(2) },
    { name: 'position', label: { en: 'translation', ja: '平行移動' }, values: column(3) },
  ]);
  room.side.append(difference);
  room.refresh();
}

function mount(room: Room<State>) {
  const status = element('p', { role: 'status' }, say(words.loading));
  let left = false;
  room.stage.append(status);
  room.closed(() => {
    left = true;
    measure = undefined;
  });
  const controls = panel(room, words.controls);
  const names = Object.fromEntries([...clips.map(name => [name, name]), ['mixed', { en: 'all three', ja: '3種類' }]]) as
    Record<string, Text>;
  controls.slider('count', words.count, 1, 4000, 1);
  controls.choice('clip', words.clip, names);
  controls.choice('by', words.by, { crowd: words.crowd, mixer: words.mixer });
  controls.slider('character', words.character, 0, 3999, 1);
  controls.slider('joint', words.joint, 0, 17, 1);
  controls.action(words.measure, () => measure?.());
  part<Library>('three').then(async three => {
    cast ??= await loadCast(three);
    status.remove();
    if (!left)
      open(room, three, cast);
  }).catch(error => {
    status.textContent = say(words.failed) + String(error);
  });
}

export const crowd: Exhibit<State> = {
  lead: {
    en: 'A thousand characters, each at its own time and place in a clip. Play, switch between ' +
      '<code>Crowd</code> of this library and the <code>AnimationMixer</code> of three.js, and measure both: ' +
      'the picture stays, the time does not.',
    ja: '1000 体のキャラクターが、それぞれ別の時刻と場所でクリップを再生します。再生しながら、このライブラリの <code>Crowd</code> と ' +
      'three.js の <code>AnimationMixer</code> を切り替え、両方を測定してみてください。表示は変わらず、計算時間だけが変わります。',
  },
  fields: {
    count: whole(1000, 1, 4000), clip: choice('mixed', [...clips, 'mixed']),
    by: choice<By>('crowd', ['crowd', 'mixer']), character: whole(999, 0, 3999), joint: whole(0, 0, 17),
    time: number(0, 0, 20), ...cameraFields(30, 25, 30),
  },
  range: () => ({ start: 0, end: 20 }),
  mount,
  code: state => cast ? crowdCode(cast, {
    ...partOf(state, chosen(state)), count: state.count, character: chosen(state), joint: state.joint, time: state.time,
  }) : `/* ${say(words.loading)} */\n`,
};
