// SPDX-License-Identifier: MIT
// The C program of a state: the matrices of the joint, and the vertex.
import { list, literal, program } from '../../kit/code';
import { vertex } from '../../kit/skinned';
import { clamped, joints, place, positions } from './mesh';
import { angles, factors, heights, vectors, type Factor, type State } from './model';
import { chosen } from './skin';

const names: Record<Factor, string> = { P: 'P', T: 'T', J: 'J', I: 'T_inverse' };

/** The declarations of the factors that a product uses. */
function declared({ order }: State): string {
  const used = factors(order), turn = order === 'degrees' ? 'nkw_degrees_from_radians(angles[i])' : 'angles[i]';
  return [
    ...(used.includes('P') ? ['const nkw_mat4 P = i ? product[i - 1] : nkw_mat4_identity();'] : []),
    ...(used.includes('T') || used.includes('I') ?
      ['const nkw_mat4 T = nkw_mat4_from_mat3(&one, (nkw_vec3){0.0f, heights[i], 0.0f});'] : []),
    `const nkw_mat4 J = nkw_mat4_from_quat(nkw_quat_from_axis_angle(axis, ${turn}));`,
    ...(used.includes('I') ? ['const nkw_mat4 T_inverse = nkw_mat4_inverse_rigid(&T);'] : []),
  ].join('\n    ');
}

function product({ order }: State): string {
  const [first, ...rest] = factors(order).map(f => names[f]);
  return [`product[i] = ${first};`, ...rest.map(name => `product[i] = nkw_mat4_mul(&product[i], &${name});`),
    `M[i] = ${order === 'transposed' ? 'nkw_mat4_transpose(&product[i])' : 'product[i]'};`].join('\n    ');
}

const matrices = (state: State) => `
const float heights[] = ${list(heights(state))};
const float angles[] = ${list(angles(state))};
const nkw_vec3 axis = ${list(vectors[state.axis])};
const nkw_mat3 one = nkw_mat3_identity();
nkw_mat4 product[${joints}], M[${joints}];
for (int i = 0; i < ${joints}; i++) {
    ${declared(state)}
    ${product(state)}
    if (i == ${state.joint}) {
        const nkw_mat4 *const shown[] = {&M[i], ${factors(state.order).map(f => `&${names[f]}`).join(', ')}};
        const char *const letters = "M${factors(state.order).join('')}";
        for (int k = 0; letters[k]; k++) {
            float rows[16];
            nkw_mat4_to_row_major(shown[k], rows);
            for (int r = 0; r < 4; r++) {
                const char name[] = {letters[k], (char)('0' + r), 0};
                show_floats(name, 4, rows + 4 * r);
            }
        }
    }
}
(void)heights;
(void)one;`;

function shares(state: State): string {
  const height = positions[3 * chosen(state) + 1];
  if (state.influence === 'hard')
    return `share[${clamped(Math.floor(height))}] = 1.0f;`;
  const { first, t } = place(height);
  return [`const nkw_weights spline = nkw_cubic_weights(NKW_CUBIC_BSPLINE, 0, ${literal(t)});`,
    ...[0, 1, 2, 3].map(i => `share[${clamped(first + i)}] += spline.w[${i}];`)].join('\n');
}

const keepTwo = `
uint16_t all[${joints}];
for (int i = 0; i < ${joints}; i++)
    all[i] = weights[i];
for (int i = 0; i < ${joints}; i++) { /* only the two largest are kept */
    int before = 0;
    for (int j = 0; j < ${joints}; j++)
        before += all[j] > all[i] || (all[j] == all[i] && j < i);
    weights[i] = before < 2 ? all[i] : 0;
}`;

const weights = (state: State) => `
float share[${joints}] = {0.0f};
uint16_t weights[${joints}];
const uint16_t joints[${joints}] = {0, 1, 2, 3};
${shares(state)}
const nkw_skin_view from = {share, 0, NKW_SKIN_F32};
nkw_skin_normalize_weights(from, ${joints}, 1, (nkw_skin_span){weights, 0, NKW_SKIN_U16});
${state.order === 'unnormalised' ? keepTwo : ''}
int sum = 0;
for (int i = 0; i < ${joints}; i++) {
    show("weights", i, weights[i]);
    show("share", i, weights[i] / 65535.0);
    sum += weights[i];
}
show("sum", 0, sum);
show("sum", 1, sum / 65535.0);`;

const moved = (state: State) => `
const nkw_vec3 vertex = ${list(vertex(positions, chosen(state)))};
for (int i = 0; i < ${joints}; i++) {
    const nkw_vec3 p = nkw_mat4_transform_point(&M[i], vertex);
    const char name[] = {'b', 'y', (char)('0' + i), 0};
    show_floats(name, 3, &p.x);
}
nkw_vec3 moved;
const nkw_skin skin = {1, ${joints}, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_U16}};
const nkw_skin_palette palette = {{M, ${joints}, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_MAT4}, {0, 0, 0}};
const nkw_vertices_view in = {.positions = {&vertex, 0}};
const nkw_vertices_span out = {.positions = {&moved, 0}};
nkw_skin_linear(&skin, &palette, in, out);
show_floats("vertex", 3, &vertex.x);
show_floats("moved", 3, &moved.x);`;

export const code = (state: State) => program([matrices, weights, moved].map(part => part(state)).join('\n'));
