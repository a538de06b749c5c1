/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <float.h>
#include <string.h>

#include <nakawari/ik.h>
#include <nakawari/quat.h>
#include <nakawari/vec.h>

#include "ik_turn.h"
#include "lane/quat.h"
#include "lane/scalar.h"
#include "work.h"

/* Half the angle by which each joint of a chain on a line is rotated first, radians; and how exactly it is a line. */
#define CHAIN_NUDGE 0x1p-4
#define CHAIN_LINE  0x1p-36

/* Of the least squares: the damping, in squares of the chain's length, and the passes without a better result. */
#define CHAIN_DAMPING  0x1p-12
#define CHAIN_PATIENCE 24

/* A joint in model space. */
typedef struct chain_frame {
    lane_f64_quat rotation;
    lane_f64_vec3 position;
} chain_frame;

static lane_f64_vec3 bone_of(const nkw_ik_chain *chain, size_t k, lane_f64_quat rotation)
{
    return lane_f64_quat_rotate(rotation, lane_f64_vec3_from(chain->offsets[k]));
}

static chain_frame base_of(const nkw_ik_chain *chain)
{
    chain_frame base = {lane_f64_quat_unit_from(chain->rotation), lane_f64_vec3_from(chain->position)};
    return base;
}

/* From the parent's rotation and the position of joint k to its own rotation and the position of the next joint. */
static chain_frame advance(const nkw_ik_chain *chain, const nkw_quat *rotations, size_t k, chain_frame f)
{
    f.rotation = lane_f64_quat_mul(f.rotation, lane_f64_quat_unit_from(rotations[k]));
    f.position = lane_f64_vec3_add(f.position, bone_of(chain, k, f.rotation));
    return f;
}

/* The rotation of the last joint and the position of the end. */
static chain_frame end_of(const nkw_ik_chain *chain, const nkw_quat *rotations)
{
    chain_frame f = base_of(chain);
    for (size_t k = 0; k < chain->count; k++)
        f = advance(chain, rotations, k, f);
    return f;
}

float nkwi_ik_chain_error(const nkw_ik_chain *chain, const nkw_quat *rotations, nkw_vec3 target)
{
    lane_f64_vec3 end = end_of(chain, rotations).position;
    double error = lane_f64_vec3_length(lane_f64_vec3_sub(end, lane_f64_vec3_from(target)));
    return error < (double)INFINITY ? (float)error : INFINITY;
}

static int chain_is_finite(const nkw_ik_chain *chain, const nkw_ik_goal *goal, const nkw_quat *rotations)
{
    int finite = nkw_vec3_is_finite(chain->position) && nkw_quat_is_finite(chain->rotation);
    for (size_t k = 0; finite && k < chain->count; k++)
        finite = nkw_vec3_is_finite(chain->offsets[k]) && nkw_quat_is_finite(rotations[k]);
    return finite && nkw_vec3_is_finite(goal->target);
}

/* Stores the local rotation of joint k, limited. */
static void store(const nkw_ik_chain *chain, nkw_quat *rotations, size_t k, nkw_quat q)
{
    rotations[k] = chain->limits ? nkw_limit_apply(&chain->limits[k], q) : q;
}

/* Rotates joint k by `turn` in model space; `parent` and `own` are its parent's rotation and its own. */
static void rotate(const nkw_ik_chain *chain, nkw_quat *rotations, size_t k, const lane_f64_quat *parent,
                   lane_f64_quat turn, lane_f64_quat own)
{
    lane_f64_quat local = lane_f64_quat_mul(lane_f64_quat_conjugate(*parent), lane_f64_quat_mul(turn, own));
    store(chain, rotations, k, lane_quat_from_f64(lane_f64_quat_normalize(local)));
}

static double length_of(const nkw_ik_chain *chain)
{
    double sum = 0.0;
    for (size_t k = 0; k < chain->count; k++)
        sum += lane_f64_vec3_length(lane_f64_vec3_from(chain->offsets[k]));
    return sum;
}

