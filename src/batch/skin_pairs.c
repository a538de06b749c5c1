/* SPDX-License-Identifier: MIT */
/*
 * Linear blend skinning of positions and normals as they lie in vertex buffers, in one pass: the matrix of each vertex
 * is blended in columns of four floats, and takes both vectors while it is in registers.
 */
#include "lane/strict.h"

#include <nakawari/skin.h>

#include "batch/table.h"
#include "lane/four.h"
#include "lane/skin.h"

/* Both vectors of a vertex. */
typedef struct pair {
    lane_four position, direction;
} pair;

#if defined(LANE_WIDE)

typedef struct columns {
    lane_wide m[LANE_WIDE_PARTS];
} columns;

/* The sum of w[e] m[e]. */
INLINE columns blend(const float *const *m, const unsigned char *w, size_t k)
{
    columns r;
    for (size_t a = 0; a < LANE_WIDE_PARTS; a++)
        r.m[a] = lane_wide_load(m[0] + a * LANE_WIDE) * lane_skin_weight(w, NKW_SKIN_F32);
    for (size_t e = 1; e < k; e++)
        for (size_t a = 0; a < LANE_WIDE_PARTS; a++)
            r.m[a] += lane_wide_load(m[e] + a * LANE_WIDE) * lane_skin_weight(w + 4 * e, NKW_SKIN_F32);
    return r;
}

/* Both vectors in one register. The direction's translation is -0, which changes no number. */
INLINE pair apply(const columns *c, lane_four position, lane_four direction)
{
    const lane_four none = {-0.0f, -0.0f, -0.0f, -0.0f};
    const lane_eight v = LANE_MIX(position, direction, 0, 1, 2, 3, 4, 5, 6, 7);
    lane_eight t = LANE_COLUMN_TWICE(c->m, 3);
    t = LANE_MIX(t, LANE_FOUR_TWICE(none, 0), 0, 1, 2, 3, 8, 9, 10, 11);
    lane_eight x = LANE_COLUMN_TWICE(c->m, 0) * lane_eight_splat(v, 0);
    lane_eight y = LANE_COLUMN_TWICE(c->m, 1) * lane_eight_splat(v, 1);
    lane_eight z = LANE_COLUMN_TWICE(c->m, 2) * lane_eight_splat(v, 2);
    lane_eight sum = (x + y) + (z + t);
    pair r = {LANE_MIX(sum, sum, 0, 1, 2, 3), LANE_MIX(sum, sum, 4, 5, 6, 7)};
    return r;
}

#else

typedef struct columns {
    lane_four m[4];
} columns;

/* The sum of w[e] m[e]. */
INLINE columns blend(const float *const *m, const unsigned char *w, size_t k)
{
    columns r;
    lane_four first = lane_four_all_of(w);
    for (size_t a = 0; a < 4; a++)
        r.m[a] = lane_four_mul(lane_four_load(m[0] + 4 * a), first);
    for (size_t e = 1; e < k; e++) {
        lane_four we = lane_four_all_of(w + 4 * e);
        for (size_t a = 0; a < 4; a++)
            r.m[a] = lane_four_add(r.m[a], lane_four_mul(lane_four_load(m[e] + 4 * a), we));
    }
    return r;
}

/* x v[0] + y v[1] */
INLINE lane_four in_plane(const columns *c, lane_four v)
{
    return lane_four_add(lane_four_mul(c->m[0], lane_four_splat(v, 0)), lane_four_mul(c->m[1], lane_four_splat(v, 1)));
}

/* As nkw_mat4_transform_point and nkw_mat4_transform_direction. */
INLINE pair apply(const columns *c, lane_four position, lane_four direction)
{
    lane_four pz = lane_four_mul(c->m[2], lane_four_splat(position, 2));
    lane_four dz = lane_four_mul(c->m[2], lane_four_splat(direction, 2));
    pair r;
    r.position = lane_four_add(in_plane(c, position), lane_four_add(pz, c->m[3]));
    r.direction = lane_four_add(in_plane(c, direction), dz);
    return r;
}

