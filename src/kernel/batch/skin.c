/* SPDX-License-Identifier: MIT */
/*
 * Skinning in one pass over the vertices, a block at a time:
 *
 *     joints, weights as stored  ->  offsets, floats              decode
 *     palette entries            ->  the matrix of each vertex    weighted_sum (skin_sum.h)
 *     vectors as stored          ->  M p, M d / |M d|             transformed, normalize
 *
 * Linear blend: the matrices of a group of vertices stay in registers while they transform positions and normals
 * (blend_groups). They are stored for other vectors, and for normals and positions that options compute otherwise. Dual
 * quaternions are summed, then converted to matrices in memory.
 *
 * Invariant: each vertex is written once, after all of it that is needed has been read, so outputs may be the inputs;
 * and its bits do not depend on its group, block or run. No byte after the last vertex is read or written.
 *
 *     block      SKIN_BLOCK or SKIN_LONG_BLOCK vertices; their influences are decoded together
 *     run        | w w w w w w w w w w w | 0 | w w w w | 0 0 | w w w     w: a weight is not 0; 0: copied as it is
 *     group      | G . . | G . . | G . . | p p                           F32XN_GROUP vertices = a register of columns
 *     part                                 p: fewer vertices than a group, read and written one by one
 *
 * `followed`: a vector is 12 bytes, and whole groups read 16 for each. So only vertices before another one may be in
 * a whole group; the last vertex of an array is always in a part. Packed groups load exactly their own floats.
 */
#include "lane/strict.h"

#include <nakawari/mat.h>
#include <nakawari/quat.h>

#include "batch/skin_sum.h"
#include "lane/influence.h"
#include "pack/columns.h"

/* Functions that stay apart, with the instruction set in their names. */
#define blend_run        NKW_JOIN_ISA(nkwi_skin_blend_run, NKW_ISA)
#define rigid_matrices   NKW_JOIN_ISA(nkwi_skin_rigid_matrices, NKW_ISA)
#define transform_stream NKW_JOIN_ISA(nkwi_skin_transform_stream, NKW_ISA)

typedef struct block {
    decoded_influences decoded;
    f32xN_columns matrix[SKIN_BLOCK / F32XN_GROUP];
    f32xN_column direction[SKIN_LONG_BLOCK / F32XN_GROUP]; /* M d, to be normalized */
} block;

/* ---- Vectors ---- */

NKW_ALWAYS_INLINE f32xN_vectors read(const unsigned char *in, size_t stride, int packed)
{
    return packed ? f32xN_read3_packed(in) : f32xN_read3(in, stride);
}

NKW_ALWAYS_INLINE void write(unsigned char *out, size_t stride, int packed, f32xN_column a)
{
    if (packed)
        f32xN_write3_packed(out, a);
    else
        f32xN_write3(out, stride, a);
}

/* What is computed of a vector; the last two are normalized when the block is finished. */
typedef enum kind { POINTS, DIVIDED_POINTS, DIRECTIONS, NORMALS, UNIT_DIRECTIONS, UNIT_NORMALS } kind;

NKW_ALWAYS_INLINE int is_unit(kind what)
{
    return what == UNIT_DIRECTIONS || what == UNIT_NORMALS;
}

NKW_ALWAYS_INLINE f32xN_column transformed(f32xN_columns m, kind what, f32xN_vectors v)
{
    switch (what) {
    case POINTS:
        return f32xN_transform_point(m, v);
    case DIVIDED_POINTS:
        return f32xN_transform_divided(m, v);
    case NORMALS:
    case UNIT_NORMALS:
        return f32xN_transform_normal(m, v);
    case DIRECTIONS:
    case UNIT_DIRECTIONS:
    default:
        return f32xN_transform_direction(m, v);
    }
}

/* The vectors of a group from s on; those to be normalized go to `later`. */
NKW_ALWAYS_INLINE void transform_group(f32xN_columns m, kind what, int packed, const skin_stream *s,
                                       f32xN_column *later)
{
    const f32xN_column r = transformed(m, what, read(s->in, s->in_stride, packed));
    if (is_unit(what))
        *later = r;
    else
        write(s->out, s->out_stride, packed, r);
}

