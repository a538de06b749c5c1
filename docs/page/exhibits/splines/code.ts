// SPDX-License-Identifier: MIT
import { list, literal, program } from '../../kit/code';
import { count, names, type State } from './model';

const given = (omega: number[]) => omega.length ? `
const float given[] = ${list(omega)};
for (int k = 0; k < COUNT; k++) {
    const nkw_vec3 w = {given[3 * k], given[3 * k + 1], given[3 * k + 2]};
    omegas[k] = w;
}` : `
for (int k = 0; k < COUNT; k++) { /* those of Catmull-Rom */
    const int i = k < COUNT - 1 ? k : COUNT - 2, before = i > 0 ? i - 1 : 0, after = i + 2 < COUNT ? i + 2 : COUNT - 1;
    const nkw_quat four[] = {keys[before], keys[i], keys[i + 1], keys[after]};
    const float four_times[] = {times[before], times[i], times[i + 1], times[after]};
    omegas[k] = nkw_rotation_from_catmull_rom(four, four_times).velocity[k - i];
}`;

export const code = ({ keys, times, omega, time }: State) => program(`
enum {COUNT = ${count}, SLERP = 0, SQUAD, GLTF, HERMITE, BSPLINE, METHODS};
const char *const names[] = {${names.map(m => `"${m}"`).join(', ')}};
const char *const key_names[] = {${names.map(m => `"${m}_key"`).join(', ')}};
const float degrees[] = ${list(keys)};
const float times[] = ${list(times)}, time = ${literal(time)};
nkw_quat keys[COUNT];
for (int k = 0; k < COUNT; k++) {
    const nkw_vec3 angles = {nkw_radians_from_degrees(degrees[3 * k]), nkw_radians_from_degrees(degrees[3 * k + 1]),
                             nkw_radians_from_degrees(degrees[3 * k + 2])};
    keys[k] = nkw_quat_from_euler(angles, NKW_EULER_YXZ);
    if (k > 0 && nkw_quat_dot(keys[k - 1], keys[k]) < 0.0f)
        keys[k] = nkw_quat_negate(keys[k]);
}
nkw_vec3 omegas[COUNT];${given(omega)}

nkw_rotation_segment segments[METHODS][COUNT - 1];
for (int k = 0; k + 1 < COUNT; k++) {
    const nkw_quat four[] = {keys[k > 0 ? k - 1 : 0], keys[k], keys[k + 1], keys[k + 2 < COUNT ? k + 2 : COUNT - 1]};
    const float duration = times[k + 1] - times[k];
    segments[SLERP][k] = nkw_rotation_from_slerp(keys[k], keys[k + 1], duration, NKW_PATH_SHORT, 0);
    segments[SQUAD][k] = nkw_rotation_from_squad(four, duration);
    segments[GLTF][k] = segments[HERMITE][k] =
        nkw_rotation_from_hermite(keys[k], omegas[k], keys[k + 1], omegas[k + 1], duration);
    segments[BSPLINE][k] = nkw_rotation_from_bspline(four, duration);
}

/* glTF's cubic: tangent in, value, tangent out, with dq/dt = (w/2) q */
nkw_quat values[3 * COUNT];
for (int k = 0; k < COUNT; k++) {
    const nkw_quat w = {omegas[k].x, omegas[k].y, omegas[k].z, 0.0f};
    values[3 * k] = values[3 * k + 2] = nkw_quat_scale(nkw_quat_mul(w, keys[k]), 0.5f);
    values[3 * k + 1] = keys[k];
}
nkw_track tracks[COUNT - 1];
for (int k = 0; k + 1 < COUNT; k++) {
    const nkw_track two = {times + k, &values[3 * k].x, 2, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    tracks[k] = two;
}

const nkw_segment now = nkw_segment_find(times, COUNT, time);
const size_t k = now.index < COUNT - 1 ? now.index : COUNT - 2;
for (int m = 0; m < METHODS; m++) {
    nkw_quat_motion at = nkw_rotation_evaluate(&segments[m][k], now.index > k ? 1.0f : now.t);
    const nkw_motion_span to = {&at.value.x, &at.velocity.x, &at.acceleration.x};
    if (m == GLTF && nkw_track_sample_motion(&tracks[k], time, to) != NKW_OK)
        return 1;
    show(names[m], 0, at.velocity.x);
    show(names[m], 1, at.velocity.y);
    show(names[m], 2, at.velocity.z);
    show(names[m], 3, nkw_degrees_from_radians(nkw_vec3_length(at.velocity)));
    for (int key = 1; key + 1 < COUNT; key++) { /* the jump of the angular velocity */
        nkw_quat_motion before = nkw_rotation_evaluate(&segments[m][key - 1], 1.0f);
        nkw_quat_motion after = nkw_rotation_evaluate(&segments[m][key], 0.0f);
        const nkw_motion_span first = {NULL, &before.velocity.x, NULL}, second = {NULL, &after.velocity.x, NULL};
        if (m == GLTF && (nkw_track_sample_motion(&tracks[key - 1], times[key], first) != NKW_OK ||
                          nkw_track_sample_motion(&tracks[key], times[key], second) != NKW_OK))
            return 1;
        show(key_names[m], key - 1, nkw_degrees_from_radians(nkw_vec3_distance(before.velocity, after.velocity)));
    }
}`);
