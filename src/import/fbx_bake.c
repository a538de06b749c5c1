/* SPDX-License-Identifier: MIT */
#include "fbx_bake.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/curve.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>

enum { PARTS = 8, FIRST = 3, SECOND = 5, DEPTH = 14, SPIN_KEYS = 8 };
enum { ADDED_MOST = 1 << 16 }; /* halves of a hostile file */

/* A segment: nine samples at eighths, the ends included. */
typedef struct piece {
    float times[PARTS + 1];
    float *values; /* of each sample `width` numbers */
    int is_spin; /* its samples are those of slerp */
} piece;

typedef struct baker {
    const nkwi_fbx_source *s;
    nkwi_fbx_baked *out;
    float tolerance;
    float gap; /* the median distance of the times */
    float last[NKWI_FBX_WIDTH]; /* the last sample, whose sign the next rotation follows */
    int has_last;
} baker;

/* ---- samples ---- */

static float *value_at(const baker *b, const piece *p, int i)
{
    return p->values + (size_t)i * b->s->width;
}

static void sample(baker *b, float time, float *out)
{
    const size_t w = b->s->width;
    float dot = 0.0f;
    b->s->sample(b->s->user, time, out);
    for (size_t k = 0; k < w; k++)
        dot += out[k] * b->last[k];
    for (size_t k = 0; b->s->is_rotation && b->has_last && dot < 0.0f && k < w; k++)
        out[k] = -out[k];
    memcpy(b->last, out, w * sizeof *out);
    b->has_last = 1;
}

static float distance(const baker *b, const float *p, const float *q)
{
    float most = 0.0f;
    for (size_t k = 0; k < b->s->width; k++)
        most = fmaxf(most, fabsf(p[k] - q[k]));
    return b->s->is_rotation ? 2.0f * most : most; /* an angle is twice a difference of unit quaternions */
}

/* Whether half the angle between two rotations is more than that of the cosine. */
static int is_beyond(const float *p, const float *q, float cosine)
{
    float dot = 0.0f;
    for (int k = 0; k < 4; k++)
        dot += p[k] * q[k];
    return fabsf(dot) < cosine;
}

static nkw_quat quat_at(const float *v)
{
    const nkw_quat q = {v[0], v[1], v[2], v[3]};
    return q;
}

/* The line, or the arc, between the ends of a piece. */
static void line_at(const baker *b, const piece *p, float x, float *out)
{
    const float *from = p->values, *to = value_at(b, p, PARTS);
    if (b->s->is_rotation) {
        const nkw_quat q = nkw_quat_slerp(quat_at(from), quat_at(to), x);
        memcpy(out, &q, sizeof q);
        return;
    }
    for (size_t k = 0; k < b->s->width; k++)
        out[k] = nkw_lerp(from[k], to[k], x);
}

static float part_of(const piece *p, int i)
{
    return p->times[PARTS] > p->times[0] ? nkw_inverse_lerp(p->times[0], p->times[PARTS], p->times[i]) : 0.0f;
}

/*
 * Angles that go from 179 to -179 degrees from one frame to the next turn by 358 degrees between them. An exporter
 * made them of rotations: the arc between the frames is meant. So are, of tracks of 8 keys or more, segments of the
 * median length that go farther than 120 degrees, and end within 90.
 */
static void mend_spin(baker *b, piece *p)
{
    const float length = p->times[PARTS] - p->times[0];
    float *end = value_at(b, p, PARTS), dot = 0.0f;
    if (!b->s->is_rotation || b->s->times->count < SPIN_KEYS || length > 1.001f * b->gap ||
        is_beyond(p->values, end, 0.70710678f) || !is_beyond(p->values, value_at(b, p, PARTS / 2), 0.5f))
        return;
    for (int k = 0; k < 4; k++)
        dot += p->values[k] * end[k];
    for (int k = 0; dot < 0.0f && k < 4; k++)
        end[k] = -end[k];
    for (int i = 1; i < PARTS; i++)
        line_at(b, p, part_of(p, i), value_at(b, p, i));
    memcpy(b->last, end, 4 * sizeof(float));
    p->is_spin = 1;
    b->out->spins++;
}

/* The next float in this direction; near 0 one of those of 1/16. */
static float beside(float time, float towards)
{
    const float step = towards > time ? 0x1p-27f : -0x1p-27f;
    return fabsf(time) < 0.0625f ? time + step : nextafterf(time, towards);
}

/* The time at which a piece begins, and that at which it ends, where they may jump. */
static float first_time(float a, float c, int jump)
{
    return jump & NKWI_FBX_AFTER ? beside(a, c) : a;
}

static float last_time(float a, float c, int jump)
{
    return jump & (NKWI_FBX_JUMP | NKWI_FBX_SEAM) ? beside(c, a) : c;
}