/* The first n vectors of a group. Reads nothing else. */
static void transform_part(const f32xN_columns *m, kind what, size_t n, const skin_stream *s, f32xN_column *later)
{
    const f32xN_column r = transformed(*m, what, f32xN_read3_first(s->in, s->in_stride, n));
    float out[4 * F32XN_GROUP];
    memcpy(out, &r, sizeof out);
    if (is_unit(what))
        *later = r;
    else
        for (size_t i = 0; i < n; i++)
            memcpy(s->out + i * s->out_stride, out + 4 * i, sizeof(nkw_vec3));
}

NKW_ALWAYS_INLINE skin_stream stream_at(const skin_stream *s, size_t i)
{
    skin_stream r = *s;
    if (r.in)
        r.in += i * r.in_stride, r.out += i * r.out_stride;
    return r;
}

/* To the next group. */
NKW_ALWAYS_INLINE void advance(skin_stream *s, int packed)
{
    s->in += F32XN_GROUP * (packed ? sizeof(nkw_vec3) : s->in_stride);
    s->out += F32XN_GROUP * (packed ? sizeof(nkw_vec3) : s->out_stride);
}

NKW_ALWAYS_INLINE int is_packed(const skin_stream *s)
{
    return !s->in || (s->in_stride == sizeof(nkw_vec3) && s->out_stride == sizeof(nkw_vec3));
}

/* Registers of F32XN vectors. */
#define SKIN_REGISTERS 4

/*
 * n / |n| of F32XN vectors, four floats of each; 0 where |n| = 0. Transposed squares are x^2, y^2, z^2 of four vectors
 * in the same elements, so one root and one division serve four vectors; element i of k is the factor of vector i.
 */
NKW_ALWAYS_INLINE void normalize(f32xN n[SKIN_REGISTERS])
{
    f32xN s[SKIN_REGISTERS];
    for (int i = 0; i < SKIN_REGISTERS; i++)
        s[i] = n[i] * n[i];
    f32xN_transpose(s);
    const f32xN k = f32xN_inverse_length((s[0] + s[1]) + s[2]);
    n[0] = n[0] * f32xN_broadcast(k, 0);
    n[1] = n[1] * f32xN_broadcast(k, 1);
    n[2] = n[2] * f32xN_broadcast(k, 2);
    n[3] = n[3] * f32xN_broadcast(k, 3);
}

/*
 * Normalizes and writes n directions, in groups as transform_group leaves them: 4 floats for each, of which the fourth
 * is not used. The floats behind them, up to the 4 F32XN of a step, are set to 0: they may be signalling numbers.
 */
NKW_ALWAYS_INLINE void write_unit_directions(f32xN_column *direction, int packed, const skin_stream *stream, size_t n)
{
    skin_stream s = *stream;
    float *d = (float *)(void *)direction;
    memset(d + 4 * n, 0, (SKIN_LONG_BLOCK - n) * 4 % (4 * F32XN) * sizeof *d);
    for (size_t i = 0; i < n; i += F32XN) {
        f32xN v[SKIN_REGISTERS];
        memcpy(v, d + 4 * i, sizeof v);
        normalize(v);
        memcpy(d + 4 * i, v, sizeof v);
    }
    size_t i = 0;
    for (; i + F32XN_GROUP <= n; i += F32XN_GROUP) {
        write(s.out, s.out_stride, packed, direction[i / F32XN_GROUP]);
        s.out += F32XN_GROUP * s.out_stride;
    }
    for (; i < n; i++, s.out += s.out_stride)
        memcpy(s.out, d + 4 * i, sizeof(nkw_vec3));
}

static void finish_directions(block *b, const skin_stream *s, size_t n)
{
    if (F32XN_GROUP > 1 && is_packed(s))
        write_unit_directions(b->direction, 1, s, n);
    else
        write_unit_directions(b->direction, 0, s, n);
}

/* ---- A run: vertices one after the other of which each has a weight ---- */

/*
 * The matrices of a group, of `width` 16 or 9. Where it has fewer vertices the last one takes the places of the others.
 */
NKW_ALWAYS_INLINE f32xN_columns blend_group(const influences *f, size_t width, size_t k, size_t last)
{
    f32xN m[F32XN_GROUP * (PARTS(16) > PARTS(9) ? PARTS(16) : PARTS(9))];
    for (size_t g = 0; g < F32XN_GROUP; g++)
        weighted_sum(f, width, k, g < last ? g : last, m + g * PARTS(width));
    return width == 16 ? f32xN_columns_of(m) : f32xN_columns_of3(m);
}

/*
 * Whether the first weights of a group are neither 0 nor subnormal, as most are. Half of their bits tell; compilers
 * would take the float for the sum from the whole of them, which is slower than to load it again.
 */
