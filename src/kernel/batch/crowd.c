/* SPDX-License-Identifier: MIT */
/*
 * Lanes are characters. include/nakawari/crowd.h has the layout.
 *
 * Invariant: no lane reads another, so each has the bits of the functions of one character, whatever the others hold.
 *
 *     floats     0 .. 15       16 .. 31      ...                   of one joint
 *     pose       tx of 16      ty of 16      tz, rx ry rz rw, sx sy sz      10 rows of 16 lanes
 *     matrix     m00 of 16     m10 of 16     m20, m01 ... m23               12 rows, column by column
 *
 *     models     joint after joint, parents first: row k of joint j at (12 j + k) 16
 *                model(j) = model(parent j) local(j): the parent's rows are in the cache, 16 lanes of each at once
 *
 *     poses to lanes: 4 characters, one component of 4 joints, become 4 joints of one row
 *
 *         character i      c of j  j+1  j+2  j+3             joint j      c of i  i+1  i+2  i+3
 *         character i + 1  c of j  j+1  j+2  j+3      ->     joint j + 1  c of i  i+1  i+2  i+3
 *         ...                                                ...
 *
 * Skinning: vertices are the outer loop, so the influences of a vertex are decoded once for 16 characters; F32XN of
 * them are one register.
 */
#include "lane/strict.h"

#include <nakawari/crowd.h>
#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "batch/crowd.h"
#include "batch/skin_sum.h"
#include "lane/mat.h"
#include "lane/skeleton.h"
#include "pack/columns.h"
#include "sizes.h"

/* Lanes of a crowd in one loop. GCC holds the address of each array in a loop of two iterations, and runs out. */
#if NKW_REGISTER_BITS == 256 && !defined(__clang__)
#define CROWD_LOOP 8
#else
#define CROWD_LOOP 16
#endif

NKW_LOOPS_CROWD(NKW_DECLARE_LOOP)

#define CROWD_LANES NKW_CROWD
typedef char crowd_row_is_that_of_skin_sum[CROWD_ROW == CROWD_LANES ? 1 : -1];

/* An affine matrix of lane i. */
static inline nkw_mat4 matrix_at(const float *m, size_t i)
{
    nkw_mat4 r = {{m[i], m[CROWD_LANES + i], m[2 * CROWD_LANES + i], 0.0f, m[3 * CROWD_LANES + i],
                   m[4 * CROWD_LANES + i], m[5 * CROWD_LANES + i], 0.0f, m[6 * CROWD_LANES + i], m[7 * CROWD_LANES + i],
                   m[8 * CROWD_LANES + i], 0.0f, m[9 * CROWD_LANES + i], m[10 * CROWD_LANES + i],
                   m[11 * CROWD_LANES + i], 1.0f}};
    return r;
}

static inline void put_matrix(float *m, size_t i, const nkw_mat4 *a)
{
    for (size_t k = 0; k < 12; k++)
        m[k * CROWD_LANES + i] = a->m[k / 3 * 4 + k % 3];
}

/* nkw_mat4_from_trs of a lane; row k of the pose of its joint is at p + 16 k. */
static inline nkw_mat4 local_at(const float *p, size_t i)
{
    const nkw_trs trs = {
        {p[i], p[CROWD_LANES + i], p[2 * CROWD_LANES + i]},
        {p[3 * CROWD_LANES + i], p[4 * CROWD_LANES + i], p[5 * CROWD_LANES + i], p[6 * CROWD_LANES + i]},
        {p[7 * CROWD_LANES + i], p[8 * CROWD_LANES + i], p[9 * CROWD_LANES + i]},
    };
    return lane_mat4_from_trs(&trs);
}

/* Functions of their own, so that the loops around them see no address of a local matrix. */
static inline void local_of(const float *p, float *out, size_t i)
{
    nkw_mat4 m = local_at(p, i);
    put_matrix(out, i, &m);
}

