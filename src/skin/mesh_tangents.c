/* SPDX-License-Identifier: MIT */
/*
 * Tangents by MikkTSpace, of triangles.
 *
 *     vertices   corners of equal position, normal and texture coordinates
 *     neighbours triangles that pass an edge between two such vertices in opposite directions
 *     groups     corners of one vertex, connected by neighbours, of the same orientation: they share a tangent
 *
 * The working memory, for T triangles: slope 3T and sums 9T doubles; vertices 6T, edges 6T, the table 6T, neighbour 3T
 * and flags T words. Groups take the place of the edges, the stack that of the table.
 */
#include "mesh_join.h"

#include "report.h"
#include "work.h"

enum {
    TANGENT_POSITIVE = 1, /* the texture is not mirrored: its area is positive */
    TANGENT_ANY = 2, /* without slopes: the triangle has the orientation of the first group that takes it */
    TANGENT_COLLAPSED = 4 /* two corners at one position */
};

typedef struct tangents_plan {
    const nkw_mesh *mesh;
    nkw_mesh_surface surface;
    lane_f64_vec3 *slope; /* of each triangle: the direction of growing u */
    lane_f64_vec3 *sum; /* of each group: of slopes times angles */
    mesh_join vertices, edges;
    uint32_t *neighbour; /* of the edge of each corner: the edge beyond, or MESH_NONE */
    uint32_t *group; /* of each corner: the first corner of its group, or MESH_NONE */
    uint32_t *flags; /* of each triangle */
    uint32_t *table; /* 6T words */
} tangents_plan;

static void lay_out(tangents_plan *p, void *memory)
{
    const size_t n = p->mesh->triangle_count;
    p->slope = (lane_f64_vec3 *)memory;
    p->sum = p->slope + n;
    p->vertices.first = (uint32_t *)(p->sum + 3 * n);
    p->vertices.next = p->vertices.first + 3 * n;
    p->edges.first = p->vertices.next + 3 * n;
    p->edges.next = p->edges.first + 3 * n;
    p->table = p->edges.next + 3 * n;
    p->neighbour = p->table + 6 * n;
    p->flags = p->neighbour + 3 * n;
    p->group = p->edges.first;
}

/* ---- Vertices and neighbours ---- */

static nkw_vec3 texcoord_of(const tangents_plan *p, size_t corner)
{
    const float *uv = p->surface.texcoords + 2 * mesh_vertex(p->mesh, corner);
    nkw_vec3 r = {uv[0], uv[1], 0.0f};
    return r;
}

static nkw_vec3 normal_of(const tangents_plan *p, size_t corner)
{
    return p->surface.normals[mesh_vertex(p->mesh, corner)];
}

static uint32_t hash_vertex(const void *context, size_t corner)
{
    const tangents_plan *p = context;
    uint32_t hash = mesh_mix_vec3(0, p->mesh->positions[mesh_vertex(p->mesh, corner)]);
    return mesh_mixed(mesh_mix_vec3(mesh_mix_vec3(hash, normal_of(p, corner)), texcoord_of(p, corner)));
}

static int same_vertex(const void *context, size_t a, size_t b)
{
    const tangents_plan *p = context;
    return mesh_same_vec3(p->mesh->positions[mesh_vertex(p->mesh, a)], p->mesh->positions[mesh_vertex(p->mesh, b)]) &&
           mesh_same_vec3(normal_of(p, a), normal_of(p, b)) && mesh_same_vec3(texcoord_of(p, a), texcoord_of(p, b));
}

/* The first edge without a neighbour takes the first one after it in the opposite direction. */
static void pair_edges(tangents_plan *p, uint32_t first)
{
    const uint32_t *ids = p->vertices.first;
    uint32_t waiting = MESH_NONE;
    for (uint32_t c = first; c != MESH_NONE; c = p->edges.next[c]) {
        if (p->flags[c / 3] & TANGENT_COLLAPSED)
            continue;
        if (waiting == MESH_NONE)
            waiting = c;
        if (mesh_ascends(ids, waiting) == mesh_ascends(ids, c))
            continue;
        p->neighbour[c] = waiting;
        p->neighbour[waiting] = c;
        while (waiting != c && (p->neighbour[waiting] != MESH_NONE || p->flags[waiting / 3] & TANGENT_COLLAPSED))
            waiting = p->edges.next[waiting];
        waiting = waiting == c ? MESH_NONE : waiting;
    }
}

static void find_neighbours(tangents_plan *p)
{
    const size_t n = 3 * p->mesh->triangle_count;
    nkwi_mesh_join_edges(p->vertices.first, n, p->edges, p->table);
    for (size_t c = 0; c < n; c++)
        p->neighbour[c] = MESH_NONE;
    for (size_t c = 0; c < n; c++)
        if (p->edges.first[c] == c)
            pair_edges(p, (uint32_t)c);
}