NKW_ALWAYS_INLINE int are_usual(const influences *f)
{
    const uint16_t order = 1;
    uint16_t high;
    for (size_t g = 0; g < F32XN_GROUP; g++) {
        memcpy(&high, f->weights + g * f->weight_stride + (*(const unsigned char *)&order ? 2 : 0), sizeof high);
        if (!NKW_LIKELY(high & 0x7f80))
            return 0;
    }
    return 1;
}

/* What the matrices of a run are for. Another vertex follows the first `followed`. */
typedef struct task {
    skin_stream points, directions;
    int normalized, stored; /* directions to be normalized; matrices to be stored in the block */
    size_t width, followed;
} task;

/*
 * Groups from vertex i on, before vertex n, while first weights are usual. Returns their end. width, k and packed are
 * constants here, and the task's members are copied to locals, so each combination is a loop without tests of them.
 */
NKW_ALWAYS_INLINE size_t blend_groups(const influences *from, size_t width, size_t k, const task *t, int packed,
                                      size_t i, size_t n, block *b)
{
    influences f = influences_at(from, i);
    skin_stream p = stream_at(&t->points, i), d = stream_at(&t->directions, i);
    const int has_points = p.in != NULL, has_directions = d.in != NULL, stored = t->stored, normalized = t->normalized;
    f32xN_columns *matrix = b->matrix + (stored ? i / F32XN_GROUP : 0);
    f32xN_column *later = b->direction + i / F32XN_GROUP;
    for (; i + F32XN_GROUP <= n && are_usual(&f); i += F32XN_GROUP) {
        const f32xN_columns m = blend_group(&f, width, k, F32XN_GROUP - 1);
        if (stored)
            *matrix++ = m;
        if (has_points) {
            transform_group(m, POINTS, packed, &p, NULL);
            advance(&p, packed);
        }
        if (has_directions) {
            if (normalized)
                transform_group(m, UNIT_DIRECTIONS, packed, &d, later++);
            else
                transform_group(m, DIRECTIONS, packed, &d, NULL);
            advance(&d, packed);
        }
        f.offset += F32XN_GROUP * k, f.weights += F32XN_GROUP * f.weight_stride;
    }
    return i;
}

/*
 * The n vertices from i on, at most a group, whatever their weights. Returns how many of them belong to the run. Reads
 * no further than their vectors.
 */
NKW_NOINLINE static size_t blend_part(const influences *from, const task *t, size_t i, size_t n, block *b)
{
    const influences f = influences_at(from, i);
    const skin_stream p = stream_at(&t->points, i), d = stream_at(&t->directions, i);
    const size_t weighted = count_weighted(&f, n);
    f32xN_columns m;
    if (weighted == 0)
        return 0;
    m = t->width == 16 ? blend_group(&f, 16, f.k, weighted - 1) : blend_group(&f, 9, f.k, weighted - 1);
    if (t->stored)
        b->matrix[i / F32XN_GROUP] = m;
    if (p.in)
        transform_part(&m, POINTS, weighted, &p, NULL);
    if (d.in)
        transform_part(&m, t->normalized ? UNIT_DIRECTIONS : DIRECTIONS, weighted, &d, b->direction + i / F32XN_GROUP);
    return weighted;
}

/*
 * Returns the number of vertices of the run, at most n. Whole groups with usual weights alternate with parts: a group
 * whose first weight is 0 or subnormal is a part of the full size, after which whole groups go on; a smaller part ends
 * the run.
 */
NKW_ALWAYS_INLINE size_t blend_run_of(const influences *f, size_t width, size_t k, const task *t, int packed, size_t n,
                                      block *b)
{
    const size_t followed = packed ? n : t->followed;
    for (size_t i = 0, part;; i += part) {
        i = blend_groups(f, width, k, t, packed, i, followed, b);
        part = i < n ? blend_part(f, t, i, n - i < F32XN_GROUP ? n - i : F32XN_GROUP, b) : 0;
        if (part < F32XN_GROUP)
            return i + part;
    }
}

NKW_ALWAYS_INLINE size_t blend_run_by_stride(const influences *f, size_t width, size_t k, const task *t, size_t n,
                                             block *b)
{
    if (F32XN_GROUP > 1 && is_packed(&t->points) && is_packed(&t->directions))
        return blend_run_of(f, width, k, t, 1, n, b);
    return blend_run_of(f, width, k, t, 0, n, b);
}

