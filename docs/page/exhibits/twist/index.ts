// SPDX-License-Identifier: MIT
// A bar that is twisted or bent, by linear blend and by dual quaternions, and its volume.
import { element, html } from '../../kit/html';
import { field, options } from '../../kit/field';
import { note } from '../../kit/note';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import { space } from '../../kit/space';
import { clamp } from '../../kit/values';
import type { Exhibit, Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { makeBars, motions, volume, ways, type Bars } from './bar';
import { code } from './code';
import { degreesOf, fields, type State } from './model';
import { measures } from './numbers';
import { colourOf, paint } from './picture';
import { help, jointWords, modeWords, notes, picture, wayWords, words } from './words';

/** The volumes at all angles, computed once for each motion and number of joints. */
function makeCurves(bars: Bars) {
  const made = new Map<string, { x: number[]; y: number[][] }>();
  return ({ mode, joints }: State) => {
    const key = `${mode} ${joints}`, { most } = motions[mode], x = Array.from({ length: 61 }, (_, i) => most * i / 60);
    const data = made.get(key) ?? { x, y: ways.map(way =>
      x.map(degrees => volume(bars.skin(mode, way, Number(joints), degrees)))) };
    made.set(key, data);
    return data;
  };
}

function curve(room: Room<State>, bars: Bars) {
  const curves = makeCurves(bars), names = wayWords();
  const at = () => bars.skin(room.state.mode, 'linear', 2, degreesOf(room.state));
  const parent = element('div', { class: 'volumes' });
  room.stage.append(parent);
  plot(room, {
    label: words.volume, x: words.degrees, parent,
    series: ways.map(way => ({ label: names[way], colour: colourOf[way], width: 2 })),
    data: () => curves(room.state),
    range: () => room.state.mode === 'twist' ? [0, 3.3] : [2, 3.2],
    time: () => degreesOf(room.state),
    handles: () => [{ label: words.angles[room.state.mode], x: degreesOf(room.state), y: volume(at()), move(x) {
      const { mode } = room.state;
      room.set({ [mode]: clamp(Math.round(x), 0, motions[mode].most) });
    } }],
  });
}

function controls(room: Room<State>) {
  room.side.append(element('div', { class: 'fields' }, [field(room, 'mode', words.mode, options(modeWords)),
    field(room, 'joints', words.joints, options(jointWords))]));
  const ui = panel(room, words.panel), { twist, bend } = motions;
  const sliders = { twist: ui.slider('twist', words.angles.twist, 0, twist.most, 1),
    bend: ui.slider('bend', words.angles.bend, 0, bend.most, 1) };
  room.draw(() => {
    sliders.twist.show(room.state.mode === 'twist');
    sliders.bend.show(room.state.mode === 'bend');
  });
}

function mount(room: Room<State>) {
  const bars = makeBars();
  room.closed(bars.dispose);
  space(room, { label: picture, distance: 6, paint: (c, view) => paint(c, view, room.state, bars) });
  curve(room, bars);
  controls(room);
  measures(room, bars);
  room.side.append(html('p', tex`V = \frac{1}{6} \sum \det(a, b, c)` + say(words.formula), { class: 'note' }),
    note(room, state => notes[state.mode]), html('p', say(help), { class: 'note' }));
}

export const twist: Exhibit<State> = {
  lead: {
    en: 'Drag the point of the plot. A bar of 3 m³ on two joints is twisted or bent, by linear blend and by dual ' +
      'quaternions; the third bar has more joints.',
    ja: 'グラフの点をドラッグしてください。2つの関節に付けた 3 m³ の角柱を、' +
      '線形ブレンドとデュアルクォータニオンでねじり、曲げます。3本目の角柱では関節を増やしています。',
  },
  fields,
  mount,
  code,
};