/* The samples of a piece from a to c; beside a seam they are two floats farther away. */
static void take(baker *b, float a, float c, int jump_a, int jump_c, piece *p)
{
    const float first = first_time(a, c, jump_a), last = last_time(a, c, jump_c);
    p->is_spin = 0;
    for (int i = 0; i <= PARTS; i++) {
        float at = i == PARTS ? last : nkw_lerp(first, last, (float)i / PARTS);
        p->times[i] = at;
        if (i == PARTS && jump_c & NKWI_FBX_SEAM)
            at = beside(beside(at, a), a);
        else if (i == 0 && jump_a & NKWI_FBX_SEAM)
            at = beside(beside(at, c), c);
        sample(b, at, value_at(b, p, i));
    }
}

/* ---- cubic segments ---- */

/* Tangents per segment of the cubic through the ends, the third and the fifth eighth. */
static void fit(const baker *b, const piece *p, float *m0, float *m1)
{
    const double x = (double)part_of(p, FIRST), y = (double)part_of(p, SECOND);
    const double a = x * (1 - x) * (1 - x), c = -x * x * (1 - x), d = y * (1 - y) * (1 - y), e = -y * y * (1 - y);
    const double scale = a * e - c * d, hx = x * x * (3 - 2 * x), hy = y * y * (3 - 2 * y);
    for (size_t k = 0; k < b->s->width; k++) {
        const double from = (double)p->values[k], rise = (double)value_at(b, p, PARTS)[k] - from;
        const double u = (double)value_at(b, p, FIRST)[k] - from - hx * rise;
        const double v = (double)value_at(b, p, SECOND)[k] - from - hy * rise;
        m0[k] = scale != 0.0 ? (float)((u * e - c * v) / scale) : (float)rise;
        m1[k] = scale != 0.0 ? (float)((a * v - d * u) / scale) : (float)rise;
    }
}

/* The largest difference of the samples to the cubic; of rotations after normalisation. */
static float error_of(const baker *b, const piece *p, const float *m0, const float *m1)
{
    const float *from = p->values, *to = value_at(b, p, PARTS);
    float most = 0.0f;
    for (int i = 1; i < PARTS; i++) {
        const float x = part_of(p, i);
        float value[NKWI_FBX_WIDTH], square = 0.0f;
        for (size_t k = 0; k < b->s->width; k++) {
            value[k] = nkw_hermite(from[k], m0[k], to[k], m1[k], x);
            square += value[k] * value[k];
        }
        for (size_t k = 0; b->s->is_rotation && k < 4; k++)
            value[k] /= square > 0.0f ? sqrtf(square) : 1.0f;
        most = fmaxf(most, distance(b, value, value_at(b, p, i)));
    }
    return most;
}

static int is_line(const baker *b, const piece *p)
{
    float value[NKWI_FBX_WIDTH];
    for (int i = 1; i < PARTS; i++) {
        line_at(b, p, part_of(p, i), value);
        if (!(distance(b, value, value_at(b, p, i)) <= b->tolerance))
            return 0;
    }
    return 1;
}

static int is_level(const baker *b, const piece *p)
{
    for (int i = 1; i <= PARTS; i++)
        if (memcmp(p->values, value_at(b, p, i), b->s->width * sizeof(float)) != 0)
            return 0;
    return 1;
}

/* ---- keys ---- */

/* Room for a key; its values, or NULL without memory. */
static float *add_key(baker *b, float time)
{
    nkwi_fbx_baked *o = b->out;
    if (o->count == o->room) {
        const size_t room = o->room ? 2 * o->room : 64;
        float *times = (float *)realloc(o->times, room * sizeof *times);
        o->times = times ? times : o->times;
        float *values = times ? (float *)realloc(o->values, room * o->width * sizeof *values) : NULL;
        o->values = values ? values : o->values;
        if (!times || !values)
            return NULL;
        o->room = room;
    }
    memset(o->values + o->count * o->width, 0, o->width * sizeof(float));
    o->times[o->count] = time;
    return o->values + o->count++ * o->width;
}

/* A key of a CUBICSPLINE track, unless the last one has its time. */
static int add_cubic_key(baker *b, float time, const float *value)
{
    const size_t w = b->s->width;
    if (b->out->count > 0 && b->out->times[b->out->count - 1] == time)
        return 1;
    float *key = add_key(b, time);
    if (key)
        memcpy(key + w, value, w * sizeof *value);
    return key != NULL;
}