NKW_NOINLINE static size_t blend_run(const influences *f, const task *t, size_t n, block *b)
{
    if (t->width == 9)
        return f->k == 4 ? blend_run_by_stride(f, 9, 4, t, n, b) : blend_run_by_stride(f, 9, f->k, t, n, b);
    return f->k == 4   ? blend_run_by_stride(f, 16, 4, t, n, b)
           : f->k == 1 ? blend_run_by_stride(f, 16, 1, t, n, b)
           : f->k == 2 ? blend_run_by_stride(f, 16, 2, t, n, b)
                       : blend_run_by_stride(f, 16, f->k, t, n, b);
}

NKW_ALWAYS_INLINE void transform_by_matrices(block *b, kind what, const skin_stream *stream, size_t followed, size_t n)
{
    size_t i = 0;
    skin_stream s = *stream;
    for (; i + F32XN_GROUP <= followed; i += F32XN_GROUP, advance(&s, 0))
        transform_group(b->matrix[i / F32XN_GROUP], what, 0, &s, b->direction + i / F32XN_GROUP);
    for (size_t part; i < n; i += part, advance(&s, 0)) {
        part = n - i < F32XN_GROUP ? n - i : F32XN_GROUP;
        transform_part(b->matrix + i / F32XN_GROUP, what, part, &s, b->direction + i / F32XN_GROUP);
    }
    if (is_unit(what))
        finish_directions(b, stream, n);
}

static kind kind_of(const skin_job *job, size_t s)
{
    if (s == SKIN_POSITIONS)
        return job->options.divide_by_weights ? DIVIDED_POINTS : POINTS;
    if (s == SKIN_NORMALS && job->options.inverse_normals)
        return job->options.keep_length ? NORMALS : UNIT_NORMALS;
    return job->options.keep_length ? DIRECTIONS : UNIT_DIRECTIONS;
}

/* Stream s of n vertices from `from` on, by the matrices of the block. */
NKW_NOINLINE static void transform_stream(const skin_job *job, size_t s, size_t from, size_t followed, size_t n,
                                          block *b)
{
    const skin_stream stream = stream_at(&job->streams[s], from);
    if (!stream.in)
        return;
    switch (kind_of(job, s)) {
    case POINTS:
        transform_by_matrices(b, POINTS, &stream, followed, n);
        break;
    case DIVIDED_POINTS:
        transform_by_matrices(b, DIVIDED_POINTS, &stream, followed, n);
        break;
    case DIRECTIONS:
        transform_by_matrices(b, DIRECTIONS, &stream, followed, n);
        break;
    case NORMALS:
        transform_by_matrices(b, NORMALS, &stream, followed, n);
        break;
    case UNIT_DIRECTIONS:
        transform_by_matrices(b, UNIT_DIRECTIONS, &stream, followed, n);
        break;
    case UNIT_NORMALS:
        transform_by_matrices(b, UNIT_NORMALS, &stream, followed, n);
    }
}

/* ---- Dual quaternions ---- */

/*
 * The four floats of column c of vertex i, and those of i + F32XN_GROUP after 16 F32XN_GROUP floats. Groups of two:
 *
 *     b->matrix    | x0 x1 | y0 y1 | z0 z1 | t0 t1 | x2 x3 | y2 y3 | ...      4 floats each
 */
NKW_ALWAYS_INLINE float *column_of(block *b, size_t i, size_t c)
{
    float *first = (float *)(void *)b->matrix;
    return first + 16 * (i - i % F32XN_GROUP) + 4 * (c * F32XN_GROUP + i % F32XN_GROUP);
}

/*
 * The weights of a vertex, negated for joints on the other half sphere than that of the largest, first of equals. q
 * and -q are the same rotation: a sum of both signs would cancel, or go the long way round.
 */
NKW_ALWAYS_INLINE void align_weights(const influences *f, size_t k, size_t i, float *out)
{
    const uint32_t *offset = f->offset + i * k;
    const unsigned char *weights = f->weights + i * f->weight_stride;
    nkw_quat pivot, q;
    size_t largest = 0;
    float most = load_float(weights);
    for (size_t e = 1; e < k; e++) {
        const float w = load_float(weights + e * sizeof w);
        largest = w > most ? e : largest;
        most = w > most ? w : most;
    }
    memcpy(&pivot, entry_at(f->palette, 8, offset[largest]), sizeof pivot);
    for (size_t e = 0; e < k; e++) {
        const float w = load_float(weights + e * sizeof w);
        memcpy(&q, entry_at(f->palette, 8, offset[e]), sizeof q);
        out[e] = nkw_quat_dot(pivot, q) < 0.0f ? -w : w;
    }
}

