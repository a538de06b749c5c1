/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/dialect.h>

#include "curve/ease_point.h"
#include "lane/scalar.h"
#include "report.h"
#include "track_keys.h"

static const nkw_handle no_handle = {0.0f, 0.0f};

/* A third of h seconds along a slope. */
static nkw_handle third_of(double h, double slope)
{
    return handle_from_f64(h / 3.0, slope * (h / 3.0));
}

static nkw_handle reversed(nkw_handle h)
{
    nkw_handle r = {-h.time, -h.value};
    return r;
}

static nkw_fcurve_key key_of(float time, float value, nkw_fcurve_kind kind)
{
    nkw_fcurve_key key = {time, value, {0.0f, 0.0f}, {0.0f, 0.0f}, kind, NKW_EASE_LINEAR};
    return key;
}

/* ---- Slopes ---- */

/* The handle of a slope, as a vector into the segment of h seconds. */
static nkw_handle sloped(float slope, float weight, int has_weight, nkw_weight_unit unit, double h)
{
    double m = (double)slope, w = (double)weight;
    if (!has_weight)
        return third_of(h, m);
    double time = unit == NKW_WEIGHT_SECONDS ? w : unit == NKW_WEIGHT_FRACTION ? w * h : w / lane_sqrt64(1.0 + m * m);
    return handle_from_f64(time, m * time);
}

/* The weight of a handle that has a slope. */
static float weight_of(nkw_handle handle, nkw_weight_unit unit, double h)
{
    double x = (double)handle.time, y = (double)handle.value;
    if (unit == NKW_WEIGHT_LENGTH)
        return (float)(x < 0.0 ? -lane_sqrt64(x * x + y * y) : lane_sqrt64(x * x + y * y));
    return unit == NKW_WEIGHT_FRACTION ? (float)(h > 0.0 ? x / h : 0.0) : handle.time;
}

static int is_slope(float slope)
{
    return slope == slope;
}

static nkw_result check_slope_key(const nkw_slope_key *s, size_t k)
{
    if ((unsigned)s->kind >= NKW_FCURVE_EASE || (unsigned)s->weighted > NKW_WEIGHTED_BOTH)
        return NKW_BAD_METHOD;
    int in = ((unsigned)s->weighted & NKW_WEIGHTED_IN) == 0 || lane_is_finite(s->in_weight);
    int out = ((unsigned)s->weighted & NKW_WEIGHTED_OUT) == 0 || lane_is_finite(s->out_weight);
    if (!lane_is_finite(s->time) || !lane_is_finite(s->value) || !is_slope(s->in_slope) || !is_slope(s->out_slope) ||
        !in || !out)
        return NKW_NOT_FINITE;
    return k > 0 && s->time < s[-1].time ? NKW_NOT_ASCENDING : NKW_OK;
}

/* The handles of the segment before key k, and its kind. */
static void slope_segment(const nkw_slope_key *s, nkw_weight_unit unit, nkw_fcurve_key *keys, size_t k)
{
    double h = (double)s[k].time - (double)s[k - 1].time;
    if (s[k - 1].kind != NKW_FCURVE_BEZIER)
        return;
    if (!lane_is_finite(s[k - 1].out_slope) || !lane_is_finite(s[k].in_slope)) {
        keys[k - 1].kind = NKW_FCURVE_CONSTANT;
        return;
    }
    int out = ((unsigned)s[k - 1].weighted & NKW_WEIGHTED_OUT) != 0;
    int in = ((unsigned)s[k].weighted & NKW_WEIGHTED_IN) != 0;
    keys[k - 1].out = sloped(s[k - 1].out_slope, s[k - 1].out_weight, out, unit, h);
    keys[k].in = reversed(sloped(s[k].in_slope, s[k].in_weight, in, unit, h));
}

/* The handles before the first and after the last key, of a third of the segment at that end, or of a second. */
static void outer_handles(const nkw_slope_key *s, nkw_fcurve_key *keys, size_t count)
{
    size_t last = count - 1;
    double h0 = last > 0 ? (double)s[1].time - (double)s[0].time : 3.0;
    double h1 = last > 0 ? (double)s[last].time - (double)s[last - 1].time : 3.0;
    if (lane_is_finite(s[0].in_slope))
        keys[0].in = reversed(third_of(h0, (double)s[0].in_slope));
    if (lane_is_finite(s[last].out_slope))
        keys[last].out = third_of(h1, (double)s[last].out_slope);
}

