/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/curve.h>
#include <nakawari/edit.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>

#include "finite.h"
#include "lane/cubic.h"
#include "lane/scalar.h"
#include "track_keys.h"

/* A track that is written key by key. */
typedef struct edit {
    nkw_track_span span;
    nkw_track track; /* refers to the arrays of the span; count keys so far */
    size_t size; /* floats of a key */
} edit;

/* has_modes: whether the track has an interpolation for each key. */
static edit edit_begin(const nkw_track *like, nkw_track_span span, int has_modes)
{
    edit e = {span, *like, track_key_size(like)};
    e.track.times = span.times;
    e.track.values = span.values;
    e.track.key_interpolation = has_modes ? span.key_interpolation : NULL;
    e.track.count = 0;
    return e;
}

/* The floats of the next key, or NULL if the arrays are full. */
static float *edit_add(edit *e, float time, nkw_interpolation mode)
{
    size_t k = e->track.count;
    if (k >= e->span.key_capacity)
        return NULL;
    e->span.times[k] = time;
    if (e->track.key_interpolation)
        e->span.key_interpolation[k] = (unsigned char)mode;
    e->track.count++;
    return e->span.values + k * e->size;
}

/* Adds key k of a track. Returns 0 if the arrays are full. */
static int edit_copy(edit *e, const nkw_track *track, size_t k, float time, nkw_interpolation mode)
{
    float *to = edit_add(e, time, mode);
    if (to)
        memmove(to, track_key_at(track, k), e->size * sizeof *to);
    return to != NULL;
}

/* Values and tangents of the result may overflow. */
static nkw_result edit_end(edit *e, nkw_result result, nkw_track *out)
{
    if (result == NKW_OK && !are_finite(e->span.values, e->size * e->track.count))
        result = NKW_NOT_FINITE;
    if (result != NKW_OK)
        e->track.count = 0;
    *out = e->track;
    return result;
}

static nkw_result check(const nkw_track *track, nkw_track_span span)
{
    nkw_result result = track_check_readable(track);
    if (result == NKW_OK && track->key_interpolation && !span.key_interpolation)
        return NKW_TOO_SMALL;
    return result;
}

/* Trim. */

/* The Hermite curve and its derivative per second, at t of the segment from key k. */
static void cut_cubic(const nkw_track *track, size_t k, float t, float *key)
{
    size_t width = track->width;
    const float *a = track_value_at(track, k), *b = track_value_at(track, k + 1);
    float duration = track->times[k + 1] - track->times[k];
    nkw_weights slope = nkw_cubic_weights(NKW_CUBIC_HERMITE, 1, t);
    for (size_t i = 0; i < width; i++) {
        float leaving = duration * a[width + i], arriving = duration * (b - width)[i];
        float tangent = lane_weigh(slope, a[i], leaving, b[i], arriving) / duration;
        key[i] = key[2 * width + i] = tangent;
        key[width + i] = nkw_hermite(a[i], leaving, b[i], arriving, t);
    }
}

static float key_length(const float *v)
{
    return nkw_quat_length(track_read_quat(v));
}

/* Adds a key at a time between two keys, or outside all. */
static nkw_result cut(edit *e, const nkw_track *track, float time)
{
    nkw_segment s = nkw_segment_find(track->times, track->count, time);
    nkw_interpolation mode = track_interpolation_at(track, s.index);
    int is_inside = s.t > 0.0f && s.t < 1.0f && s.index + 1 < track->count;
    float *key = edit_add(e, time, mode);
    if (!key)
        return NKW_TOO_SMALL;
    if (!track_is_cubic(track)) {
        nkw_track_sample_segment(track, s, key);
        return NKW_OK;
    }
    if (is_inside && mode == NKW_INTERPOLATION_CUBICSPLINE) {
        cut_cubic(track, s.index, s.t, key);
        if (!track_is_rotation(track))
            return NKW_OK;
        e->track.kind = NKW_TRACK_ROTATION_NORMALIZED;
        return lane_is_unit_length(key_length(key + track->width)) ? NKW_OK : NKW_NOT_UNIT;
    }
    memset(key, 0, e->size * sizeof *key);
    nkw_track_sample_segment(track, s, key + track->width);
    return NKW_OK;
}

nkw_result nkw_track_trim(const nkw_track *track, float from, float to, nkw_track_span span, nkw_track *out)
{
    const nkw_track source = *track;
    edit e = edit_begin(&source, span, source.key_interpolation != NULL);
    nkw_result result = check(&source, span);
    if (result == NKW_OK && (!lane_is_finite(from) || !lane_is_finite(to)))
        result = NKW_NOT_FINITE;
    if (result == NKW_OK && from > to)
        result = NKW_NOT_ASCENDING;
    size_t first = 0, end;
    while (result == NKW_OK && first < source.count && source.times[first] <= from)
        first++;
    for (end = first; result == NKW_OK && end < source.count && source.times[end] <= to;)
        end++;
    /* The last key at or before `from` is the first of the part, unless the part begins after it. */
    if (result == NKW_OK && first > 0 && source.times[first - 1] == from)
        first--;
    else if (result == NKW_OK && (first > 0 || end == 0))
        result = cut(&e, &source, from);
    for (size_t k = first; result == NKW_OK && k < end; k++)
        if (!edit_copy(&e, &source, k, source.times[k], track_interpolation_at(&source, k)))
            result = NKW_TOO_SMALL;
    if (result == NKW_OK && end > 0 && end < source.count && e.span.times[e.track.count - 1] < to)
        result = cut(&e, &source, to);
    return edit_end(&e, result, out);
}

