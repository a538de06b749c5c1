// SPDX-License-Identifier: MIT
// The texts of the exhibit.
import { degreesFromRadians } from 'nakawari/all';
import type { Text } from '../../shell/text';
import type { Factor, Order, State } from './model';

export const controls = {
  title: { en: 'Angles, heights, vertex', ja: '角度、高さ、頂点' },
  order: { en: 'Joint matrix', ja: '関節行列' },
  steps: { en: 'The steps of the lesson', ja: '授業の各段階' },
  mistakes: { en: 'Mistakes', ja: 'よくある間違い' },
  axis: { en: 'axis', ja: '回転軸' },
  angle: (i: number): Text => ({ en: `J${i}: angle (rad)`, ja: `J${i} の角度（rad）` }),
  height: (i: number): Text => ({ en: `T${i}: height`, ja: `T${i} の高さ` }),
  influence: { en: 'Weights', ja: '影響度' },
  paint: { en: 'Colours', ja: '色分け' },
  joint: { en: 'Joint', ja: '関節' },
  ring: { en: 'vertex: ring', ja: '頂点の段' },
  column: { en: 'vertex: place in the ring', ja: '頂点の段内の位置' },
  nextOrder: { en: 'next product', ja: '次の積' },
  nextJoint: { en: 'next joint', ja: '次の関節' },
  bindPose: { en: 'bind pose', ja: 'バインドポーズ' },
  up: { en: 'next vertex above', ja: '1段上の頂点' },
  down: { en: 'next vertex below', ja: '1段下の頂点' },
};

export const axisWords = { x: { en: 'x', ja: 'x 軸' }, y: { en: 'y', ja: 'y 軸' }, z: { en: 'z', ja: 'z 軸' } };
export const influenceWords = {
  smooth: { en: 'four joints', ja: '4関節' },
  hard: { en: 'one joint', ja: '1関節' },
};
export const paintWords = {
  one: { en: 'one weight', ja: '1関節' }, all: { en: 'all weights', ja: '全関節' },
};

export const orderWords: Record<Order, Text> = {
  turn: { en: 'J: rotations only', ja: 'J：回転のみ' },
  origin: { en: 'J · T⁻¹: moved to the origin', ja: 'J · T⁻¹：原点への移動まで' },
  noParent: { en: 'T · J · T⁻¹: without the parent', ja: 'T · J · T⁻¹：親なし' },
  right: { en: 'M · T · J · T⁻¹: right', ja: 'M · T · J · T⁻¹：正しい積' },
  noInverse: { en: 'M · T · J: without inverse bind', ja: 'M · T · J：逆バインド行列なし' },
  noTranslation: { en: 'M · J · T⁻¹: without T', ja: 'M · J · T⁻¹：T なし' },
  turnFirst: { en: 'M · J · T · T⁻¹: J before T', ja: 'M · J · T · T⁻¹：J と T が逆' },
  swapped: { en: 'M · T⁻¹ · J · T: T and T⁻¹ exchanged', ja: 'M · T⁻¹ · J · T：T と T⁻¹ が逆' },
  parentLast: { en: 'T · J · T⁻¹ · M: parent on the right', ja: 'T · J · T⁻¹ · M：親が右側' },
  transposed: { en: 'rows and columns exchanged', ja: '行と列の取り違え（転置）' },
  degrees: { en: 'degrees for radians', ja: 'ラジアンの引数に度を渡す' },
  unnormalised: { en: 'weights not normalised', ja: '影響度の正規化忘れ' },
};

