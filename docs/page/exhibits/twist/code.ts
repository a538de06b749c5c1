// SPDX-License-Identifier: MIT
// The C program of a state: the bar, skinned in three ways, and its measures.
import { list, literal, program } from '../../kit/code';
import { around, length, middle, motions, outline, pivot, steps } from './bar';
import { degreesOf, type State } from './model';

const count = (steps + 1) * around;

const setup = ({ mode }: State, joints: number) => `
enum { VERTICES = ${count}, JOINTS = ${joints} };
static const float outline[${around}][2] = {${outline.map(list).join(', ')}};
static nkw_vec3 bar[VERTICES], bent[VERTICES];
static uint16_t joints[VERTICES][JOINTS];
static float weights[VERTICES][JOINTS];
const nkw_vec3 bone = {0.0f, 1.0f, 0.0f}, pivot = ${list(pivot)};
for (int k = 0; k < VERTICES; k++) {
    const double height = ${length}.0 * (k / ${around}) / ${steps};
    bar[k] = (nkw_vec3){outline[k % ${around}][0], (float)height, outline[k % ${around}][1]};
}
const nkw_quat q = nkw_quat_from_axis_angle((nkw_vec3)${list(motions[mode].axis)}, nkw_radians_from_degrees(angle));
const nkw_swing_twist parts = nkw_quat_swing_twist(q, bone);
const nkw_mat3 one = nkw_mat3_identity();
const nkw_mat4 T = nkw_mat4_from_mat3(&one, pivot), T_inverse = nkw_mat4_inverse_rigid(&T);
nkw_mat4 models[JOINTS];
nkw_dual_quat duals[JOINTS];`;

/** One way: `n` joints. */
const skin = ({ mode }: State) => `
    const int n = way == 3 ? JOINTS : 2;
    for (int k = 0; k < VERTICES; k++)
        for (int j = 0; j < n; j++) {
            double up = (${length}.0 * (k / ${around}) / ${steps} - 1.5) / ${motions[mode].spread.toFixed(1)} + 0.5;
            up = up < 0 ? 0 : up > 1 ? 1 : up;
            double apart = up * (n - 1) - j;
            apart = apart < 0 ? -apart : apart;
            joints[k][j] = (uint16_t)j;
            weights[k][j] = apart < 1 ? (float)(1 - apart) : 0.0f;
        }
    for (int j = 0; j < n; j++) {
        const float share = (float)((double)j / (n - 1));
        const nkw_quat J = nkw_quat_mul(nkw_quat_pow(parts.swing, share), nkw_quat_pow(parts.twist, share));
        const nkw_mat4 turn = nkw_mat4_from_quat(J), TJ = nkw_mat4_mul(&T, &turn);
        models[j] = nkw_mat4_mul(&TJ, &T_inverse);
    }
    const nkw_palette_source source = {.models = models, .model_count = (size_t)n, .joint_count = (size_t)n};
    nkw_palette_from_models(&source, (nkw_palette_span){duals, (size_t)n, NKW_PALETTE_DUAL_QUAT});
    const nkw_skin skin = {VERTICES, (size_t)n, {joints, sizeof joints[0], NKW_SKIN_U16},
        {weights, sizeof weights[0], NKW_SKIN_F32}};
    const nkw_skin_palette linear = {{models, (size_t)n, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_MAT4}, {0, 0, 0}};
    const nkw_vertices_view in = {.positions = {bar, 0}};
    const nkw_vertices_span out = {.positions = {bent, 0}};
    if (way == 2)
        nkw_skin_dual_quat(&skin, (nkw_palette_view){duals, (size_t)n, NKW_PALETTE_DUAL_QUAT}, in, out);
    else
        nkw_skin_linear(&skin, &linear, in, out);
    const nkw_vec3 *const p = way ? bent : bar;`;

const measureVolume = `
    double sum = 0;
    for (int f = 0; f < ${steps * around + 2}; f++) { /* the lower end, the sides from below, the upper end */
        const int low = f - 1, next = low / ${around} * ${around} + (low + 1) % ${around};
        const int end = f == 0 || low == ${steps * around}, corners = end ? ${around} : 4;
        int face[${around}] = {low, next, next + ${around}, low + ${around}};
        for (int i = 0; end && i < corners; i++)
            face[i] = f ? low + i : corners - 1 - i;
        for (int s = 0; s < 2; s++) /* both ways to divide the face */
            for (int i = 2; i < corners; i++) {
                const nkw_mat3 m = nkw_mat3_from_columns(p[face[s]], p[face[(s + i - 1) % corners]],
                    p[face[(s + i) % corners]]);
                sum += (double)nkw_mat3_determinant(&m);
            }
    }
    show("volume", way, sum / 12);`;

const measureRadius = ({ mode }: State) => mode === 'twist' ? `
    show("radius", way, (double)nkw_vec3_length(nkw_vec3_reject(p[${middle}], bone)));` : `
    show("radius", way, (double)nkw_vec3_length(nkw_vec3_sub(p[${middle + 1}], pivot)));
    float most = p[0].x;
    for (int k = 1; k < ${middle + around}; k++)
        most = p[k].x > most ? p[k].x : most;
    show("bulge", way, (double)most);`;

export const code = (state: State) => program([
  `const float angle = ${literal(degreesOf(state))};${setup(state, Number(state.joints))}`,
  `for (int way = 0; way < 4; way++) { /* bind pose, linear blend, dual quaternions, linear blend of more joints */`,
  `${skin(state)}${measureVolume}${measureRadius(state)}`, '}'].join('\n'));
