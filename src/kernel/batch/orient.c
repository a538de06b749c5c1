/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/orient.h>

#include "batch/element.h"
#include "batch/nlerp_sums.h"
#include "batch/orient.h"
#include "batch/tail.h"
#include "lane/arc.h"
#include "lane/nlerp.h"
#include "lane/slerp.h"
#include "pack/slerp.h"
#include "sizes.h"

NKW_LOOPS_ORIENT(NKW_DECLARE_LOOP)

/* Elements from..to - 1; `each`, a constant: every element has its own t; else *t is that of all. */
NKW_ALWAYS_INLINE void nlerp_block(nkw_quat_view a, nkw_quat_view b, const float *t, int each, int generic,
                                   nkw_quat_span out, size_t from, size_t to)
{
    const nkw_quat_span o = {out.x + from, out.y + from, out.z + from, out.w + from};
    nlerp_sums s;
    int far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = from; i < to; i++)
        put_nlerp(s, i - from, lane_quat_nlerp(at_quat(a, i), at_quat(b, i), t[each ? i : 0], generic), far);
    normalize_block_sums(&s, far, o, to - from);
}

/* Whether no result may be one of the inputs: equal ones have the same |w|. */
NKW_ALWAYS_INLINE int is_nlerp_generic(const float *a, const float *b, const float *t, int each, size_t from, size_t to)
{
    int special = 0;
#pragma omp simd reduction(| : special)
    for (size_t i = from; i < to; i++) {
        float at = t[each ? i : 0];
        special |= (lane_abs(a[i]) == lane_abs(b[i])) | (at == 0.0f) | (at == 1.0f);
    }
    return !special;
}

NKW_ALWAYS_INLINE void nlerp_blocks(nkw_quat_view a, nkw_quat_view b, const float *t, int each, nkw_quat_span out,
                                    size_t n)
{
    for (size_t from = 0; from < n; from += ORIENT_BLOCK) {
        size_t end = n - from < ORIENT_BLOCK ? n : from + ORIENT_BLOCK;
        if (is_nlerp_generic(a.w, b.w, t, each, from, end))
            nlerp_block(a, b, t, each, 1, out, from, end);
        else
            nlerp_block(a, b, t, each, 0, out, from, end);
    }
}

NKW_ALWAYS_INLINE void nlerp(nkw_quat_view a, nkw_quat_view b, const float *t, int each, nkw_quat_span out, size_t n)
{
    quat_tail r;
    if (!has_tail(n)) {
        nlerp_blocks(a, b, t, each, out, n);
        return;
    }
    const size_t last = n - F32XN;
    read_register(&r.a, a, last);
    read_register(&r.b, b, last);
    if (each)
        copy_register(r.t, t + last);
    nlerp_block(register_view(&r.a), register_view(&r.b), each ? r.t : t, each, 0, register_span(&r.out), 0, F32XN);
    nlerp_blocks(a, b, t, each, out, n - n % F32XN);
    write_register(&r.out, out, last);
}

NKW_LOOP(nkw_quat_nlerp_n)(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n)
{
    nlerp(a, b, t, 1, out, n);
}

NKW_LOOP(nkw_quat_nlerp_at_n)(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n)
{
    nlerp(a, b, &t, 0, out, n);
}

static inline int any_outside(const float *t, size_t from, size_t to)
{
    int outside = 0;
#pragma omp simd reduction(| : outside)
    for (size_t i = from; i < to; i++)
        outside |= !lane_t_is_inside(t[i]);
    return outside;
}

/* For t in 0..1. */
static inline int all_generic(const float *t, size_t from, size_t to)
{
    int special = 0;
#pragma omp simd reduction(| : special)
    for (size_t i = from; i < to; i++)
        special |= (t[i] == 0.0f) | (t[i] == 0.5f) | (t[i] == 1.0f);
    return !special;
}

/*
 * Slerp takes two steps over a block, arcs and what is made of them: then no element waits for the division of the one
 * before. Elements from..to - 1; out may be a, b or t.
 */
static inline void arcs_between(nkw_quat_view a, nkw_quat_view b, float *arcs, size_t from, size_t to)
{
#pragma omp simd
    for (size_t i = from; i < to; i++)
        arcs[i - from] = lane_slerp_arc(at_quat(a, i), at_quat(b, i), 0);
}

/* `generic`, a constant: no t is 0, 1/2 or 1, which saves up to a tenth of the instructions. */
NKW_ALWAYS_INLINE void slerp_inside(nkw_quat_view a, nkw_quat_view b, const float *t, int generic, nkw_quat_span out,
                                    size_t from, size_t to)
{
    float arcs[ORIENT_BLOCK];
    arcs_between(a, b, arcs, from, to);
#pragma omp simd
    for (size_t i = from; i < to; i++) {
        lane_slerp_time at = lane_slerp_time_at(t[i], generic);
        lane_slerp_weights k = lane_slerp_weights_of(&at, lane_abs(arcs[i - from]));
        put_quat(out, i, lane_quat_slerp_by(at_quat(a, i), at_quat(b, i), arcs[i - from], &at, k));
    }
}

/* For t outside 0..1, where slerp needs no branch. */
static inline int is_near(float t)
{
    return lane_abs(t) < (float)LANE_T_NEAR;
}

/* Inlined with what it calls, without which Clang does not vectorise the loops. */
NKW_ALWAYS_INLINE LANE_FLAT nkw_quat slerp_near(nkw_quat a, nkw_quat b, float t)
{
    return lane_quat_slerp_turned(a, b, t, NKW_PATH_SHORT, 1);
}

/* nkw_quat_slerp of one element. */
NKW_NOINLINE static nkw_quat slerp_one(nkw_quat a, nkw_quat b, float t)
{
    return quat_slerp(a, b, t);
}

