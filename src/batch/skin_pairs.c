/* SPDX-License-Identifier: MIT */
/*
 * Linear blend skinning of positions and directions (normals, tangents) as they lie in vertex buffers, either or both
 * in one pass: the matrix of each vertex is blended column by column, and takes its vectors while it is in registers;
 * as many vertices together as a register has columns.
 */
#include "lane/strict.h"

#include <nakawari/skin.h>

#include "batch/skin.h"
#include "lane/fours.h"
#include "lane/skin.h"

/* As nkw_mat4_transform_point and nkw_mat4_transform_direction. */
INLINE lane_wide take_point(lane_wide_columns m, lane_wide_vectors v)
{
    lane_wide xy = lane_wide_add(lane_wide_mul(m.x, v.x), lane_wide_mul(m.y, v.y));
    return lane_wide_add(xy, lane_wide_add(lane_wide_mul(m.z, v.z), m.t));
}

INLINE lane_wide take_direction(lane_wide_columns m, lane_wide_vectors v)
{
    lane_wide xy = lane_wide_add(lane_wide_mul(m.x, v.x), lane_wide_mul(m.y, v.y));
    return lane_wide_add(xy, lane_wide_mul(m.z, v.z));
}

/* n / |n|; zero stays zero: as lane_skin_unit. */
INLINE void make_unit(lane_wide n[4])
{
    lane_wide s[4];
    for (int v = 0; v < 4; v++)
        s[v] = lane_wide_mul(n[v], n[v]);
    lane_wide_transpose(s);
    lane_wide n2 = lane_wide_add(lane_wide_add(s[0], s[1]), s[2]);
    lane_wide k = lane_wide_unless_zero(n2, lane_wide_div(lane_wide_all(1.0f), lane_wide_sqrt(n2)));
    n[0] = lane_wide_mul(n[0], lane_wide_splat(k, 0));
    n[1] = lane_wide_mul(n[1], lane_wide_splat(k, 1));
    n[2] = lane_wide_mul(n[2], lane_wide_splat(k, 2));
    n[3] = lane_wide_mul(n[3], lane_wide_splat(k, 3));
}

INLINE lane_wide_vectors read(const skin_stream *s, int tight)
{
    return tight ? lane_wide_read3_tight(s->in) : lane_wide_read3(s->in, s->in_stride);
}

INLINE void write(const skin_stream *s, int tight, lane_wide a)
{
    if (tight)
        lane_wide_write3_tight(s->out, a);
    else
        lane_wide_write3(s->out, s->out_stride, a);
}

/* The sum of w[e] palette[joint[e]], k at least 1: 0 if a joint is not in the palette. */
INLINE int blend(const nkw_mat4 *palette, size_t limit, const unsigned char *joint, nkw_skin_format format,
                 const unsigned char *w, size_t k, lane_wide_matrix *sum)
{
    size_t j = lane_skin_joint(joint, format);
    lane_wide we = lane_wide_all_of(w);
    if (j >= limit)
        return 0;
    for (size_t a = 0; a < LANE_PARTS; a++)
        sum->part[a] = lane_wide_mul(lane_wide_load(palette[j].m + a * LANE_WIDE), we);
    for (size_t e = 1; e < k; e++) {
        j = lane_skin_joint(joint + e * lane_skin_format_size(format), format);
        we = lane_wide_all_of(w + e * sizeof(float));
        if (j >= limit)
            return 0;
        for (size_t a = 0; a < LANE_PARTS; a++) {
            lane_wide part = lane_wide_mul(lane_wide_load(palette[j].m + a * LANE_WIDE), we);
            sum->part[a] = lane_wide_add(sum->part[a], part);
        }
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
        if (USUALLY(high & 0x7f80))
            return 1;
    }
    return 0;
}

/*
 * Moves up to n vertices, before the first LANE_FOURS of which one has no such weight or a joint beyond the palette:
 * gives how many. Directions go to `blended`, as they are, if it is not NULL. `tight`: everything lies one behind the
 * other, and all joints are in the palette.
 */