/* n dual quaternions to the first three rows of matrices, in component arrays, column by column. */
NKW_NOINLINE static void rigid_matrices(float d[8][SKIN_BLOCK], float m[12][SKIN_BLOCK], size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_quat real = {d[0][i], d[1][i], d[2][i], d[3][i]}, dual = {d[4][i], d[5][i], d[6][i], d[7][i]};
        float n2 = nkw_quat_dot(real, real);
        nkw_quat r = lane_skin_rotation(real, n2);
        nkw_mat3 rotation = nkw_mat3_from_quat(r);
        nkw_vec3 translation = lane_skin_translation(r, dual, n2);
        for (size_t e = 0; e < 9; e++)
            m[e][i] = rotation.m[e];
        m[9][i] = translation.x;
        m[10][i] = translation.y;
        m[11][i] = translation.z;
    }
}

/*
 * The n dual quaternions at every 16 floats of b->matrix become matrices, by way of component arrays. n % 4 is 0.
 *
 *     b->matrix    | real x y z w, dual x y z w, 8 floats not used | of the next vertex ...
 *     d[8][n]      real x of all, y of all, ... dual w of all               transposed, four vertices at a time
 *     m[12][n]     columns x y z of three rows, then t                      rigid_matrices
 *     b->matrix    columns as column_of has them                            transposed back
 */
static void matrices_from_dual_quats(size_t n, block *b)
{
    float d[8][SKIN_BLOCK], m[12][SKIN_BLOCK], *dual = (float *)(void *)b->matrix;
    for (size_t i = 0; i < n; i += 4, dual += 64)
        for (size_t c = 0; c < 8; c += 4) {
            const float *const from[4] = {dual + c, dual + 16 + c, dual + 32 + c, dual + 48 + c};
            float *const to[4] = {d[c] + i, d[c + 1] + i, d[c + 2] + i, d[c + 3] + i};
            f32x4_transpose_rows(from, to);
        }
    rigid_matrices(d, m, n);
    for (size_t i = 0; i < n; i += 4)
        for (size_t c = 0; c < 4; c++) {
            const float *const from[4] = {m[3 * c] + i, m[3 * c + 1] + i, m[3 * c + 2] + i, m[3 * c] + i};
            float *const to[4] = {column_of(b, i, c), column_of(b, i + 1, c), column_of(b, i + 2, c),
                                  column_of(b, i + 3, c)};
            f32x4_transpose_rows(from, to);
        }
}

/* The sum of dual quaternion entries of vertex i. */
NKW_ALWAYS_INLINE void sum_dual_quat(const influences *f, size_t k, size_t i, float out[8])
{
    f32xN sum[PARTS(8)];
    float weight[NKW_SKIN_INFLUENCES] = {0.0f};
    influences aligned = influences_at(f, i);
    align_weights(f, k, i, weight);
    aligned.weights = (const unsigned char *)weight;
    weighted_sum(&aligned, 8, k, 0, sum);
    for (size_t a = 0; a < PARTS(8); a++)
        store_part(out, 8, a, sum[a]);
}

NKW_ALWAYS_INLINE void blend_dual_quats_of(const influences *f, size_t k, size_t n, block *b)
{
    float *dual = (float *)(void *)b->matrix;
    const size_t padded = (n + 3) / 4 * 4;
    for (size_t i = 0; i < n; i++)
        sum_dual_quat(f, k, i, dual + 16 * i);
    memset(dual + 16 * n, 0, (padded - n) * 16 * sizeof *dual);
    matrices_from_dual_quats(padded, b);
}

NKW_NOINLINE static void blend_dual_quats(const influences *f, size_t n, block *b)
{
    if (f->k == 4)
        blend_dual_quats_of(f, 4, n, b);
    else
        blend_dual_quats_of(f, f->k, n, b);
}

/* ---- The two methods ---- */

/* Whether linear blend stores the matrices, and transforms stream s by the stored ones. */
static int is_by_stored(const skin_job *job, size_t s)
{
    if (!job->streams[s].in)
        return 0;
    return s == SKIN_POSITIONS ? job->options.divide_by_weights : s == SKIN_NORMALS ? job->options.inverse_normals : 1;
}

