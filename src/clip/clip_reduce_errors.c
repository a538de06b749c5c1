/* SPDX-License-Identifier: MIT */
/*
 * The errors of a reduction in model space (clip_reduction.h).
 *
 * Invariant: errors[j] is the largest distance, in tolerances of joint j, between a point of j in the source's pose and
 * the same point in the reduced one, over all times so far.
 *
 *     point of j     position + sum over columns c of axes[c] n[c] column c,   |n| <= 1        farthest.h
 *     axes           distance / the longest that column c becomes: the points are at most `distance` away
 *
 *     reach[j]       max over joints k below j of (|position k - position j| + distance k) / tolerance k
 *
 *     times          a clip: of each track its key times, and parts of its segments; segments of packed clips depend
 *                    on them. Tracks: the key times of all, merged, and parts between two of them
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip_reduce.h>
#include <nakawari/pose.h>
#include <nakawari/scalar.h>
#include <nakawari/segment.h>

#include "clip_reduction.h"
#include "clip_tracks.h"
#include "farthest.h"
#include "lane/mat.h"

static void models_of(const nkw_clip_reduction *r, size_t joints, reduce_pose *p)
{
    const nkw_pose_view view = {p->pose, joints};
    for (size_t j = 0; j < joints; j++) {
        size_t parent = reduce_parent(r, j);
        nkw_trs trs = nkw_pose_get(view, j);
        const lane_f64_affine local = lane_f64_affine_from_trs(&trs);
        p->models[j] = parent == j ? local : lane_f64_affine_mul(&p->models[parent], &local);
    }
}

static void set_rest(const nkw_clip_source *s, reduce_pose *p)
{
    const nkw_pose_span span = {p->pose, s->joint_count};
    if (s->rest.data)
        memcpy(p->pose, s->rest.data, NKW_POSE_FLOATS(s->joint_count) * sizeof(float));
    else
        nkw_pose_identity(span);
    for (size_t i = 0; i < s->float_count; i++)
        p->floats[i] = s->rest_floats ? s->rest_floats[i] : 0.0f;
}

/*
 * Sets what the tracks animate; everything else remains at the rest pose, which is set once. Tracks that share their
 * times share one search, which begins where the last one ended.
 */
static void sample_tracks(const nkw_clip_source *s, float time, reduce_pose *p)
{
    const size_t stride = NKW_POSE_STRIDE(s->joint_count);
    const nkw_track *found = NULL;
    nkw_segment at = {0, 0.0f};
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_clip_track *c = &s->tracks[i];
        float v[4];
        if (!found || found->times != c->track.times || found->count != c->track.count)
            at = nkw_segment_find_hint(c->track.times, c->track.count, time, p->cursors[i]);
        found = &c->track;
        p->cursors[i] = (uint32_t)at.index;
        nkw_track_sample_segment(&c->track, at, c->target == NKW_CLIP_FLOATS ? p->floats + c->index : v);
        for (size_t k = 0; c->target != NKW_CLIP_FLOATS && k < c->track.width; k++)
            p->pose[clip_array_of(c->target, k) * stride + c->index] = v[k];
    }
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static double column_length(const lane_f64_affine *m, size_t c)
{
    return lane_f64_vec3_length(lane_f64_affine_column(m, c));
}

/* The longest of the three columns. */
static double largest_scale(const lane_f64_affine *m)
{
    return larger(larger(column_length(m, 0), column_length(m, 1)), column_length(m, 2));
}

static double tightness(const nkw_clip_reduction *r, size_t joint)
{
    return reduce_tightness(r->tolerances ? r->tolerances[joint] : r->tolerance);
}

static double distance_of(const nkw_clip_reduction *r, size_t joint)
{
    return (double)(r->distances ? r->distances[joint] : r->distance);
}

