// SPDX-License-Identifier: MIT
import { list, literal, program } from '../../kit/code';
import { axesOf, hasSpeeds, letters, orders, passSpeed, turnAt, unit, type Order, type State } from './model';

const axisText = (axis: number) => `{${unit(axis).map(literal).join(', ')}}`;

function poseText(state: State): string {
  const { order, by, x, y, z, miss, time } = state, [i, j] = axesOf(order);
  return by === 'pass' ? `
const nkw_vec3 first = ${axisText(i)}, second = ${axisText(j)};
const nkw_quat q = nkw_quat_mul(
    nkw_quat_from_axis_angle(second, nkw_radians_from_degrees(${literal(turnAt(time))})),
    nkw_quat_from_axis_angle(first, nkw_radians_from_degrees(${literal(miss)})));
const nkw_vec3 angles = nkw_euler_from_quat(q, NKW_EULER_${order});` : `
const float given[] = ${list([x, y, z])};
const nkw_vec3 angles = {nkw_radians_from_degrees(given[0]), nkw_radians_from_degrees(given[1]),
                         nkw_radians_from_degrees(given[2])};
const nkw_quat q = nkw_quat_from_euler(angles, NKW_EULER_${order});`;
}

/** The angles of the first n gimbals; the others are 0. */
const partly = (order: Order, n: number) => `{${letters.map((letter, axis) =>
  axesOf(order).slice(0, n).includes(axis) ? `angles.${letter}` : '0.0f').join(', ')}}`;

const speedText = (order: Order) => `
/* w = sum of speed times axis */
const nkw_vec3 w = nkw_vec3_scale(second, ${literal(passSpeed)});
const nkw_vec3 across_outer = nkw_vec3_cross(axis[1], axis[2]), across_inner = nkw_vec3_cross(axis[0], axis[1]);
show("speed", ${axesOf(order)[0]}, nkw_vec3_dot(w, across_outer) / nkw_vec3_dot(axis[0], across_outer));
show("speed", ${axesOf(order)[1]}, nkw_vec3_dot(w, axis[1]));
show("speed", ${axesOf(order)[2]}, nkw_vec3_dot(w, across_inner) / nkw_vec3_dot(axis[2], across_inner));`;

export const code = (state: State) => {
  const { order } = state, axes = axesOf(order);
  return program(`${poseText(state)}
const nkw_vec3 other = nkw_euler_alternate(angles, NKW_EULER_${order});
const nkw_vec3 turned[] = {${[0, 1, 2].map(n => partly(order, n)).join(', ')}};
const nkw_vec3 axes[] = {${axes.map(axisText).join(', ')}};
nkw_vec3 axis[3];
for (int i = 0; i < 3; i++)
    axis[i] = nkw_quat_rotate(nkw_quat_from_euler(turned[i], NKW_EULER_${order}), axes[i]);

const nkw_vec3 sets[] = {angles, other};
const char *const set_names[] = {"angles", "other"};
for (int i = 0; i < 2; i++) {
    show(set_names[i], 0, nkw_degrees_from_radians(sets[i].x));
    show(set_names[i], 1, nkw_degrees_from_radians(sets[i].y));
    show(set_names[i], 2, nkw_degrees_from_radians(sets[i].z));
}
const char *const axis_names[] = {"outer", "middle", "inner"};
for (int i = 0; i < 3; i++) {
    show(axis_names[i], 0, axis[i].x);
    show(axis_names[i], 1, axis[i].y);
    show(axis_names[i], 2, axis[i].z);
}
show("between", 0, nkw_degrees_from_radians(nkw_vec3_angle(axis[0], axis[2])));
show("q", 0, q.x);
show("q", 1, q.y);
show("q", 2, q.z);
show("q", 3, q.w);
${hasSpeeds(state) ? speedText(order) : ''}
const char *const orders[] = {${orders.map(o => `"${o}"`).join(', ')}};
const int middle_axes[] = {${orders.map(o => axesOf(o)[1]).join(', ')}};
for (int i = 0; i < 6; i++) {
    const nkw_vec3 e = nkw_euler_from_quat(q, (nkw_euler_order)i);
    const float in_degrees[] = {nkw_degrees_from_radians(e.x), nkw_degrees_from_radians(e.y),
                                nkw_degrees_from_radians(e.z)};
    const float middle = in_degrees[middle_axes[i]];
    for (int k = 0; k < 3; k++)
        show(orders[i], k, in_degrees[k]);
    show(orders[i], 3, 90.0f - (middle < 0.0f ? -middle : middle));
}`);
};