#endif

/* n / |n| of four; zero stays zero: as lane_skin_unit. */
INLINE void make_unit(lane_four n[4])
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

/* The matrices of a vertex: 0 if a joint is not in the palette. */
INLINE int find_matrices(const nkw_mat4 *palette, size_t limit, const unsigned char *joint, nkw_skin_format format,
                         size_t k, const float **m)
{
    for (size_t e = 0; e < k; e++) {
        size_t j = lane_skin_joint(joint + e * lane_skin_format_size(format), format);
        if (j >= limit)
            return 0;
        m[e] = palette[j].m;
    }
    return 1;
}

/*
 * A weight that is not 0 nor subnormal: for those, half of its bits say enough. No more are read, or the compiler would
 * make the floats of them, which takes longer than reading those as well.
 */
INLINE int has_weight(const unsigned char *w, size_t k)
{
    const uint16_t order = 1;
    uint16_t high;
    for (size_t e = 0; e < k; e++) {
        memcpy(&high, w + 4 * e + (*(const unsigned char *)&order ? 2 : 0), sizeof high);
        if (high & 0x7f80)
            return 1;
    }
    return 0;
}

/*
 * Moves up to n vertices, before the first one that has no such weight or a joint beyond the palette: gives how many.
 * Reads the four bytes after a vector too. Directions go to `four`, as blended, if it is not NULL.
 */
INLINE size_t move_usual(const skin_influences *f, size_t k, nkw_skin_format format, const nkw_mat4 *palette,
                         const skin_stream *position, const skin_stream *direction, lane_four *four, size_t n)
{
    const unsigned char *w = (const unsigned char *)f->weights.data, *joint = (const unsigned char *)f->joints.data;
    const size_t weight_stride = f->weights.stride, joint_stride = f->joints.stride, limit = f->limit;
    skin_stream p = *position, d = *direction;
    size_t i = 0;
    for (; i < n; i++) {
        const float *m[NKW_SKIN_INFLUENCES];
        if (!find_matrices(palette, limit, joint, format, k, m) || !has_weight(w, k))
            return i;
        columns c = blend(m, w, k);
        pair r = apply(&c, lane_four_load_bytes(p.in), lane_four_load_bytes(d.in));
        lane_four_store3(p.out, r.position);
        if (four)
            four[i] = r.direction;
        else
            lane_four_store3(d.out, r.direction);
        w += weight_stride, joint += joint_stride;
        p.in += p.in_stride, p.out += p.out_stride;
        d.in += d.in_stride, d.out += d.out_stride;
    }
    return i;
}

/* The usual counts and the formats as constants. */
INLINE size_t move_by_format(const skin_influences *f, size_t k, const nkw_mat4 *palette, const skin_stream *p,
                             const skin_stream *d, lane_four *four, size_t n)
{
    if (f->joints.format == NKW_SKIN_U8)
        return move_usual(f, k, NKW_SKIN_U8, palette, p, d, four, n);
    if (f->joints.format == NKW_SKIN_U16)
        return move_usual(f, k, NKW_SKIN_U16, palette, p, d, four, n);
    return move_usual(f, k, NKW_SKIN_U32, palette, p, d, four, n);
}

INLINE size_t move_by_count(const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p,
                            const skin_stream *d, lane_four *four, size_t n)
{
    if (f->count == 4)
        return move_by_format(f, 4, palette, p, d, four, n);
    if (f->count == 2)
        return move_by_format(f, 2, palette, p, d, four, n);
    if (f->count == 1)
        return move_by_format(f, 1, palette, p, d, four, n);
    return move_by_format(f, f->count, palette, p, d, four, n);
}

