/* SPDX-License-Identifier: MIT */
/*
 * Loops over two arrays of quaternions whose length is no multiple of a register: the last register overlaps the one
 * before. Its inputs are copied before anything is written, since an output may be an input. The elements that are
 * computed twice have the same bits. A remainder of a loop would be computed element by element.
 */
#ifndef NAKAWARI_BATCH_TAIL_H
#define NAKAWARI_BATCH_TAIL_H

#include "lane/strict.h"

#include "batch/isa.h"
#include "pack/f32xn.h"
#include "sizes.h"

typedef struct quat_register {
    float x[F32XN], y[F32XN], z[F32XN], w[F32XN];
} quat_register;

typedef struct quat_tail {
    quat_register a, b, out;
    float t[F32XN];
} quat_tail;

/* Whether n elements have a last register that overlaps. */
NKW_ALWAYS_INLINE int has_tail(size_t n)
{
    return n > F32XN && n % F32XN >= TAIL_LEAST;
}

NKW_ALWAYS_INLINE void copy_register(float *to, const float *from)
{
    f32xN_store(to, f32xN_load(from));
}

/* Elements from .. from + F32XN - 1. */
NKW_ALWAYS_INLINE void read_register(quat_register *r, nkw_quat_view v, size_t from)
{
    copy_register(r->x, v.x + from);
    copy_register(r->y, v.y + from);
    copy_register(r->z, v.z + from);
    copy_register(r->w, v.w + from);
}

NKW_ALWAYS_INLINE void write_register(const quat_register *r, nkw_quat_span s, size_t from)
{
    copy_register(s.x + from, r->x);
    copy_register(s.y + from, r->y);
    copy_register(s.z + from, r->z);
    copy_register(s.w + from, r->w);
}

NKW_ALWAYS_INLINE nkw_quat_view register_view(const quat_register *r)
{
    nkw_quat_view v = {r->x, r->y, r->z, r->w};
    return v;
}

NKW_ALWAYS_INLINE nkw_quat_span register_span(quat_register *r)
{
    nkw_quat_span s = {r->x, r->y, r->z, r->w};
    return s;
}

#endif