nkw_result nkw_fcurve_from_slope_keys(const nkw_slope_key *slopes, size_t count, nkw_weight_unit unit,
                                       nkw_fcurve_key *keys, size_t *bad)
{
    if (count == 0 || (unsigned)unit > NKW_WEIGHT_LENGTH)
        return report(count == 0 ? NKW_EMPTY : NKW_BAD_METHOD, 0, bad);
    for (size_t k = 0; k < count; k++) {
        nkw_result result = check_slope_key(slopes + k, k);
        if (result != NKW_OK)
            return report(result, k, bad);
        keys[k] = key_of(slopes[k].time, slopes[k].value, slopes[k].kind);
        if (k > 0)
            slope_segment(slopes, unit, keys, k);
    }
    outer_handles(slopes, keys, count);
    return report(NKW_OK, 0, bad);
}

/* Slope and weight of a handle as a vector into its segment. Returns whether it has a slope. */
static int take_handle(nkw_handle handle, nkw_weight_unit unit, double h, float *slope, float *weight, int *has_weight)
{
    *slope = handle.time != 0.0f ? (float)((double)handle.value / (double)handle.time) : 0.0f;
    *has_weight = handle.time != (float)(h / 3.0);
    *weight = *has_weight ? weight_of(handle, unit, h) : 0.0f;
    return handle.time != 0.0f || handle.value == 0.0f;
}

/* Writes the slopes of the segment of keys[0] and keys[1]. */
static int slopes_of_segment(const nkw_fcurve_key *keys, nkw_weight_unit unit, nkw_slope_key *s)
{
    double h = (double)keys[1].time - (double)keys[0].time;
    int out = 0, in = 0, has_slopes = 1;
    if (keys->kind == NKW_FCURVE_LINEAR && h > 0.0)
        s[0].out_slope = s[1].in_slope = (float)(((double)keys[1].value - (double)keys[0].value) / h);
    if (keys->kind == NKW_FCURVE_BEZIER)
        has_slopes = take_handle(keys[0].out, unit, h, &s[0].out_slope, &s[0].out_weight, &out) &
                     take_handle(reversed(keys[1].in), unit, h, &s[1].in_slope, &s[1].in_weight, &in);
    s[0].weighted = (nkw_weighted)((unsigned)s[0].weighted | (out ? NKW_WEIGHTED_OUT : 0u));
    s[1].weighted = in ? NKW_WEIGHTED_IN : NKW_WEIGHTED_NONE;
    return has_slopes;
}

/* The error of a key before any conversion from keys. */
static nkw_result check_keys(const nkw_fcurve_key *keys, size_t count, size_t *bad)
{
    nkw_fcurve curve = {keys, count, NKW_FCURVE_OUTSIDE_HOLD, NKW_FCURVE_OUTSIDE_HOLD, 0, 0, NKW_HANDLE_NONE};
    return nkw_fcurve_validate(&curve, bad);
}

nkw_result nkw_slope_keys_from_fcurve(const nkw_fcurve_key *keys, size_t count, nkw_weight_unit unit,
                                       nkw_slope_key *slopes, size_t *bad)
{
    nkw_result result = check_keys(keys, count, bad);
    if (result != NKW_OK || (unsigned)unit > NKW_WEIGHT_LENGTH)
        return result != NKW_OK ? result : report(NKW_BAD_METHOD, 0, bad);
    for (size_t k = 0; k < count; k++) {
        nkw_slope_key s = {keys[k].time, keys[k].value, 0.0f, 0.0f, 0.0f, 0.0f, NKW_WEIGHTED_NONE, keys[k].kind};
        if (k == 0)
            slopes[0] = s;
        if (keys[k].kind == NKW_FCURVE_EASE)
            return report(NKW_BAD_METHOD, k, bad);
        if (k + 1 == count)
            break;
        s.time = keys[k + 1].time;
        s.value = keys[k + 1].value;
        s.kind = keys[k + 1].kind;
        slopes[k + 1] = s;
        if (!slopes_of_segment(keys + k, unit, slopes + k))
            return report(NKW_OUT_OF_RANGE, k, bad);
    }
    const nkw_handle in = keys[0].in, out = keys[count - 1].out;
    slopes[0].in_slope = in.time != 0.0f ? (float)((double)in.value / (double)in.time) : 0.0f;
    slopes[count - 1].out_slope = out.time != 0.0f ? (float)((double)out.value / (double)out.time) : 0.0f;
    return report(NKW_OK, 0, bad);
}