INLINE size_t move_usual(const skin_influences *f, size_t k, nkw_skin_format format, int tight, const nkw_mat4 *palette,
                         const skin_stream *positions, const skin_stream *directions, lane_wide *blended, size_t n)
{
    const unsigned char *w = (const unsigned char *)f->weights.data, *joint = (const unsigned char *)f->joints.data;
    const size_t joint_stride = tight ? k * lane_skin_format_size(format) : f->joints.stride;
    const size_t weight_stride = tight ? k * sizeof(float) : f->weights.stride, limit = tight ? SIZE_MAX : f->limit;
    const int has_positions = positions->in_stride != 0, has_directions = directions->in_stride != 0;
    skin_stream p = *positions, d = *directions;
    size_t i = 0;
    if (tight)
        p.in_stride = p.out_stride = d.in_stride = d.out_stride = sizeof(nkw_vec3);
    for (; i + LANE_FOURS <= n; i += LANE_FOURS) {
        lane_wide_matrix m[LANE_FOURS];
        for (size_t v = 0; v < LANE_FOURS; v++, joint += joint_stride, w += weight_stride)
            if (!has_weight(w, k) || !blend(palette, limit, joint, format, w, k, &m[v]))
                return i;
        lane_wide_columns c = lane_wide_columns_of(m);
        if (USUALLY(has_positions)) {
            write(&p, tight, take_point(c, read(&p, tight)));
            p.in += LANE_FOURS * p.in_stride, p.out += LANE_FOURS * p.out_stride;
        }
        if (USUALLY(has_directions)) {
            lane_wide r = take_direction(c, read(&d, tight));
            if (blended)
                blended[i / LANE_FOURS] = r;
            else
                write(&d, tight, r);
            d.in += LANE_FOURS * d.in_stride, d.out += LANE_FOURS * d.out_stride;
        }
    }
    return i;
}

/* The usual counts, the formats and `tight` as constants. */
INLINE size_t move_by_count(const skin_influences *f, nkw_skin_format format, int tight, const nkw_mat4 *palette,
                            const skin_stream *p, const skin_stream *d, lane_wide *blended, size_t n)
{
    if (f->count == 4)
        return move_usual(f, 4, format, tight, palette, p, d, blended, n);
    if (f->count == 2)
        return move_usual(f, 2, format, tight, palette, p, d, blended, n);
    if (f->count == 1)
        return move_usual(f, 1, format, tight, palette, p, d, blended, n);
    return move_usual(f, f->count, format, tight, palette, p, d, blended, n);
}

APART static size_t move_u8(const skin_influences *f, int tight, const nkw_mat4 *palette, const skin_stream *p,
                            const skin_stream *d, lane_wide *blended, size_t n)
{
    return tight ? move_by_count(f, NKW_SKIN_U8, 1, palette, p, d, blended, n)
                 : move_by_count(f, NKW_SKIN_U8, 0, palette, p, d, blended, n);
}

APART static size_t move_u16(const skin_influences *f, int tight, const nkw_mat4 *palette, const skin_stream *p,
                             const skin_stream *d, lane_wide *blended, size_t n)
{
    return tight ? move_by_count(f, NKW_SKIN_U16, 1, palette, p, d, blended, n)
                 : move_by_count(f, NKW_SKIN_U16, 0, palette, p, d, blended, n);
}

APART static size_t move_u32(const skin_influences *f, int tight, const nkw_mat4 *palette, const skin_stream *p,
                             const skin_stream *d, lane_wide *blended, size_t n)
{
    return tight ? move_by_count(f, NKW_SKIN_U32, 1, palette, p, d, blended, n)
                 : move_by_count(f, NKW_SKIN_U32, 0, palette, p, d, blended, n);
}

