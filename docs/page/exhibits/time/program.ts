// SPDX-License-Identifier: MIT
// The C program of a state: the point of each policy, its handles, and the two segments of a split.
import { list, literal, program } from '../../kit/code';
import { policies, type State } from './segment';

const split = (s: State) => `

nkw_handle_segment first = nkw_handle_limit(&segment, (nkw_handle_policy)${policies.indexOf(s.policy)}), second;
nkw_handle_split(&first, time, &first, &second);
show_floats("key", 2, (const float[]){second.time0, second.value0});
show_floats("left", 4, (const float[]){first.out.time, first.out.value, first.in.time, first.in.value});
show_floats("right", 4, (const float[]){second.out.time, second.out.value, second.in.time, second.in.value});`;

export const code = (s: State) => program(`
static const char *const names[] = {"none", "contain", "ratio", "start"};
static const char *const handles[] = {"none_handles", "contain_handles", "ratio_handles", "start_handles"};
const float given[8] = ${list(s.segment)}, time = ${literal(s.time)};
const nkw_handle_segment segment = {given[0], given[1], {given[2], given[3]}, {given[4], given[5]}, given[6], given[7]};
for (int i = 0; i < 4; i++) {
    const nkw_handle_segment limited = nkw_handle_limit(&segment, (nkw_handle_policy)i);
    const nkw_motion point = nkw_handle_sample(&limited, time);
    const float shown[3] = {point.value, point.velocity, nkw_handle_parameter(&limited, time)};
    const float lengths[4] = {limited.out.time, limited.out.value, limited.in.time, limited.in.value};
    show_floats(names[i], 3, shown);
    show_floats(handles[i], 4, lengths);
}
show("runs_back", 0, nkw_handle_runs_back(&segment));${s.split ? split(s) : ''}`);
