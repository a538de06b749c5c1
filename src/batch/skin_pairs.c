/* SPDX-License-Identifier: MIT */
/*
 * Linear blend skinning of positions and normals as they lie in vertex buffers, in one pass: the matrix of each vertex
 * is blended in columns of four floats, and takes both vectors while it is in registers. Vertices go by fours, so that
 * four normals are made unit together.
 */
#include "lane/strict.h"

#include <nakawari/skin.h>

#include "batch/table.h"
#include "lane/four.h"
#include "lane/skin.h"

typedef struct columns {
    lane_four x, y, z, t;
} columns;

static inline float weight_at(const unsigned char *w, size_t e)
{
    return lane_skin_weight(w + 4 * e, NKW_SKIN_F32);
}

static inline const float *matrix_at(const nkw_mat4 *palette, const unsigned char *joint, nkw_skin_format format,
                                     size_t e)
{
    return palette[lane_skin_joint(joint + e * lane_skin_format_size(format), format)].m;
}

#if defined(LANE_FOUR_SPLIT)

static inline columns blend(const nkw_mat4 *palette, const unsigned char *w, const unsigned char *joint,
                            nkw_skin_format format, size_t k)
{
    lane_wide m[LANE_WIDE_PARTS];
    const float *from = matrix_at(palette, joint, format, 0);
    for (size_t a = 0; a < LANE_WIDE_PARTS; a++)
        m[a] = lane_wide_load(from + a * LANE_WIDE) * weight_at(w, 0);
    for (size_t e = 1; e < k; e++) {
        from = matrix_at(palette, joint, format, e);
        for (size_t a = 0; a < LANE_WIDE_PARTS; a++)
            m[a] += lane_wide_load(from + a * LANE_WIDE) * weight_at(w, e);
    }
    columns r = LANE_FOUR_SPLIT(m);
    return r;
}

#else

static inline lane_four scaled(const float *column, lane_four w)
{
    return lane_four_mul(lane_four_load(column), w);
}

static inline columns blend(const nkw_mat4 *palette, const unsigned char *w, const unsigned char *joint,
                            nkw_skin_format format, size_t k)
{
    const float *m = matrix_at(palette, joint, format, 0);
    lane_four we = lane_four_all_of(w);
    columns r = {scaled(m, we), scaled(m + 4, we), scaled(m + 8, we), scaled(m + 12, we)};
    for (size_t e = 1; e < k; e++) {
        m = matrix_at(palette, joint, format, e);
        we = lane_four_all_of(w + 4 * e);
        r.x = lane_four_add(r.x, scaled(m, we));
        r.y = lane_four_add(r.y, scaled(m + 4, we));
        r.z = lane_four_add(r.z, scaled(m + 8, we));
        r.t = lane_four_add(r.t, scaled(m + 12, we));
    }
    return r;
}

#endif

/* As nkw_mat4_transform_point. */
static inline lane_four point(const columns *m, const unsigned char *at)
{
    lane_four x = lane_four_mul(m->x, lane_four_all_of(at)), y = lane_four_mul(m->y, lane_four_all_of(at + 4));
    lane_four z = lane_four_mul(m->z, lane_four_all_of(at + 8));
    return lane_four_add(lane_four_add(x, y), lane_four_add(z, m->t));
}

/* As nkw_mat4_transform_direction. */
static inline lane_four direction(const columns *m, const unsigned char *at)
{
    lane_four x = lane_four_mul(m->x, lane_four_all_of(at)), y = lane_four_mul(m->y, lane_four_all_of(at + 4));
    lane_four z = lane_four_mul(m->z, lane_four_all_of(at + 8));
    return lane_four_add(lane_four_add(x, y), z);
}