INLINE size_t move_by_format(const skin_influences *f, int tight, const nkw_mat4 *palette, const skin_stream *p,
                             const skin_stream *d, lane_wide *blended, size_t n)
{
    if (f->joints.format == NKW_SKIN_U8)
        return move_u8(f, tight, palette, p, d, blended, n);
    if (f->joints.format == NKW_SKIN_U16)
        return move_u16(f, tight, palette, p, d, blended, n);
    return move_u32(f, tight, palette, p, d, blended, n);
}

/* Directions made unit and written. */
INLINE void finish(lane_wide *blended, size_t wides, int tight, const skin_stream *d)
{
    skin_stream s = *d;
    for (size_t i = wides; i % 4; i++)
        blended[i] = lane_wide_all(0.0f);
    for (size_t i = 0; i < wides; i += 4) {
        make_unit(blended + i);
        for (size_t v = i; v < i + 4 && v < wides; v++, s.out += LANE_FOURS * s.out_stride)
            write(&s, tight, blended[v]);
    }
}

/* A block at most where directions are made unit. */
static inline size_t move_block(const skin_influences *f, int tight, const nkw_mat4 *palette, const skin_stream *p,
                                const skin_stream *d, int raw, size_t n)
{
    lane_wide blended[SKIN_BLOCK / LANE_FOURS];
    size_t moved;
    if (raw || !d->in_stride)
        return move_by_format(f, tight, palette, p, d, NULL, n);
    moved = move_by_format(f, tight, palette, p, d, blended, n < SKIN_BLOCK ? n : SKIN_BLOCK);
    if (tight)
        finish(blended, moved / LANE_FOURS, 1, d);
    else
        finish(blended, moved / LANE_FOURS, 0, d);
    return moved;
}

/* Whether all weights of vertex i are 0, whatever its joints. */
static inline int is_weightless(const skin_influences *f, size_t i)
{
    const unsigned char *w = (const unsigned char *)f->weights.data + i * f->weights.stride;
    uint32_t any = 0;
    if (has_weight(w, f->count))
        return 0;
    for (size_t e = 0; e < f->count; e++)
        any |= lane_bits(lane_skin_weight(w + e * sizeof(float), NKW_SKIN_F32)) << 1;
    return any == 0;
}

/* The matrix of a vertex of any weights and joints; gives 0 if its weights are all 0. */
static inline uint32_t blend_any(const skin_influences *f, const nkw_mat4 *palette, size_t i, nkw_mat4 *sum)
{
    const unsigned char *joint = (const unsigned char *)f->joints.data + i * f->joints.stride;
    const unsigned char *w = (const unsigned char *)f->weights.data + i * f->weights.stride;
    lane_wide_matrix r;
    uint32_t any = 0;
    memset(&r, 0, sizeof r);
    for (size_t e = 0; e < f->count; e++) {
        const uint32_t j = lane_skin_joint(joint + e * lane_skin_format_size(f->joints.format), f->joints.format);
        const float weight = j < f->limit ? lane_skin_weight(w + e * sizeof weight, NKW_SKIN_F32) : 0.0f;
        const float *m = palette[j < f->limit ? j : 0].m;
        any |= lane_bits(weight) << 1;
        for (size_t a = 0; a < LANE_PARTS; a++) {
            const lane_wide part = lane_wide_mul(lane_wide_load(m + a * LANE_WIDE), lane_wide_all(weight));
            r.part[a] = e == 0 ? part : lane_wide_add(r.part[a], part);
        }
    }
    memcpy(sum, &r, sizeof *sum);
    return any;
}

static inline void keep_vector(const skin_stream *s, size_t i)
{
    nkw_vec3 v;
    if (s->in_stride) {
        memcpy(&v, s->in + i * s->in_stride, sizeof v);
        memcpy(s->out + i * s->out_stride, &v, sizeof v);
    }
}