/** When each product is seen. */
export const notes: Record<Order, Text> = {
  turn: {
    en: 'You see this when the vertices are only rotated (the lesson, 2.1): all joints rotate about the origin.',
    ja: '頂点を回転させただけのとき（授業の 2.1）、このように表示されます。すべての関節が原点を中心に回転します。',
  },
  origin: {
    en: 'You see this when T⁻¹ has moved each joint to the origin and T has not yet moved it back (the lesson, 2.2).',
    ja: 'T⁻¹ で各関節を原点に移し、T でまだ戻していないとき（授業の 2.2）、このように表示されます。',
  },
  noParent: {
    en: 'You see this when the matrix of the parent joint is missing (the lesson, 2.2): a part bends in its place, ' +
      'and the parts of its children do not follow.',
    ja: '親の関節の行列を掛けていないとき（授業の 2.2）、このように表示されます。各部分がその場で曲がるだけで、' +
      '先の部分が付いてきません。',
  },
  right: {
    en: 'Each joint rotates about its own position and moves its children. The coloured columns of J and M ' +
      'are the rotated axes.',
    ja: '各関節は自分の位置を中心に回転し、その先の関節を動かします。J と M の色付きの列は、回転後の座標軸です。',
  },
  noInverse: {
    en: 'You see this when the inverse bind matrix is missing: even in the bind pose, each part is too high by the ' +
      'heights of its joint and of all its parents.',
    ja: '逆バインドポーズ行列 T⁻¹ を掛け忘れると、このように表示されます。バインドポーズでも、各部分が、' +
      'その関節までの高さの合計だけ上にずれます。',
  },
  noTranslation: {
    en: 'You see this when T is missing: T⁻¹ lowers each part, and nothing lifts it again; along the chain the parts ' +
      'sink through the floor.',
    ja: 'T を掛け忘れると、このように表示されます。T⁻¹ で下がった各部分が元に戻らず、先の関節ほど床の下に沈みます。',
  },
  turnFirst: {
    en: 'You see this when J and T are multiplied in the wrong order: T and T⁻¹ cancel, and all joints rotate about ' +
      'the origin. In the bind pose nothing is wrong.',
    ja: 'J と T を逆の順に掛けると、このように表示されます。T と T⁻¹ が打ち消し合い、' +
      'すべての関節が原点を中心に回転します。バインドポーズでは正しく見えます。',
  },
  swapped: {
    en: 'You see this when T and T⁻¹ are exchanged: each joint rotates about a point as far below the origin as the ' +
      'joint is above it. In the bind pose nothing is wrong.',
    ja: 'T と T⁻¹ を取り違えると、このように表示されます。各関節が、原点に関して反対側にある点を中心に回転します。' +
      'バインドポーズでは正しく見えます。',
  },
  parentLast: {
    en: 'You see this when the matrix of the parent joint is on the right: a joint rotates about its place in the ' +
      'bind pose, not where its parent has moved it. With one bent joint nothing is wrong.',
    ja: '親の関節の行列を右から掛けると、このように表示されます。関節が、親によって動かされた位置ではなく、' +
      'バインドポーズでの位置を中心に回転します。曲げた関節が1つだけなら正しく見えます。',
  },
  transposed: {
    en: 'You see this when matrices stored by columns are read by rows: rotations are inverse, and the translation ' +
      'is in the last row, which is not used. (A shader divides by w in addition.)',
    ja: '列ごとに格納した行列を行ごとに読むと、このように表示されます。回転が逆向きになり、' +
      '平行移動は使われない第4行に入ります。（シェーダでは、さらに w による除算も加わります。）',
  },
  degrees: {
    en: 'You see this when a function of radians is given degrees: half a radian becomes 28.6 rad, four and a half ' +
      'turns. A small change of the angle makes a joint spin.',
    ja: 'ラジアンを受け取る関数に度の値を渡すと、このように表示されます。0.5 rad のつもりが 28.6 rad、' +
      'つまり約4回転半になり、角度を少し変えるだけで関節が激しく回ります。',
  },
  unnormalised: {
    en: 'You see this when the weights do not sum to 65535, here because only the two largest of four are kept: the ' +
      'missing share pulls a vertex to the origin.',
    ja: '影響度の和が 65535 にならないとき、このように表示されます。ここでは4つのうち大きい方の2つだけを残しました。' +
      '足りない分だけ頂点が原点に引き寄せられます。',
  },
};

export const blockWords: Record<Factor | 'M', Text> = {
  M: { en: 'palette', ja: 'パレット' },
  P: { en: 'parent joint', ja: '親の関節' },
  T: { en: 'bind pose', ja: 'バインドポーズ' },
  J: { en: '', ja: '' },
  I: { en: 'inverse bind', ja: '逆バインド' },
};

export const labels = {
  picture: {
    en: 'The capsule in the colours of its weights, with its joints and their axes. A click chooses a vertex. Arrow ' +
      'keys turn the camera.',
    ja: '影響度で色分けしたカプセルと、関節およびその座標軸。クリックで頂点を選びます。矢印キーで視点を回します。',
  },
  handle: (j: number, angle: number): Text => ({
    en: `angle of joint ${j}: ${angle.toFixed(2)} rad`, ja: `関節 ${j} の角度：${angle.toFixed(2)} rad` }),
  joint: (j: number): Text => ({ en: `joint ${j}`, ja: `関節 ${j}` }),
  weightOf: (j: number): Text => ({ en: `weight of joint ${j}`, ja: `関節 ${j} の影響度` }),
  noParent: { en: 'no parent', ja: '親なし' },
  turned: ({ order, axis }: State, angle: number) =>
    `${(order === 'degrees' ? degreesFromRadians(angle) : angle).toFixed(2)} rad, ${axis}`.replace('-', '−'),
  matrices: { en: 'The matrices of the joint', ja: '関節の行列' },
  vertexTable: { en: 'Vertex v, weights w, blended: Σ w M v', ja: '頂点 v、影響度 w、変形後：Σ w M v' },
  columns: ['w', 'w / 65535', 'x', 'y', 'z'],
  bind: 'v',
  moves: (j: number) => `M<sub>${j}</sub>v`,
  blended: 'Σ',
};
