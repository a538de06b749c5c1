/* SPDX-License-Identifier: MIT */
#include "compare.h"

#include <nakawari/euler.h>
#include <nakawari/mat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

/* The rows of one part and one method, and what they are compared with. */
typedef struct group {
    const scene *s;
    const compare_row *rows;
    size_t count;
    compare_part part;
    int stated; /* the method that the rows state, or COMPARE_UNSTATED */
    int method; /* the one that they are compared with */
    float tolerance;
} group;

static const report_method *list_of(compare_part part)
{
    return part == COMPARE_POSITION ? report_positions : report_orientations;
}

nkw_mat3 compare_rotation(const float angles[3])
{
    nkw_vec3 xyz = {angles[1], angles[0], angles[2]};
    return nkw_mat3_from_euler(xyz, NKW_EULER_YXZ);
}

/* ---- the difference of one row ---- */

static float position_difference(const compare_row *r, nkw_vec3 p)
{
    nkw_vec3 d = nkw_vec3_sub(nkw_mat4_translation(&r->m), p);
    return nkw_max(nkw_abs(d.x), nkw_max(nkw_abs(d.y), nkw_abs(d.z)));
}

/* The last row of a whole matrix is 0 0 0 1. */
static float orientation_difference(const compare_row *r, const nkw_mat3 *rotation)
{
    const nkw_vec3 nowhere = {0.0f, 0.0f, 0.0f};
    const nkw_mat4 m = nkw_mat4_from_mat3(rotation, nowhere);
    float most = 0.0f;
    for (int i = 0; i < 16; i++)
        if (i < 12 || i == 15)
            most = nkw_max(most, nkw_abs(r->m.m[i] - m.m[i]));
    return most;
}

/* What the row differs by from the right numbers, or from those of a mistake. */
static float difference(const group *g, const compare_row *r, int method, const mistake *wrong)
{
    const int code = list_of(g->part)[method].method;
    attempt a = {0};
    a.s = g->s;
    a.time = r->time;
    a.method = code;
    const int is_position = g->part == COMPARE_POSITION;
    const nkw_keyframe_options options = {is_position ? (nkw_position_method)code : NKW_POSITION_LINEAR,
                                          is_position ? NKW_ORIENTATION_STEP : (nkw_orientation_method)code,
                                          g->s->rule};
    (void)nkw_keyframes_trace(g->s->keys, g->s->count, r->time, &options, &a.right);
    if (is_position)
        return position_difference(r, wrong ? wrong->position(&a) : a.right.position);
    nkw_mat3 rotation = wrong ? wrong->orientation(&a) : a.right.rotation;
    return orientation_difference(r, &rotation);
}

static int is_of(const group *g, const compare_row *r)
{
    const int has = g->part == COMPARE_POSITION ? r->has_position : r->form != COMPARE_NONE;
    return has && r->method[g->part] == g->stated;
}

/* ---- causes ---- */

/* Angles in degrees that were taken for radians, read again. */
static compare_row read_as_degrees(const compare_row *r)
{
    compare_row again = *r;
    for (int i = 0; i < 3; i++)
        again.angles[i] = nkw_radians_from_degrees(r->angles[i]);
    nkw_mat3 rotation = compare_rotation(again.angles);
    again.m = nkw_mat4_from_mat3(&rotation, nkw_mat4_translation(&r->m));
    return again;
}

static float cause_difference(const group *g, const compare_row *r, const compare_cause *c)
{
    if (c->mistake)
        return difference(g, r, g->method, c->mistake);
    if (c->method != COMPARE_UNSTATED)
        return difference(g, r, c->method, NULL);
    const compare_row again = read_as_degrees(r);
    return difference(g, &again, g->method, NULL);
}

static int explains(const group *g, compare_cause *c)
{
    for (size_t i = 0; i < g->count; i++) {
        const compare_row *r = &g->rows[i];
        if (!is_of(g, r))
            continue;
        const float wrong = cause_difference(g, r, c);
        if (!(wrong <= g->tolerance))
            continue;
        c->agreeing++;
        if (difference(g, r, g->method, NULL) <= g->tolerance)
            continue;
        c->reproduced++;
        c->worst = nkw_max(c->worst, wrong);
    }
    return c->reproduced > 0;
}

/* Of causes of all differing rows those that agree with most rows are kept, the closest first; of others the one of most. */
static void keep(compare_finding *f, compare_cause c)
{
    if (c.reproduced < f->differing) {
        if (c.reproduced > f->nearest.reproduced)
            f->nearest = c;
        return;
    }
    if (f->cause_count > 0 && c.agreeing < f->causes[0].agreeing)
        return;
    if (f->cause_count > 0 && c.agreeing > f->causes[0].agreeing)
        f->cause_count = 0;
    for (size_t i = 0; i < f->cause_count; i++)
        if (c.worst < f->causes[i].worst) {
            const compare_cause worse = f->causes[i];
            f->causes[i] = c;
            c = worse;
        }
    if (f->cause_count < COMPARE_CAUSES)
        f->causes[f->cause_count++] = c;
}

static void try_cause(const group *g, compare_finding *f, const mistake *wrong, int method)
{
    compare_cause c = {wrong, method, 0, 0, 0.0f};
    if (explains(g, &c))
        keep(f, c);
}

