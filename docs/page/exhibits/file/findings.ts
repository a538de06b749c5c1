// SPDX-License-Identifier: MIT
// The findings of all channels of an animation, as a list.
import { element, html } from '../../kit/html';
import { say, type Text } from '../../shell/text';
import type { Channel } from './channels';
import { check, type Finding, type Severity } from './checks';

/** What each finding means; the names are those of the command `nakawari check`. */
export const meanings: Record<string, Text> = {
  'unsorted-time': { en: 'a key is earlier than the one before it', ja: '前のキーより時刻が早いキー' },
  'duplicate-time': { en: 'two keys at one time: a jump', ja: '同じ時刻の2つのキー（値が不連続に変わります）' },
  'short-segment': { en: 'two times that differ by rounding only', ja: '丸め誤差ほどの差しかない時刻' },
  'not-finite': { en: 'infinite, or not a number', ja: '無限大、または NaN' },
  'not-unit': { en: 'a rotation whose length is not 1', ja: '長さが 1 でない回転' },
  'rounded-unit': { en: 'lengths of rotations are rounded', ja: '回転の長さに丸め誤差があります' },
  'over-half-turn': { en: 'LINEAR turns back: more than half a turn as given',
    ja: '与えられた値は半回転を超えるため、LINEAR は逆向きに回ります' },
  'sign-flip': { en: 'nearly q and −q: a player that does not negate turns the long way',
    ja: '符号の反転（ほぼ q と −q）。反転しない再生では遠回りします' },
  'half-turn': { en: 'half a turn: rounding decides the direction', ja: 'ちょうど半回転で、回る向きは丸め誤差で決まります' },
  'long-way': { en: 'CUBICSPLINE goes the long way', ja: 'CUBICSPLINE が遠回りします' },
  'non-positive-scale': { en: 'a scale that is not positive', ja: '正でないスケール' },
  unused: { en: 'animates nothing of the scene', ja: 'シーン内の何も動かしません' },
  refused: { en: 'the library refuses the track', ja: 'ライブラリがトラックを受け付けません' },
};

const severities: Record<Severity, Text> = {
  error: { en: 'error', ja: 'エラー' }, warning: { en: 'warning', ja: '警告' }, note: { en: 'note', ja: '注記' },
};
const words = {
  none: { en: 'No findings in this animation.', ja: 'このアニメーションに問題は見つかりませんでした。' },
  note: { en: 'These are the findings of <code>nakawari check</code> about single keys. The command also finds ' +
    'spare keys, constant tracks, open loops and faults of skins.',
    ja: '<code>nakawari check</code> のうち、個々のキーについての検査です。コマンドでは、不要なキー、一定のトラック、' +
      'つながらないループ、スキンの誤りも調べられます。' },
  more: { en: 'more', ja: '件は省略' },
  key: { en: 'key', ja: 'キー' },
};

export interface Checked {
  channel: Channel;
  findings: Finding[];
  total: number;
}

export const checkAll = (channels: Channel[]): Checked[] => channels.map(channel => ({ channel, ...check(channel) }));

const numberText = (x: number) => Number.isFinite(x) ? String(+x.toPrecision(6)) : String(x);

function item({ channel }: Checked, finding: Finding) {
  const { severity, what, key, time, amount } = finding;
  const at = key < 0 ? '' : ` ${say(words.key)} ${key}, ${numberText(time)} s:`;
  const data = { 'data-finding': what, 'data-key': String(key), 'data-amount': String(amount) };
  return element('li', { class: severity, ...data },
    [element('strong', {}, say(severities[severity])), ` ${channel.name}.${channel.path}${at} `,
      element('code', {}, what), ` ${say(meanings[what])}`]);
}

const note = () => html('p', say(words.note), { class: 'note' });

/** At most `most` findings as a list, with the counts before it. */
export function findingList(checked: Checked[], most = 200): HTMLElement[] {
  const all = checked.flatMap(one => one.findings.map(finding => ({ one, finding })));
  const total = checked.reduce((sum, one) => sum + one.total, 0);
  if (total === 0)
    return [element('p', { 'data-total': '0' }, say(words.none)), note()];
  const counts = (Object.keys(severities) as Severity[]).map(severity =>
    `${say(severities[severity])}: ${all.filter(x => x.finding.severity === severity).length}`);
  const shown = all.slice(0, most), left = total - shown.length;
  const more = left > 0 ? [element('li', {}, `${left} ${say(words.more)}`)] : [];
  const items = [...shown.map(({ one, finding }) => item(one, finding)), ...more];
  return [element('p', { 'data-total': String(total) }, counts.join(', ')),
    element('ul', { class: 'findings', tabindex: '0' }, items), note()];
}