/* Retime. */

static float retimed(float time, float scale, float offset)
{
    return (float)((double)scale * (double)time + (double)offset);
}

/* Divides the tangents of a key by the scale; a negative scale exchanges them. */
static void scale_tangents(float *key, size_t width, float scale)
{
    for (size_t i = 0; i < width; i++) {
        float in = key[i] / scale, leaving = key[2 * width + i] / scale;
        key[i] = scale > 0.0f ? in : leaving;
        key[2 * width + i] = scale > 0.0f ? leaving : in;
    }
}

/* Adds key k at its new time, with the mode of the segment that follows in the new order. */
static int add_retimed(edit *e, const nkw_track *track, size_t k, float scale, float offset, nkw_interpolation mode)
{
    if (!edit_copy(e, track, k, retimed(track->times[k], scale, offset), mode))
        return 0;
    if (track_is_cubic(track))
        scale_tangents(e->span.values + (e->track.count - 1) * e->size, track->width, scale);
    return 1;
}

/*
 * The keys in reverse. The segment of keys k - 1 and k begins at key k. If it is STEP it holds the value of key k - 1,
 * and the value of key k has a key of its own at the same time, unless the segment before is STEP too and does not
 * reach it.
 */
static int add_reversed(edit *e, const nkw_track *track, float scale, float offset)
{
    for (size_t k = track->count; k-- > 0;) {
        nkw_interpolation mode = track_interpolation_at(track, k > 0 ? k - 1 : 0);
        int is_step = k > 0 && mode == NKW_INTERPOLATION_STEP;
        int was_step = k + 1 < track->count && track_interpolation_at(track, k) == NKW_INTERPOLATION_STEP;
        if (!(is_step && was_step) && !add_retimed(e, track, k, scale, offset, mode))
            return 0;
        if (is_step) {
            if (!add_retimed(e, track, k - 1, scale, offset, mode))
                return 0;
            e->span.times[e->track.count - 1] = retimed(track->times[k], scale, offset);
        }
    }
    return 1;
}

static int add_all_retimed(edit *e, const nkw_track *track, float scale, float offset)
{
    for (size_t k = 0; k < track->count; k++)
        if (!add_retimed(e, track, k, scale, offset, track_interpolation_at(track, k)))
            return 0;
    return 1;
}

nkw_result nkw_track_retime(const nkw_track *track, float scale, float offset, nkw_track_span span,
                            nkw_track *out)
{
    const nkw_track source = *track;
    edit e = edit_begin(&source, span, source.key_interpolation != NULL);
    nkw_result result = check(&source, span);
    if (result == NKW_OK && (scale == 0.0f || !lane_is_finite(scale)))
        result = NKW_OUT_OF_RANGE;
    if (result == NKW_OK && (!lane_is_finite(retimed(source.times[0], scale, offset)) ||
                             !lane_is_finite(retimed(source.times[source.count - 1], scale, offset))))
        result = NKW_NOT_FINITE;
    if (result == NKW_OK &&
        !(scale > 0.0f ? add_all_retimed(&e, &source, scale, offset) : add_reversed(&e, &source, scale, offset)))
        result = NKW_TOO_SMALL;
    return edit_end(&e, result, out);
}

/* Join. */

static nkw_result check_join(const nkw_track *a, const nkw_track *b, nkw_track_span span, int has_modes)
{
    nkw_result result = check(a, span);
    if (result == NKW_OK)
        result = check(b, span);
    if (result != NKW_OK)
        return result;
    if (a->width != b->width || a->kind != b->kind || track_is_cubic(a) != track_is_cubic(b))
        return NKW_MISMATCHED;
    float last = a->times[a->count - 1],
          shifted = (float)((double)b->times[b->count - 1] - (double)b->times[0] + (double)last);
    if (!lane_is_finite(last) || !lane_is_finite(shifted))
        return NKW_NOT_FINITE;
    return has_modes && !span.key_interpolation ? NKW_TOO_SMALL : NKW_OK;
}

