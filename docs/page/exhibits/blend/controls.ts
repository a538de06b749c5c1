// SPDX-License-Identifier: MIT
// Controls that more than one mode has.
import type { Panel } from '../../kit/panel';
import { type Text } from '../../shell/text';
import type { Rig } from './rig';
import { axisNames, clipNames, type State } from './state';
import { words } from './words';

const clips = Object.fromEntries(clipNames.map(name => [name, words[name]])) as Record<string, Text>;
const same = (names: readonly string[]) => Object.fromEntries(names.map(name => [name, { en: name, ja: name }]));

export const clipControl = (panel: Panel<State>, name: 'from' | 'to' | 'other', label: Text) =>
  panel.choice(name, label, clips);

export function jointControls(panel: Panel<State>, rig: Rig) {
  panel.choice('joint', words.joint, same(rig.names));
  panel.choice('axis', words.axis, same(axisNames));
}
