// SPDX-License-Identifier: MIT
// The texts of the exhibit.
import type { Text } from '../../shell/text';
import type { Mode, Way } from './bar';

export const modeWords: Record<Mode, Text> = {
  twist: { en: 'twist', ja: 'ねじり' }, bend: { en: 'bend', ja: '曲げ' },
};
export const jointWords = { 3: { en: '3 joints', ja: '関節3個' }, 5: { en: '5 joints', ja: '関節5個' } };

/** Without a number of joints, for a legend. */
export const wayWords = (joints = ''): Record<Way, Text> => ({
  linear: { en: 'linear blend', ja: '線形ブレンド' },
  dual: { en: 'dual quaternions', ja: 'デュアルクォータニオン' },
  more: { en: `linear blend, ${joints || 'more'} joints`, ja: `線形ブレンド、関節${joints ? `${joints}個` : '追加'}` },
});

export const words = {
  mode: { en: 'Motion', ja: '動き' },
  joints: { en: 'Third bar', ja: '3本目の角柱' },
  panel: { en: 'The angle of the end', ja: '端の角度' },
  angles: { twist: { en: 'twist (degrees)', ja: 'ねじり（度）' }, bend: { en: 'bend (degrees)', ja: '曲げ（度）' } },
  volume: { en: 'Volume (m³)', ja: '体積（m³）' },
  degrees: { en: 'degrees', ja: '度' },
  table: { en: 'Measures', ja: '測定値' },
  columns: [{ en: 'bind', ja: '元の形' }, { en: 'linear', ja: '線形' }, { en: 'dual', ja: '双対' },
    { en: 'more', ja: '追加' }],
  volumes: { en: 'volume (m³)', ja: '体積（m³）' },
  radii: {
    twist: { en: 'corner to bone, half way up (m)', ja: '中央の角とボーンの距離（m）' },
    bend: { en: 'outer side to joint, half way up (m)', ja: '中央の外側と関節の距離（m）' },
  },
  bulges: { en: 'bulge: outer side to bone, at most (m)', ja: '膨らみ：外側とボーンの最大距離（m）' },
  formula: {
    en: ', a, b, c: the corners of each triangle of the surface. A part that is inside twice counts twice.',
    ja: '（a、b、c は表面の各三角形の頂点）。2重に囲まれた部分は2回数えます。',
  },
};

/** What happens, and what helps. */
export const notes: Record<Mode, Text> = {
  twist: {
    en: 'Linear blend moves a vertex straight from one place to the other, so a section half way is smaller by the ' +
      'cosine of half the angle. Dual quaternions move it on an arc, the shorter one: past 180° they turn back. ' +
      'Twist joints between the ends, each with its share of the twist, let linear blend keep more of the volume.',
    ja: '線形ブレンドは頂点を直線に沿って動かすため、中央の断面は、角度の半分の余弦倍に縮みます。' +
      'デュアルクォータニオンは円弧に沿って動かしますが、短い方の弧を通るので、180° を超えると逆向きになります。' +
      '両端の間にツイスト関節を置き、ねじりを分担させると、線形ブレンドでも体積があまり減りません。',
  },
  bend: {
    en: 'Linear blend moves the outer side of the elbow towards the joint and loses volume. Dual quaternions keep ' +
      'its distance to the joint, so that the skin beside the elbow bulges beyond the arm (the table has the most of ' +
      'the lower half). Joints at the same place with a share of the bend each bring linear blend near to dual ' +
      'quaternions, with less of the bulge.',
    ja: '線形ブレンドでは、肘の外側が関節に近づき、体積が減ります。デュアルクォータニオンは関節からの距離を保つため、' +
      '肘の近くで腕より外に膨らみます（表は下半分での最大値です）。同じ位置に関節を加え、曲げを分担させると、' +
      '線形ブレンドでもデュアルクォータニオンに近い形になり、膨らみも抑えられます。',
  },
};
export const help = {
  en: 'The share of a joint: <code>quat_swing_twist</code>, then <code>quat_pow</code>.',
  ja: '分担の計算：<code>quat_swing_twist</code> と <code>quat_pow</code>。',
};
export const picture = {
  en: 'Three bars: linear blend, dual quaternions, linear blend with more joints. Arrow keys turn the camera.',
  ja: '3本の角柱。線形ブレンド、デュアルクォータニオン、関節を加えた線形ブレンドです。矢印キーで視点を回します。',
};
