// SPDX-License-Identifier: MIT
// A channel as a C program: its keys as a track, and its value at the present time.
import { list, program } from '../../kit/code';
import type { Channel } from './channels';

const most = 20000;

export function fileCode(channel: Channel, time: number): string {
  const { times, values, width, mode, property, path, name } = channel;
  if (values.length > most)
    return `/* ${name}.${path} has ${values.length} numbers: more than ${most} are not copied. */\n`;
  const kind = property === 'quaternion' ? 'NKW_TRACK_ROTATION' : 'NKW_TRACK_FLOATS';
  return program(`
/* The keys of a channel, as in the file. */
static const float times[] = ${list(times)};
static const float values[] = ${list(values)};
const nkw_track track = {times, values, ${times.length}, ${width}, ${kind}, NKW_INTERPOLATION_${mode}, NULL};
float value[${width}] = {0};
size_t bad;
if (nkw_track_validate(&track, &bad) != NKW_OK)
    return 1;
nkw_track_sample(&track, ${list([time]).slice(1, -1)}, NULL, value);
show_floats("value", ${width}, value);`);
}