/* Whether all joints, the end and the target are on one line; `to` is the target from the base. */
static int is_line(const nkw_ik_chain *chain, const nkw_quat *rotations, lane_f64_vec3 to, lane_f64_vec3 line)
{
    chain_frame f = base_of(chain);
    lane_f64_vec3 base = f.position, across = lane_f64_vec3_cross(to, line);
    double length = length_of(chain), most = CHAIN_LINE * (length * length) * lane_f64_vec3_dot(line, line);
    int is_on = lane_f64_vec3_dot(across, across) <= most;
    for (size_t k = 0; k < chain->count && is_on; k++) {
        f = advance(chain, rotations, k, f);
        across = lane_f64_vec3_cross(lane_f64_vec3_sub(f.position, base), line);
        is_on = lane_f64_vec3_dot(across, across) <= most;
    }
    return is_on;
}

/*
 * Curls a chain that would have to bend, but is on one line with the target. (If only joint 0 rotates, the chain stays
 * straight, and on one line with a target at or near joint 0.) The line is the longer of those to the target and to
 * the end: the other one may have no direction.
 */
static void leave_line(const nkw_ik_chain *chain, const nkw_ik_goal *goal, nkw_quat *rotations)
{
    chain_frame f = base_of(chain);
    lane_f64_vec3 to = lane_f64_vec3_sub(lane_f64_vec3_from(goal->target), f.position);
    lane_f64_vec3 line = lane_f64_vec3_sub(end_of(chain, rotations).position, f.position);
    double length = length_of(chain), d2 = lane_f64_vec3_dot(to, to);
    line = d2 > lane_f64_vec3_dot(line, line) ? to : line;
    if (chain->count < 2 || d2 >= length * length || !is_line(chain, rotations, to, line))
        return;
    double n = (double)chain->count, half = n > 16.0 ? 16.0 * CHAIN_NUDGE / n : CHAIN_NUDGE;
    lane_f64_quat turn = lane_f64_quat_from_axis_half(lane_f64_vec3_perpendicular(line), lane_sincos64(half));
    for (size_t k = 0; k < chain->count; k++) {
        lane_f64_quat own = lane_f64_quat_mul(f.rotation, lane_f64_quat_unit_from(rotations[k]));
        rotate(chain, rotations, k, &f.rotation, turn, own);
        f = advance(chain, rotations, k, f);
    }
}

/* Limits the rotations, and returns the error; a chain on a line leaves it if it has to move. */
static float begin(const nkw_ik_chain *chain, const nkw_ik_goal *goal, nkw_quat *rotations)
{
    for (size_t k = 0; k < chain->count; k++)
        store(chain, rotations, k, rotations[k]);
    float error = nkwi_ik_chain_error(chain, rotations, goal->target);
    if (goal->iterations == 0 || !(error > goal->tolerance))
        return error;
    leave_line(chain, goal, rotations);
    return nkwi_ik_chain_error(chain, rotations, goal->target);
}

/* ---- Cyclic coordinate descent ---- */

static void ccd_pass(const nkw_ik_chain *chain, lane_f64_vec3 target, nkw_quat *rotations)
{
    chain_frame f = end_of(chain, rotations);
    lane_f64_vec3 end = f.position, position = end;
    for (size_t k = chain->count; k-- > 0;) {
        lane_f64_quat parent =
            lane_f64_quat_mul(f.rotation, lane_f64_quat_conjugate(lane_f64_quat_unit_from(rotations[k])));
        position = lane_f64_vec3_sub(position, bone_of(chain, k, f.rotation));
        lane_f64_vec3 from = lane_f64_vec3_sub(end, position);
        lane_f64_quat turn = ik_turn_between(from, lane_f64_vec3_sub(target, position));
        rotate(chain, rotations, k, &parent, turn, f.rotation);
        lane_f64_quat now = lane_f64_quat_mul(parent, lane_f64_quat_unit_from(rotations[k]));
        from = lane_f64_quat_rotate(lane_f64_quat_conjugate(f.rotation), from);
        end = lane_f64_vec3_add(position, lane_f64_quat_rotate(now, from));
        f.rotation = parent;
    }
}