static inline void move_one(const nkw_mat4 *m, const skin_stream *p, const skin_stream *d, int raw, size_t i)
{
    nkw_vec3 v;
    if (p->in_stride) {
        memcpy(&v, p->in + i * p->in_stride, sizeof v);
        v = nkw_mat4_transform_point(m, v);
        memcpy(p->out + i * p->out_stride, &v, sizeof v);
    }
    if (d->in_stride) {
        memcpy(&v, d->in + i * d->in_stride, sizeof v);
        v = nkw_mat4_transform_direction(m, v);
        v = raw ? v : lane_skin_unit(v);
        memcpy(d->out + i * d->out_stride, &v, sizeof v);
    }
}

/*
 * Vertices of any weights and joints: up to `few` with weights, and those without that follow them. Gives how many.
 * Reads no further than their vectors go.
 */
static inline size_t move_any(const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p,
                              const skin_stream *d, int raw, size_t few, size_t n)
{
    nkw_mat4 m;
    size_t i = 0;
    for (; i < few && blend_any(f, palette, i, &m); i++)
        move_one(&m, p, d, raw, i);
    for (int none = i < few; none; none = ++i < n && is_weightless(f, i)) {
        keep_vector(p, i);
        keep_vector(d, i);
    }
    return i;
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
    skin_stream r = *s;
    if (s->in_stride)
        r.in += i * s->in_stride, r.out += i * s->out_stride;
    return r;
}

static inline int is_apart(const skin_stream *s)
{
    return s->in_stride == 0 || s->in_stride >= sizeof(float);
}

static inline int is_tight(const skin_stream *s)
{
    return s->in_stride == 0 || (s->in_stride == sizeof(nkw_vec3) && s->out_stride == sizeof(nkw_vec3));
}

/* Whether n joints, one behind the other, are in the palette. */
INLINE int are_joints(const unsigned char *joint, nkw_skin_format format, uint32_t limit, size_t n)
{
    uint32_t odd = limit >> 31;
#pragma omp simd reduction(| : odd)
    for (size_t i = 0; i < n; i++) {
        uint32_t j = lane_skin_joint(joint + i * lane_skin_format_size(format), format);
        odd |= j | (limit - 1 - j);
    }
    return odd >> 31 == 0;
}

/* Where a register has more than one column it pays to know the strides. */
static inline int are_tight(const skin_influences *f, const skin_stream *p, const skin_stream *d, size_t n)
{
    const unsigned char *joint = (const unsigned char *)f->joints.data;
    const nkw_skin_format format = f->joints.format;
    if (LANE_FOURS == 1 || !is_tight(p) || !is_tight(d) || f->weights.stride != f->count * sizeof(float) ||
        f->joints.stride != f->count * lane_skin_format_size(format))
        return 0;
    if (format == NKW_SKIN_U8)
        return are_joints(joint, NKW_SKIN_U8, f->limit, n * f->count);
    if (format == NKW_SKIN_U16)
        return are_joints(joint, NKW_SKIN_U16, f->limit, n * f->count);
    return are_joints(joint, NKW_SKIN_U32, f->limit, n * f->count);
}

NKW_LOOP(nkwi_skin_pairs)
(const skin_influences *influences, const nkw_mat4 *palette, const skin_stream *positions,
 const skin_stream *directions, int raw, size_t more, size_t n)
{
    const int tight = are_tight(influences, positions, directions, n);
    const size_t over = tight ? 0 : 1; /* vectors that are read, in part, behind the last one */
    const size_t all = is_apart(positions) && is_apart(directions) ? n + more : 0;
    const size_t followed = all < over ? 0 : all - over < n ? all - over : n;
    size_t moved;
    for (size_t i = 0; i < n; i += moved) {
        const skin_influences f = influences_at(influences, i);
        const skin_stream p = stream_at(positions, i), d = stream_at(directions, i);
        moved = i < followed ? move_block(&f, tight, palette, &p, &d, raw, followed - i) : 0;
        if (moved == 0)
            moved = move_any(&f, palette, &p, &d, raw, n - i < LANE_FOURS ? n - i : LANE_FOURS, n - i);
    }
}
