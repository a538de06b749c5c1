// SPDX-License-Identifier: MIT
import type { Text } from '../../shell/text';
import type { Orientation, Position, View } from './model';

export const positionWords: Record<Position, Text> = {
  linear: { en: 'Linear', ja: '線形補間' },
  hermite: { en: 'Hermite', ja: 'Hermite 曲線' },
  bezier: { en: 'Bézier', ja: 'Bézier 曲線' },
  bspline: { en: 'B-spline', ja: 'B スプライン曲線' },
  'catmull-rom': { en: 'Catmull-Rom (not in the exercise)', ja: 'Catmull-Rom 曲線（演習にはない）' },
  centripetal: { en: 'Centripetal (not in the exercise)', ja: '求心 Catmull-Rom 曲線（演習にはない）' },
  step: { en: 'None (not in the exercise)', ja: '補間なし（演習にはない）' },
};
export const orientationWords: Record<Orientation, Text> = {
  euler: { en: 'Euler angles', ja: 'オイラー角補間' },
  quat: { en: 'Quaternions, slerp', ja: '四元数の球面線形補間' },
  none: { en: 'None', ja: '補間なし' },
  'euler-unwrapped': { en: 'Euler angles, all unwrapped (not in the exercise)', ja: 'オイラー角補間、3 つの角度を調整（演習にはない）' },
  nlerp: { en: 'Quaternions, nlerp (not in the exercise)', ja: '四元数の nlerp（演習にはない）' },
  squad: { en: 'Quaternions, squad (not in the exercise)', ja: '四元数の squad（演習にはない）' },
};
export const viewWords: Record<View, Text> = {
  trajectory: { en: 'Trajectory', ja: '軌道表示' },
  frames: { en: 'All frames', ja: '全フレーム表示' },
  plain: { en: 'Normal', ja: '通常表示' },
};
export const labels = {
  scene: { en: 'Scene', ja: 'シーン' },
  position: { en: 'Position', ja: '位置補間' },
  orientation: { en: 'Orientation', ja: '向き補間' },
  view: { en: 'View', ja: '表示' },
  play: { en: 'Play from the start', ja: '最初から再生' },
  stop: { en: 'Stop and resume', ja: '停止・再開' },
  add: { en: 'Add a key', ja: 'キーを追加' },
  remove: { en: 'Delete the last key', ja: '最後のキーを削除' },
  axes: { en: 'Axes through the objects', ja: '軸を物体越しに表示' },
  local: { en: 'Handles along the axes of the object', ja: '操作軸を物体の座標系にする' },
  program: { en: 'The exercise’s own numbers', ja: '演習のプログラムと同じ値' },
  save: { en: 'Save the layout', ja: '配置を保存' },
  load: { en: 'Load a layout', ja: '配置を読み込む' },
  camera: { en: 'Camera', ja: 'カメラ' },
  yaw: { en: 'yaw', ja: '方位角' },
  pitch: { en: 'pitch', ja: '仰角' },
  roll: { en: 'roll', ja: '旋回角' },
  distance: { en: 'distance', ja: '距離' },
  fov: { en: 'field of view', ja: '画角' },
  time: { en: 'time', ja: '時刻' },
  key: { en: 'Key', ja: 'キー' },
  keys: { en: 'Keys: seconds, position, degrees', ja: 'キー（秒、位置、度）' },
  negate: { en: 'negate the quaternion', ja: '四元数の符号を反転' },
  refused: { en: 'refused: times must ascend, within 64 s', ja: '使えない値です。時刻は昇順で、64 秒以内にしてください' },
  one: { en: 'The exercise’s program writes no matrix for one key.', ja: 'キーが 1 つのとき、演習のプログラムは行列に書き込みません。' },
  trace: { en: 'The present time by hand', ja: '現在の時刻を手で計算する' },
  blanks: { en: 'The blanks of the report', ja: 'レポートの空欄' },
  blank: { en: 'blank', ja: '空欄' },
  weight: { en: 'weight', ja: '係数' },
  programNote: {
    en: 'Segments include both ends, Bézier is not clamped outside the keys, the orientation without interpolation ends ' +
      'at the second to last key, playback drops the rest of the step, and one key gives no matrix.',
    ja: '区間は両端を含みます。Bézier 曲線はキーの範囲外でも延長されます。補間なしの向きは、最後から 2 番目のキーで終わります。' +
      '再生では時間刻みの余りを捨て、キーが 1 つのときは行列に書き込みません。',
  },
} satisfies Record<string, Text>;