static nkw_ik_chain_result ccd_solve(const nkw_ik_chain *chain, const nkw_ik_goal *goal, nkw_quat *rotations)
{
    nkw_ik_chain_result r = {begin(chain, goal, rotations), 0};
    float tolerance = goal->tolerance, before = INFINITY;
    while (r.error > tolerance && r.iterations < goal->iterations && r.error != before) {
        before = r.error;
        ccd_pass(chain, lane_f64_vec3_from(goal->target), rotations);
        r.error = nkwi_ik_chain_error(chain, rotations, goal->target);
        r.iterations++;
    }
    return r;
}

/* ---- Forward and backward reaching ---- */

/* Positions beyond the floats are at their ends. */
static nkw_vec3 place_at(lane_f64_vec3 p)
{
    const double most = (double)FLT_MAX;
    lane_f64_vec3 r = {lane_limit64(p.x, -most, most), lane_limit64(p.y, -most, most), lane_limit64(p.z, -most, most)};
    return lane_vec3_from_f64(r);
}

/* From the end to the root: where each joint should be, so that the next one is where it should be. */
static void backward(const nkw_ik_chain *chain, lane_f64_vec3 target, const nkw_quat *rotations, nkw_vec3 *places)
{
    chain_frame f = base_of(chain);
    for (size_t k = 0; k < chain->count; k++) {
        places[k] = place_at(f.position);
        f = advance(chain, rotations, k, f);
    }
    for (size_t k = chain->count; k-- > 0;) {
        lane_f64_vec3 back = lane_f64_vec3_sub(lane_f64_vec3_from(places[k]), target);
        double length = lane_f64_vec3_length(lane_f64_vec3_from(chain->offsets[k]));
        target = lane_f64_vec3_add_scaled(target, lane_f64_vec3_normalize(back), length);
        places[k] = place_at(target);
    }
}

/* From the root to the end: each joint aims at the place of the next, or at the target if places is NULL. */
static void forward(const nkw_ik_chain *chain, lane_f64_vec3 target, const nkw_vec3 *places, nkw_quat *rotations)
{
    chain_frame f = base_of(chain);
    for (size_t k = 0; k < chain->count; k++) {
        lane_f64_vec3 aim = places && k + 1 < chain->count ? lane_f64_vec3_from(places[k + 1]) : target;
        lane_f64_quat own = lane_f64_quat_mul(f.rotation, lane_f64_quat_unit_from(rotations[k]));
        lane_f64_quat turn = ik_turn_between(bone_of(chain, k, own), lane_f64_vec3_sub(aim, f.position));
        rotate(chain, rotations, k, &f.rotation, turn, own);
        f = advance(chain, rotations, k, f);
    }
}

static void fabrik_pass(const nkw_ik_chain *chain, lane_f64_vec3 target, nkw_quat *rotations, nkw_vec3 *places)
{
    backward(chain, target, rotations, places);
    forward(chain, target, places, rotations);
}

static nkw_ik_chain_result fabrik_solve(const nkw_ik_chain *chain, const nkw_ik_goal *goal, nkw_quat *rotations,
                                        nkw_vec3 *places)
{
    nkw_ik_chain_result r = {begin(chain, goal, rotations), 0};
    lane_f64_vec3 target = lane_f64_vec3_from(goal->target);
    double length = length_of(chain), d = lane_f64_vec3_length(lane_f64_vec3_sub(target, base_of(chain).position));
    int stretched = d >= length;
    float tolerance = goal->tolerance, before = INFINITY;
    while (r.error > tolerance && r.iterations < goal->iterations && r.error != before) {
        before = r.error;
        if (stretched)
            forward(chain, target, NULL, rotations);
        else
            fabrik_pass(chain, target, rotations, places);
        r.error = nkwi_ik_chain_error(chain, rotations, goal->target);
        r.iterations++;
        if (stretched)
            break;
    }
    return r;
}