static inline void model_of(const float *parent, const float *p, float *out, size_t i)
{
    nkw_mat4 a = matrix_at(parent, i), b = local_at(p, i), m = lane_mat4_mul_affine(&a, &b);
    put_matrix(out, i, &m);
}

static inline void bound_of(const float *model, const nkw_mat4 *inverse_bind, float *out, size_t i)
{
    nkw_mat4 a = matrix_at(model, i), m = lane_mat4_mul_affine(&a, inverse_bind);
    put_matrix(out, i, &m);
}

NKW_ALWAYS_INLINE void locals_of(const float *pose, float *out)
{
#pragma omp simd
    NKW_KEEP_LOOP
    for (size_t i = 0; i < CROWD_LOOP; i++)
        local_of(pose, out, i);
}

NKW_ALWAYS_INLINE void models_of(const float *parent, const float *pose, float *out)
{
#pragma omp simd
    NKW_KEEP_LOOP
    for (size_t i = 0; i < CROWD_LOOP; i++)
        model_of(parent, pose, out, i);
}

NKW_LOOP(nkwi_crowd_models)
(const int32_t *parents, size_t joints, const float *crowd, const float *roots, float *models)
{
    for (size_t j = 0; j < joints; j++) {
        const float *pose = crowd + j * 10 * CROWD_LANES;
        float *model = models + j * 12 * CROWD_LANES;
        size_t p = skeleton_parent(parents, j);
        const float *parent = p < j ? models + p * 12 * CROWD_LANES : roots;
        if (parent)
            for (size_t i = 0; i < CROWD_LANES; i += CROWD_LOOP)
                models_of(parent + i, pose + i, model + i);
        else
            for (size_t i = 0; i < CROWD_LANES; i += CROWD_LOOP)
                locals_of(pose + i, model + i);
    }
}

NKW_LOOP(nkwi_crowd_bind)(const float *model, const nkw_mat4 *inverse_bind, float *out)
{
    const nkw_mat4 bind = *inverse_bind;
#pragma omp simd
    for (size_t i = 0; i < CROWD_LANES; i++)
        bound_of(model, &bind, out, i);
}

/*
 * Transposes four floats of four poses to four lanes of four joints. The stride of a pose is a multiple of 16, so four
 * floats from joint j on are always there; joints from `joints` on are not written.
 */
NKW_LOOP(nkwi_crowd_from_poses)(const float *const *poses, size_t joints, size_t stride, float *crowd)
{
    static const float identity[10][4] = {{0}, {0},          {0},          {0},          {0},
                                          {0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}};
    for (size_t j = 0; j < joints; j += 4)
        for (size_t c = 0; c < 10; c++)
            for (size_t i = 0; i < CROWD_LANES; i += 4) {
                const float *from[4];
                float *to[4];
                for (size_t k = 0; k < 4; k++) {
                    from[k] = poses[i + k] ? poses[i + k] + c * stride + j : identity[c];
                    to[k] = j + k < joints ? crowd + ((j + k) * 10 + c) * CROWD_LANES + i : NULL;
                }
                f32x4_transpose_rows(from, to);
            }
}

/* The way back: three rows and the constant last row of a column become the columns of four characters. */
NKW_LOOP(nkwi_crowd_to_matrices)(const float *crowd, size_t joints, nkw_mat4 *const *matrices)
{
    static const float last[2][4] = {{0, 0, 0, 0}, {1, 1, 1, 1}};
    for (size_t j = 0; j < joints; j++)
        for (size_t column = 0; column < 4; column++)
            for (size_t i = 0; i < CROWD_LANES; i += 4) {
                const float *at = crowd + (12 * j + 3 * column) * CROWD_LANES + i;
                const float *const from[4] = {at, at + CROWD_LANES, at + 2 * CROWD_LANES, last[column == 3]};
                float *to[4];
                for (size_t k = 0; k < 4; k++)
                    to[k] = matrices[i + k] ? matrices[i + k][j].m + 4 * column : NULL;
                f32x4_transpose_rows(from, to);
            }
}

