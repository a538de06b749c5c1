// SPDX-License-Identifier: MIT
// The last passings as a list, and one sentence for screen readers when the head has come to rest.
import { element } from '../../kit/html';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import type { Passing, State } from './model';

const words = {
  log: { en: 'The last keys that were passed', ja: '最後に通過したキー' },
  key: { en: 'key', ja: 'キー' },
  time: { en: 'running time (s)', ja: '経過時間（秒）' },
  way: { en: 'direction', ja: '向き' },
  forwards: { en: 'forwards →', ja: '順方向 →' },
  backwards: { en: 'backwards ←', ja: '逆方向 ←' },
  rest: { en: 'The head rests. Keys passed: ', ja: '再生ヘッドが止まりました。通過したキー：' },
};
const rows = 6, pause = 700, spoken = 12;

export function makeLog(room: Room<State>) {
  const body = element('tbody'), live = element('p', { role: 'status', class: 'note passings' });
  const head = element('tr', {}, [words.time, words.key, words.way].map(text =>
    element('th', { scope: 'col' }, say(text))));
  const table = element('table', { class: 'numbers log' }, [element('caption', {}, say(words.log)),
    element('thead', {}, head), body]);
  let unsaid: number[] = [], timer = 0;
  const tell = () => {
    const more = unsaid.length > spoken ? ` … (${unsaid.length})` : '';
    if (unsaid.length)
      live.textContent = say(words.rest) + unsaid.slice(0, spoken).join(', ') + more;
    unsaid = [];
  };
  room.closed(() => clearTimeout(timer));
  room.side.append(table, live);
  return {
    /** Adds the keys of a step, the last one on top. */
    add(list: Passing[], way: number) {
      const direction = say(way > 0 ? words.forwards : words.backwards);
      const made = list.slice(-rows).map(({ at, key }) => element('tr', {},
        [at.toFixed(3).replace('-', '−'), String(key), direction].map(text => element('td', {}, text))));
      body.prepend(...made.reverse());
      [...body.rows].slice(rows).forEach(row => row.remove());
      unsaid.push(...list.map(p => p.key));
      clearTimeout(timer);
      timer = window.setTimeout(tell, pause);
    },
  };
}