/* n / |n| of four; zero stays zero: as lane_skin_unit. */
static inline void make_unit(lane_four n[4])
{
    lane_four s[4];
    for (int v = 0; v < 4; v++)
        s[v] = lane_four_mul(n[v], n[v]);
    lane_four_transpose(s);
    lane_four n2 = lane_four_add(lane_four_add(s[0], s[1]), s[2]);
    lane_four k = lane_four_unless_zero(n2, lane_four_div(lane_four_all(1.0f), lane_four_sqrt(n2)));
    n[0] = lane_four_mul(n[0], lane_four_splat(k, 0));
    n[1] = lane_four_mul(n[1], lane_four_splat(k, 1));
    n[2] = lane_four_mul(n[2], lane_four_splat(k, 2));
    n[3] = lane_four_mul(n[3], lane_four_splat(k, 3));
}

/* A vertex whose joints are all in the palette, and of a weight that is not 0. */
static inline int is_usual(const unsigned char *w, const unsigned char *joint, nkw_skin_format format, uint32_t limit,
                           size_t k)
{
    uint32_t any = 0;
    for (size_t e = 0; e < k; e++) {
        if (lane_skin_joint(joint + e * lane_skin_format_size(format), format) >= limit)
            return 0;
        any |= lane_bits(weight_at(w, e));
    }
    return any << 1 != 0;
}

/* Where the influences and the vectors of a vertex are, and the steps to those of the next. */
typedef struct place {
    const unsigned char *weight, *joint, *p_in, *d_in;
    unsigned char *p_out, *d_out;
} place;

/* Nothing is added to the addresses of what is not there. */
static inline place place_of(const skin_influences *f, const skin_stream *p, const skin_stream *d, size_t i)
{
    place r = {NULL, NULL, NULL, NULL, NULL, NULL};
    if (f->count) {
        r.weight = (const unsigned char *)f->weights.data + i * f->weights.stride;
        r.joint = (const unsigned char *)f->joints.data + i * f->joints.stride;
    }
    if (p->in_stride) {
        r.p_in = p->in + i * p->in_stride;
        r.p_out = p->out + i * p->out_stride;
    }
    if (d->in_stride) {
        r.d_in = d->in + i * d->in_stride;
        r.d_out = d->out + i * d->out_stride;
    }
    return r;
}

/* How many vertices of n, at most a block, are usual before one that is not. */
static inline size_t count_usual(const skin_influences *f, place at, nkw_skin_format format, size_t k, size_t n)
{
    const size_t weight_stride = f->weights.stride, joint_stride = f->joints.stride;
    const uint32_t limit = f->limit;
    size_t i = 0;
    n = n < SKIN_BLOCK ? n : SKIN_BLOCK;
    while (i < n && is_usual(at.weight, at.joint, format, limit, k))
        i++, at.weight += weight_stride, at.joint += joint_stride;
    return i;
}

/* Writes the position of the next vertex, and gives its direction, as blended. */
static inline lane_four move_next(const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p,
                                  const skin_stream *d, place *at, nkw_skin_format format, size_t k)
{
    columns m = blend(palette, at->weight, at->joint, format, k);
    lane_four r = m.x;
    at->weight += f->weights.stride;
    at->joint += f->joints.stride;
    if (p->in_stride) {
        lane_four_store3(at->p_out, point(&m, at->p_in));
        at->p_in += p->in_stride;
        at->p_out += p->out_stride;
    }
    if (d->in_stride) {
        r = direction(&m, at->d_in);
        at->d_in += d->in_stride;
    }
    return r;
}

static inline void put_direction(const skin_stream *d, place *at, lane_four r)
{
    lane_four_store3(at->d_out, r);
    at->d_out += d->out_stride;
}

