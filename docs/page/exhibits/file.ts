// SPDX-License-Identifier: MIT
// Your file: the curves, checks and sizes of a glTF file, and its model, moved by the library.
import { Clip } from 'nakawari/all';
import { button, element } from '../kit/html';
import { numberTable } from '../kit/numbers';
import { type Camera, cameraFields, type Library, openView, type View } from '../kit/view3';
import type { Exhibit, Room } from '../shell/exhibit';
import { part } from '../shell/part';
import { choice, number, whole } from '../shell/state';
import { say, type Text } from '../shell/text';
import { type Channel, channelsOf } from './file/channels';
import { fileCode } from './file/code';
import { components, makeCurves } from './file/curves';
import { type Checked, checkAll, findingList } from './file/findings';
import { makePlayer, type Player, type Sizes } from './file/player';
import { type Loaded, readModel, Refused } from './file/read';

interface State extends Camera {
  source: string;
  clip: number;
  channel: number;
  time: number;
}

const words = {
  pick: { en: 'Choose a file', ja: 'ファイルを選ぶ' },
  drop: { en: 'Or drop it here: .glb, or .gltf with its files. It stays in this browser.',
    ja: 'ここにドロップもできます（.glb、または .gltf と関連ファイル）。ファイルはこのブラウザの外へ送られません。' },
  example: { en: 'The example character', ja: '例のキャラクター' },
  again: { en: 'Choose the file again: the address does not contain it.',
    ja: 'ファイルをもう一度選んでください。URL にはファイルの内容が含まれません。' },
  loading: { en: 'Loading …', ja: '読み込んでいます…' },
  refused: { en: 'This file is not shown. ', ja: 'このファイルは表示できません。' },
  none: { en: 'It has no animation.', ja: 'アニメーションがありません。' },
  view: { en: 'The model of the file', ja: 'ファイルのモデル' },
  clip: { en: 'Animation', ja: 'アニメーション' },
  channels: { en: 'Channels', ja: 'チャンネル' },
  channel: { en: 'channel', ja: 'チャンネル' },
  mode: { en: 'mode', ja: 'モード' },
  keys: { en: 'keys', ja: 'キー数' },
  findings: { en: 'findings', ja: '検出' },
  curve: { en: 'Curve of the channel', ja: 'チャンネルの曲線' },
  checks: { en: 'Checks', ja: '検査' },
  sizes: { en: 'Sizes in bytes (a clip contains the rest pose)', ja: '大きさ（バイト。クリップはレストポーズを含む）' },
  missing: { en: 'images not given: ', ja: '見つからない画像：' },
  value: { en: 'Value now', ja: '現在の値' },
};

// What is open, in this room and, so that a change of the language keeps it, in the next.
interface Open {
  loaded: Loaded;
  player: Player;
  channels: Channel[][];
  checked: Checked[][];
}
let kept: { name: string; bytes: Uint8Array<ArrayBuffer>; files: File[] } | undefined;
let current: Open | undefined;

const clipOf = (state: State, open: Open) => Math.min(state.clip, open.player.clips.length - 1);
const channelOf = (state: State, open: Open) => open.channels[clipOf(state, open)]?.[
  Math.min(state.channel, open.channels[clipOf(state, open)].length - 1)];

async function openFile(three: Library, view: View, file: NonNullable<typeof kept>): Promise<Open> {
  const loaded = await readModel(three, file.name, file.bytes, file.files), player = makePlayer(three, view, loaded);
  const channels = loaded.gltf.animations.map((_, i) => channelsOf(loaded, player.rig, i));
  return { loaded, player, channels, checked: channels.map(checkAll) };
}