/* ---- Skinning: the lanes of a vertex share its influences and its vectors ---- */

/*
 * Vertices whose results are written together: where the output is packed, 4 vectors of 3 floats are 3 stores of 4
 * floats for each character.
 *
 *     r                  x0 y0 z0 x1 | y1 z1 x2 y2 | z2 x3 y3 z3      12 registers, lane i is character i
 *     f32xN_scatter      4 registers  | the next 4  | the last 4       to 4 floats at out[i] each
 */
enum { GROUP = 4 };

/* One vector of the F32XN lanes of a group: x0 y0 z0 x1 y1 ... */
typedef f32xN group_vectors[3 * GROUP];

/* A vector that all lanes share. */
NKW_ALWAYS_INLINE f32xN_vectors shared_vector(const unsigned char *in)
{
    const f32xN_vectors v = {f32xN_splat(load_float(in)), f32xN_splat(load_float(in + sizeof(float))),
                             f32xN_splat(load_float(in + 2 * sizeof(float)))};
    return v;
}

/* M p. */
NKW_ALWAYS_INLINE void transform_points(const f32xN m[12], f32xN_vectors v, f32xN *r)
{
    for (int i = 0; i < 3; i++)
        r[i] = f32xN_point(m[i], m[3 + i], m[6 + i], m[9 + i], v);
}

/* M d. */
NKW_ALWAYS_INLINE void transform_directions(const f32xN m[12], f32xN_vectors v, f32xN *r)
{
    for (int i = 0; i < 3; i++)
        r[i] = f32xN_direction(m[i], m[3 + i], m[6 + i], v);
}

/* f32xN_transform_normal of the matrix of each lane. */
NKW_ALWAYS_INLINE void transform_normals(const f32xN m[12], f32xN_vectors v, f32xN *r)
{
    f32xN side[3];
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        const f32xN_minor minor = {m[i1], m[i2], m[3 + i1], m[3 + i2], m[6 + i1], m[6 + i2]};
        r[i] = f32xN_cofactors(minor, v);
        side[i] = f32xN_side(m[i], minor);
    }
    const i32xN mirrors = f32xN_mirrors(side[0], side[1], side[2]);
    for (int i = 0; i < 3; i++)
        r[i] = f32xN_negate_where(mirrors, r[i]);
}

/* d / |d|; 0 where |d| = 0. */
NKW_ALWAYS_INLINE void normalize_directions(f32xN *r)
{
    const f32xN scale = f32xN_inverse_length((r[0] * r[0] + r[1] * r[1]) + r[2] * r[2]);
    for (int i = 0; i < 3; i++)
        r[i] = r[i] * scale;
}

/* The sum of the weights of vertex v: the last element of its blended nkw_mat4. */
NKW_ALWAYS_INLINE float sum_of_weights(const influences *f, size_t k, size_t v)
{
    const unsigned char *weights = f->weights + v * f->weight_stride;
    float sum = load_float(weights);
    for (size_t e = 1; e < k; e++)
        sum = sum + load_float(weights + e * sizeof sum);
    return sum;
}

/* Stream s of a vertex whose weights have a sum. */
NKW_ALWAYS_INLINE void transform_lanes(const nkw_skin_options *options, size_t s, const f32xN m[12], float sum,
                                       const unsigned char *in, f32xN *r)
{
    const f32xN_vectors v = shared_vector(in);
    if (s == SKIN_POSITIONS)
        transform_points(m, v, r);
    else if (s == SKIN_NORMALS && options->inverse_normals)
        transform_normals(m, v, r);
    else
        transform_directions(m, v, r);
    if (s == SKIN_POSITIONS && options->divide_by_weights)
        for (int i = 0; i < 3; i++)
            r[i] = r[i] / f32xN_splat(sum);
    if (s != SKIN_POSITIONS && !options->keep_length)
        normalize_directions(r);
}

