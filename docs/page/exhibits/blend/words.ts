// SPDX-License-Identifier: MIT
// The texts that more than one mode has.
import type { Text } from '../../shell/text';

export const words = {
  change: { en: 'Change', ja: '切り替え' },
  pair: { en: 'Two clips', ja: '2つのクリップ' },
  additive: { en: 'Additive', ja: '加算' },
  springs: { en: 'Springs', ja: 'ばね' },
  modes: { en: 'What is shown', ja: '表示の選択' },
  loading: { en: 'Loading the character …', ja: 'キャラクターを読み込んでいます…' },
  failed: { en: 'The character does not load: ', ja: 'キャラクターを読み込めません：' },
  walk: { en: 'walk', ja: '歩く' },
  wave: { en: 'wave', ja: '手を振る' },
  hop: { en: 'hop', ja: '跳ねる' },
  seconds: { en: 'time (s)', ja: '時刻（秒）' },
  from: { en: 'first clip', ja: '1つ目のクリップ' },
  to: { en: 'second clip', ja: '2つ目のクリップ' },
  joint: { en: 'joint', ja: '関節' },
  axis: { en: 'plotted axis', ja: 'グラフの軸' },
  weight: { en: 'weight', ja: '重み' },
  angle: { en: 'Rotation of the joint about the axis (degrees)', ja: '関節の軸まわりの回転（度）' },
  angles: { en: 'Rotation vector now, x y z (degrees)', ja: '現在の回転ベクトル x y z（度）' },
} satisfies Record<string, Text>;