/* ---- Slopes ---- */

/*
 * dP/du and dP/dv of a triangle, times the area of its texture (equations 18 and 19 of the source):
 *
 *     (v2 - v0) d1 - (v1 - v0) d2,    (u1 - u0) d2 - (u2 - u0) d1,    d = P - P0
 */
static void measure_triangle(tangents_plan *p, size_t t)
{
    lane_f64_vec3 at[3], uv[3];
    for (size_t k = 0; k < 3; k++) {
        at[k] = mesh_position(p->mesh, 3 * t + k);
        uv[k] = lane_f64_vec3_from(texcoord_of(p, 3 * t + k));
    }
    const lane_f64_vec3 d1 = lane_f64_vec3_sub(at[1], at[0]), d2 = lane_f64_vec3_sub(at[2], at[0]);
    const lane_f64_vec3 e1 = lane_f64_vec3_sub(uv[1], uv[0]), e2 = lane_f64_vec3_sub(uv[2], uv[0]);
    const double area = e1.x * e2.y - e1.y * e2.x;
    const lane_f64_vec3 by_u = lane_f64_vec3_add_scaled(lane_f64_vec3_scale(d1, e2.y), d2, -e1.y);
    const lane_f64_vec3 by_v = lane_f64_vec3_add_scaled(lane_f64_vec3_scale(d2, e1.x), d1, -e2.x);
    const double size = lane_abs64(area), least = (double)FLT_MIN * size;
    const int has_area = size > (double)FLT_MIN;
    const int is_sound = has_area && lane_f64_vec3_length(by_u) > least && lane_f64_vec3_length(by_v) > least;
    const int is_collapsed = mesh_same_vec3(lane_vec3_from_f64(at[0]), lane_vec3_from_f64(at[1])) ||
                             mesh_same_vec3(lane_vec3_from_f64(at[1]), lane_vec3_from_f64(at[2])) ||
                             mesh_same_vec3(lane_vec3_from_f64(at[2]), lane_vec3_from_f64(at[0]));
    p->slope[t] = lane_f64_vec3_scale(lane_f64_vec3_normalize(by_u), area > 0.0 ? 1.0 : -1.0);
    p->flags[t] =
        (area > 0.0 ? TANGENT_POSITIVE : 0u) | (is_sound ? 0u : TANGENT_ANY) | (is_collapsed ? TANGENT_COLLAPSED : 0u);
}

/* ---- Groups ---- */

/* Whether the group takes the corner: it is free, and its triangle has the orientation of the group. */
static int takes(tangents_plan *p, uint32_t group, size_t corner)
{
    const uint32_t positive = p->flags[group / 3] & TANGENT_POSITIVE, *of = p->group + corner / 3 * 3;
    uint32_t *flags = &p->flags[corner / 3];
    if (p->group[corner] != MESH_NONE)
        return 0;
    if (*flags & TANGENT_ANY && of[0] == MESH_NONE && of[1] == MESH_NONE && of[2] == MESH_NONE)
        *flags = (*flags & ~(uint32_t)TANGENT_POSITIVE) | positive;
    return (*flags & TANGENT_POSITIVE) == positive;
}

/*
 * The corners that the first corner's group reaches, depth first, over the edge of a corner before the edge to it. The
 * order decides only which group takes a triangle without slopes. The stack grows by one for each corner taken.
 */
static void reach_group(tangents_plan *p, uint32_t first)
{
    const uint32_t *ids = p->vertices.first;
    uint32_t *stack = p->table;
    size_t depth = 0;
    uint32_t corner = first;
    for (;;) {
        if (takes(p, first, corner)) {
            p->group[corner] = first;
            stack[depth++] = p->neighbour[mesh_before(corner)];
            stack[depth++] = p->neighbour[corner];
        }
        while (depth > 0 && stack[depth - 1] == MESH_NONE)
            depth--;
        if (depth == 0)
            return;
        corner = stack[--depth];
        while (ids[corner] != ids[first])
            corner = (uint32_t)mesh_after(corner);
    }
}

static void find_groups(tangents_plan *p)
{
    const size_t n = 3 * p->mesh->triangle_count;
    for (size_t c = 0; c < n; c++)
        p->group[c] = MESH_NONE;
    for (size_t c = 0; c < n; c++)
        if (!(p->flags[c / 3] & (TANGENT_ANY | TANGENT_COLLAPSED)) && p->group[c] == MESH_NONE)
            reach_group(p, (uint32_t)c);
}

/* ---- Tangents ---- */

/* The part of v in the plane of the unit normal n, of length 1; zero stays. */
static lane_f64_vec3 in_plane(lane_f64_vec3 v, lane_f64_vec3 n)
{
    return lane_f64_vec3_normalize(lane_f64_vec3_add_scaled(v, n, -lane_f64_vec3_dot(n, v)));
}