/* Elements of half a block, side by side. */
typedef struct slerp_elements {
    float a[4][ORIENT_BLOCK / 2], b[4][ORIENT_BLOCK / 2], t[ORIENT_BLOCK / 2];
    uint32_t index[ORIENT_BLOCK / 2];
    size_t count;
} slerp_elements;

/* The slerp of a far t is computed here, and stored as a: the loop then slerps by t = 0. */
static inline void keep_element(slerp_elements *e, nkw_quat a, nkw_quat b, float t, size_t index)
{
    const nkw_quat_span to_a = {e->a[0], e->a[1], e->a[2], e->a[3]}, to_b = {e->b[0], e->b[1], e->b[2], e->b[3]};
    put_quat(to_a, e->count, is_near(t) ? a : slerp_one(a, b, t));
    put_quat(to_b, e->count, b);
    e->t[e->count] = is_near(t) ? t : 0.0f;
    e->index[e->count++] = (uint32_t)index;
}

/*
 * Half a block with t outside 0..1: those elements are taken out before the others overwrite a, b or t, one of which may be
 * out.
 */
NKW_NOINLINE LANE_FLAT static void slerp_beyond(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out,
                                                size_t from, size_t to)
{
    slerp_elements e;
    e.count = 0;
    for (size_t i = from; i < to; i++)
        if (!lane_t_is_inside(t[i]))
            keep_element(&e, at_quat(a, i), at_quat(b, i), t[i], i);
    slerp_inside(a, b, t, 0, out, from, to);
    const nkw_quat_span r = {e.a[0], e.a[1], e.a[2], e.a[3]};
    const nkw_quat_view kept_b = {e.b[0], e.b[1], e.b[2], e.b[3]};
#pragma omp simd
    for (size_t k = 0; k < e.count; k++)
        put_quat(r, k, slerp_near(at_quat(r, k), at_quat(kept_b, k), e.t[k]));
    for (size_t k = 0; k < e.count; k++)
        put_quat(out, e.index[k], at_quat(r, k));
}

NKW_ALWAYS_INLINE void slerp_blocks(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n)
{
    for (size_t from = 0; from < n; from += ORIENT_BLOCK) {
        size_t end = n - from < ORIENT_BLOCK ? n : from + ORIENT_BLOCK;
        if (end - from == 1)
            put_quat(out, from, slerp_one(at_quat(a, from), at_quat(b, from), t[from]));
        else if (any_outside(t, from, end)) {
            size_t middle = end - (end - from) / 2; /* ORIENT_BLOCK is even */
            slerp_beyond(a, b, t, out, from, middle);
            slerp_beyond(a, b, t, out, middle, end);
        } else if (all_generic(t, from, end))
            slerp_inside(a, b, t, 1, out, from, end);
        else
            slerp_inside(a, b, t, 0, out, from, end);
    }
}

NKW_LOOP(nkw_quat_slerp_n)(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n)
{
    const int tail = has_tail(n);
    const size_t last = n - F32XN;
    quat_tail r;
    if (tail) {
        read_register(&r.a, a, last);
        read_register(&r.b, b, last);
        copy_register(r.t, t + last);
        slerp_blocks(register_view(&r.a), register_view(&r.b), r.t, register_span(&r.out), F32XN);
    }
    slerp_blocks(a, b, t, out, tail ? n - n % F32XN : n);
    if (tail)
        write_register(&r.out, out, last);
}

NKW_ALWAYS_INLINE void slerp_at_time(nkw_quat_view a, nkw_quat_view b, lane_slerp_time at, nkw_quat_span out, size_t n)
{
    const lane_slerp_series series = lane_slerp_series_at(&at);
    for (size_t from = 0; from < n; from += ORIENT_BLOCK) {
        size_t end = n - from < ORIENT_BLOCK ? n : from + ORIENT_BLOCK;
        float arcs[ORIENT_BLOCK];
        arcs_between(a, b, arcs, from, end);
#pragma omp simd
        for (size_t i = from; i < end; i++) {
            lane_slerp_weights k = lane_slerp_weights_in(&at, &series, lane_abs(arcs[i - from]));
            put_quat(out, i, lane_quat_slerp_by(at_quat(a, i), at_quat(b, i), arcs[i - from], &at, k));
        }
    }
}

static void slerp_at(nkw_quat_view a, nkw_quat_view b, const lane_slerp_time *at, float t, nkw_quat_span out, size_t n)
{
    if (!lane_t_is_generic(t))
        slerp_at_time(a, b, *at, out, n);
    else if (at->first)
        slerp_at_time(a, b, lane_slerp_time_from(*at, 1), out, n);
    else
        slerp_at_time(a, b, lane_slerp_time_from(*at, 0), out, n);
}

NKW_LOOP(nkw_quat_slerp_at_n)(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n)
{
    if (n == 1 || !is_near(t)) {
        for (size_t i = 0; i < n; i++)
            put_quat(out, i, slerp_one(at_quat(a, i), at_quat(b, i), t));
        return;
    }
    if (!lane_t_is_inside(t)) {
#pragma omp simd
        for (size_t i = 0; i < n; i++)
            put_quat(out, i, slerp_near(at_quat(a, i), at_quat(b, i), t));
        return;
    }
    const lane_slerp_time at = lane_slerp_time_at(t, 0);
    const int tail = has_tail(n);
    const size_t last = n - F32XN;
    quat_tail r;
    if (tail) {
        read_register(&r.a, a, last);
        read_register(&r.b, b, last);
        slerp_at(register_view(&r.a), register_view(&r.b), &at, t, register_span(&r.out), F32XN);
    }
    slerp_at(a, b, &at, t, out, tail ? n - n % F32XN : n);
    if (tail)
        write_register(&r.out, out, last);
}
