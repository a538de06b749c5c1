// SPDX-License-Identifier: MIT
// The C program of a state: the bar, both ways to skin it, its volume and its thickness.
import { list, program } from '../../kit/code';
import { angles, around, length, middle, outline, steps } from './bar';

const count = (steps + 1) * around;

const setup = (joints: number, twist: number) => `
static const float angles[] = ${list(angles(joints, twist))};
static const float outline[${around}][2] = {${outline.map(list).join(', ')}};
static nkw_vec3 bar[${count}], bent[${count}];
static uint16_t joints[${count}][${joints}];
static float weights[${count}][${joints}];
for (int k = 0; k < ${count}; k++) {
    bar[k] = (nkw_vec3){outline[k % ${around}][0], ${length}.0f * (float)(k / ${around}) / ${steps}.0f, outline[k % ${around}][1]};
    for (int j = 0; j < ${joints}; j++) {
        const double apart = (double)(k / ${around}) / ${steps} * ${joints - 1} - j, share = 1 - (apart < 0 ? -apart : apart);
        joints[k][j] = (uint16_t)j;
        weights[k][j] = share > 0 ? (float)share : 0.0f;
    }
}`;

const skin = (joints: number) => `
nkw_mat4 models[${joints}];
nkw_dual_quat duals[${joints}];
for (int j = 0; j < ${joints}; j++)
    models[j] = nkw_mat4_from_quat(nkw_quat_from_axis_angle((nkw_vec3){0.0f, 1.0f, 0.0f}, nkw_radians_from_degrees(angles[j])));
const nkw_palette_source source = {.models = models, .model_count = ${joints}, .joint_count = ${joints}};
nkw_palette_from_models(&source, (nkw_palette_span){duals, ${joints}, NKW_PALETTE_DUAL_QUAT});
const nkw_skin skin = {${count}, ${joints}, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_F32}};
const nkw_skin_palette linear = {{models, ${joints}, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_MAT4}, 0};
const nkw_vertices_view in = {.positions = {bar, 0}};
const nkw_vertices_span out = {.positions = {bent, 0}};`;

const measure = `
for (int way = 0; way < 3; way++) {
    const nkw_vec3 *p = way ? bent : bar;
    if (way == 1)
        nkw_skin_linear(&skin, &linear, &in, &out);
    if (way == 2)
        nkw_skin_dual_quat(&skin, (nkw_palette_view){duals, skin.influence_count, NKW_PALETTE_DUAL_QUAT}, &in, &out);
    double sum = 0;
    for (int f = 0; f < ${steps * around + 2}; f++) { /* the lower end, the sides from below, the upper end */
        const int low = f - 1, next = low / ${around} * ${around} + (low + 1) % ${around}, end = f == 0 || low == ${steps * around};
        int face[${around}] = {low, next, next + ${around}, low + ${around}};
        const int n = end ? ${around} : 4;
        for (int i = 0; end && i < n; i++)
            face[i] = f ? low + i : n - 1 - i;
        for (int s = 0; s < 2; s++) /* both ways to divide the face */
            for (int i = 2; i < n; i++)
                sum += (double)nkw_vec3_dot(p[face[s]], nkw_vec3_cross(p[face[(s + i - 1) % n]], p[face[(s + i) % n]]));
    }
    show("volume", way, sum / 12);
    show("radius", way, (double)nkw_vec3_length(nkw_vec3_reject(p[${middle}], (nkw_vec3){0.0f, 1.0f, 0.0f})));
}`;

export const code = ({ joints, twist }: { joints: string; twist: number }) =>
  program([setup(Number(joints), twist), skin(Number(joints)), measure].join('\n'));
