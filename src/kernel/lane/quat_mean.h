/* SPDX-License-Identifier: MIT */
/* Means of rotations as dominant eigenvectors (quat.h, blend.h), in binary64. */
#ifndef NAKAWARI_LANE_QUAT_MEAN_H
#define NAKAWARI_LANE_QUAT_MEAN_H

#include "strict.h"

#include "quat.h"

/* The most squarings of the matrix: the ratio of two eigenvalues, taken to the power 2^32. */
#define LANE_MEAN_SQUARINGS 32

static inline double lane_f64_form_trace(const lane_f64_form *m)
{
    return (m->x.x + m->y.y) + (m->z.z + m->w.w);
}

static inline lane_f64_form lane_f64_form_scale(const lane_f64_form *m, double s)
{
    lane_f64_form r = {
        lane_f64_quat_scale(m->x, s),
        lane_f64_quat_scale(m->y, s),
        lane_f64_quat_scale(m->z, s),
        lane_f64_quat_scale(m->w, s),
    };
    return r;
}

/* m + p q^T. */
static inline lane_f64_form lane_f64_form_added(const lane_f64_form *m, lane_f64_quat p, lane_f64_quat q)
{
    lane_f64_form r = {
        lane_f64_quat_add(m->x, lane_f64_quat_scale(q, p.x)),
        lane_f64_quat_add(m->y, lane_f64_quat_scale(q, p.y)),
        lane_f64_quat_add(m->z, lane_f64_quat_scale(q, p.z)),
        lane_f64_quat_add(m->w, lane_f64_quat_scale(q, p.w)),
    };
    return r;
}

/* m m of a symmetric m. */
static inline lane_f64_form lane_f64_form_squared(const lane_f64_form *m)
{
    lane_f64_form r = {
        lane_f64_form_apply(m, m->x),
        lane_f64_form_apply(m, m->y),
        lane_f64_form_apply(m, m->z),
        lane_f64_form_apply(m, m->w),
    };
    return r;
}

/* The unit eigenvector of the largest eigenvalue of a symmetric m of trace > 0 without negative eigenvalues. */
static inline lane_f64_quat lane_f64_form_axis(lane_f64_form m)
{
    m = lane_f64_form_scale(&m, 1.0 / lane_f64_form_trace(&m));
    for (int i = 0; i < LANE_MEAN_SQUARINGS; i++) {
        m = lane_f64_form_squared(&m);
        m = lane_f64_form_scale(&m, 1.0 / lane_f64_form_trace(&m));
    }
    return lane_f64_quat_normalize(lane_f64_form_row(&m));
}

#endif
