// SPDX-License-Identifier: MIT
// The nine scenes: 1 and 2 are those of the exercise, 3 to 9 each show one property of key frames.
import type { Text } from '../../shell/text';

/** Position, and the angles of Ry(yaw) Rx(pitch) Rz(roll) in degrees. `opposite` stores -q for the rotation q. */
export interface Placement {
  time: number;
  at: [number, number, number];
  turn: [yaw: number, pitch: number, roll: number];
  opposite?: boolean;
}

/** Degrees, and the distance of the eye from the point (-0.5, 0, 0). */
export interface Camera { yaw: number; pitch: number; distance: number; fov: number }

export interface Scene { title: Text; reason: Text; keys: Placement[]; camera: Camera }

const camera = (yaw: number, pitch: number, distance: number): Camera => ({ yaw, pitch, distance, fov: 45 });

/** Keys at even times, one a second, as in the exercise. */
const everySecond = (keys: Omit<Placement, 'time'>[]): Placement[] => keys.map((key, time) => ({ time, ...key }));

const first: Scene = {
  title: { en: 'Scene 1 of the exercise', ja: '演習のシーン 1' },
  reason: {
    en: 'Seven keys, one a second. All four position curves differ here, most at key 2, and between keys 0 and 2 ' +
      'so do Euler angles and slerp. Between keys 3 and 4 the dot product of the quaternions is negative: blank B ' +
      'is needed.',
    ja: '1 秒おきの7つのキーです。4つの位置補間はすべて異なり、キー 2 の付近で最も違います。' +
      'キー 0 から 2 の間では、オイラー角補間と球面線形補間も異なります。' +
      'キー 3 と 4 の間では四元数の内積が負になるので、空欄 B の処理が必要です。',
  },
  keys: everySecond([
    { at: [-1, 0.5, -1.5], turn: [108, 0, 0] },
    { at: [0, 1, 0], turn: [216, 60, 45] },
    { at: [-2, 0.5, 1], turn: [180, -30, 0] },
    { at: [0, 0.4, 1.5], turn: [216, 0, 0] },
    { at: [1, 0.35, 1.75], turn: [-72, 15, 0] },
    { at: [1.5, 0.6, 0], turn: [0, 0, 0] },
    { at: [1, 1, -1], turn: [60, 0, 0] },
  ]),
  camera: camera(15, -20, 6),
};

const second: Scene = {
  title: { en: 'Scene 2 of the exercise', ja: '演習のシーン 2' },
  reason: {
    en: 'The first two orientations of scene 1 and one segment. The smallest case for a new program. Bézier needs ' +
      'four keys: here it stays at key 0.',
    ja: 'シーン 1 の最初の2つの向きと、1つの区間だけです。プログラムを最初に試すのに向いています。' +
      'Bézier 曲線には4つのキーが必要なので、ここではキー 0 の位置にとどまります。',
  },
  keys: everySecond([
    { at: [-1, 0.5, 0], turn: [108, 0, 0] },
    { at: [1, 0.5, 0], turn: [216, 60, 45] },
  ]),
  camera: camera(0, -20, 5),
};

const uneven: Scene = {
  title: { en: 'Uneven times on a straight line', ja: '直線上の不等間隔のキー' },
  reason: {
    en: 'The keys are on a line, one unit for each second, at the times 0, 0.5, 1, 3 and 4. Linear has constant ' +
      'speed. Hermite has not: its tangents are 1 per segment, which is 2 units a second in a segment of half a ' +
      'second. The B-spline takes the keys as even. Compare the dots, one every 0.2 s.',
    ja: 'キーは直線上に、1 秒あたり 1 の間隔で、時刻 0、0.5、1、3、4 に並んでいます。線形補間では等速です。' +
      'Hermite 曲線では等速になりません。接線の長さが区間あたり 1 なので、0.5 秒の区間では毎秒 2 になるからです。' +
      'B スプライン曲線は、キーを等間隔とみなします。0.2 秒おきの点の間隔を比べてください。',
  },
  keys: [
    { time: 0, at: [-2.5, 0.5, 0], turn: [-90, 0, 0] },
    { time: 0.5, at: [-2, 0.5, 0], turn: [-90, 0, 0] },
    { time: 1, at: [-1.5, 0.5, 0], turn: [-90, 0, 0] },
    { time: 3, at: [0.5, 0.5, 0], turn: [-90, 0, 0] },
    { time: 4, at: [1.5, 0.5, 0], turn: [-90, 0, 0] },
  ],
  camera: camera(0, -20, 6),
};