/*
 * The first n vertices of a group. Where outputs are not packed, three floats of each vector are written; the fourth
 * register is there only because a transposition takes four.
 */
NKW_ALWAYS_INLINE void write_group(const crowd_stream *s, size_t lane, size_t n, f32xN *r)
{
    unsigned char *const *out = s->out + lane;
    if (n == GROUP && s->packed)
        for (size_t i = 0; i < 3; i++)
            f32xN_scatter(r + 4 * i, 4, out, 4 * i * sizeof(float));
    else
        for (size_t v = 0; v < n; v++) {
            unsigned char *to[F32XN];
            f32xN m[4] = {r[3 * v], r[3 * v + 1], r[3 * v + 2], r[3 * v + 2]};
            for (size_t i = 0; i < F32XN; i++)
                to[i] = out[i] + v * s->out_stride[lane + i];
            f32xN_scatter(m, 3, to, 0);
        }
}

/* n vertices with weights, at most a group. */
NKW_ALWAYS_INLINE void skin_group(const skin_job *job, const influences *from, size_t k, size_t n,
                                  const crowd_stream *streams)
{
    group_vectors r[SKIN_STREAMS];
    for (size_t lane = 0; lane < CROWD_LANES; lane += F32XN) {
        influences f = *from;
        f.palette += lane * sizeof(float);
        for (size_t v = 0; v < n; v++) {
            f32xN m[12]; /* row r, column c at [3 c + r] */
            weighted_sum(&f, CROWD_WIDTH, k, v, m);
            const float sum = job->options.divide_by_weights ? sum_of_weights(&f, k, v) : 1.0f;
            for (size_t s = 0; s < SKIN_STREAMS; s++)
                if (streams[s].in)
                    transform_lanes(&job->options, s, m, sum, streams[s].in + v * streams[s].in_stride, r[s] + 3 * v);
        }
        for (size_t s = 0; s < SKIN_STREAMS; s++)
            if (streams[s].in)
                write_group(&streams[s], lane, n, r[s]);
    }
}

/* A vertex without weights is copied to every character, as nkw_skin_linear copies it. */
static void copy_vertex(const crowd_stream *streams)
{
    for (size_t v = 0; v < SKIN_STREAMS; v++)
        for (size_t i = 0; i < CROWD_LANES && streams[v].in; i++)
            memcpy(streams[v].out[i], streams[v].in, sizeof(nkw_vec3));
}

static void advance(crowd_stream *streams, size_t n)
{
    for (size_t v = 0; v < SKIN_STREAMS; v++)
        if (streams[v].in) {
            streams[v].in += n * streams[v].in_stride;
            for (size_t i = 0; i < CROWD_LANES; i++)
                streams[v].out[i] += n * streams[v].out_stride[i];
        }
}

/* Groups of vertices with weights; a vertex without weights ends a group, and is copied. */
NKW_LOOP(nkwi_crowd_skin)(const skin_job *job, crowd_stream *streams)
{
    decoded_influences decoded;
    const size_t count = job->vertex_count, k = job->influence_count;
    for (size_t from = 0; from < count; from += SKIN_BLOCK) {
        const size_t n = count - from < SKIN_BLOCK ? count - from : SKIN_BLOCK;
        const influences all = decode(job, from, n, &decoded);
        for (size_t i = 0, part; i < n; i += part, advance(streams, part)) {
            const influences f = influences_at(&all, i);
            part = k == 0 ? 0 : count_weighted(&f, n - i < GROUP ? n - i : GROUP);
            if (part == 0)
                copy_vertex(streams), part = 1;
            else if (k == 4 && part == GROUP)
                skin_group(job, &f, 4, GROUP, streams);
            else
                skin_group(job, &f, k, part, streams);
        }
    }
}
