/* SPDX-License-Identifier: MIT */
/* What the lines of rows.h are written in, and the table that they make: each loop, and its scalar function. */
#ifndef NAKAWARI_TESTS_ACCESS_H
#define NAKAWARI_TESTS_ACCESS_H

#include <string.h>

#include <nakawari/nakawari.h>

#include "../support/put.h"

#define ARRAYS  32
#define LONGEST 600

static float packed[16 * LONGEST];

static const nkw_mat4 some_matrix = {{0.5f, 1, -2, 0, 3, 0.25f, 1, 0, -1, 1, 4, 0, 10, -20, 30, 1}};

/* The first `width` input arrays as one array of structs. */
static const void *aos(const float *const *in, size_t width, size_t n)
{
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < width; k++)
            packed[i * width + k] = in[k][i];
    return packed;
}

#define V(k)   ((nkw_vec3_view){in[k], in[(k) + 1], in[(k) + 2]})
#define Q(k)   ((nkw_quat_view){in[k], in[(k) + 1], in[(k) + 2], in[(k) + 3]})
#define VS(k)  ((nkw_vec3_span){out[k], out[(k) + 1], out[(k) + 2]})
#define QS(k)  ((nkw_quat_span){out[k], out[(k) + 1], out[(k) + 2], out[(k) + 3]})
#define TRS(k) ((nkw_trs_view){V(k), Q((k) + 3), V((k) + 7)})
#define v(k)   ((nkw_vec3){x[k], x[(k) + 1], x[(k) + 2]})
#define q(k)   ((nkw_quat){x[k], x[(k) + 1], x[(k) + 2], x[(k) + 3]})
#define trs(k) ((nkw_trs){v(k), q((k) + 3), v((k) + 7)})
#define M4(k)  view16(in + (k))
#define MS4(k) span16(out + (k))
#define m3(k)  (*(const nkw_mat3 *)(const void *)(x + (k)))
#define m4(k)  (*(const nkw_mat4 *)(const void *)(x + (k)))

static nkw_mat4_view view16(const float *const *in)
{
    nkw_mat4_view r;
    memcpy(r.m, in, sizeof r.m);
    return r;
}

static nkw_mat4_span span16(float *const *out)
{
    nkw_mat4_span r;
    memcpy(r.m, out, sizeof r.m);
    return r;
}

/* ---- The lines of rows.h as a table ---- */

#define P(name, letters, count, arguments, result)                                                                     \
    static void loop_##name(const float *const *in, float *const *out, size_t n)                                       \
    {                                                                                                                  \
        (void)in;                                                                                                      \
        nkw_##name##_n arguments;                                                                                      \
    }                                                                                                                  \
    static void single_##name(const float *x, float *o)                                                                \
    {                                                                                                                  \
        result;                                                                                                        \
    }
#define PX P
#include "rows.h"
#undef P
#undef PX

typedef struct row {
    const char *name, *inputs;
    size_t outputs;
    int in_place;
    void (*loop)(const float *const *in, float *const *out, size_t n);
    void (*single)(const float *x, float *o);
} row;

static const row rows[] = {
#define P(name, letters, count, arguments, result)  {#name, letters, count, 1, loop_##name, single_##name},
#define PX(name, letters, count, arguments, result) {#name, letters, count, 0, loop_##name, single_##name},
#include "rows.h"
#undef P
#undef PX
};

#define ROWS (sizeof rows / sizeof rows[0])

#endif
