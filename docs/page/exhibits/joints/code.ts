// SPDX-License-Identifier: MIT
// The C program of a state: the matrices of the joint, and the vertex.
import { list, literal, program } from '../../kit/code';
import { vertex } from '../../kit/skinned';
import { clamped, front, joints, place, positions } from './mesh';
import { angles, factors, heights, vectors, type State } from './model';

const names = { P: 'P', T: 'T', J: 'J', I: 'T_inverse' };

function product(state: State): string {
  const [first, ...rest] = factors(state.order).map(f => names[f]);
  return [`M[i] = ${first};`, ...rest.map(name => `M[i] = nkw_mat4_mul(&M[i], &${name});`)].map(l => `    ${l}`).join('\n');
}

function shares(state: State): string {
  const height = positions[3 * front(state.ring) + 1];
  if (state.influence === 'hard')
    return `share[${clamped(Math.floor(height))}] = 1.0f;`;
  const { first, t } = place(height);
  return [`const nkw_weights w = nkw_cubic_weights(NKW_CUBIC_BSPLINE, 0, ${literal(t)});`,
    ...[0, 1, 2, 3].map(i => `share[${clamped(first + i)}] += w.w[${i}];`)].join('\n');
}

const used = (state: State) => Object.entries(names).filter(([f]) => !factors(state.order).includes(f as 'P'))
  .map(([, name]) => `    (void)${name};\n`).join('');

export const code = (state: State) => program(`
const float heights[] = ${list(heights(state))};
const float angles[] = ${list(angles(state))};
const nkw_vec3 axis = ${list(vectors[state.axis])};
const nkw_mat3 one = nkw_mat3_identity();
nkw_mat4 M[${joints}];
for (int i = 0; i < ${joints}; i++) {
    const nkw_mat4 P = i ? M[i - 1] : nkw_mat4_identity();
    const nkw_mat4 T = nkw_mat4_from_mat3(&one, (nkw_vec3){0.0f, heights[i], 0.0f});
    const nkw_mat4 J = nkw_mat4_from_quat(nkw_quat_from_axis_angle(axis, angles[i]));
    const nkw_mat4 T_inverse = nkw_mat4_inverse_rigid(&T);
${used(state)}${product(state)}
    if (i == ${state.joint}) {
        const nkw_mat4 *const shown[] = {&P, &T, &J, &T_inverse, &M[i]};
        const char *const letters = "PTJIM";
        for (int k = 0; k < 5; k++) {
            float rows[16];
            nkw_mat4_to_row_major(shown[k], rows);
            for (int r = 0; r < 4; r++) {
                const char name[] = {letters[k], (char)('0' + r), 0};
                show_floats(name, 4, rows + 4 * r);
            }
        }
    }
}

float share[${joints}] = {0.0f};
uint16_t weights[${joints}];
const uint16_t joints[${joints}] = {0, 1, 2, 3};
${shares(state)}
nkw_skin_normalize_weights((nkw_skin_view){share, 0, NKW_SKIN_F32}, (nkw_skin_span){weights, 0, NKW_SKIN_U16}, ${joints}, 1);
const nkw_vec3 vertex = ${list(vertex(positions, front(state.ring)))};
nkw_vec3 moved;
const nkw_skin skin = {1, ${joints}, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_U16}};
const nkw_skin_palette palette = {{M, ${joints}, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_MAT4}, 0};
const nkw_vertices_view in = {.positions = {&vertex, 0}};
const nkw_vertices_span out = {.positions = {&moved, 0}};
nkw_skin_linear(&skin, &palette, &in, &out);
for (int i = 0; i < ${joints}; i++)
    show("weights", i, weights[i]);
show_floats("vertex", 3, &vertex.x);
show_floats("moved", 3, &moved.x);`);