static int has_radians(const group *g)
{
    size_t n = 0;
    for (size_t i = 0; i < g->count; i++)
        n += is_of(g, &g->rows[i]) && g->rows[i].form == COMPARE_ANGLES && !g->rows[i].degrees;
    return n > 0;
}

static const mistake *mistakes_of(compare_part part)
{
    return part == COMPARE_POSITION ? position_mistakes : orientation_mistakes;
}

static void find_causes(const group *g, compare_finding *f)
{
    const report_method *list = list_of(g->part);
    for (const mistake *m = mistakes_of(g->part); m->name; m++)
        if (m->method == MISTAKE_ANY || m->method == list[g->method].method)
            try_cause(g, f, m, g->method);
    for (int other = 0; list[other].name; other++)
        if (other != g->method)
            try_cause(g, f, NULL, other);
    if (g->part == COMPARE_ORIENTATION && has_radians(g))
        try_cause(g, f, NULL, COMPARE_UNSTATED);
}

/* ---- findings ---- */

static void measure(const group *g, compare_finding *f)
{
    for (size_t i = 0; i < g->count; i++) {
        const compare_row *r = &g->rows[i];
        if (!is_of(g, r))
            continue;
        const float d = difference(g, r, g->method, NULL);
        f->rows++;
        if (d <= g->tolerance)
            continue;
        if (f->differing++ == 0)
            f->line = r->line;
        f->first = f->differing == 1 ? r->time : nkw_min(f->first, r->time);
        f->last = f->differing == 1 ? r->time : nkw_max(f->last, r->time);
        f->worst_time = d > f->worst ? r->time : f->worst_time;
        f->worst = nkw_max(f->worst, d);
    }
}

/* How many rows the method itself, or else one of its own mistakes, reproduces. */
static size_t score_of(const group *g)
{
    compare_finding f = {0};
    measure(g, &f);
    size_t most = f.rows - f.differing;
    for (const mistake *m = mistakes_of(g->part); m->name && f.differing > 0; m++) {
        compare_cause c = {m, g->method, 0, 0, 0.0f};
        if ((m->method == MISTAKE_ANY || m->method == list_of(g->part)[g->method].method) && explains(g, &c))
            most = c.agreeing > most ? c.agreeing : most;
    }
    return 2 * most + (f.differing == 0);
}

enum { TAUGHT_POSITIONS = 4, TAUGHT_ORIENTATIONS = 3 }; /* by the exercise: the first of the lists */

static int guess_method(group g)
{
    const int count = g.part == COMPARE_POSITION ? TAUGHT_POSITIONS : TAUGHT_ORIENTATIONS;
    size_t best = 0;
    int guess = 0;
    for (g.method = 0; g.method < count; g.method++) {
        const size_t score = score_of(&g);
        if (score > best) {
            best = score;
            guess = g.method;
        }
    }
    return guess;
}

static void add_finding(compare_result *result, group g, const compare_options *o)
{
    compare_finding f = {0};
    size_t any = 0;
    for (size_t i = 0; i < g.count; i++)
        any += (size_t)is_of(&g, &g.rows[i]);
    if (any == 0 || result->count == COMPARE_FINDINGS)
        return;
    g.method = g.stated != COMPARE_UNSTATED ? g.stated : o->method[g.part];
    f.is_guess = g.method == COMPARE_UNSTATED;
    f.part = g.part;
    f.method = g.method = f.is_guess ? guess_method(g) : g.method;
    measure(&g, &f);
    if (f.differing > 0)
        find_causes(&g, &f);
    result->findings[result->count++] = f;
}

/* ---- transposed matrices ---- */

/* Whether the last row has what the last column should have, in all 4x4 matrices. */
static int are_transposed(const compare_row *rows, size_t count, float tolerance)
{
    size_t whole = 0, moved = 0;
    for (size_t i = 0; i < count; i++) {
        const float *m = rows[i].m.m;
        if (!rows[i].whole)
            continue;
        whole++;
        if (!(nkw_abs(m[12]) + nkw_abs(m[13]) + nkw_abs(m[14]) <= tolerance))
            return 0;
        moved += nkw_abs(m[3]) + nkw_abs(m[7]) + nkw_abs(m[11]) > tolerance;
    }
    return moved > 0 && 2 * moved > whole;
}

int compare_rows(const scene *s, const compare_options *o, compare_row *rows, size_t count, compare_result *result)
{
    size_t differing = 0;
    result->count = 0;
    result->is_transposed = are_transposed(rows, count, o->tolerance);
    for (size_t i = 0; i < count; i++)
        if (result->is_transposed && rows[i].whole)
            rows[i].m = nkw_mat4_transpose(&rows[i].m);
    for (int part = 0; part < COMPARE_PARTS; part++)
        for (int stated = COMPARE_UNSTATED; stated < 0 || list_of((compare_part)part)[stated].name; stated++) {
            const group g = {s, rows, count, (compare_part)part, stated, stated, o->tolerance};
            add_finding(result, g, o);
        }
    for (size_t i = 0; i < result->count; i++)
        differing += result->findings[i].differing;
    return differing == 0 && !result->is_transposed;
}
