/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/quat.h>

#include "lane/quat.h"

/* Squarings of the matrix: the ratio of two eigenvalues, taken to the power 2^32. */
#define MEAN_SQUARINGS 32

static double trace_of(const lane_f64_form *m)
{
    return (m->x.x + m->y.y) + (m->z.z + m->w.w);
}

static lane_f64_form scaled(const lane_f64_form *m, double s)
{
    lane_f64_form r = {
        lane_f64_quat_scale(m->x, s),
        lane_f64_quat_scale(m->y, s),
        lane_f64_quat_scale(m->z, s),
        lane_f64_quat_scale(m->w, s),
    };
    return r;
}

/* m + weight q q^T. */
static lane_f64_form added(const lane_f64_form *m, lane_f64_quat q, double weight)
{
    lane_f64_quat w = lane_f64_quat_scale(q, weight);
    lane_f64_form r = {
        lane_f64_quat_add(m->x, lane_f64_quat_scale(q, w.x)),
        lane_f64_quat_add(m->y, lane_f64_quat_scale(q, w.y)),
        lane_f64_quat_add(m->z, lane_f64_quat_scale(q, w.z)),
        lane_f64_quat_add(m->w, lane_f64_quat_scale(q, w.w)),
    };
    return r;
}

/* m m of a symmetric m. */
static lane_f64_form squared(const lane_f64_form *m)
{
    lane_f64_form r = {
        lane_f64_form_apply(m, m->x),
        lane_f64_form_apply(m, m->y),
        lane_f64_form_apply(m, m->z),
        lane_f64_form_apply(m, m->w),
    };
    return r;
}

nkw_quat nkw_quat_mean(const nkw_quat *rotations, size_t count, const float *weights)
{
    lane_f64_form m = {{0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}};
    for (size_t i = 0; i < count; i++) {
        double weight = weights ? (double)weights[i] : 1.0;
        m = added(&m, lane_f64_quat_from(rotations[i]), weight < 0.0 ? 0.0 : weight);
    }
    double trace = trace_of(&m);
    if (trace == 0.0)
        return nkw_quat_identity();
    m = scaled(&m, 1.0 / trace);
    for (int i = 0; i < MEAN_SQUARINGS; i++) {
        m = squared(&m);
        m = scaled(&m, 1.0 / trace_of(&m));
    }
    lane_f64_quat mean = lane_f64_quat_normalize(lane_f64_form_row(&m));
    double sign = lane_f64_quat_dot(mean, lane_f64_quat_from(rotations[0])) < 0.0 ? -1.0 : 1.0;
    return lane_quat_from_f64(lane_f64_quat_scale(mean, sign));
}