static int stores_matrices(const skin_job *job)
{
    int any = 0;
    for (size_t s = 0; s < SKIN_STREAMS; s++)
        any |= is_by_stored(job, s);
    return any;
}

/*
 * Both methods transform a run: of the n vertices from `from` on the first ones; they return how many. Another vertex
 * follows the first `followed`.
 */
static size_t linear_run(const skin_job *job, const influences *f, size_t from, size_t followed, size_t n, block *b)
{
    const skin_stream none = {NULL, NULL, 0, 0}, normals = stream_at(&job->streams[SKIN_NORMALS], from);
    const skin_stream points = stream_at(&job->streams[SKIN_POSITIONS], from);
    const int normalized = !job->options.keep_length && normals.in;
    const int apart = job->normals || is_by_stored(job, SKIN_NORMALS);
    task t = {is_by_stored(job, SKIN_POSITIONS) ? none : points,
              apart ? none : normals,
              normalized && !apart,
              stores_matrices(job),
              16,
              followed};
    const size_t run = blend_run(f, &t, n, b);
    if (t.normalized)
        finish_directions(b, &normals, run);
    t.followed = followed < run ? followed : run;
    for (size_t s = 0; t.stored && s < SKIN_STREAMS; s++)
        if (is_by_stored(job, s))
            transform_stream(job, s, from, t.followed, run, b);
    if (job->normals && normals.in) {
        influences by_normals = *f;
        by_normals.palette = job->normals;
        t.points = none, t.directions = normals, t.normalized = normalized, t.stored = 0, t.width = 9;
        blend_run(&by_normals, &t, run, b);
        if (normalized)
            finish_directions(b, &normals, run);
    }
    return run;
}

static size_t dual_quat_run(const skin_job *job, const influences *f, size_t from, size_t followed, size_t n, block *b)
{
    const size_t run = count_weighted(f, n);
    blend_dual_quats(f, run, b);
    for (size_t s = 0; s < SKIN_STREAMS; s++)
        transform_stream(job, s, from, followed < run ? followed : run, run, b);
    return run;
}

static void copy_vertices(const skin_job *job, size_t from, size_t n)
{
    for (size_t v = 0; v < SKIN_STREAMS; v++) {
        const skin_stream s = stream_at(&job->streams[v], from);
        for (size_t i = 0; s.in && i < n; i++)
            memmove(s.out + i * s.out_stride, s.in + i * s.in_stride, sizeof(nkw_vec3));
    }
}

/*
 * The n vertices of a block: runs, and between them vertices without weights, one by one. `inside` is what is followed
 * of the vertices from i on.
 */
NKW_ALWAYS_INLINE void transform_block(const skin_job *job, int dual, const influences *all, size_t from,
                                       size_t followed, size_t n, block *b)
{
    for (size_t i = 0; i < n; i++) {
        const influences f = influences_at(all, i);
        const size_t inside = followed > i ? followed - i : 0;
        i +=
            dual ? dual_quat_run(job, &f, from + i, inside, n - i, b) : linear_run(job, &f, from + i, inside, n - i, b);
        if (i < n)
            copy_vertices(job, from + i, 1);
    }
}

/* Vectors of four floats can be read where another one follows, unless their stride is less than a float. */
static int may_read_fours(const skin_job *job)
{
    for (size_t s = 0; s < SKIN_STREAMS; s++)
        if (job->streams[s].in && job->streams[s].in_stride < sizeof(float))
            return 0;
    return 1;
}

NKW_ALWAYS_INLINE void transform_blocks(const skin_job *job, int dual)
{
    const int is_long = !dual && job->influence_count <= 4 && !stores_matrices(job), fours = may_read_fours(job);
    const size_t count = job->vertex_count, size = is_long ? SKIN_LONG_BLOCK : SKIN_BLOCK;
    block b;
    if (job->influence_count == 0)
        copy_vertices(job, 0, count);
    for (size_t from = 0; job->influence_count > 0 && from < count; from += size) {
        const size_t n = count - from < size ? count - from : size, followed = fours ? n - (n == count - from) : 0;
        const influences f = decode(job, from, n, &b.decoded);
        transform_block(job, dual, &f, from, followed, n, &b);
    }
}

NKW_LOOP(nkwi_skin_linear)(const skin_job *job)
{
    transform_blocks(job, 0);
}

NKW_LOOP(nkwi_skin_dual_quat)(const skin_job *job)
{
    transform_blocks(job, 1);
}
