// SPDX-License-Identifier: MIT
// Exhibit 8: a twisted bar, by linear blend and by dual quaternions, and its volume.
import type { View } from '../../kit/eye';
import { colour } from '../../kit/colours';
import { numberTable } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import type { Shape } from '../../kit/picture';
import { plot } from '../../kit/plot';
import { rgb, skinned } from '../../kit/skinned';
import { space, turnFields } from '../../kit/space';
import type { Exhibit, Room } from '../../shell/exhibit';
import { choice, number } from '../../shell/state';
import { say } from '../../shell/text';
import { faces, length, makeBar, positions, radius, volume, type Bar, type Way } from './bar';
import { code } from './code';

const fields = {
  ...turnFields(25, 12),
  twist: number(170, 0, 360),
  joints: choice<'2' | '3' | '5'>('2', ['2', '3', '5']),
};
type State = { [K in keyof typeof fields]: typeof fields[K]['initial'] };

const words = {
  linear: { en: 'linear blend', ja: '行列の線形ブレンド' },
  dual: { en: 'dual quaternions', ja: 'デュアルクォータニオン' },
  bind: { en: 'bind pose', ja: 'バインドポーズ' },
  twist: { en: 'twist (degrees)', ja: 'ねじりの角度（度）' },
  joints: { en: 'joints', ja: '関節の数' },
  panel: { en: 'The bar', ja: '角柱' },
  volume: { en: 'Volume against twist', ja: 'ねじりの角度と体積' },
  table: { en: 'Bind pose, linear blend, dual quaternions', ja: 'バインドポーズ、線形ブレンド、デュアルクォータニオン' },
  volumes: { en: 'volume (m³)', ja: '体積 (m³)' },
  radii: { en: 'corner to axis, half way up (m)', ja: '中央の断面の角から軸まで (m)' },
  picture: {
    en: 'Two twisted bars: linear blend on the left, dual quaternions on the right. Arrow keys turn the camera.',
    ja: 'ねじった2本の角柱。左が線形ブレンド、右がデュアルクォータニオンです。矢印キーで視点を回します。',
  },
};

const ways: Way[] = ['linear', 'dual'];
const colourOf: Record<Way, string> = { linear: 'c1', dual: 'c0' };

/* ---- the bars ---- */

type Bars = (joints: string) => Bar;

function makeBars(room: Room<State>): Bars {
  const made = new Map<string, Bar>();
  room.closed(() => made.forEach(bar => bar.dispose()));
  return joints => {
    const bar = made.get(joints) ?? makeBar(Number(joints));
    made.set(joints, bar);
    return bar;
  };
}

function label(c: CanvasRenderingContext2D, view: View, way: Way, at: number[]): Shape {
  return { distance: -1, paint() {
    const p = view.project(at);
    if (!p)
      return;
    c.font = '14px system-ui, sans-serif';
    c.textAlign = 'center';
    c.fillStyle = colour('ink');
    c.fillText(say(words[way]), p.x, p.y);
  } };
}

/** Each face in the colour of its way; one side is paler, so that the twist is seen. */
function paint(c: CanvasRenderingContext2D, view: View, bar: Bar, twist: number): Shape[] {
  return ways.flatMap((way, i) => {
    const offset = [i * 2.4 - 1.2, 0, 0], fill = rgb(colourOf[way]), pale = rgb('soft');
    return [...skinned(c, view, bar.skin(way, twist), faces, face => (face - 1) % 8 < 2 ? pale : fill, offset),
      label(c, view, way, [offset[0], length + 0.35, 0])];
  });
}

/* ---- the volumes ---- */

const twists = Array.from({ length: 37 }, (_, i) => 10 * i);

function makeCurves(bars: Bars) {
  const made = new Map<string, number[][]>();
  return (joints: string) => {
    const curves = made.get(joints) ?? ways.map(way => twists.map(twist => volume(bars(joints).skin(way, twist))));
    made.set(joints, curves);
    return curves;
  };
}

function curve(room: Room<State>, bars: Bars) {
  const curves = makeCurves(bars);
  plot(room, {
    label: words.volume, x: words.twist, series: ways.map(way => ({ label: words[way], colour: colourOf[way], width: 2 })),
    data: () => ({ x: twists, y: curves(room.state.joints) }),
    range: () => [0, 3.3],
    time: () => room.state.twist,
    handles: () => [{ label: words.twist, x: room.state.twist,
      y: volume(bars(room.state.joints).skin('linear', room.state.twist)),
      move: x => room.set({ twist: Math.min(Math.max(Math.round(x), 0), 360) }) }],
  });
}

function mount(room: Room<State>) {
  const bars = makeBars(room), bar = () => bars(room.state.joints), ui = panel(room, words.panel);
  space(room, { label: words.picture, distance: 6.5, aim: [0, length / 2, 0],
    paint: (c, view) => paint(c, view, bar(), room.state.twist) });
  curve(room, bars);
  ui.slider('twist', words.twist, 0, 360, 1);
  ui.choice('joints', words.joints, { 2: { en: '2', ja: '2' }, 3: { en: '3', ja: '3' }, 5: { en: '5', ja: '5' } });
  numberTable(room, words.table, () => {
    const list = [positions, ...ways.map(way => bar().skin(way, room.state.twist))];
    return [{ name: 'volume', label: words.volumes, values: list.map(volume) },
      { name: 'radius', label: words.radii, values: list.map(radius) }];
  });
}

export const twist: Exhibit<State> = {
  lead: {
    en: 'Drag the point of the plot. Linear blend moves a vertex along a straight line and loses volume; dual ' +
      'quaternions move it on an arc, along the shorter way: past 180° between two joints they turn back. More joints help both.',
    ja: 'グラフの点をドラッグしてください。線形ブレンドは頂点を直線に沿って動かすため、体積が減ります。デュアルクォータニオンは' +
      '円弧に沿って、短い方の向きに動かします。2つの関節の間が 180° を超えると逆向きになります。関節を増やすと、どちらも改善します。',
  },
  fields,
  mount,
  code,
};
