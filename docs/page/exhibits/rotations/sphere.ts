// SPDX-License-Identifier: MIT
// The object, the curves of its nose on the sphere, and two noses that are dragged.
import { colour } from '../../kit/colours';
import type { Ray, View } from '../../kit/eye';
import { grips, onSphere, type Grip } from '../../kit/grips';
import { dot, line } from '../../kit/picture';
import { space } from '../../kit/space';
import { curve, globe, isBehind, nose, object } from '../../kit/sphere';
import type { Room } from '../../shell/exhibit';
import { colours, isWrongWay, keysOf, seconds, shownOf, turned, type CurvesOf, type State } from './model';

const size = 1.6;

function gripsOf(room: Room<State>, view: View): Grip[] {
  const keys = keysOf(room.state);
  return (['a', 'b'] as const).map(name => {
    const at = nose(keys[name]), mark = name.toUpperCase();
    return { mark, colour: 'ink', at, behind: isBehind(view, at),
      label: { en: `${mark}: the nose of the key`, ja: `${mark}：キーの機首` },
      move: (ray: Ray) => room.set(turned(room.state, name, onSphere(ray, at))) };
  });
}

export function sphere(room: Room<State>, curves: CurvesOf, host: HTMLElement) {
  const show = grips(host);
  const paint = (c: CanvasRenderingContext2D, view: View) => {
    const { state } = room, { method, time } = state, { keys, curves: all } = curves(state);
    const at = (m: typeof method) => all[m].at(time / seconds).q, mine = at(method);
    const shown = shownOf(state);
    const ghost = isWrongWay(keys) && method !== 'given' && shown.includes('given');
    show(view, gripsOf(room, view));
    globe(c, view);
    return [
      object(c, view, mine, size), line(c, view, [0, 0, 0], nose(mine), colour('ink'), 1.5),
      ...ghost ? [object(c, view, at('given'), size, 0.4)] : [],
      ...shown.flatMap(m => curve(c, view, all[m].points, { style: colour(colours[m]), width: m === method ? 6 : 2,
        dashed: m === 'given' && m !== method, horizon: 1 })),
      ...shown.map(m => dot(c, view, nose(at(m)), colour(colours[m]))),
    ];
  };
  space(room, { label: { en: 'The object, and the curves of its nose on the sphere. Arrow keys turn the camera.',
    ja: '物体と、その機首が球面上に描く曲線。矢印キーで視点を回します。' }, distance: 2.75, parent: host, paint });
}