/* Moves four vertices. */
static inline void move_four(const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p,
                             const skin_stream *d, int raw, place *at, nkw_skin_format format, size_t k)
{
    lane_four four[4];
    four[0] = move_next(f, palette, p, d, at, format, k);
    four[1] = move_next(f, palette, p, d, at, format, k);
    four[2] = move_next(f, palette, p, d, at, format, k);
    four[3] = move_next(f, palette, p, d, at, format, k);
    if (!d->in_stride)
        return;
    if (!raw)
        make_unit(four);
    put_direction(d, at, four[0]);
    put_direction(d, at, four[1]);
    put_direction(d, at, four[2]);
    put_direction(d, at, four[3]);
}

/* Moves vertices from i on, by fours, up to those that are not usual: gives the number of the next. */
static inline size_t move_usual(const skin_influences *of, size_t k, nkw_skin_format format, const nkw_mat4 *palette,
                                const skin_stream *position, const skin_stream *dir, int raw, size_t i, size_t n)
{
    const skin_influences f = *of;
    const skin_stream p = *position, d = *dir;
    place at = place_of(&f, &p, &d, i);
    size_t usual = 4;
    while (usual >= 4) {
        usual = count_usual(&f, at, format, k, n - i);
        for (size_t e = 4; e <= usual; e += 4, i += 4)
            move_four(&f, palette, &p, &d, raw, &at, format, k);
    }
    return i;
}

/* Any vertex: gives the number of the next. */
static inline size_t move_one(const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p,
                              const skin_stream *d, int raw, size_t i)
{
    float w[NKW_SKIN_INFLUENCES];
    uint32_t joint[NKW_SKIN_INFLUENCES], any = 0;
    size_t size = lane_skin_format_size(f->joints.format);
    place at = place_of(f, p, d, i);
    for (size_t e = 0; e < f->count; e++) {
        uint32_t j = lane_skin_joint(at.joint + e * size, f->joints.format);
        w[e] = j < f->limit ? weight_at(at.weight, e) : 0.0f;
        joint[e] = j < f->limit ? j : 0;
        any |= lane_bits(w[e]) << 1;
    }
    if (any) {
        at.weight = (const unsigned char *)w;
        at.joint = (const unsigned char *)joint;
        lane_four r = move_next(f, palette, p, d, &at, NKW_SKIN_U32, f->count), four[4] = {r, r, r, r};
        if (!raw)
            make_unit(four);
        if (d->in_stride)
            put_direction(d, &at, four[0]);
        return i + 1;
    }
    if (p->in_stride)
        memmove(at.p_out, at.p_in, sizeof(nkw_vec3));
    if (d->in_stride)
        memmove(at.d_out, at.d_in, sizeof(nkw_vec3));
    return i + 1;
}

/* The usual counts and formats as constants. */
static inline size_t move_by_format(const skin_influences *f, size_t k, const nkw_mat4 *palette, const skin_stream *p,
                                    const skin_stream *d, int raw, size_t i, size_t n)
{
    if (f->joints.format == NKW_SKIN_U8)
        return move_usual(f, k, NKW_SKIN_U8, palette, p, d, raw, i, n);
    if (f->joints.format == NKW_SKIN_U16)
        return move_usual(f, k, NKW_SKIN_U16, palette, p, d, raw, i, n);
    return move_usual(f, k, NKW_SKIN_U32, palette, p, d, raw, i, n);
}

static inline size_t move_by_count(const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p,
                                   const skin_stream *d, int raw, size_t i, size_t n)
{
    if (f->count == 4)
        return move_by_format(f, 4, palette, p, d, raw, i, n);
    if (f->count == 1)
        return move_by_format(f, 1, palette, p, d, raw, i, n);
    if (f->count == 2)
        return move_by_format(f, 2, palette, p, d, raw, i, n);
    return move_by_format(f, f->count, palette, p, d, raw, i, n);
}

KERNEL(skin_pairs)
(const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p, const skin_stream *d, int raw, size_t n)
{
    for (size_t i = 0; i < n;) {
        if (f->count)
            i = move_by_count(f, palette, p, d, raw, i, n);
        if (i < n)
            i = move_one(f, palette, p, d, raw, i);
    }
}