/* ---- Forward and backward reaching within limits ---- */

/* The upper triangle of a symmetric matrix. */
typedef struct symmetric {
    double xx, xy, xz, yy, yz, zz;
} symmetric;

/* The solution of m x = v by Cramer's rule; zero for a singular matrix. */
static lane_f64_vec3 solution_of(const symmetric *m, lane_f64_vec3 v)
{
    lane_f64_vec3 x = {m->yy * m->zz - m->yz * m->yz, m->xz * m->yz - m->xy * m->zz, m->xy * m->yz - m->xz * m->yy};
    lane_f64_vec3 y = {x.y, m->xx * m->zz - m->xz * m->xz, m->xy * m->xz - m->xx * m->yz};
    lane_f64_vec3 z = {x.z, y.z, m->xx * m->yy - m->xy * m->xy};
    double determinant = m->xx * x.x + m->xy * x.y + m->xz * x.z, scale = determinant > 0.0 ? 1.0 / determinant : 0.0;
    lane_f64_vec3 r = {lane_f64_vec3_dot(x, v) * scale, lane_f64_vec3_dot(y, v) * scale,
                       lane_f64_vec3_dot(z, v) * scale};
    return r;
}

/* Of the end's displacement J w by small rotations w of all joints: J J^T + damping. */
static symmetric normal_matrix(const nkw_ik_chain *chain, const nkw_quat *rotations, lane_f64_vec3 end, double damping)
{
    symmetric m = {damping, 0.0, 0.0, damping, 0.0, damping};
    chain_frame f = base_of(chain);
    for (size_t k = 0; k < chain->count; k++) {
        lane_f64_vec3 r = lane_f64_vec3_sub(end, f.position);
        m.xx += r.y * r.y + r.z * r.z;
        m.yy += r.x * r.x + r.z * r.z;
        m.zz += r.x * r.x + r.y * r.y;
        m.xy -= r.x * r.y;
        m.xz -= r.x * r.z;
        m.yz -= r.y * r.z;
        f = advance(chain, rotations, k, f);
    }
    return m;
}

/*
 * Damped least squares: with r_k from joint k to the end, and e from the end to the target, the least rotations w_k of
 * all joints that move the end to the target, to first order and without damping, are
 *
 *     w_k = r_k x l,     (sum of |r_k|^2 I - r_k r_k^T  + damping L^2 I) l = e
 *
 * each at most 1 rad, and then clamped by its limit.
 */
static void least_squares_pass(const nkw_ik_chain *chain, lane_f64_vec3 target, nkw_quat *rotations)
{
    lane_f64_vec3 end = end_of(chain, rotations).position;
    double length = length_of(chain);
    symmetric m = normal_matrix(chain, rotations, end, CHAIN_DAMPING * (length * length));
    lane_f64_vec3 l = solution_of(&m, lane_f64_vec3_sub(target, end));
    chain_frame f = base_of(chain);
    for (size_t k = 0; k < chain->count; k++) {
        lane_f64_vec3 w = lane_f64_vec3_cross(lane_f64_vec3_sub(end, f.position), l);
        double angle = lane_f64_vec3_length(w);
        chain_frame parent = f;
        lane_f64_quat own = lane_f64_quat_mul(f.rotation, lane_f64_quat_unit_from(rotations[k]));
        f = advance(chain, rotations, k, f);
        lane_f64_quat turn = lane_f64_quat_exp(lane_f64_vec3_scale(w, angle > 1.0 ? 0.5 / angle : 0.5));
        rotate(chain, rotations, k, &parent.rotation, turn, own);
    }
}

