// SPDX-License-Identifier: MIT
// The exhibit as a C program: it samples the characters of one clip, and prints the matrix of one joint of one of them.
import { list, program } from '../../kit/code';
import type { Cast } from './cast';

const words = (bytes: Uint8Array) => {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  return Array.from({ length: bytes.length / 4 }, (_, i) => `0x${view.getUint32(4 * i, true).toString(16)}`);
};

function lines(items: string[], length = 100) {
  const made = [''];
  for (const item of items) {
    if (made[made.length - 1].length + item.length > length)
      made.push('');
    made[made.length - 1] += `${item}, `;
  }
  return made.map(line => `    ${line.trim()}`).join('\n');
}

const matrices = (floats: number[]) => Array.from({ length: floats.length / 16 }, (_, k) =>
  `    {${list(floats.slice(16 * k, 16 * k + 16))}},`).join('\n');

export interface Shown {
  clip: number;
  from: number;
  step: number;
  count: number;
  character: number;
  joint: number;
  time: number;
}

/** Characters from, from + step, ... of `count`. */
export function crowdCode(cast: Cast, { clip, from, step, count, character, joint, time }: Shown): string {
  const { skeleton, parents } = cast.rig;
  return program(`
enum { JOINTS = ${skeleton.jointCount}, SKIN = ${cast.joints.length}, COUNT = ${count} };
enum { FROM = ${from}, STEP = ${step} };
/* The clip: the bytes that nkw_clip_build wrote. */
static const uint32_t block[] = {
${lines(words(cast.clips[clip].bytes))}
};
static const int32_t parents[JOINTS] = {${parents.join(', ')}};
static const int32_t joints[SKIN] = {${cast.joints.join(', ')}};
static const nkw_mat4 inverse_bind[SKIN] = {
${matrices(cast.inverseBind)}
};
static float pose_floats[NKW_CROWD_POSE_FLOATS(JOINTS)], model_floats[NKW_CROWD_MATRIX_FLOATS(JOINTS)];
static float palette_floats[NKW_CROWD_MATRIX_FLOATS(SKIN)], root_floats[NKW_CROWD_MATRIX_FLOATS(1)];
NKW_STACK_WORK(work, NKW_CROWD_SAMPLE_WORK(JOINTS));
static nkw_mat4 matrices[NKW_CROWD][SKIN];
const nkw_clip *clip;
if (nkw_clip_open(block, sizeof block, &clip) != NKW_OK)
    return 1;
const nkw_skeleton skeleton = {parents, JOINTS};
const nkw_crowd_poses_span poses = {pose_floats, JOINTS};
const nkw_crowd_matrices_span models = {model_floats, JOINTS}, palette = {palette_floats, SKIN};
const nkw_crowd_matrices_span roots = {root_floats, 1};
const nkw_clip_description described = nkw_clip_describe(clip);
const float start = described.start, duration = described.end - start;
const nkw_vec3 up = {0.0f, 1.0f, 0.0f};
int side = 1;
while (side * side < COUNT)
    side++;
for (int first = FROM; first < COUNT; first += STEP * NKW_CROWD) {
    float times[NKW_CROWD];
    nkw_mat4 places[NKW_CROWD], *out[NKW_CROWD] = {NULL};
    const nkw_mat4 *in[NKW_CROWD] = {NULL};
    int lanes = 0;
    for (int i = first; i < COUNT && lanes < NKW_CROWD; i += STEP, lanes++) {
        const float seconds = ${list([time]).slice(1, -1)} + (float)(i * 37 % 101) / 16.0f;
        const float size = (float)(90 + i * 5 % 11 * 2) / 100.0f, half = (float)(side - 1) / 2.0f;
        const nkw_quat heading = nkw_quat_from_axis_angle(up, (float)(i * 7 % 11 - 5) / 10.0f);
        const nkw_trs place = {{(float)(i % side) - half, 0.0f, (float)(i / side) - half}, heading, {size, size, size}};
        times[lanes] = nkw_playback_head(NKW_PLAYBACK_LOOP, start, duration, start + seconds).time;
        places[lanes] = nkw_mat4_from_trs(&place);
        in[lanes] = &places[lanes];
        out[lanes] = matrices[lanes];
    }
    const nkw_crowd_players players = {times, NULL, (size_t)lanes};
    nkw_crowd_sample(&players, clip, poses, work);
    nkw_crowd_from_matrices(in, roots);
    nkw_crowd_models_from_pose(&skeleton, NKW_VIEW(nkw_crowd_poses, poses),
                               NKW_VIEW(nkw_crowd_matrices, roots), models);
    nkw_crowd_palette_from_models(NKW_VIEW(nkw_crowd_matrices, models), joints, inverse_bind, palette);
    nkw_crowd_to_matrices(NKW_VIEW(nkw_crowd_matrices, palette), out);
    const int lane = (${character} - first) / STEP;
    if (${character} >= first && lane < lanes) {
        show("time", 0, (double)times[lane]);
        show_floats("x", 3, matrices[lane][${joint}].m);
        show_floats("y", 3, matrices[lane][${joint}].m + 4);
        show_floats("z", 3, matrices[lane][${joint}].m + 8);
        show_floats("position", 3, matrices[lane][${joint}].m + 12);
    }
}`);
}
