// SPDX-License-Identifier: MIT
// The texts of the exhibit.
import type { Text } from '../../shell/text';
import type { Order } from './model';

export const controls = {
  title: { en: 'Joints', ja: '関節' },
  order: { en: 'product', ja: '積の順序' },
  axis: { en: 'axis', ja: '回転軸' },
  angle: (i: number): Text => ({ en: `J${i}: angle (rad)`, ja: `J${i} の角度 (rad)` }),
  height: (i: number): Text => ({ en: `T${i}: height`, ja: `T${i} の高さ` }),
  influence: { en: 'weights', ja: '影響度' },
  paint: { en: 'painted', ja: '色分け' },
  joint: { en: 'joint shown', ja: '表示する関節' },
  ring: { en: 'vertex', ja: '頂点' },
};

export const axisWords = { x: { en: 'x', ja: 'x 軸' }, y: { en: 'y', ja: 'y 軸' }, z: { en: 'z', ja: 'z 軸' } };
export const influenceWords = {
  smooth: { en: 'B-spline over the joints', ja: 'B スプライン' },
  hard: { en: 'one joint per vertex', ja: '1頂点に1関節' },
};
export const paintWords = {
  all: { en: 'all joints', ja: 'すべての関節' }, one: { en: 'the joint shown', ja: '表示する関節のみ' },
};

export const orderWords: Record<Order, Text> = {
  right: { en: 'M T J T⁻¹, right', ja: 'M T J T⁻¹（正しい）' },
  noParent: { en: 'T J T⁻¹, no parent', ja: 'T J T⁻¹（親なし）' },
  parentLast: { en: 'T J T⁻¹ M, parent last', ja: 'T J T⁻¹ M（親が右）' },
  swapped: { en: 'M T⁻¹ J T, T swapped', ja: 'M T⁻¹ J T（T が逆）' },
  noInverse: { en: 'M T J, no T⁻¹', ja: 'M T J（T⁻¹ なし）' },
  onlyTurn: { en: 'M J, no T', ja: 'M J（T なし）' },
};

/** What is seen with each order, and why. */
export const notes: Record<Order, Text> = {
  right: {
    en: 'Each joint rotates about its own position and moves the joints behind it.',
    ja: '各関節は自分の位置を中心に回転し、その先の関節を動かします。',
  },
  noParent: {
    en: 'The matrix of the joint before is missing: each joint rotates about its place in the bind pose, and the parts ' +
      'behind a bent joint stay behind.',
    ja: '1つ前の関節の行列を掛けていません。各関節がバインドポーズの位置で回転するだけで、曲がった関節の先の部分が付いてきません。',
  },
  parentLast: {
    en: 'The matrix of the joint before is on the right, so it acts first: a joint then rotates about its place in the ' +
      'bind pose, not about where its parent has moved it. The mesh tears as soon as two joints are bent.',
    ja: '1つ前の関節の行列が右にあるため、先に作用します。関節は、親によって動かされた先ではなく、バインドポーズの位置を中心に' +
      '回転します。2つ以上の関節を曲げるとメッシュの形が崩れます。',
  },
  swapped: {
    en: 'T and its inverse are exchanged: each joint rotates about the mirror image of its position, at minus its ' +
      'height. In the bind pose nothing is wrong, so the error is found only when a joint rotates.',
    ja: 'T とその逆行列が入れ替わっています。関節は、原点に関して反対側の、高さの符号が逆の点を中心に回転します。' +
      'バインドポーズでは正しく見えるので、回転させるまで間違いに気付きません。',
  },
  noInverse: {
    en: 'The inverse bind matrix is missing: a vertex is taken as if it were given relative to its joint. Already in the ' +
      'bind pose the parts are shifted by their heights, which add up along the chain.',
    ja: '逆バインド行列がありません。頂点の座標が関節に対するものとして扱われます。バインドポーズでも各部分が高さの分だけずれ、' +
      'そのずれは関節の鎖に沿って積み重なります。',
  },
  onlyTurn: {
    en: 'T is missing: all joints rotate about the origin, the foot of the capsule. In the bind pose nothing is wrong.',
    ja: 'T がありません。すべての関節が原点、つまりカプセルの下端を中心に回転します。バインドポーズでは正しく見えます。',
  },
};

export const labels = {
  picture: {
    en: 'The capsule in the colours of its weights, with its joints and their axes. Arrow keys turn the camera.',
    ja: '影響度で色分けしたカプセルと、関節およびその座標軸。矢印キーで視点を回します。',
  },
  joint: (j: number): Text => ({ en: `joint ${j}`, ja: `関節 ${j}` }),
  row: (r: number): Text => ({ en: `row ${r + 1}`, ja: `${r + 1} 行目` }),
  noParent: { en: 'no parent: 1', ja: '親なし：1' },
  matrices: { en: 'The matrices of the joint shown, by rows', ja: '表示する関節の行列（行ごと）' },
  vertexTable: { en: 'The vertex shown as a dot', ja: '点で示した頂点' },
  weights: { en: 'weights of 65535', ja: '影響度（和は 65535）' },
  vertex: { en: 'in the bind pose', ja: 'バインドポーズでの位置' },
  moved: { en: 'blended', ja: '変形後の位置' },
};