const groups: Scene = {
  title: { en: 'An incomplete Bézier group', ja: '4つに足りない Bézier の組' },
  reason: {
    en: 'Bézier takes keys 0 to 3 as one curve. Keys 4 and 5 do not complete the next group, so it stops at key ' +
      '3. Add a key (a): the second curve appears. It joins smoothly, because keys 2, 3 and 4 are on one line.',
    ja: 'Bézier 曲線は、キー 0 から 3 を1つの曲線として使います。次の組はキー 4 と 5 だけで足りないため、' +
      'キー 3 で止まります。キーを追加すると（a キー）、2つ目の曲線が現れます。' +
      'キー 2、3、4 が一直線に並んでいるので、2つの曲線は滑らかにつながります。',
  },
  keys: everySecond([
    { at: [-2, 0.5, 1], turn: [-8, 20, 0] },
    { at: [-1.8, 1.2, -0.5], turn: [-22, 10, 0] },
    { at: [-1.2, 1.2, -1], turn: [-85, 0, 0] },
    { at: [-0.6, 0.8, -0.6], turn: [-124, -25, 0] },
    { at: [0, 0.4, -0.2], turn: [-131, -15, 0] },
    { at: [0.8, 0.4, 0.6], turn: [-135, 0, 0] },
  ]),
  camera: camera(15, -25, 6),
};

const turns: Scene = {
  title: { en: 'A turn of more than 180 degrees', ja: '180 度を超える回転' },
  reason: {
    en: 'Key 1 is meant to be 240 degrees to the left of key 0. Both methods turn 120 degrees to the right: two ' +
      'orientations do not say how one came from one to the other. From key 2 to key 5 the same turn is made of ' +
      'three turns of 80 degrees, and goes to the left.',
    ja: 'キー 1 は、キー 0 から左へ 240 度回った向きのつもりです。しかし、どちらの方法でも右へ 120 度回ります。' +
      '2つの向きだけでは、どう回ったかは決まらないからです。' +
      'キー 2 から 5 では、同じ回転を 80 度ずつ3回に分けてあるので、左へ回ります。',
  },
  keys: everySecond([
    { at: [-2.5, 0.5, 0], turn: [0, 0, 0] },
    { at: [-1.7, 0.5, 0], turn: [240, 0, 0] },
    { at: [-0.9, 0.5, 0], turn: [0, 0, 0] },
    { at: [-0.1, 0.5, 0], turn: [80, 0, 0] },
    { at: [0.7, 0.5, 0], turn: [160, 0, 0] },
    { at: [1.5, 0.5, 0], turn: [240, 0, 0] },
  ]),
  camera: camera(0, -35, 6),
};

const signs: Scene = {
  title: { en: 'A key stored with the opposite sign', ja: '符号が逆の四元数のキー' },
  reason: {
    en: 'q and -q are one rotation. Key 1 stores -q, so the dot products with its neighbours are negative. Blank B ' +
      'negates q1, and the turns are those of 30 degrees. Without it the object would turn 330 degrees.',
    ja: 'q と -q は同じ回転を表します。キー 1 には -q が入っているので、両隣との内積は負になります。' +
      '空欄 B で q1 の符号を反転すれば、回転は 30 度のままです。反転しなければ、330 度回ってしまいます。',
  },
  keys: everySecond([
    { at: [-2, 0.5, 0], turn: [-90, 0, 0] },
    { at: [-1, 0.5, 0.2], turn: [-60, 0, 0], opposite: true },
    { at: [-0.1, 0.5, -0.3], turn: [-30, 0, 0] },
    { at: [0.4, 0.5, -1.2], turn: [0, 0, 0] },
  ]),
  camera: camera(0, -30, 5),
};