/* The pose of one time: the largest of all times are collected. `above` goes from joint j to its root. */
static void add_reach(const nkw_clip_source *s, const nkw_clip_reduction *r, reduce_errors *e)
{
    for (size_t j = 0; j < s->joint_count; j++) {
        const lane_f64_affine *m = &e->want.models[j];
        double skin = distance_of(r, j), tight = tightness(r, j);
        size_t parent = reduce_parent(r, j);
        e->scale[j] = larger(e->scale[j], parent == j ? 1.0 : largest_scale(&e->want.models[parent]));
        for (size_t c = 0; c < 3; c++)
            e->axes[3 * j + c] = larger(e->axes[3 * j + c], column_length(m, c));
        for (size_t above = j, next = j;; above = next) {
            lane_f64_vec3 own = lane_f64_affine_column(m, 3);
            lane_f64_vec3 other = lane_f64_affine_column(&e->want.models[above], 3);
            double d = lane_f64_vec3_length(lane_f64_vec3_sub(own, other)) + skin;
            e->reach[above] = larger(e->reach[above], d * tight);
            e->tight[above] = larger(e->tight[above], tight);
            next = reduce_parent(r, above);
            if (next == above)
                break;
        }
    }
}

/* a - b; 0 of equal infinities. */
static double minus(double a, double b)
{
    return a == b ? 0.0 : a - b;
}

/*
 * The largest distance of the points of a joint, of its position and those around it: axes[c] n[c] on its axes, |n| <= 1.
 *
 * a, b   the model matrices
 * known  distances up to this one need not be exact: the result is then at most this
 */
static double joint_error(const lane_f64_affine *a, const lane_f64_affine *b, const double *axes, double known)
{
    double d[3], m[9], squares = 0.0;
    for (size_t i = 0; i < 3; i++)
        d[i] = minus(a->m[9 + i], b->m[9 + i]);
    for (size_t i = 0; i < 9; i++) {
        m[i] = minus(a->m[i], b->m[i]) * axes[i / 3];
        squares += m[i] * m[i];
    }
    /* (|d| + |m|)^2 <= 2 (|d|^2 + |m|^2) */
    double moved = (d[0] * d[0] + d[1] * d[1]) + d[2] * d[2];
    if (2.0 * (moved + squares) <= known * known)
        return known;
    double most = lane_sqrt64(moved) + lane_sqrt64(squares);
    double found = most <= known ? most : farthest_of(d, m);
    return found >= 0.0 ? found : INFINITY; /* infinite for NaN */
}

static void add_errors(const nkw_clip_source *s, const nkw_clip_reduction *r, reduce_errors *e)
{
    for (size_t j = 0; j < s->joint_count; j++) {
        const double tight = tightness(r, j), own = e->errors[j] / tight;
        double d = joint_error(&e->want.models[j], &e->got.models[j], e->axes + 3 * j,
                               own < e->distance ? own : e->distance);
        e->distance = larger(e->distance, d);
        e->errors[j] = larger(e->errors[j], d * tight);
    }
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_clip_track *c = &s->tracks[i];
        for (size_t k = c->index; c->target == NKW_CLIP_FLOATS && k < c->index + c->track.width; k++) {
            double d = lane_abs64((double)e->want.floats[k] - (double)e->got.floats[k]);
            e->floats = larger(e->floats, d);
            e->errors[s->joint_count + i] =
                larger(e->errors[s->joint_count + i], d * reduce_tightness(r->float_tolerance));
        }
    }
}

/* made: NULL for the reach */
static void add_time(const nkw_clip_source *s, const nkw_clip_reduction *r, const reduce_made *made, float time,
                     reduce_errors *e)
{
    const nkw_pose_span span = {e->got.pose, s->joint_count};
    if (time < e->from || time > e->to)
        return;
    sample_tracks(s, time, &e->want);
    models_of(r, s->joint_count, &e->want);
    if (!made) {
        add_reach(s, r, e);
        return;
    }
    if (made->clip)
        nkw_clip_sample(made->clip, time, NULL, span, e->got.floats);
    else
        sample_tracks(made->tracks, time, &e->got);
    models_of(r, s->joint_count, &e->got);
    add_errors(s, r, e);
}