/* The angle of the triangle at the corner, in the plane of n; a right angle where an edge is parallel to n. */
static double angle_in_plane(const nkw_mesh *mesh, size_t corner, lane_f64_vec3 n)
{
    const lane_f64_vec3 at = mesh_position(mesh, corner);
    const lane_f64_vec3 a = in_plane(lane_f64_vec3_sub(mesh_position(mesh, mesh_before(corner)), at), n);
    const lane_f64_vec3 b = in_plane(lane_f64_vec3_sub(mesh_position(mesh, mesh_after(corner)), at), n);
    const double sine = lane_f64_vec3_length(lane_f64_vec3_cross(a, b)), cosine = lane_f64_vec3_dot(a, b);
    return sine == 0.0 && cosine == 0.0 ? LANE_HALF_PI : lane_atan2_64(sine, cosine);
}

static void sum_groups(tangents_plan *p)
{
    const lane_f64_vec3 zero = {0.0, 0.0, 0.0};
    const size_t count = 3 * p->mesh->triangle_count;
    for (size_t c = 0; c < count; c++)
        p->sum[c] = zero;
    for (size_t c = 0; c < count; c++) {
        const uint32_t group = p->group[c];
        if (group == MESH_NONE || p->flags[c / 3] & TANGENT_ANY)
            continue;
        const lane_f64_vec3 n = lane_f64_vec3_normalize(lane_f64_vec3_from(normal_of(p, c)));
        p->sum[group] =
            lane_f64_vec3_add_scaled(p->sum[group], in_plane(p->slope[c / 3], n), angle_in_plane(p->mesh, c, n));
    }
}

/* The corner whose tangent this one has: of a collapsed triangle, the first of another one at the same vertex. */
static size_t source_of(const tangents_plan *p, size_t corner)
{
    uint32_t c = p->vertices.first[corner];
    if (!(p->flags[corner / 3] & TANGENT_COLLAPSED))
        return corner;
    while (c != MESH_NONE && p->flags[c / 3] & TANGENT_COLLAPSED)
        c = p->vertices.next[c];
    return c == MESH_NONE ? corner : c;
}

static void write_corner(const tangents_plan *p, size_t corner, float *tangent, nkw_vec3 *bitangent)
{
    const uint32_t group = p->group[source_of(p, corner)];
    const lane_f64_vec3 axis = {1.0, 0.0, 0.0}, n = lane_f64_vec3_normalize(lane_f64_vec3_from(normal_of(p, corner)));
    const lane_f64_vec3 t = group == MESH_NONE ? axis : lane_f64_vec3_normalize(p->sum[group]);
    const double sign = group != MESH_NONE && p->flags[group / 3] & TANGENT_POSITIVE ? 1.0 : -1.0;
    const nkw_vec3 rounded = lane_vec3_from_f64(t);
    tangent[0] = rounded.x;
    tangent[1] = rounded.y;
    tangent[2] = rounded.z;
    tangent[3] = (float)sign;
    if (bitangent)
        *bitangent = lane_vec3_from_f64(lane_f64_vec3_scale(lane_f64_vec3_cross(n, t), sign));
}

static nkw_result check_surface(const tangents_plan *p, size_t *bad)
{
    for (size_t c = 0; c < 3 * p->mesh->triangle_count; c++) {
        const nkw_vec3 n = normal_of(p, c), uv = texcoord_of(p, c);
        if (!lane_is_finite(n.x) || !lane_is_finite(n.y) || !lane_is_finite(n.z) || !lane_is_finite(uv.x) ||
            !lane_is_finite(uv.y))
            return report(NKW_NOT_FINITE, c / 3, bad);
    }
    return report(NKW_OK, 0, bad);
}

nkw_result nkw_mesh_tangents(const nkw_mesh *mesh, nkw_mesh_surface surface, float *tangents, nkw_vec3 *bitangents,
                             size_t *bad, nkw_work work)
{
    const size_t n = mesh->triangle_count;
    tangents_plan p = {0};
    nkw_result result = nkwi_mesh_check(mesh, bad);
    p.mesh = mesh;
    p.surface = surface;
    if (result == NKW_OK)
        result = check_surface(&p, bad);
    if (result != NKW_OK)
        return result;
    if (!work_fits_each(work, n, NKW_MESH_WORK(1)))
        return NKW_TOO_SMALL;
    lay_out(&p, work.data);
    mesh_join_equal(p.vertices, 3 * n, p.table, hash_vertex, same_vertex, &p);
    for (size_t t = 0; t < n; t++)
        measure_triangle(&p, t);
    find_neighbours(&p);
    find_groups(&p);
    sum_groups(&p);
    for (size_t c = 0; c < 3 * n; c++)
        write_corner(&p, c, tangents + 4 * c, bitangents ? bitangents + c : NULL);
    return NKW_OK;
}