/* ---- Blender ---- */

enum { BLENDER_CONSTANT, BLENDER_LINEAR, BLENDER_BEZIER, BLENDER_BACK, BLENDER_SINE = 12 };

/* The first of the three functions of a family, by Blender's number, from back on; LINEAR where they differ. */
static const nkw_ease_kind families[10] = {NKW_EASE_BACK_IN,  NKW_EASE_BOUNCE_IN, NKW_EASE_CIRC_IN, NKW_EASE_CUBIC_IN,
                                           NKW_EASE_LINEAR,   NKW_EASE_LINEAR,    NKW_EASE_QUAD_IN, NKW_EASE_QUART_IN,
                                           NKW_EASE_QUINT_IN, NKW_EASE_SINE_IN};

/* Kind and ease of a key; 0 if there is none. */
static int take_blender_kind(const nkw_blender_key *b, nkw_fcurve_key *key)
{
    static const nkw_fcurve_kind kinds[3] = {NKW_FCURVE_CONSTANT, NKW_FCURVE_LINEAR, NKW_FCURVE_BEZIER};
    if (b->interpolation < 0 || b->interpolation > BLENDER_SINE || b->easing < 0 || b->easing > 3)
        return 0;
    key->kind = NKW_FCURVE_EASE;
    key->ease = NKW_EASE_LINEAR;
    if (b->interpolation <= BLENDER_BEZIER) {
        key->kind = kinds[b->interpolation];
        return 1;
    }
    nkw_ease_kind first = families[b->interpolation - BLENDER_BACK];
    int is_out = first == NKW_EASE_BACK_IN || first == NKW_EASE_BOUNCE_IN;
    int form = b->easing > 0 ? b->easing - 1 : is_out;
    key->ease = (nkw_ease_kind)((int)first + form);
    return first != NKW_EASE_LINEAR;
}

static nkw_handle between(nkw_handle from, nkw_handle to)
{
    return handle_from_f64((double)to.time - (double)from.time, (double)to.value - (double)from.value);
}

nkw_result nkw_fcurve_from_blender_keys(const nkw_blender_key *blender, size_t count, nkw_fcurve_key *keys,
                                        size_t *bad)
{
    size_t k = 0;
    int is_known = 1;
    for (; k < count && is_known; k++) {
        keys[k] = key_of(blender[k].center.time, blender[k].center.value, NKW_FCURVE_CONSTANT);
        keys[k].in = between(blender[k].center, blender[k].left);
        keys[k].out = between(blender[k].center, blender[k].right);
        is_known = take_blender_kind(blender + k, keys + k);
    }
    if (!is_known)
        keys[k - 1].kind = NKW_FCURVE_CONSTANT;
    nkw_result result = check_keys(keys, k, bad);
    return is_known || result != NKW_OK ? result : report(NKW_BAD_METHOD, k - 1, bad);
}

/* Blender's numbers of a kind and an ease; 0 if there are none. */
static int put_blender_kind(const nkw_fcurve_key *key, nkw_blender_key *b)
{
    b->easing = 0;
    b->interpolation = key->kind == NKW_FCURVE_LINEAR   ? BLENDER_LINEAR
                       : key->kind == NKW_FCURVE_BEZIER ? BLENDER_BEZIER
                                                        : BLENDER_CONSTANT;
    if (key->kind != NKW_FCURVE_EASE)
        return key->kind != NKW_FCURVE_CONSTANT_NEXT;
    b->interpolation = BLENDER_LINEAR;
    if (key->ease == NKW_EASE_LINEAR)
        return 1;
    for (int i = 0; i < 10; i++) {
        int form = (int)key->ease - (int)families[i];
        if (families[i] == NKW_EASE_LINEAR || form < 0 || form > 2)
            continue;
        b->interpolation = BLENDER_BACK + i;
        b->easing = form + 1;
        return 1;
    }
    return 0;
}

nkw_result nkw_blender_keys_from_fcurve(const nkw_fcurve_key *keys, size_t count, nkw_blender_key *blender,
                                        size_t *bad)
{
    nkw_result result = check_keys(keys, count, bad);
    for (size_t k = 0; k < count && result == NKW_OK; k++) {
        const nkw_fcurve_key *key = keys + k;
        blender[k].center = handle_from_f64((double)key->time, (double)key->value);
        blender[k].left =
            handle_from_f64((double)key->time + (double)key->in.time, (double)key->value + (double)key->in.value);
        blender[k].right =
            handle_from_f64((double)key->time + (double)key->out.time, (double)key->value + (double)key->out.value);
        if (!put_blender_kind(key, blender + k))
            return report(NKW_BAD_METHOD, k, bad);
    }
    return result;
}

