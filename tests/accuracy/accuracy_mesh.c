/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/mesh.h> against binary128. */
#include "wide.h"
#include "../support/views.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 20000u

/* A fan of triangles about vertex 0, the last beside the first. */
enum { RIM = 6, VERTICES = RIM + 1, NUMBERS = 3 * VERTICES };

static void cone(random_source *r, float *x)
{
    const float height = random_sign(r) * random_log(r, 1e-4f, 3);
    put_vec3(x, random_vec3(r, -10, 10));
    for (int i = 0; i < RIM; i++) {
        const float angle = 1.0471976f * ((float)i + random_between(r, -0.4f, 0.4f)), radius = random_log(r, 0.1f, 10);
        nkw_vec3 p = {radius * nkw_cos(angle), radius * nkw_sin(angle), height + random_between(r, -0.1f, 0.1f)};
        put_vec3(x + 3 * (i + 1), nkw_vec3_add(vec3_at(x), p));
    }
}

static void any(random_source *r, float *x)
{
    for (int i = 0; i < VERTICES; i++)
        put_vec3(x + 3 * i, random_vec3(r, -1, 1));
}

/* The unit normal of triangle i and its angle at vertex 0. */
static wide triangle(const float *x, int i, wide normal[3])
{
    wide p[3], u[3], v[3];
    wide_from(x, p, 3);
    wide_from(x + 3 * (1 + i), u, 3);
    wide_from(x + 3 * (1 + (i + 1) % RIM), v, 3);
    for (int k = 0; k < 3; k++)
        u[k] -= p[k], v[k] -= p[k];
    wide_cross(u, v, normal);
    const wide angle = atan2q(wide_length(normal, 3), wide_dot(u, v, 3));
    wide_normalize(normal, 3);
    return angle;
}

/* The error of the corner of triangle 0 at vertex 0; none where the sum is short, or where the crease is near. */
static double error_of(const float *x, float crease)
{
    uint32_t indices[3 * RIM];
    nkw_vec3 positions[VERTICES], normals[3 * RIM];
    unsigned char memory[NKW_MESH_WORK(RIM) + 16];
    wide own[3], normal[3], sum[3] = {0, 0, 0}, weights = 0;
    for (int i = 0; i < VERTICES; i++)
        positions[i] = vec3_at(x + 3 * i);
    for (uint32_t i = 0; i < RIM; i++)
        indices[3 * i] = 0, indices[3 * i + 1] = 1 + i, indices[3 * i + 2] = 1 + (i + 1) % RIM;
    const nkw_mesh mesh = {positions, VERTICES, indices, RIM};
    const nkw_work work = work_in(memory, sizeof memory);
    if (nkw_mesh_normals(&mesh, crease, normals, NULL, work) != NKW_OK)
        return 0;
    triangle(x, 0, own);
    for (int i = 0; i < RIM; i++) {
        const wide angle = triangle(x, i, normal), cosine = wide_dot(normal, own, 3);
        const wide between = acosq(cosine > 1 ? 1 : cosine < -1 ? -1 : cosine);
        if (fabsq(between - crease) < (wide)1e-5)
            return 0;
        for (int k = 0; between < crease && k < 3; k++)
            sum[k] += angle * normal[k];
        weights += between < crease ? angle : 0;
    }
    if (wide_length(sum, 3) < weights / 2)
        return 0;
    wide_normalize(sum, 3);
    return wide_error(&normals[0].x, sum, 3);
}

static double smooth_error(const float *x)
{
    return error_of(x, 4);
}

static double crease_error(const float *x)
{
    return error_of(x, 0.8f);
}

static const wide_case cases[] = {
    {"nkw_mesh_normals", "cones of 6 triangles, all count", cone, smooth_error, NUMBERS, WIDE_CHECKED},
    {"nkw_mesh_normals", "cones, crease 0.8 rad", cone, crease_error, NUMBERS, WIDE_CHECKED},
    {"nkw_mesh_normals", "any fan, all count", any, smooth_error, NUMBERS, WIDE_CHECKED},
    {"nkw_mesh_normals", "any fan, crease 0.8 rad", any, crease_error, NUMBERS, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("mesh.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