static inline size_t move_block(const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p,
                                const skin_stream *d, int raw, size_t n)
{
    lane_four four[SKIN_BLOCK + 3];
    size_t moved;
    if (raw)
        return move_by_count(f, palette, p, d, NULL, n);
    moved = move_by_count(f, palette, p, d, four, n);
    if (!d->out_stride)
        return moved;
    for (size_t i = moved; i % 4; i++)
        four[i] = lane_four_all(0.0f);
    for (size_t i = 0; i < moved; i += 4) {
        lane_four n4[4] = {four[i], four[i + 1], four[i + 2], four[i + 3]};
        make_unit(n4);
        for (size_t v = 0; v < 4 && i + v < moved; v++)
            lane_four_store3(d->out + (i + v) * d->out_stride, n4[v]);
    }
    return moved;
}

/* One vertex of any weights and joints, read no further than its vectors go. */
static inline void move_alone(const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p,
                              const skin_stream *d, int raw)
{
    const unsigned char *w = (const unsigned char *)f->weights.data, *joint = (const unsigned char *)f->joints.data;
    const float *m[NKW_SKIN_INFLUENCES];
    float weight[NKW_SKIN_INFLUENCES], v[2][4] = {{0.0f}, {0.0f}};
    uint32_t any = 0;
    memcpy(v[0], p->in, sizeof(nkw_vec3));
    memcpy(v[1], d->in, sizeof(nkw_vec3));
    for (size_t e = 0; e < f->count; e++) {
        uint32_t j = lane_skin_joint(joint + e * lane_skin_format_size(f->joints.format), f->joints.format);
        weight[e] = j < f->limit ? lane_skin_weight(w + 4 * e, NKW_SKIN_F32) : 0.0f;
        m[e] = palette[j < f->limit ? j : 0].m;
        any |= lane_bits(weight[e]);
    }
    if (any << 1 == 0) {
        memcpy(p->out, v[0], sizeof(nkw_vec3));
        memcpy(d->out, v[1], sizeof(nkw_vec3));
        return;
    }
    columns c = blend(m, (const unsigned char *)weight, f->count);
    pair r = apply(&c, lane_four_load(v[0]), lane_four_load(v[1]));
    lane_four four[4] = {r.direction, r.direction, r.direction, r.direction};
    if (!raw)
        make_unit(four);
    lane_four_store3(p->out, r.position);
    lane_four_store3(d->out, four[0]);
}

static inline skin_influences influences_at(const skin_influences *f, size_t i)
{
    skin_influences r = *f;
    r.joints.data = (const unsigned char *)f->joints.data + i * f->joints.stride;
    r.weights.data = (const unsigned char *)f->weights.data + i * f->weights.stride;
    return r;
}

static inline skin_stream stream_at(const skin_stream *s, size_t i)
{
    skin_stream r = {s->in + i * s->in_stride, s->out + i * s->out_stride, s->in_stride, s->out_stride};
    return r;
}

/* A stream that is not there is read from and written to one place. */
static inline skin_stream stream_or(const skin_stream *s, const float *from, float *to)
{
    skin_stream none = {(const unsigned char *)from, (unsigned char *)to, 0, 0};
    return s->in_stride ? *s : none;
}

static inline int is_apart(const skin_stream *s)
{
    return s->in_stride == 0 || s->in_stride >= sizeof(float);
}

KERNEL(skin_pairs)
(const skin_influences *influences, const nkw_mat4 *palette, const skin_stream *positions,
 const skin_stream *directions, int raw, int more, size_t n)
{
    const float nothing[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    float unused[2][4];
    const skin_stream ps = stream_or(positions, nothing, unused[0]), ds = stream_or(directions, nothing, unused[1]);
    const size_t followed = is_apart(&ps) && is_apart(&ds) ? n - (more ? 0 : 1) : 0;
    size_t moved;
    for (size_t i = 0; i < n; i += moved) {
        const skin_influences f = influences_at(influences, i);
        const skin_stream p = stream_at(&ps, i), d = stream_at(&ds, i);
        const size_t count = followed - i < SKIN_BLOCK ? followed - i : SKIN_BLOCK;
        moved = i < followed ? move_block(&f, palette, &p, &d, raw, count) : 0;
        if (moved == 0) {
            move_alone(&f, palette, &p, &d, raw);
            moved = 1;
        }
    }
}
