// SPDX-License-Identifier: MIT
// What the plot of values can change: keys and tangents are dragged, keys are added and deleted.
import type { Handle } from '../../kit/points';
import { clamp } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { closest, curve, keysOf, most, nearest, tangentsOf, type Keys, type State } from './curves';

const arm = 0.2;
const replaced = (list: ArrayLike<number>, k: number, x: number) =>
  Array.from(list, (old, i) => i === k ? x : old);
const flat = (times: number[], values: number[], tangents: ArrayLike<number>) =>
  times.flatMap((t, k) => [t, values[k], tangents[k]]);

/** Adds a key with the slope that the chosen curve has at its time: a Hermite curve per second does not change. */
export function add(room: Room<State>, time: number, value?: number) {
  const s = keysOf(room.state), free = s.times.every(t => Math.abs(t - time) >= closest);
  if (s.times.length === most || !free)
    return room.announce(free ? { en: `There are ${most} keys already.`, ja: `キーは ${most} 個までです。` }
      : { en: 'A key is too close to this time.', ja: 'この時刻のすぐ近くにキーがあります。' });
  const [on, slope] = curve(s, s.method)(time), k = s.times.filter(t => t < time).length;
  room.set({ keys: [...s.keys.slice(0, 3 * k), time, value ?? on, slope, ...s.keys.slice(3 * k)] });
  room.announce({ en: `Key ${k} is added at ${time.toFixed(2)} s.`, ja: `${time.toFixed(2)} 秒にキー ${k} を追加しました。` });
}

export function remove(room: Room<State>, k = nearest(keysOf(room.state))) {
  const s = keysOf(room.state);
  if (s.times.length === 2)
    return room.announce({ en: 'A curve needs two keys.', ja: '曲線には2つのキーが必要です。' });
  const keys = s.keys.filter((_, i) => Math.floor(i / 3) !== k);
  room.set({ keys, time: clamp(s.time, keys[0], keys[keys.length - 3]) });
  room.announce({ en: `Key ${k} is deleted.`, ja: `キー ${k} を削除しました。` });
}

function keyHandle(room: Room<State>, { times, values }: Keys, k: number): Handle {
  return {
    label: { en: `key ${k}`, ja: `キー ${k}` }, text: String(k), x: times[k], y: values[k],
    move(x, y) {
      const s = keysOf(room.state), least = k ? s.times[k - 1] + closest : 0, last = k === s.times.length - 1;
      const time = clamp(x, least, last ? 8 : s.times[k + 1] - closest);
      const keys = flat(replaced(s.times, k, time), replaced(s.values, k, y), s.tangents);
      room.set({ keys, time: clamp(s.time, keys[0], keys[keys.length - 3]) });
    },
    remove: () => remove(room, k),
  };
}

/** A drag of a tangent makes the present tangents the reader's own. That of the last key points back. */
function tangentHandle(room: Room<State>, s: Keys, k: number): Handle {
  const last = k === s.times.length - 1, side = last ? -1 : 1;
  const present = (now: Keys) => tangentsOf(now)?.[last ? 'before' : 'after'] ?? now.tangents;
  return {
    label: { en: `tangent of key ${k}`, ja: `キー ${k} の接線` }, small: true,
    x: s.times[k] + side * arm, y: s.values[k] + side * arm * present(s)[k],
    move(x, y) {
      const now = keysOf(room.state), along = x - now.times[k], slope = (y - now.values[k]) / along;
      if (side * along > 0.02)
        room.set({ method: 'own', keys: flat(now.times, now.values, replaced(present(now), k, slope)) });
    },
  };
}

/** The keys, then their tangents. */
export function handles(room: Room<State>): Handle[] {
  const s = keysOf(room.state);
  return [keyHandle, tangentHandle].flatMap(make => s.times.map((_, k) => make(room, s, k)));
}
