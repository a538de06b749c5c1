/* SPDX-License-Identifier: MIT */
/*
 * Consistent facing.
 *
 * The working memory, for T triangles, in words: corners 6T, edges 6T, the table 6T, partner 3T, turned T, queue T.
 */
#include "mesh_join.h"

#include "report.h"
#include "work.h"

/* A volume that is this much smaller than the sum of its magnitudes is none. */
#define LEAST_VOLUME 0x1p-40

typedef struct facing_plan {
    const nkw_mesh *mesh;
    mesh_join corners, edges;
    uint32_t *partner; /* of the edge of each corner: the one other edge with the same ends, or MESH_NONE */
    uint32_t *turned; /* of each triangle: 0 or 1; MESH_NONE before it is reached */
    uint32_t *queue; /* the triangles of all pieces so far, in the order in which they are reached */
    nkw_mesh_facing found;
} facing_plan;

/* Returns the table. */
static uint32_t *lay_out(facing_plan *p, const nkw_mesh *mesh, uint32_t *words)
{
    const size_t n = 3 * mesh->triangle_count;
    const nkw_mesh_facing none = {0, 0, 0, 0, 0};
    p->mesh = mesh;
    p->found = none;
    p->corners.first = words;
    p->corners.next = words + n;
    p->edges.first = words + 2 * n;
    p->edges.next = words + 3 * n;
    p->partner = words + 4 * n;
    p->turned = words + 5 * n;
    p->queue = p->turned + n / 3;
    return p->queue + n / 3;
}

static void pair_edges(facing_plan *p)
{
    const mesh_join edges = p->edges;
    for (size_t c = 0; c < 3 * p->mesh->triangle_count; c++) {
        const uint32_t second = edges.first[c] == c ? edges.next[c] : MESH_NONE;
        if (edges.first[c] == c)
            p->partner[c] = MESH_NONE;
        if (second == MESH_NONE)
            continue;
        const int is_pair = edges.next[second] == MESH_NONE;
        p->found.branch_count += !is_pair;
        for (uint32_t other = second; other != MESH_NONE; other = edges.next[other])
            p->partner[other] = is_pair ? (uint32_t)c : MESH_NONE;
        p->partner[c] = is_pair ? second : MESH_NONE;
    }
}

/* Whether one of the triangles of two edges with the same ends must be turned: both pass them in the same direction. */
static uint32_t must_differ(const facing_plan *p, size_t a, size_t b)
{
    return mesh_ascends(p->corners.first, a) == mesh_ascends(p->corners.first, b);
}

/* Reaches the triangles of a piece from its first one. Returns the end of the piece in the queue. */
static size_t reach_piece(facing_plan *p, size_t first, size_t begin)
{
    size_t end = begin;
    p->turned[first] = 0;
    p->queue[end++] = (uint32_t)first;
    for (size_t i = begin; i < end; i++)
        for (size_t c = 3 * (size_t)p->queue[i]; c < 3 * (size_t)p->queue[i] + 3; c++) {
            const uint32_t other = p->partner[c];
            if (other == MESH_NONE || p->turned[other / 3] != MESH_NONE)
                continue;
            p->turned[other / 3] = p->turned[c / 3] ^ must_differ(p, c, other);
            p->queue[end++] = other / 3;
        }
    return end;
}

/* det(p0 - o, p1 - o, p2 - o) of a triangle as it is turned now. */
static double volume_of(const facing_plan *p, size_t triangle, lane_f64_vec3 o)
{
    lane_f64_vec3 v[3];
    for (size_t k = 0; k < 3; k++)
        v[k] = lane_f64_vec3_sub(mesh_position(p->mesh, 3 * triangle + k), o);
    const double volume = lane_f64_vec3_dot(v[0], lane_f64_vec3_cross(v[1], v[2]));
    return p->turned[triangle] ? -volume : volume;
}

/* Turns all triangles of a piece if they face inward, or if most of them are turned. */
static void settle_piece(facing_plan *p, size_t begin, size_t end)
{
    const lane_f64_vec3 o = mesh_position(p->mesh, 3 * (size_t)p->queue[begin]);
    size_t turned = 0, conflicts = 0, open = 0;
    double volume = 0.0, magnitude = 0.0;
    for (size_t i = begin; i < end; i++) {
        const size_t t = p->queue[i];
        const double part = volume_of(p, t, o);
        volume += part;
        magnitude += lane_abs64(part);
        turned += p->turned[t];
        for (size_t c = 3 * t; c < 3 * t + 3; c++) {
            const uint32_t other = p->partner[c];
            open += other == MESH_NONE;
            if (other != MESH_NONE && c < other)
                conflicts += (p->turned[t] ^ p->turned[other / 3]) != must_differ(p, c, other);
        }
    }
    const int is_closed = open == 0 && conflicts == 0;
    const int has_volume = is_closed && lane_abs64(volume) > LEAST_VOLUME * magnitude;
    const int turns = has_volume ? volume < 0.0 : turned > end - begin - turned;
    for (size_t i = begin; turns && i < end; i++)
        p->turned[p->queue[i]] ^= 1;
    p->found.turned_count += turns ? end - begin - turned : turned;
    p->found.piece_count++;
    p->found.closed_count += (size_t)is_closed;
    p->found.conflict_count += conflicts;
}

static void settle(facing_plan *p)
{
    const size_t n = p->mesh->triangle_count;
    size_t end = 0;
    for (size_t t = 0; t < n; t++)
        p->turned[t] = mesh_is_collapsed(p->corners.first, t) ? 0 : MESH_NONE;
    for (size_t t = 0; t < n; t++) {
        const size_t begin = end;
        if (p->turned[t] != MESH_NONE)
            continue;
        end = reach_piece(p, t, begin);
        settle_piece(p, begin, end);
    }
}

nkw_result nkw_mesh_fix_facing(const nkw_mesh *mesh, uint32_t *indices, nkw_mesh_facing *facing, size_t *bad,
                               nkw_work work)
{
    const size_t n = mesh->triangle_count;
    const nkw_result result = nkwi_mesh_check(mesh, bad);
    if (result != NKW_OK)
        return result;
    if (!work_fits_each(work, n, NKW_MESH_WORK(1)))
        return NKW_TOO_SMALL;
    facing_plan p;
    uint32_t *table = lay_out(&p, mesh, (uint32_t *)work.data);
    nkwi_mesh_join_positions(mesh, p.corners, table);
    nkwi_mesh_join_edges(p.corners.first, 3 * n, p.edges, table);
    pair_edges(&p);
    settle(&p);
    for (size_t t = 0; t < n; t++) {
        const size_t a = mesh_vertex(mesh, 3 * t), b = mesh_vertex(mesh, 3 * t + 1), c = mesh_vertex(mesh, 3 * t + 2);
        indices[3 * t] = (uint32_t)a;
        indices[3 * t + 1] = (uint32_t)(p.turned[t] ? c : b);
        indices[3 * t + 2] = (uint32_t)(p.turned[t] ? b : c);
    }
    if (facing)
        *facing = p.found;
    return NKW_OK;
}