function channelTable(room: Room<State>, open: Open) {
  const body = open.checked[clipOf(room.state, open)].map(({ channel, total }, i) => {
    const pick = button(`${channel.name}.${channel.path}`, () => room.set({ channel: i }), 'pick');
    pick.dataset.channel = String(i);
    return element('tr', {}, [element('th', { scope: 'row' }, pick), element('td', {}, channel.mode),
      element('td', {}, String(channel.times.length)), element('td', {}, String(total))]);
  });
  const head = element('tr', {}, [words.channel, words.mode, words.keys, words.findings].map(text =>
    element('th', { scope: 'col' }, say(text))));
  return element('div', { class: 'scroll', tabindex: '0', role: 'group', 'aria-label': say(words.channels) },
    element('table', { class: 'numbers' }, [element('caption', {}, say(words.channels)),
      element('thead', {}, head), element('tbody', {}, body)]));
}

function clipChoice(room: Room<State>, open: Open) {
  const select = element('select', { 'aria-label': say(words.clip) }, open.loaded.gltf.animations.map((animation, i) =>
    element('option', { value: String(i), ...(i === clipOf(room.state, open) ? { selected: '' } : {}) },
      animation.name || String(i))));
  select.addEventListener('change', () => room.set({ clip: Number(select.value), channel: 0, time: 0 }));
  return element('label', {}, [`${say(words.clip)}: `, select]);
}

// The tables of the present animation.
function details(room: Room<State>, open: Open, box: HTMLElement) {
  const index = clipOf(room.state, open), clip = open.player.clips[index];
  if (index < 0)
    return box.replaceChildren(element('p', {}, say(words.none)));
  const refused = clip instanceof Clip ? [] : [element('p', { role: 'alert' }, String(clip.message))];
  box.replaceChildren(clipChoice(room, open), ...refused, channelTable(room, open),
    element('h2', {}, say(words.checks)), ...findingList(open.checked[index]));
}

const sizeRows: { name: keyof Sizes; label: Text }[] = [
  { name: 'file', label: { en: 'in the file, shared arrays once', ja: 'ファイル内（共有する配列は1回）' } },
  { name: 'float32', label: { en: 'clip, float32', ja: 'クリップ（float32）' } },
  { name: 'unorm16', label: { en: 'clip, 16 bits', ja: 'クリップ（16 ビット）' } },
  { name: 'reduced', label: { en: 'clip within 1/10000 of the model', ja: 'クリップ（誤差はモデルの 1/10000 以内）' } },
];

function tables(room: Room<State>) {
  const value = () => {
    const channel = current && channelOf(room.state, current), out = new Float32Array(channel?.width ?? 0);
    channel?.track?.sample(room.state.time, out);
    const label = channel ? components(channel).slice(0, 8).join(' ') : '';
    return channel?.track ? [{ name: 'value', label, values: out.slice(0, 8) }] : [];
  };
  const sizes = () => {
    const found = current?.player.sizes[clipOf(room.state, current)];
    return !found ? [] : sizeRows.filter(({ name }) => Number.isFinite(found[name])).map(({ name, label }) =>
      ({ name: `bytes_${name}`, label, values: [found[name]], digits: 0 }));
  };
  const made = [numberTable(room, words.value, value), numberTable(room, words.sizes, sizes)];
  room.draw(() => made.forEach(table => { table.hidden = table.rows.length === 0; }));
}

async function exampleFile() {
  const { default: bytes } = await part<{ default: Uint8Array<ArrayBuffer> }>('character');
  return { name: 'character.glb', bytes: bytes.slice(), files: [] };
}

// The field, the button, and dropping.
function entrance(room: Room<State>, status: HTMLElement, load: (file: NonNullable<typeof kept>) => void) {
  const input = element('input', { type: 'file', accept: '.glb,.gltf,model/gltf-binary,model/gltf+json', multiple: '',
    'aria-label': say(words.pick) });
  const take = async (files: File[]) => {
    const file = files.find(f => /\.gl(b|tf)$/i.test(f.name)) ?? files[0];
    if (!file)
      return;
    const bytes = new Uint8Array(await file.arrayBuffer());
    room.set({ source: 'file', clip: 0, channel: 0, time: 0 });
    load({ name: file.name, bytes, files });
  };
  const example = button(say(words.example), async () => {
    const file = await exampleFile();
    room.set({ source: 'example', clip: 0, channel: 0, time: 0 });
    load(file);
  }, 'example');
  const over = (event: DragEvent) => event.preventDefault();
  const drop = (event: DragEvent) => {
    event.preventDefault();
    void take([...event.dataTransfer?.files ?? []]);
  };
  input.addEventListener('change', () => void take([...input.files ?? []]));
  addEventListener('dragover', over);
  addEventListener('drop', drop);
  room.closed(() => {
    removeEventListener('dragover', over);
    removeEventListener('drop', drop);
  });
  room.side.append(element('div', { class: 'entrance' }, [
    element('div', { class: 'tools' }, [element('label', { class: 'pick' }, [say(words.pick), input]), example]),
    element('p', { class: 'note' }, say(words.drop)), status]));
}