/* The best rotations that were found, and for how many more passes better ones are looked for. */
typedef struct chain_best {
    nkw_quat *rotations;
    float error;
    int patience;
    int is_kept; /* rotations were stored; the first ones always are, for their error may be infinite */
} chain_best;

static void keep_best(const nkw_ik_chain *chain, const nkw_quat *rotations, float error, chain_best *best)
{
    best->patience = error < 0.75f * best->error ? CHAIN_PATIENCE : best->patience - 1;
    if (best->is_kept && !(error < best->error))
        return;
    best->is_kept = 1;
    best->error = error;
    memcpy(best->rotations, rotations, chain->count * sizeof *rotations);
}

static float best_of(const nkw_ik_chain *chain, nkw_quat *rotations, const chain_best *best)
{
    memcpy(rotations, best->rotations, chain->count * sizeof *rotations);
    return best->error;
}

/* Reaching while each pass at least halves the error; then least squares; from their best, descent. */
static nkw_ik_chain_result limited_solve(const nkw_ik_chain *chain, const nkw_ik_goal *goal, nkw_quat *rotations,
                                         void *memory)
{
    enum { REACHING, SQUARES, DESCENT } stage = REACHING;
    nkw_ik_chain_result r = {begin(chain, goal, rotations), 0};
    lane_f64_vec3 target = lane_f64_vec3_from(goal->target);
    chain_best best = {memory, INFINITY, CHAIN_PATIENCE, 0};
    float before = r.error;
    for (int ends = 0; r.error > goal->tolerance && r.iterations < goal->iterations && !ends; before = r.error) {
        if (stage == REACHING)
            fabrik_pass(chain, target, rotations, memory);
        else if (stage == SQUARES)
            least_squares_pass(chain, target, rotations);
        else
            ccd_pass(chain, target, rotations);
        r.error = nkwi_ik_chain_error(chain, rotations, goal->target);
        r.iterations++;
        ends = stage == DESCENT && r.error == before;
        if (stage == REACHING && !(r.error > 0.5f * before))
            continue;
        keep_best(chain, rotations, r.error, &best);
        if (stage == SQUARES && best.patience <= 0)
            r.error = best_of(chain, rotations, &best);
        stage = stage == DESCENT || best.patience <= 0 ? DESCENT : SQUARES;
    }
    if (best.error < r.error)
        r.error = best_of(chain, rotations, &best);
    return r;
}

static nkw_result check_goal(const nkw_ik_goal *goal, nkw_ik_method method)
{
    if (method != NKW_IK_FABRIK && method != NKW_IK_CCD)
        return NKW_BAD_METHOD;
    if (goal->tolerance < 0.0f)
        return NKW_OUT_OF_RANGE;
    return goal->tolerance == goal->tolerance ? NKW_OK : NKW_NOT_FINITE;
}

nkw_result nkw_ik_chain_solve(const nkw_ik_chain *chain, const nkw_ik_goal *goal, nkw_ik_method method,
                              nkw_quat *rotations, nkw_ik_chain_result *result, nkw_work work)
{
    nkw_result status = check_goal(goal, method);
    if (status != NKW_OK)
        return status;
    if (!chain_is_finite(chain, goal, rotations))
        return NKW_NOT_FINITE;
    if (method == NKW_IK_FABRIK && !work_fits_each(work, chain->count, NKW_IK_CHAIN_WORK(1)))
        return NKW_TOO_SMALL;
    nkw_ik_chain_result reached = method == NKW_IK_CCD ? ccd_solve(chain, goal, rotations)
                                  : chain->limits      ? limited_solve(chain, goal, rotations, work.data)
                                                       : fabrik_solve(chain, goal, rotations, work.data);
    if (result)
        *result = reached;
    return NKW_OK;
}
