/* SPDX-License-Identifier: MIT */
/*
 * Smooth normals of corners.
 *
 * The working memory, for T triangles: normal 3T and angle 3T doubles, first 3T, next 3T and the table 6T words.
 */
#include "mesh_join.h"

#include "report.h"
#include "work.h"

/* Normals are at most this much farther apart than the crease, in radians: 8 times the rounding of a float at 1. */
#define CREASE_MARGIN 0x1p-20
/* A sum of weighted normals that is this much shorter than the sum of its weights has cancelled. */
#define LEAST_SUM 0x1p-20
/* More than the square of any distance of two unit vectors. */
#define LIMIT_ALL 8.0

typedef struct normals_plan {
    const nkw_mesh *mesh;
    lane_f64_vec3 *normal; /* of each triangle, zero if it is degenerate */
    double *angle; /* at each corner */
    mesh_join join; /* corners of the same position */
    double limit; /* of the square of the distance of two normals */
} normals_plan;

/* N and the angles of a triangle, from its edges: tan angle = |u x v| / (u.v), and |u x v| is the same at each corner. */
static void measure_triangle(normals_plan *p, size_t t)
{
    const lane_f64_vec3 zero = {0.0, 0.0, 0.0};
    lane_f64_vec3 edge[3], cross;
    for (size_t k = 0; k < 3; k++)
        edge[k] = lane_f64_vec3_sub(mesh_position(p->mesh, 3 * t + (k + 1) % 3), mesh_position(p->mesh, 3 * t + k));
    cross = lane_f64_vec3_cross(edge[0], edge[1]);
    const double sine = lane_f64_vec3_length(cross);
    p->normal[t] = sine > 0.0 ? lane_f64_vec3_normalize(cross) : zero;
    for (size_t k = 0; k < 3; k++)
        p->angle[3 * t + k] = lane_atan2_64(sine, -lane_f64_vec3_dot(edge[k], edge[(k + 2) % 3]));
}

static int is_zero(lane_f64_vec3 v)
{
    return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

typedef struct normal_sum {
    lane_f64_vec3 sum;
    double weights;
} normal_sum;

/* Over the corners at a position whose normals are within the limit of `own`: |a - b| = 2 sin(angle / 2). */
static normal_sum sum_near(const normals_plan *p, uint32_t first, lane_f64_vec3 own, double limit)
{
    normal_sum s = {{0.0, 0.0, 0.0}, 0.0};
    for (uint32_t c = first; c != MESH_NONE; c = p->join.next[c]) {
        const lane_f64_vec3 normal = p->normal[c / 3], between = lane_f64_vec3_sub(normal, own);
        if (is_zero(normal) || lane_f64_vec3_dot(between, between) > limit)
            continue;
        s.sum = lane_f64_vec3_add_scaled(s.sum, normal, p->angle[c]);
        s.weights += p->angle[c];
    }
    return s;
}

static nkw_vec3 normal_of_sum(const normal_sum *s, lane_f64_vec3 own)
{
    const double least = LEAST_SUM * s->weights;
    return lane_vec3_from_f64(lane_f64_vec3_dot(s->sum, s->sum) > least * least ? lane_f64_vec3_normalize(s->sum)
                                                                                : own);
}

static void write_position(const normals_plan *p, uint32_t first, nkw_vec3 *normals)
{
    const normal_sum all = sum_near(p, first, p->normal[first / 3], LIMIT_ALL);
    for (uint32_t c = first; c != MESH_NONE; c = p->join.next[c]) {
        const lane_f64_vec3 own = p->normal[c / 3];
        normal_sum s = all;
        if (p->limit < LIMIT_ALL && !is_zero(own))
            s = sum_near(p, first, own, p->limit);
        normals[c] = normal_of_sum(&s, own);
    }
}

/* Returns the table. */
static uint32_t *lay_out(normals_plan *p, const nkw_mesh *mesh, void *memory)
{
    const size_t n = mesh->triangle_count;
    p->mesh = mesh;
    p->normal = (lane_f64_vec3 *)memory;
    p->angle = (double *)(p->normal + n);
    p->join.first = (uint32_t *)(p->angle + 3 * n);
    p->join.next = p->join.first + 3 * n;
    return p->join.next + 3 * n;
}

/* The square of 2 sin(crease / 2). */
static double limit_of(float crease)
{
    const double angle = (double)crease + CREASE_MARGIN;
    if (angle >= LANE_PI)
        return LIMIT_ALL;
    const double sine = lane_sin64(0.5 * angle);
    return 4.0 * (sine * sine);
}

nkw_result nkw_mesh_normals(const nkw_mesh *mesh, float crease, nkw_vec3 *normals, size_t *bad, nkw_work work)
{
    const size_t n = mesh->triangle_count;
    if (!(crease >= 0.0f))
        return report(NKW_OUT_OF_RANGE, 0, bad);
    const nkw_result result = nkwi_mesh_check(mesh, bad);
    if (result != NKW_OK)
        return result;
    if (!work_fits_each(work, n, NKW_MESH_WORK(1)))
        return NKW_TOO_SMALL;
    normals_plan p;
    uint32_t *table = lay_out(&p, mesh, work.data);
    p.limit = limit_of(crease);
    nkwi_mesh_join_positions(mesh, p.join, table);
    for (size_t t = 0; t < n; t++)
        measure_triangle(&p, t);
    for (size_t c = 0; c < 3 * n; c++)
        if (p.join.first[c] == c)
            write_position(&p, (uint32_t)c, normals);
    return NKW_OK;
}