function mount(room: Room<State>) {
  const status = element('p', { role: 'status' }), box = element('div', { class: 'details' });
  const plot = element('div', { class: 'curves', role: 'img', 'aria-label': say(words.curve) });
  const curves = makeCurves(plot);
  let view: View | null | undefined, turn = 0, shown = '';
  const close = () => {
    current?.player.dispose();
    current = undefined;
    shown = '';
    box.replaceChildren();
  };
  const load = async (file: NonNullable<typeof kept>) => {
    const mine = ++turn;
    kept = file;
    close();
    status.textContent = say(words.loading);
    delete status.dataset.of;
    try {
      const three = await part<Library>('three');
      if (mine !== turn)
        return;
      view ??= openView(room, three, words.view);
      const open = view && await openFile(three, view, file);
      if (!open || mine !== turn)
        return open?.player.dispose();
      current = open;
      view!.aim(0, open.player.height / 2, 0);
      const { missing } = open.loaded;
      status.textContent = file.name + (missing.length ? ` (${say(words.missing)}${missing.join(', ')})` : '');
    } catch (error) {
      const text = error instanceof Refused ? say(error.text) : String(error instanceof Error ? error.message : error);
      if (mine === turn)
        status.textContent = say(words.refused) + text;
    }
    if (mine === turn)
      status.dataset.of = file.name;
    room.refresh();
  };
  entrance(room, status, file => void load(file));
  room.stage.append(plot);
  room.side.append(box);
  tables(room);
  room.draw(() => {
    const { state } = room, next = current ? `${clipOf(state, current)} ${current.loaded.name}` : '';
    if (next !== shown && current)
      details(room, current, box);
    shown = next;
    box.querySelectorAll<HTMLElement>('[data-channel]').forEach(pick =>
      pick.setAttribute('aria-pressed', String(Number(pick.dataset.channel) === state.channel)));
    current?.player.show(clipOf(state, current), state.time);
    curves.show(current && channelOf(state, current), state.time);
    view?.render();
  });
  room.closed(() => {
    turn++;
    close();
    curves.dispose();
  });
  if (room.state.source === 'file')
    kept ? void load(kept) : status.textContent = say(words.again);
  else
    exampleFile().then(load, error => { status.textContent = String(error); });
}

// The time of the clock, from 0 on as in glTF.
const rangeOf = (state: State) => {
  const clip = current?.player.clips[clipOf(state, current)];
  return { start: 0, end: clip instanceof Clip ? clip.end : 0 };
};

export const file: Exhibit<State> = {
  lead: {
    en: 'Drop a <code>.glb</code>: its curves, what is wrong with its keys, its sizes, and the model, which this ' +
      'library moves.',
    ja: '<code>.glb</code> をドロップすると、曲線、キーの問題点、大きさを調べ、このライブラリでモデルを動かします。',
  },
  fields: {
    source: choice('example', ['example', 'file']), clip: whole(0, 0, 1e4), channel: whole(0, 0, 1e5),
    time: number(0, 0, 1e6), ...cameraFields(30, 15, 4.5),
  },
  range: rangeOf,
  mount,
  code: state => {
    const channel = current && channelOf(state, current);
    return channel ? fileCode(channel, state.time) : `/* ${say(words.pick)} */\n`;
  },
};