static int add_segment(baker *b, const piece *p, const float *m0, const float *m1)
{
    const size_t w = b->s->width;
    const float end = p->times[PARTS], length = end - p->times[0];
    if (!add_cubic_key(b, p->times[0], p->values))
        return 0;
    float *key = b->out->values + (b->out->count - 1) * b->out->width;
    for (size_t k = 0; k < w; k++)
        key[2 * w + k] = length > 0.0f ? m0[k] / length : 0.0f;
    if (!add_cubic_key(b, end, value_at(b, p, PARTS)))
        return 0;
    key = b->out->values + (b->out->count - 1) * b->out->width;
    for (size_t k = 0; k < w; k++)
        key[k] = length > 0.0f ? m1[k] / length : 0.0f;
    return 1;
}

/* The signs of the rotations of a piece follow the last key. */
static void align(baker *b, piece *p)
{
    const nkwi_fbx_baked *o = b->out;
    float dot = 0.0f;
    if (o->count == 0 || !b->s->is_rotation)
        return;
    const float *last = o->values + (o->count - 1) * o->width + b->s->width;
    for (size_t k = 0; k < 4; k++)
        dot += last[k] * p->values[k];
    for (size_t k = 0; dot < 0.0f && k < (PARTS + 1) * b->s->width; k++)
        p->values[k] = -p->values[k];
}

/* A part of a piece that waits: from a to c. */
typedef struct part {
    float a, c;
    int depth, jump_a, jump_c; /* nkwi_fbx_time.may_jump of its ends */
} part;

/* The piece as one segment, or as halves. a, c: the times of which its ends may be beside. */
static int add_piece(baker *b, piece *whole, const nkwi_fbx_time *from, const nkwi_fbx_time *to)
{
    part waiting[DEPTH + 2] = {{from->time, to->time, 0, from->may_jump, to->may_jump}};
    float samples[(PARTS + 1) * NKWI_FBX_WIDTH], m0[NKWI_FBX_WIDTH], m1[NKWI_FBX_WIDTH];
    piece half = {{0}, samples, 0}, *p = whole;
    size_t count = 1;
    align(b, whole);
    while (count > 0) {
        const part one = waiting[--count];
        const float middle = (float)(0.5 * ((double)one.a + (double)one.c));
        if (one.depth > 0) {
            p = &half;
            take(b, one.a, one.c, one.jump_a, one.jump_c, p);
        }
        fit(b, p, m0, m1);
        const float error = error_of(b, p, m0, m1);
        if (error > b->tolerance && !p->is_spin && one.depth < DEPTH && b->out->added < ADDED_MOST &&
            middle - one.a > 1e-5f) {
            const part left = {one.a, middle, one.depth + 1, one.jump_a, 0};
            const part right = {middle, one.c, one.depth + 1, 0, one.jump_c};
            waiting[count++] = right;
            waiting[count++] = left;
            b->out->added++;
            memcpy(b->last, p->values, b->s->width * sizeof *b->last);
            continue;
        }
        b->out->difference = p->is_spin ? b->out->difference : fmaxf(b->out->difference, error);
        if (!add_segment(b, p, m0, m1))
            return 0;
    }
    return 1;
}

/* ---- the track ---- */

/* Whether the piece begins behind its time, and the one before ends before it: the time has a value of its own. */
static int is_alone(const baker *b, const piece *p, size_t i)
{
    const nkwi_fbx_time *t = &b->s->times->list[i];
    return p->times[0] != t->time && (i == 0 || p[-1].times[PARTS] != t->time);
}

/* Lines or steps: one key for each time. */
static int add_plain(baker *b, const piece *pieces, size_t count)
{
    const size_t w = b->s->width;
    for (size_t i = 0; i <= count; i++) {
        const float time = i < count ? pieces[i].times[0] : pieces[count - 1].times[PARTS];
        float *key = i < count && is_alone(b, &pieces[i], i) ? add_key(b, b->s->times->list[i].time) : NULL;
        if (key)
            b->s->sample(b->s->user, b->s->times->list[i].time, key);
        key = add_key(b, time);
        if (!key)
            return 0;
        memcpy(key, i < count ? pieces[i].values : b->last, w * sizeof *key);
    }
    return 1;
}

static int compare(const void *left, const void *right)
{
    const float a = *(const float *)left, b = *(const float *)right;
    return a < b ? -1 : a > b;
}

static float median_gap(const nkwi_fbx_times *t, float *gaps)
{
    for (size_t i = 1; i < t->count; i++)
        gaps[i - 1] = t->list[i].time - t->list[i - 1].time;
    qsort(gaps, t->count - 1, sizeof *gaps, compare);
    return gaps[(t->count - 1) / 2];
}

/* What all pieces are. */
typedef struct kinds {
    int level, lines, jump;
    float largest;
} kinds;