nkw_result nkw_track_join(const nkw_track *first, const nkw_track *second, nkw_track_span span,
                          nkw_track *out)
{
    const nkw_track a = *first, b = *second;
    int has_modes = a.key_interpolation || b.key_interpolation || a.interpolation != b.interpolation;
    edit e = edit_begin(&a, span, has_modes);
    nkw_result result = check_join(&a, &b, span, has_modes);
    for (size_t k = 0; result == NKW_OK && k < a.count; k++)
        if (!edit_copy(&e, &a, k, a.times[k], track_interpolation_at(&a, k)))
            result = NKW_TOO_SMALL;
    if (result != NKW_OK)
        return edit_end(&e, result, out);
    double shift = (double)a.times[a.count - 1] - (double)b.times[0];
    const float *end = track_value_at(&a, a.count - 1), *begin = track_value_at(&b, 0);
    size_t next = memcmp(end, begin, a.width * sizeof *end) == 0;
    if (next && track_is_cubic(&a))
        memcpy(span.values + (a.count - 1) * e.size + 2 * a.width, begin + a.width, a.width * sizeof *begin);
    if (next && e.track.key_interpolation)
        span.key_interpolation[a.count - 1] = (unsigned char)track_interpolation_at(&b, 0);
    for (size_t k = next; result == NKW_OK && k < b.count; k++)
        if (!edit_copy(&e, &b, k, (float)((double)b.times[k] + shift), track_interpolation_at(&b, k)))
            result = NKW_TOO_SMALL;
    return edit_end(&e, result, out);
}

/* Close. */

/* share - u of key k. */
static double part_at(const nkw_track *track, size_t k, float share)
{
    double first = (double)track->times[0], duration = (double)track->times[track->count - 1] - first;
    return (double)share - ((double)track->times[k] - first) / duration;
}

static void close_numbers(const nkw_track *track, float share, const edit *e)
{
    size_t last = track->count - 1, width = track->width, at = track_is_cubic(track) ? width : 0;
    double duration = (double)track->times[last] - (double)track->times[0];
    float *keys = e->span.values;
    for (size_t i = at; i < at + width; i++) {
        double d = (double)keys[last * e->size + i] - (double)keys[i];
        for (size_t k = 0; k <= last; k++) {
            float *v = keys + k * e->size + i;
            *v = (float)((double)*v + part_at(track, k, share) * d);
            for (size_t side = 0; at && side < 2; side++) {
                float *tangent = side ? v + width : v - width;
                *tangent = (float)((double)*tangent - d / duration);
            }
        }
        keys[last * e->size + i] = keys[i];
    }
}

/* The derivative of D^(share - u(time)) q(time) by the time: turn * tangent - (log D / duration) * turned. */
static void turn_tangent(float *tangent, nkw_quat turn, nkw_vec3 rate, nkw_quat turned)
{
    nkw_quat change = {rate.x, rate.y, rate.z, 0.0f};
    track_write_quat(nkw_quat_sub(nkw_quat_mul(turn, track_read_quat(tangent)), nkw_quat_mul(change, turned)), tangent);
}

static void close_rotations(const nkw_track *track, float share, const edit *e)
{
    size_t last = track->count - 1, at = track_is_cubic(track) ? 4 : 0;
    float duration = track->times[last] - track->times[0], *keys = e->span.values + at;
    nkw_quat d = nkw_quat_mul(track_read_quat(keys + last * e->size), nkw_quat_conjugate(track_read_quat(keys)));
    nkw_vec3 whole = nkw_quat_log(d.w < 0.0f ? nkw_quat_negate(d) : d);
    nkw_vec3 rate = nkw_vec3_scale(whole, 1.0f / duration);
    for (size_t k = 0; k <= last; k++) {
        float *v = keys + k * e->size;
        nkw_quat turn = nkw_quat_exp(nkw_vec3_scale(whole, (float)part_at(track, k, share)));
        nkw_quat turned = nkw_quat_mul(turn, track_read_quat(v));
        for (size_t side = 0; at && side < 2; side++)
            turn_tangent(side ? v + 4 : v - 4, turn, rate, turned);
        track_write_quat(turned, v);
    }
    nkw_quat begin = track_read_quat(keys), end = track_read_quat(keys + last * e->size);
    track_write_quat(nkw_quat_dot(begin, end) < 0.0f ? nkw_quat_negate(begin) : begin, keys + last * e->size);
}

nkw_result nkw_track_close(const nkw_track *track, float share, nkw_track_span span, nkw_track *out)
{
    const nkw_track source = *track;
    edit e = edit_begin(&source, span, source.key_interpolation != NULL);
    nkw_result result = check(&source, span);
    if (result == NKW_OK && !(share >= 0.0f && share <= 1.0f))
        result = NKW_OUT_OF_RANGE;
    if (result == NKW_OK && source.count > 1 && !(source.times[0] < source.times[source.count - 1]))
        result = NKW_NOT_ASCENDING;
    if (result == NKW_OK && !add_all_retimed(&e, &source, 1.0f, 0.0f))
        result = NKW_TOO_SMALL;
    if (result == NKW_OK && source.count > 1) {
        if (track_is_rotation(&source))
            close_rotations(&e.track, share, &e);
        else
            close_numbers(&e.track, share, &e);
    }
    return edit_end(&e, result, out);
}
