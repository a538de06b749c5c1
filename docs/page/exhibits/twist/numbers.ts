// SPDX-License-Identifier: MIT
// The measures of the bar in the bind pose and in the three ways to skin it.
import { element } from '../../kit/html';
import { numberTable } from '../../kit/numbers';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { bulge, positions, radius, volume, ways, type Bars } from './bar';
import { degreesOf, type State } from './model';
import { words } from './words';

export function measures(room: Room<State>, bars: Bars) {
  const table = numberTable(room, words.table, () => {
    const { state } = room, { mode, joints } = state, degrees = degreesOf(state);
    const list = [positions, ...ways.map(way => bars.skin(mode, way, Number(joints), degrees))];
    return [
      { name: 'volume', label: words.volumes, values: list.map(volume) },
      { name: 'radius', label: words.radii[mode], values: list.map(p => radius(mode, p)) },
      ...(mode === 'bend' ? [{ name: 'bulge', label: words.bulges, values: list.map(bulge) }] : []),
    ];
  });
  const head = words.columns.map(name => element('th', { scope: 'col', style: 'text-align: right' }, say(name)));
  table.createTHead().append(element('tr', {}, [element('td'), ...head]));
}