/* There is no jump at the end of a piece. */
static void join(const baker *b, const nkwi_fbx_times *t, size_t i, piece *pieces)
{
    t->list[i + 1].may_jump = 0;
    pieces[i].times[PARTS] = t->list[i + 1].time;
    if (i + 2 < t->count)
        pieces[i + 1].times[0] = t->list[i + 1].time;
    memcpy(value_at(b, &pieces[i], PARTS), i + 2 < t->count ? pieces[i + 1].values : b->last,
           b->s->width * sizeof(float));
}

static kinds sample_all(baker *b, piece *pieces)
{
    const nkwi_fbx_times *t = b->s->times;
    kinds all = {1, 1, 0, b->s->is_rotation ? 1.0f : 1e-6f};
    for (size_t i = 0; i + 1 < t->count; i++) {
        take(b, t->list[i].time, t->list[i + 1].time, t->list[i].may_jump, t->list[i + 1].may_jump, &pieces[i]);
        mend_spin(b, &pieces[i]);
        for (size_t k = 0; !b->s->is_rotation && k < (PARTS + 1) * b->s->width; k++)
            all.largest = fmaxf(all.largest, fabsf(pieces[i].values[k]));
    }
    b->tolerance = all.largest * NKWI_FBX_TOLERANCE;
    sample(b, t->list[t->count - 1].time, b->last); /* after a jump at the last time */
    for (size_t i = 0; i + 1 < t->count; i++) {
        const float *next = i + 2 < t->count ? pieces[i + 1].values : b->last;
        all.level = all.level && is_level(b, &pieces[i]);
        all.lines = all.lines && is_line(b, &pieces[i]);
        if (!t->list[i + 1].may_jump)
            continue;
        float own[NKWI_FBX_WIDTH];
        b->s->sample(b->s->user, t->list[i + 1].time, own);
        if (distance(b, value_at(b, &pieces[i], PARTS), next) > 4 * b->tolerance ||
            (!b->s->is_rotation && distance(b, own, next) > 4 * b->tolerance) ||
            (b->s->is_rotation && is_beyond(own, next, 0.9999999f)))
            all.jump = 1;
        else
            join(b, t, i, pieces);
    }
    return all;
}

static int bake_pieces(baker *b, piece *pieces)
{
    const nkwi_fbx_times *t = b->s->times;
    const size_t count = t->count - 1, w = b->s->width;
    const kinds all = sample_all(b, pieces);
    float last[NKWI_FBX_WIDTH], own[NKWI_FBX_WIDTH];
    memcpy(last, b->last, sizeof last);
    if (all.level || (all.lines && !all.jump)) {
        b->out->interpolation = all.level && all.jump ? NKW_INTERPOLATION_STEP : NKW_INTERPOLATION_LINEAR;
        b->out->width = w;
        if (all.level && !all.jump) { /* constant: its ends */
            pieces[0].times[PARTS] = pieces[count - 1].times[PARTS];
            return add_plain(b, pieces, 1);
        }
        return add_plain(b, pieces, count);
    }
    b->out->interpolation = NKW_INTERPOLATION_CUBICSPLINE;
    b->out->width = 3 * w;
    for (size_t i = 0; i < count; i++) {
        if (is_alone(b, &pieces[i], i)) {
            b->s->sample(b->s->user, t->list[i].time, own);
            if (!add_cubic_key(b, t->list[i].time, own))
                return 0;
        }
        if (!add_piece(b, &pieces[i], &t->list[i], &t->list[i + 1]))
            return 0;
    }
    return add_cubic_key(b, t->list[count].time, last);
}

/* One time: a key. */
static int bake_time(baker *b)
{
    const float time = b->s->times->list[0].time;
    b->out->interpolation = NKW_INTERPOLATION_LINEAR;
    b->out->width = b->s->width;
    float *key = add_key(b, time);
    if (key)
        b->s->sample(b->s->user, time, key);
    return key != NULL;
}

int nkwi_fbx_bake(const nkwi_fbx_source *source, nkwi_fbx_baked *out)
{
    baker b = {source, out, 0.0f, 0.0f, {0}, 0};
    const size_t count = source->times->count, floats = (PARTS + 1) * source->width;
    memset(out, 0, sizeof *out);
    if (count == 1)
        return bake_time(&b);
    piece *pieces = count < SIZE_MAX / sizeof *pieces ? (piece *)calloc(count, sizeof *pieces) : NULL;
    float *values = count < SIZE_MAX / sizeof(float) / floats ? (float *)malloc(count * floats * sizeof *values) : NULL;
    int done = pieces && values;
    if (done) {
        b.gap = median_gap(source->times, values);
        for (size_t i = 0; i < count; i++)
            pieces[i].values = values + i * floats;
        done = bake_pieces(&b, pieces);
    }
    free(values);
    free(pieces);
    return done;
}

void nkwi_fbx_baked_free(nkwi_fbx_baked *baked)
{
    free(baked->times);
    free(baked->values);
}