/* ---- CSS ---- */

void nkw_fcurve_from_css(const float css[4], nkw_fcurve_key keys[2])
{
    double h = (double)keys[1].time - (double)keys[0].time, rise = (double)keys[1].value - (double)keys[0].value;
    keys[0].kind = NKW_FCURVE_BEZIER;
    keys[0].out = handle_from_f64((double)css[0] * h, (double)css[1] * rise);
    keys[1].in = handle_from_f64(((double)css[2] - 1.0) * h, ((double)css[3] - 1.0) * rise);
}

/* The control points of a BEZIER segment of h seconds. */
static nkw_result css_of_handles(const nkw_fcurve_key keys[2], double h, float css[4])
{
    double rise = (double)keys[1].value - (double)keys[0].value;
    int is_level = keys[0].out.value == 0.0f && keys[1].in.value == 0.0f;
    if (rise == 0.0 && !is_level)
        return NKW_OUT_OF_RANGE;
    double unit = rise == 0.0 ? 1.0 : rise;
    css[0] = (float)((double)keys[0].out.time / h);
    css[1] = (float)((double)keys[0].out.value / unit);
    css[2] = (float)(1.0 + (double)keys[1].in.time / h);
    css[3] = (float)(1.0 + (double)keys[1].in.value / unit);
    return css[0] >= 0.0f && css[0] <= 1.0f && css[2] >= 0.0f && css[2] <= 1.0f ? NKW_OK : NKW_OUT_OF_RANGE;
}

nkw_result nkw_fcurve_to_css(const nkw_fcurve_key keys[2], float css[4])
{
    static const float line[4] = {0.0f, 0.0f, 1.0f, 1.0f};
    double h = (double)keys[1].time - (double)keys[0].time;
    const float *c = keys->kind == NKW_FCURVE_LINEAR ? line
                     : keys->kind == NKW_FCURVE_EASE ? nkwi_ease_css(keys->ease)
                                                     : NULL;
    if (!(h > 0.0))
        return NKW_OUT_OF_RANGE;
    if (keys->kind == NKW_FCURVE_BEZIER)
        return css_of_handles(keys, h, css);
    for (int i = 0; c && i < 4; i++)
        css[i] = c[i];
    return c ? NKW_OK : NKW_BAD_METHOD;
}

/* ---- Hermite tangents ---- */

/* Handles of h/3 from the tangents per second in handle.value. */
static void scale_tangents(nkw_fcurve_key *keys, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        double before = k > 0 ? (double)keys[k].time - (double)keys[k - 1].time : 0.0;
        double after = k + 1 < count ? (double)keys[k + 1].time - (double)keys[k].time : 0.0;
        keys[k].in = k > 0 ? reversed(third_of(before, (double)keys[k].in.value)) : no_handle;
        keys[k].out = k + 1 < count ? third_of(after, (double)keys[k].out.value) : no_handle;
    }
}

nkw_result nkw_fcurve_from_track(const nkw_track *track, size_t component, nkw_fcurve_key *keys, size_t *bad)
{
    static const nkw_fcurve_kind kinds[3] = {NKW_FCURVE_LINEAR, NKW_FCURVE_CONSTANT, NKW_FCURVE_BEZIER};
    nkw_result result = nkw_track_validate(track, bad);
    if (result != NKW_OK)
        return result;
    if (track_is_rotation(track) || component >= track->width)
        return report(track_is_rotation(track) ? NKW_MISMATCHED : NKW_OUT_OF_RANGE, 0, bad);
    for (size_t k = 0; k < track->count; k++) {
        const float *value = track_value_at(track, k) + component;
        keys[k] = key_of(track->times[k], *value, kinds[track_interpolation_at(track, k)]);
        keys[k].in.value = track_is_cubic(track) ? value[-(ptrdiff_t)track->width] : 0.0f;
        keys[k].out.value = track_is_cubic(track) ? value[track->width] : 0.0f;
    }
    if (track_is_cubic(track))
        scale_tangents(keys, track->count);
    return NKW_OK;
}