/* Whether no track before has these times: equal times are measured once. */
static int is_first_of_timeline(const nkw_clip_source *s, size_t i)
{
    for (size_t k = 0; k < i; k++)
        if (clip_same_times(&s->tracks[k].track, &s->tracks[i].track))
            return 0;
    return 1;
}

/* All key times, and the times that divide each segment of a track into equal parts. Packed clips depend on them. */
static void add_track_times(const nkw_clip_source *s, const nkw_clip_reduction *r, const reduce_made *made,
                            reduce_errors *e)
{
    const int parts = made->parts;
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_track *t = &s->tracks[i].track;
        const size_t count = is_first_of_timeline(s, i) ? t->count : 0;
        for (size_t k = 0; k < count; k++) {
            add_time(s, r, made, t->times[k], e);
            for (int part = 1; part < parts && k + 1 < count; part++)
                add_time(s, r, made, nkw_lerp(t->times[k], t->times[k + 1], (float)part / (float)parts), e);
        }
    }
}

/* The first key time of all tracks that is later than `after`. Returns 0 if there is none. */
static int next_time(const nkw_clip_source *s, float after, float *next)
{
    const float *searched = NULL;
    int found = 0;
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_track *t = &s->tracks[i].track;
        if (t->times == searched || !(after < t->times[t->count - 1]))
            continue;
        searched = t->times;
        size_t k = after < t->times[0] ? 0 : nkw_segment_find(t->times, t->count, after).index + 1;
        if (!found || t->times[k] < *next)
            *next = t->times[k];
        found = 1;
    }
    return found;
}

/* The key times of all tracks, and the times that divide the segment between two of them into equal parts. */
static void add_all_times(const nkw_clip_source *s, const nkw_clip_reduction *r, const reduce_made *made,
                          reduce_errors *e)
{
    const int parts = made ? made->parts : 1;
    float time, next;
    for (int more = next_time(s, -INFINITY, &time); more; time = next) {
        add_time(s, r, made, time, e);
        more = next_time(s, time, &next);
        for (int part = 1; part < parts && more; part++)
            add_time(s, r, made, nkw_lerp(time, next, (float)part / (float)parts), e);
    }
}

static void add_times(const nkw_clip_source *s, const nkw_clip_reduction *r, const reduce_made *made, reduce_errors *e)
{
    set_rest(s, &e->want);
    set_rest(s, &e->got);
    if (made && made->clip)
        add_track_times(s, r, made, e);
    else
        add_all_times(s, r, made, e);
}

void nkwi_reduce_no_errors(const nkw_clip_source *source, reduce_errors *e)
{
    for (size_t i = 0; i < source->joint_count + source->track_count; i++)
        e->errors[i] = 0.0;
    e->distance = e->floats = 0.0;
    e->from = -INFINITY, e->to = INFINITY;
}

void nkwi_reduce_reach(const nkw_clip_source *source, const nkw_clip_reduction *r, reduce_errors *e)
{
    nkwi_reduce_no_errors(source, e);
    for (size_t j = 0; j < source->joint_count; j++)
        e->reach[j] = e->tight[j] = e->scale[j] = 0.0;
    for (size_t i = 0; i < 3 * source->joint_count; i++)
        e->axes[i] = 0.0;
    add_times(source, r, NULL, e);
    for (size_t i = 0; i < 3 * source->joint_count; i++) /* from lengths of columns */
        e->axes[i] = distance_of(r, i / 3) / lane_divisor64(e->axes[i]);
}

void nkwi_reduce_errors(const nkw_clip_source *source, const nkw_clip_reduction *r, const reduce_made *made,
                        reduce_errors *e)
{
    add_times(source, r, made, e);
}
