/* SPDX-License-Identifier: MIT */
/*
 * Linear blend skinning of vertices as they lie in vertex buffers: the matrix of each vertex is blended in columns of
 * four floats, and takes the vertex's vectors while it is in registers. Vertices go by fours, so that four directions
 * are made unit together.
 */
#include "lane/strict.h"

#include <nakawari/skin.h>

#include "batch/table.h"
#include "lane/four.h"
#include "lane/skin.h"

typedef struct columns {
    lane_four x, y, z, t;
} columns;

#if defined(LANE_FOUR_SPLIT)

static inline columns blend(const nkw_mat4 *palette, const float *w, const uint32_t *joint, size_t k)
{
    lane_wide m[LANE_WIDE_PARTS];
    for (size_t a = 0; a < LANE_WIDE_PARTS; a++)
        m[a] = lane_wide_load(palette[joint[0]].m + a * LANE_WIDE) * w[0];
    for (size_t e = 1; e < k; e++)
        for (size_t a = 0; a < LANE_WIDE_PARTS; a++)
            m[a] += lane_wide_load(palette[joint[e]].m + a * LANE_WIDE) * w[e];
    columns r = LANE_FOUR_SPLIT(m);
    return r;
}

#else

static inline lane_four scaled(const float *column, lane_four w)
{
    return lane_four_mul(lane_four_load(column), w);
}

static inline columns blend(const nkw_mat4 *palette, const float *w, const uint32_t *joint, size_t k)
{
    const float *m = palette[joint[0]].m;
    lane_four we = lane_four_all(w[0]);
    columns r = {scaled(m, we), scaled(m + 4, we), scaled(m + 8, we), scaled(m + 12, we)};
    for (size_t e = 1; e < k; e++) {
        m = palette[joint[e]].m;
        we = lane_four_all(w[e]);
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
    float p[3];
    memcpy(p, at, sizeof p);
    lane_four x = lane_four_mul(m->x, lane_four_all(p[0])), y = lane_four_mul(m->y, lane_four_all(p[1]));
    lane_four z = lane_four_mul(m->z, lane_four_all(p[2]));
    return lane_four_add(lane_four_add(x, y), lane_four_add(z, m->t));
}

/* As nkw_mat4_transform_direction. */
static inline lane_four direction(const columns *m, const unsigned char *at)
{
    float d[3];
    memcpy(d, at, sizeof d);
    lane_four x = lane_four_mul(m->x, lane_four_all(d[0])), y = lane_four_mul(m->y, lane_four_all(d[1]));
    lane_four z = lane_four_mul(m->z, lane_four_all(d[2]));
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

/* `count` vertices, 4 or 1. */
static inline void move_group(const skin_block *b, const nkw_mat4 *palette, size_t k, const skin_streams *s, size_t i,
                              size_t count)
{
    lane_four d[3][4];
    const skin_stream *p = &s->position;
    for (size_t v = 0; v < count; v++) {
        columns m = blend(palette, b->weight + (i + v) * k, b->joint + (i + v) * k, k);
        if (p->in)
            lane_four_store3(p->out + (i + v) * p->out_stride, point(&m, p->in + (i + v) * p->in_stride));
        for (size_t a = 0; a < s->directions; a++)
            d[a][v] = direction(&m, s->direction[a].in + (i + v) * s->direction[a].in_stride);
    }
    for (size_t a = 0; a < s->directions; a++) {
        const skin_stream *to = &s->direction[a];
        for (size_t v = count; v < 4; v++)
            d[a][v] = d[a][0];
        if (!s->raw)
            make_unit(d[a]);
        for (size_t v = 0; v < count; v++)
            lane_four_store3(to->out + (i + v) * to->out_stride, d[a][v]);
    }
}

static inline void copy_vertex(const skin_streams *s, size_t i)
{
    const skin_stream *p = &s->position;
    if (p->in)
        memmove(p->out + i * p->out_stride, p->in + i * p->in_stride, sizeof(nkw_vec3));
    for (size_t a = 0; a < s->directions; a++) {
        p = &s->direction[a];
        memmove(p->out + i * p->out_stride, p->in + i * p->in_stride, sizeof(nkw_vec3));
    }
}

static inline void move(const skin_block *b, const nkw_mat4 *palette, size_t k, const skin_streams *s, size_t n)
{
    const uint32_t *moved = b->moved;
    for (size_t i = 0; i < n;)
        if (i + 4 <= n && moved[i] && moved[i + 1] && moved[i + 2] && moved[i + 3]) {
            move_group(b, palette, k, s, i, 4);
            i += 4;
        } else {
            if (moved[i])
                move_group(b, palette, k, s, i, 1);
            else
                copy_vertex(s, i);
            i++;
        }
}

KERNEL(skin_streams)(const skin_block *b, const nkw_mat4 *palette, size_t k, const skin_streams *s, size_t n)
{
    if (k == 4)
        move(b, palette, 4, s, n);
    else if (k == 1)
        move(b, palette, 1, s, n);
    else if (k == 2)
        move(b, palette, 2, s, n);
    else
        move(b, palette, k, s, n);
}
