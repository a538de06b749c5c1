/* SPDX-License-Identifier: MIT */
/*
 * Ranges of packed keys, and what one step makes of a track. All sums are in binary64.
 *
 * Invariant: the knots of a track that fits are whole numbers of steps from 0 to 2^20, so every key that is read back
 * is within half a step of the track.
 *
 *     number of a key    x = low ... high                        in the unit of the track, or tan(angle / 4)
 *     base               the largest float <= low                so x - base >= 0
 *     code               (x - base) / step, less than 2^20       a float has 24 bits: 4 remain for fractions
 *
 * A rotation, whose three numbers p are those of lane/compact.h, moves by 2 (1 + w) |e| radians for an error e of p. The
 * angle's step over the largest 2 (1 + w) is therefore the step of p. Of q and -q, the one whose lowest w is higher is
 * taken for all keys, since |p|^2 = (1 - w)/(1 + w) grows beyond bounds at w = -1:
 *
 *     w          1     0     -1/2    -0.9    -1
 *     |p|        0     1     1.73    4.36    infinite            keys below -0.9 are not packed
 *
 * A constant is made where no number leaves the middle of its range by more than half a step.
 */
#include "lane/strict.h"

#include "clip_packed.h"
#include "clip_packed_numbers.h"
#include "lane/f64.h"

/* Knots are less than this, so that the line between two of them is exact to 1/16 step. */
#define PACKED_KNOT 0x1p20
/* A range must be less than this: base + range is then computed without overflow. */
#define PACKED_RANGE 0x1p127
/* The lowest w of a rotation: from here on its three numbers are too large, 4.4 and more. */
#define PACKED_LOWEST (-0.9)
/* By how much the squared length of a unit rotation differs from 1 by the rounding of its components, at most. */
#define PACKED_UNIT 0x1p-22

/*
 * Sets key 0 with the sign that keeps w of all keys as high as it can be, and the limits. The other sign exchanges the
 * limits: -high..-low in place of low..high, so it is better where -high > low.
 */
static void set_limits(const nkw_clip_track *c, size_t component, packed_range *r)
{
    packed_keys keys = {c, component, 1.0f, {0.0f, 0.0f, 0.0f, 1.0f}};
    double low = 1.0, high = -1.0;
    r->shortest = r->longest = 1.0;
    for (size_t k = 0; c->target == NKW_CLIP_ROTATION && k < c->track.count; k++) {
        lane_f64_quat q = lane_f64_quat_from(packed_next_rotation(&keys, k));
        double w = q.w * (double)keys.sign, square = lane_f64_quat_dot(q, q);
        low = w < low ? w : low;
        high = w > high ? w : high;
        r->shortest = k == 0 || square < r->shortest ? square : r->shortest;
        r->longest = k == 0 || square > r->longest ? square : r->longest;
    }
    keys.sign = low >= -high ? 1.0f : -1.0f;
    r->lowest = low >= -high ? low : -high;
    r->highest = low >= -high ? high : -low;
    r->keys = keys;
}

packed_range nkwi_packed_range(const nkw_clip_track *c, size_t component, float step)
{
    packed_range r;
    set_limits(c, component, &r);
    r.step = c->target == NKW_CLIP_ROTATION ? (double)step / (2.0 * (1.0 + r.highest)) : (double)step;
    packed_keys keys = r.keys;
    for (size_t k = 0; k < c->track.count; k++) {
        double x[3] = {0.0, 0.0, 0.0};
        packed_next_numbers(&keys, k, x);
        for (size_t i = 0; i < packed_rows_of(c); i++) {
            r.low[i] = k == 0 || x[i] < r.low[i] ? x[i] : r.low[i];
            r.high[i] = k == 0 || x[i] > r.high[i] ? x[i] : r.high[i];
        }
    }
    return r;
}

/* (float)x rounds to nearest; where that is above x, the float before: 1 less of the bits, or 1 more if negative. */
float nkwi_packed_base(double x)
{
    float f = (float)x;
    return (double)f <= x ? f : lane_float(lane_bits(f) + (f > 0.0f ? 0xffffffffu : 1u));
}

/* Whether all knots, and so all residuals, are within their limits, and the range is that of a float. */
static int fits(const nkw_clip_track *c, const packed_range *r)
{
    for (size_t i = 0; i < packed_rows_of(c); i++) {
        const double range = r->high[i] - (double)nkwi_packed_base(r->low[i]);
        if (!((float)r->step > 0.0f && range / (double)(float)r->step < PACKED_KNOT && range < PACKED_RANGE))
            return 0;
    }
    return r->lowest > PACKED_LOWEST;
}

/*
 * Whether rotations with the squared lengths of a range may have the square n. A square of 1 + d moves a point as a
 * rotation by d radians does, and rounding to steps rotates by half a step. Those of unit rotations in floats may.
 */
static int are_lengths(const packed_range *r, float step, double n)
{
    const double most = 0.5 * (double)step > PACKED_UNIT ? 0.5 * (double)step : PACKED_UNIT;
    return r->longest - n <= most && n - r->shortest <= most;
}

packed_survey nkwi_packed_survey(const nkw_clip_track *c, float step, float *middle)
{
    const int is_rotation = c->target == NKW_CLIP_ROTATION;
    packed_survey result = {c->track.count > 1 && c->track.interpolation == NKW_INTERPOLATION_LINEAR &&
                                !c->track.key_interpolation && 3 * c->track.width <= PACKED_SLOTS,
                            c->track.interpolation != NKW_INTERPOLATION_CUBICSPLINE};
    for (size_t i = 0; i < (is_rotation ? 1 : c->track.width); i++) {
        packed_range r = nkwi_packed_range(c, i, step);
        const double square = 0.5 * (r.shortest + r.longest);
        result.fits = result.fits && fits(c, &r) && are_lengths(&r, step, 1.0);
        result.is_constant = result.is_constant && are_lengths(&r, step, square);
        double p[3] = {0.0, 0.0, 0.0};
        for (size_t row = 0; row < packed_rows_of(c); row++) {
            p[row] = 0.5 * (r.low[row] + r.high[row]);
            result.is_constant = result.is_constant && r.high[row] - r.low[row] <= r.step;
        }
        if (!is_rotation) {
            middle[i] = (float)p[0] + 0.0f; /* +0 for -0 */
            continue;
        }
        /* q = (2 p, 1 - p.p)/(1 + p.p), times the length of the keys. */
        double n = (p[0] * p[0] + p[1] * p[1]) + p[2] * p[2], scale = lane_sqrt64(square) / (1.0 + n);
        for (size_t row = 0; row < 3; row++)
            middle[row] = (float)(2.0 * p[row] * scale) + 0.0f;
        middle[3] = (float)((1.0 - n) * scale);
    }
    return result;
}
