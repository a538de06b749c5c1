/* SPDX-License-Identifier: MIT */
/*
 * Ranges of packed keys, and what one step makes of a track. All sums are in binary64.
 *
 * Invariant: the knots of a track that fits are whole numbers of steps from 0 to 2^20, so every key that is read back
 * is within half a step of the track.
 *
 *     number of a key    x = low ... high                        in the unit of the track, or tan(angle / 4)
 *     base               the largest float of 8 digits <= low    so x - base >= 0
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
 * The limits of w and of the squared length, and the sign that keeps w of all keys as high as it can be. The other sign
 * exchanges the limits: -high..-low in place of low..high, so it is better where -high > low.
 */
static void measure_lengths(const nkw_clip_track *c, packed_extent *e)
{
    packed_keys keys = {c, 0, 1.0f, {0.0f, 0.0f, 0.0f, 1.0f}};
    double low = 1.0, high = -1.0;
    for (size_t k = 0; k < c->track.count; k++) {
        lane_f64_quat q = lane_f64_quat_from(packed_next_rotation(&keys, k));
        double w = q.w * (double)keys.sign, square = lane_f64_quat_dot(q, q);
        low = w < low ? w : low;
        high = w > high ? w : high;
        e->shortest = k == 0 || square < e->shortest ? square : e->shortest;
        e->longest = k == 0 || square > e->longest ? square : e->longest;
    }
    e->sign = low >= -high ? 1.0 : -1.0;
    e->lowest = low >= -high ? low : -high;
    e->highest = low >= -high ? high : -low;
}

/* The limits of the numbers of a rotation, or of one component. */
static void measure_numbers(const nkw_clip_track *c, size_t component, float sign, double *low, double *high)
{
    packed_keys keys = {c, component, sign, {0.0f, 0.0f, 0.0f, 1.0f}};
    for (size_t k = 0; k < c->track.count; k++) {
        double x[3] = {0.0, 0.0, 0.0};
        packed_next_numbers(&keys, k, x);
        for (size_t i = 0; i < packed_rows_of(c); i++) {
            low[i] = k == 0 || x[i] < low[i] ? x[i] : low[i];
            high[i] = k == 0 || x[i] > high[i] ? x[i] : high[i];
        }
    }
}

void nkwi_packed_measure(const nkw_clip_source *source, const packed_extents *out)
{
    for (size_t i = 0; i < source->track_count; i++) {
        const nkw_clip_track *c = &source->tracks[i];
        packed_extent *e = &out->tracks[i];
        e->lowest = e->shortest = e->longest = e->sign = 1.0, e->highest = -1.0;
        if (c->target == NKW_CLIP_ROTATION) {
            measure_lengths(c, e);
            measure_numbers(c, 0, (float)e->sign, e->low, e->high);
        }
        for (size_t k = 0; c->target != NKW_CLIP_ROTATION && k < c->track.width; k++) {
            double *pair = out->floats + 2 * (c->index + k);
            int is_float = c->target == NKW_CLIP_FLOATS;
            measure_numbers(c, k, 1.0f, is_float ? pair : e->low + k, is_float ? pair + 1 : e->high + k);
        }
    }
}

packed_range nkwi_packed_range(const packed_extents *extents, const nkw_clip_track *c, size_t track, size_t component,
                               float step)
{
    packed_range r = {extents->tracks[track], (double)step};
    if (c->target == NKW_CLIP_ROTATION) {
        r.step = (double)step / (2.0 * (1.0 + r.extent.highest));
    } else if (c->target == NKW_CLIP_FLOATS) {
        r.extent.low[0] = extents->floats[2 * (c->index + component)];
        r.extent.high[0] = extents->floats[2 * (c->index + component) + 1];
    } else {
        r.extent.low[0] = r.extent.low[component];
        r.extent.high[0] = r.extent.high[component];
    }
    return r;
}

/*
 * (float)x rounds to nearest; where that is above x, the float before: 1 less of the bits, or 1 more if negative. Then
 * the bits are rounded towards 0, or away from 0 if negative.
 */
float nkwi_packed_base(double x)
{
    float f = (float)x;
    f = (double)f <= x ? f : lane_float(lane_bits(f) + (f > 0.0f ? 0xffffffffu : 1u));
    return lane_float((f < 0.0f ? lane_bits(f) + 0xffffu : lane_bits(f)) & 0xffff0000u);
}

/* Whether all knots, and so all residuals, are within their limits, and the range is that of a float. */
static int fits(const nkw_clip_track *c, const packed_range *r)
{
    const float step = nkwi_packed_base(r->step);
    for (size_t i = 0; i < packed_rows_of(c); i++) {
        const double range = r->extent.high[i] - (double)nkwi_packed_base(r->extent.low[i]);
        if (!(step > 0.0f && range / (double)step < PACKED_KNOT && range < PACKED_RANGE))
            return 0;
    }
    return r->extent.lowest > PACKED_LOWEST;
}

/*
 * Whether rotations with the squared lengths of a range may have the square n. A square of 1 + d moves a point as a
 * rotation by d radians does, and rounding to steps rotates by half a step. Those of unit rotations in floats may.
 */
static int are_lengths(const packed_extent *e, float step, double n)
{
    const double most = 0.5 * (double)step > PACKED_UNIT ? 0.5 * (double)step : PACKED_UNIT;
    return e->longest - n <= most && n - e->shortest <= most;
}

packed_survey nkwi_packed_survey(const packed_extents *extents, const nkw_clip_track *tracks, size_t track, float step,
                                 float *middle)
{
    const nkw_clip_track *c = &tracks[track];
    const int is_rotation = c->target == NKW_CLIP_ROTATION;
    packed_survey result = {c->track.count > 1 && c->track.interpolation == NKW_INTERPOLATION_LINEAR &&
                                !c->track.key_interpolation && 3 * c->track.width <= PACKED_SLOTS,
                            c->track.interpolation != NKW_INTERPOLATION_CUBICSPLINE};
    for (size_t i = 0; i < (is_rotation ? 1 : c->track.width); i++) {
        const packed_range r = nkwi_packed_range(extents, c, track, i, step);
        const packed_extent *e = &r.extent;
        const double square = 0.5 * (e->shortest + e->longest);
        result.fits = result.fits && fits(c, &r) && are_lengths(e, step, 1.0);
        result.is_constant = result.is_constant && are_lengths(e, step, square);
        double p[3] = {0.0, 0.0, 0.0};
        for (size_t row = 0; row < packed_rows_of(c); row++) {
            p[row] = 0.5 * (e->low[row] + e->high[row]);
            result.is_constant = result.is_constant && e->high[row] - e->low[row] <= r.step;
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
