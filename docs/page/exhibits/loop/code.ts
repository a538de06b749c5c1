// SPDX-License-Identifier: MIT
// The numbers of the exhibit in C.
import { list, literal, program } from '../../kit/code';
import { nearest, rangeOf, shownKeys, unrolled, type State } from './model';

const modes = ['NKW_PLAYBACK_CLAMP', 'NKW_PLAYBACK_LOOP', 'NKW_PLAYBACK_PING_PONG'];
const notes = {
  once: 'The clip plays once.',
  loop: 'The clip repeats.',
  twice: 'The clip plays twice: the keys of both times are in the list, which does not repeat.',
  pingpong: 'The clip alternates: a period has its keys forwards, then backwards.',
};

export function code(state: State): string {
  const { times, index, period } = unrolled(state), range = rangeOf(state), near = nearest(state, state.to)!;
  return program(`
/* ${notes[state.wrap]} */
static const float times[] = ${list(times)};
static const int index[] = {${index.join(', ')}};
const float from = ${literal(state.from)}, to = ${literal(state.to)}, period = ${literal(period)};
const nkw_playback_range range = {
    0.0, ${range.duration}, 0.0, ${modes[range.before]}, ${modes[range.after]}, 0, ${range.afterCycles},
};
const nkw_play_head_f64 head = nkw_playback_head_f64(&range, to);
const nkw_playback_step step = {times, ${times.length}, period, from, to, 0};
size_t keys[${shownKeys}], passed;
const nkw_result result = nkw_playback_passed(&step, keys, ${shownKeys}, &passed);
if (result != NKW_OK && result != NKW_TOO_SMALL)
    return 1;
show("step", 0, (double)from);
show("step", 1, (double)to);
show("head", 0, head.time);
show("cycle", 0, head.cycle);
show("passed", 0, (double)passed);
for (size_t i = 0; i < passed && i < ${shownKeys}; i++)
    show("key", (int)i, (double)index[keys[i]]);
/* The four steps to and from the key that is nearest to the head. */
const float at = nkw_playback_offset(times[${near.entry}], 0.0f, period, ${near.cycle});
const float part = ${literal(state.duration / 8)};
const float starts[4] = {at - part, at, at + part, at}, stops[4] = {at, at + part, at, at - part};
static const char *const names[4] = {"forwards_to", "forwards_from", "backwards_to", "backwards_from"};
show("nearest", 0, (double)index[${near.entry}]);
show("at", 0, (double)at);
for (int i = 0; i < 4; i++) {
    const nkw_playback_step one = {&times[${near.entry}], 1, period, starts[i], stops[i], 0};
    if (nkw_playback_passed(&one, keys, ${shownKeys}, &passed) != NKW_OK)
        return 1;
    show(names[i], 0, (double)passed);
}
`);
}
