// SPDX-License-Identifier: MIT
import { say, type Text } from '../../shell/text';
import type { Own } from './object';
import type { Operation, Orientation, Position, View } from './model';

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
  quat: { en: 'Quaternion slerp', ja: '四元数補間' },
  none: { en: 'None', ja: '補間なし' },
  'euler-unwrapped': {
    en: 'Euler angles, all unwrapped (not in the exercise)', ja: 'オイラー角補間、3つの角度を調整（演習にはない）',
  },
  nlerp: { en: 'Quaternions, nlerp (not in the exercise)', ja: '四元数の nlerp（演習にはない）' },
  squad: { en: 'Quaternions, squad (not in the exercise)', ja: '四元数の squad（演習にはない）' },
};
export const viewWords: Record<View, Text> = {
  trajectory: { en: 'Trajectory', ja: '軌道表示' },
  frames: { en: 'All frames', ja: '全フレーム表示' },
  plain: { en: 'Normal', ja: '通常表示' },
};

/* ---- the texts of the program in its picture ---- */

export const programWords = {
  position: {
    linear: 'Linear', hermite: 'Hermit', bezier: 'Bezier', bspline: 'B-Spline', 'catmull-rom': 'Catmull-Rom',
    centripetal: 'Centripetal', step: 'None',
  } satisfies Record<Position, string>,
  orientation: {
    euler: 'Euler', quat: 'Quat', none: 'None', 'euler-unwrapped': 'Euler unwrapped', nlerp: 'Nlerp', squad: 'Squad',
  } satisfies Record<Orientation, string>,
};
/** The document has the names of the operations, OP_W_TRANSLATION and so on, and Japanese words, not the texts. */
export const operationWords: Record<Operation, Text> = {
  moveWorld: { en: 'World Translation', ja: 'World Translation（ワールド座標系での移動）' },
  turnLocal: { en: 'Model Rotation', ja: 'Model Rotation（ローカル座標系での回転）' },
  moveLocal: { en: 'Model Translation', ja: 'Model Translation（ローカル座標系での移動）' },
  turnWorld: { en: 'World Rotation', ja: 'World Rotation（ワールド座標系での回転）' },
};

export const labels = {
  scene: { en: 'Scene', ja: 'シーン' },
  position: { en: 'Position', ja: '位置補間' },
  orientation: { en: 'Orientation', ja: '向き補間' },
  view: { en: 'View', ja: '表示' },
  play: { en: 'From the start', ja: '最初から再生' },
  stop: { en: 'Stop and resume', ja: '停止・再開' },
  add: { en: 'Add', ja: '追加' },
  remove: { en: 'Delete', ja: '削除' },
  earlier: { en: 'The present time, 0.1 s earlier', ja: '現在の時刻を 0.1 秒戻す' },
  later: { en: 'The present time, 0.1 s later', ja: '現在の時刻を 0.1 秒進める' },
  keyEarlier: { en: 'The chosen key, 0.1 s earlier', ja: '選んだキーの時刻を 0.1 秒早める' },
  keyLater: { en: 'The chosen key, 0.1 s later', ja: '選んだキーの時刻を 0.1 秒遅らせる' },
  axes: { en: 'Axes in front', ja: '軸を手前に表示' },
  local: { en: 'Object’s axes', ja: '物体の座標系' },
  clicks: { en: 'Four modes', ja: '4つの操作' },
  program: { en: 'The exercise’s own numbers', ja: '演習のプログラムと同じ値' },
  save: { en: 'Save', ja: '保存' },
  load: { en: 'Load', ja: '読み込み' },
  loaded: { en: 'Keys of a file. A digit returns to a scene.', ja: 'ファイルから読み込んだキーです。数字キーでシーンに戻ります。' },
  dart: { en: 'The dart again', ja: '元の物体に戻す' },
  space: { en: 'space', ja: 'スペース' },
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
  refused: {
    en: 'refused: times must ascend, within 64 s', ja: '使えない値です。時刻は昇順で、64 秒以内にしてください',
  },
  one: {
    en: 'The exercise’s program writes no matrix for one key.',
    ja: 'キーが1つのとき、演習のプログラムは行列に書き込みません。',
  },
  trace: { en: 'The present time by hand', ja: '現在の時刻の計算' },
  answers: { en: 'The blanks in code, with vecmath', ja: '空欄のコード（vecmath）' },
  operation: {
    en: 'The next operation of clicks: moves in the world, turns of the object, moves of the object, turns in the world',
    ja: 'クリックの操作を切り替え（ワールド座標系での移動、ローカル座標系での回転、ローカル座標系での移動、ワールド座標系での回転）',
  },
  segment: { en: 'segment', ja: '区間' },
  blank: { en: 'blank', ja: '空欄' },
  weight: { en: 'weight', ja: '係数' },
  control: { en: 'key', ja: 'キー' },
  canvas: {
    en: 'The key frames in space. In the picture, Tab chooses the next key; arrow keys, page up and page down ' +
      'move it, with Shift they turn it.',
    ja: '空間のキーフレームです。図の中では、Tab キーで次のキーを選び、矢印キーと PageUp、PageDown で移動します。' +
      'Shift を加えると回転します。',
  },
  programNote: {
    en: 'By the rules of the exercise’s program: segments include both ends, Bézier is not clamped outside the ' +
      'keys, the orientation without interpolation ends at the second to last key, Euler angles lose roll at a ' +
      'pitch of 90°, playback drops the rest of the step, and for one key no matrix is written.',
    ja: '演習のプログラムの規則による値です。区間は両端を含みます。Bézier 曲線はキーの範囲外でも延長されます。' +
      '補間なしの向きは、最後から2番目のキーで終わります。オイラー角は、仰角 90° で旋回角が失われます。' +
      '再生では時間刻みの余りを捨て、キーが1つのときは行列に書き込みません。',
  },
  titles: {
    time: { en: 'The present time in seconds, outside the keys too', ja: '現在の時刻（秒）。キーの範囲外も指定できます' },
    add: { en: 'Adds a key after the last', ja: '末尾にキーを追加します' },
    remove: { en: 'Deletes the last key', ja: '末尾のキーを削除します' },
    axes: { en: 'The axes of the keys are drawn through the objects', ja: 'キーの軸を物体越しに表示します' },
    local: { en: 'Handles along the axes of the object', ja: '操作軸を物体の座標系に合わせます' },
    clicks: {
      en: 'As in the exercise’s program: only the handles of one operation, and each click on the key changes it (m)',
      ja: '演習のプログラムと同じく、1つの操作の軸だけを表示し、キーをクリックするたびに操作が切り替わります（m キー）',
    },
    save: { en: 'Saves the keys as a file of the command', ja: 'キーの配置をコマンドの形式で保存します' },
    load: {
      en: 'Loads keys of a file, .json or .csv, or a model .obj with its .mtl in place of the dart; files can be dropped',
      ja: 'キーの配置（.json、.csv）、または物体のモデル（.obj と .mtl）を読み込みます。ファイルをドロップすることもできます',
    },
  },
} satisfies Record<string, Text | Record<string, Text>>;

/** What is drawn in place of the dart, and the files that would have its colours. */
export function objectText({ name, triangles, missing }: Own): string {
  const lacks = missing.join(', ');
  return say({
    en: `${name}: ${triangles} triangles.${lacks ? ` Its colours are in ${lacks}: choose both files.` : ''}`,
    ja: `${name}：三角形 ${triangles} 個。${lacks ? `色は ${lacks} にあります。両方のファイルを選んでください。` : ''}`,
  });
}