const pole: Scene = {
  title: { en: 'Through the vertical', ja: '真上を通る宙返り' },
  reason: {
    en: 'The object pulls up into half a loop. From key 2 to key 3 it turns 30 degrees, through the vertical. Its ' +
      'pitch is 75 degrees at both keys, and yaw and roll change by 180: Euler angles swing the nose to the side, ' +
      'slerp does not.',
    ja: '物体が機首を上げ、宙返りの前半を行います。キー 2 から 3 では、真上を向く姿勢をまたいで 30 度だけ回ります。' +
      '仰角（ピッチ角）は両方のキーで 75 度ですが、方位角（ヨー角）と旋回角（ロール角）は 180 度変わります。' +
      'そのため、オイラー角補間では機首が横に振れます。球面線形補間では振れません。',
  },
  keys: everySecond([
    { at: [-1.9, 0.4, 0], turn: [-90, 0, 0] },
    { at: [-0.5, 0.4, 0], turn: [-90, 0, 0] },
    { at: [0.37, 1.07, 0], turn: [-90, 75, 0] },
    { at: [0.37, 1.53, 0], turn: [-90, 105, 0] },
    { at: [-0.5, 2.2, 0], turn: [-90, 180, 0] },
  ]),
  camera: camera(25, -12, 7),
};

const lap: Scene = {
  title: { en: 'A lap that ends where it began', ja: '1周して最初に戻る' },
  reason: {
    en: 'The last key equals the first. Hermite closes; the B-spline does not, because its end keys are repeated. ' +
      'Playback keeps the rest of the step at the end of a lap; the exercise’s program drops it, and its laps are ' +
      'up to one step longer.',
    ja: '最後のキーは最初のキーと同じです。Hermite 曲線は閉じますが、B スプライン曲線は端のキーを2回使うため閉じません。' +
      '再生では、1周の終わりで時間刻みの余りを残します。演習のプログラムは余りを捨てるので、' +
      '1周が最大で1刻み長くなります。',
  },
  keys: everySecond([
    { at: [0.7, 0.6, 0], turn: [180, 0, 0] },
    { at: [0.1, 0.6, 1.04], turn: [120, 0, 0] },
    { at: [-1.1, 0.6, 1.04], turn: [60, 0, 0] },
    { at: [-1.7, 0.6, 0], turn: [0, 0, 0] },
    { at: [-1.1, 0.6, -1.04], turn: [-60, 0, 0] },
    { at: [0.1, 0.6, -1.04], turn: [-120, 0, 0] },
    { at: [0.7, 0.6, 0], turn: [-180, 0, 0] },
  ]),
  camera: camera(15, -30, 6),
};

const cut: Scene = {
  title: { en: 'Two keys at one time', ja: '同じ時刻の2つのキー' },
  reason: {
    en: 'Keys 2 and 3 are both at 2 s: the object jumps. Linear and Hermite use the two keys of a segment only, ' +
      'so both sides stay as they are. The B-spline and Bézier use keys beyond the jump too. Delete keys (d) ' +
      'until one is left: nakawari returns that key, and the exercise’s program writes no matrix.',
    ja: 'キー 2 と 3 はどちらも 2 秒なので、物体は瞬間移動します。線形補間と Hermite 曲線は、区間の両端のキーだけを使うので、' +
      '前後の動きは変わりません。B スプライン曲線と Bézier 曲線は、瞬間移動の向こう側のキーも使います。' +
      'キーを1つになるまで削除すると（d キー）、nakawari はそのキーを返し、演習のプログラムは行列に書き込みません。',
  },
  keys: [
    { time: 0, at: [-2.2, 0.5, -0.5], turn: [-130, 0, 0] },
    { time: 1, at: [-1.6, 0.7, 0], turn: [-130, 0, 0] },
    { time: 2, at: [-1, 0.5, 0.5], turn: [-130, 0, 0] },
    { time: 2, at: [0, 0.5, -1], turn: [-130, 0, 0] },
    { time: 3, at: [0.6, 0.8, -0.5], turn: [-130, 0, 0] },
    { time: 4, at: [1.2, 0.5, 0], turn: [-130, 0, 0] },
  ],
  camera: camera(15, -25, 6),
};

export const scenes: Scene[] = [first, second, uneven, groups, turns, signs, pole, lap, cut];
