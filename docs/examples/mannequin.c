/* SPDX-License-Identifier: MIT */
/* The body is made of tubes: rings of vertices around an axis, closed at both ends. */
#include "mannequin.h"

#include <nakawari/scalar.h>
#include <nakawari/vec.h>

const mannequin_bone mannequin_bones[MANNEQUIN_JOINTS] = {
    {"hips", -1, {0, 0.93f, 0}},          {"spine", HIPS, {0, 0.12f, 0}},        {"chest", SPINE, {0, 0.18f, 0}},
    {"neck", CHEST, {0, 0.23f, 0}},       {"head", NECK, {0, 0.09f, 0}},         {"arm.L", CHEST, {0.19f, 0.16f, 0}},
    {"forearm.L", ARM_L, {0.27f, 0, 0}},  {"hand.L", FOREARM_L, {0.25f, 0, 0}},  {"arm.R", CHEST, {-0.19f, 0.16f, 0}},
    {"forearm.R", ARM_R, {-0.27f, 0, 0}}, {"hand.R", FOREARM_R, {-0.25f, 0, 0}}, {"thigh.L", HIPS, {0.1f, -0.04f, 0}},
    {"shin.L", THIGH_L, {0, -0.41f, 0}},  {"foot.L", SHIN_L, {0, -0.41f, 0}},    {"thigh.R", HIPS, {-0.1f, -0.04f, 0}},
    {"shin.R", THIGH_R, {0, -0.41f, 0}},  {"foot.R", SHIN_R, {0, -0.41f, 0}},
};

nkw_vec3 mannequin_place(int joint)
{
    nkw_vec3 at = NKW_VEC3_ZERO;
    for (; joint >= 0; joint = mannequin_bones[joint].parent)
        at = nkw_vec3_add(at, mannequin_bones[joint].translation);
    return at;
}

/* ---- tubes ---- */

enum { AROUND = 12, LINKS = 5 };
static const float tau = 6.28318531f;

/* A ring: how far along the axis, metres, and its radii in the two directions across. */
typedef struct ring {
    float along, across, deep;
} ring;

/* A joint of a tube, and where along the axis it takes over from the one before. */
typedef struct link {
    int joint;
    float from;
} link;

/* The axis begins at `origin`; across x deep = axis, so that faces point outwards. Two influences a vertex. */
typedef struct tube {
    nkw_vec3 origin, axis, across, deep;
    const ring *rings;
    size_t ring_count;
    link links[LINKS];
    size_t link_count;
    float blend; /* metres before and after `from` over which the weights change */
} tube;

/* The weight goes over at each `from` by the smooth step 3 x^2 - 2 x^3. */
static void set_weights(const tube *t, float along, mesh_vertex *v)
{
    size_t k = 0;
    while (k + 1 < t->link_count && along >= t->links[k + 1].from - t->blend)
        k++;
    float x = k ? nkw_clamp((along - t->links[k].from) / (2.0f * t->blend) + 0.5f, 0.0f, 1.0f) : 1.0f;
    float weight = x * x * (3.0f - 2.0f * x);
    v->weights[0] = (uint16_t)(weight * 65535.0f + 0.5f);
    v->joints[0] = (uint16_t)t->links[k].joint;
    v->weights[1] = (uint16_t)(65535 - v->weights[0]);
    v->joints[1] = (uint16_t)(v->weights[1] ? t->links[k - 1].joint : 0);
}

static int add_point(mesh *m, const tube *t, const ring *r, float turn)
{
    nkw_vec3 at = nkw_vec3_add_scaled(t->origin, t->axis, r->along);
    at = nkw_vec3_add_scaled(at, t->across, r->across * nkw_cos(turn));
    at = nkw_vec3_add_scaled(at, t->deep, r->deep * nkw_sin(turn));
    if (!mesh_add_vertex(m, at, NKW_VEC3_ZERO))
        return 0;
    set_weights(t, r->along, &m->vertices[m->vertex_count - 1]);
    return 1;
}

static int add_triangle(mesh *m, size_t a, size_t b, size_t c)
{
    const size_t corner[3] = {a, b, c};
    return mesh_add_face(m, corner, 3);
}

/* Between two rings of AROUND vertices. */
static int add_band(mesh *m, size_t below, size_t above)
{
    for (size_t i = 0; i < AROUND; i++) {
        size_t next = (i + 1) % AROUND;
        if (!add_triangle(m, below + i, below + next, above + next) ||
            !add_triangle(m, below + i, above + next, above + i))
            return 0;
    }
    return 1;
}

/* The first and the last ring are points. */
static int add_tube(mesh *m, const tube *t)
{
    size_t first = m->vertex_count, last = t->ring_count - 1;
    if (!add_point(m, t, &t->rings[0], 0.0f))
        return 0;
    for (size_t r = 1; r < last; r++)
        for (size_t i = 0; i < AROUND; i++)
            if (!add_point(m, t, &t->rings[r], tau * (float)i / AROUND))
                return 0;
    if (!add_point(m, t, &t->rings[last], 0.0f))
        return 0;
    size_t end = m->vertex_count - 1;
    for (size_t r = 1; r + 1 < last; r++)
        if (!add_band(m, first + 1 + (r - 1) * AROUND, first + 1 + r * AROUND))
            return 0;
    for (size_t i = 0; i < AROUND; i++) {
        size_t next = (i + 1) % AROUND;
        if (!add_triangle(m, first, first + 1 + next, first + 1 + i) ||
            !add_triangle(m, end, end - AROUND + i, end - AROUND + next))
            return 0;
    }
    return 1;
}

/* Smooth normals: the sum of the normals of a vertex's faces, each as long as twice the area of its face. */
static void set_normals(mesh *m)
{
    for (size_t f = 0; f < m->face_count; f++) {
        const size_t *c = m->faces[f].corner;
        nkw_vec3 a = m->vertices[c[0]].position, b = m->vertices[c[1]].position, d = m->vertices[c[2]].position;
        nkw_vec3 n = nkw_vec3_cross(nkw_vec3_sub(b, a), nkw_vec3_sub(d, a));
        for (int i = 0; i < 3; i++)
            m->vertices[c[i]].normal = nkw_vec3_add(m->vertices[c[i]].normal, n);
    }
    for (size_t i = 0; i < m->vertex_count; i++)
        m->vertices[i].normal = nkw_vec3_normalize(m->vertices[i].normal);
}

/* ---- the parts ---- */

static const nkw_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};

#define COUNT(array) (sizeof(array) / sizeof *(array))

static int add_torso(mesh *m)
{
    static const ring rings[] = {{0.84f, 0, 0},          {0.85f, 0.09f, 0.06f},  {0.89f, 0.15f, 0.1f},
                                 {0.95f, 0.165f, 0.11f}, {1.02f, 0.15f, 0.1f},   {1.1f, 0.135f, 0.092f},
                                 {1.18f, 0.145f, 0.1f},  {1.27f, 0.17f, 0.112f}, {1.36f, 0.185f, 0.11f},
                                 {1.42f, 0.16f, 0.09f},  {1.455f, 0.09f, 0.07f}, {1.48f, 0.06f, 0.056f},
                                 {1.55f, 0.05f, 0.05f},  {1.57f, 0, 0}};
    const nkw_vec3 back = nkw_vec3_scale(z, -1.0f);
    const tube t = {NKW_VEC3_ZERO,
                    y,
                    x,
                    back,
                    rings,
                    COUNT(rings),
                    {{HIPS, 0}, {SPINE, 1.05f}, {CHEST, 1.23f}, {NECK, 1.46f}, {HEAD, 1.55f}},
                    5,
                    0.045f};
    return add_tube(m, &t);
}

/* side: 1 the left one, -1 the right one. Joints: arm, forearm, hand. */
static int add_arm(mesh *m, int arm, float side)
{
    static const ring rings[] = {{-0.07f, 0, 0},          {-0.05f, 0.05f, 0.05f},  {0, 0.065f, 0.062f},
                                 {0.06f, 0.058f, 0.055f}, {0.15f, 0.048f, 0.047f}, {0.23f, 0.042f, 0.042f},
                                 {0.27f, 0.043f, 0.043f}, {0.31f, 0.041f, 0.041f}, {0.4f, 0.036f, 0.036f},
                                 {0.49f, 0.03f, 0.028f},  {0.52f, 0.031f, 0.026f}, {0.56f, 0.042f, 0.024f},
                                 {0.62f, 0.04f, 0.02f},   {0.68f, 0.026f, 0.016f}, {0.7f, 0, 0}};
    const nkw_vec3 axis = nkw_vec3_scale(x, side);
    const tube t = {mannequin_place(arm),
                    axis,
                    side > 0 ? y : z,
                    side > 0 ? z : y,
                    rings,
                    COUNT(rings),
                    {{CHEST, -1}, {arm, -0.01f}, {arm + 1, 0.27f}, {arm + 2, 0.52f}},
                    4,
                    0.04f};
    return add_tube(m, &t);
}

/* Joints: thigh, shin, foot. */
static int add_leg(mesh *m, int thigh)
{
    static const ring rings[] = {{-0.07f, 0, 0},
                                 {-0.05f, 0.06f, 0.06f},
                                 {0.02f, 0.085f, 0.088f},
                                 {0.12f, 0.082f, 0.086f},
                                 {0.25f, 0.068f, 0.072f},
                                 {0.36f, 0.056f, 0.06f},
                                 {0.41f, 0.054f, 0.058f},
                                 {0.46f, 0.052f, 0.055f},
                                 {0.55f, 0.053f, 0.057f},
                                 {0.68f, 0.042f, 0.044f},
                                 {0.78f, 0.036f, 0.038f},
                                 {0.83f, 0.036f, 0.04f},
                                 {0.85f, 0, 0}};
    const tube t = {mannequin_place(thigh),
                    nkw_vec3_scale(y, -1.0f),
                    x,
                    z,
                    rings,
                    COUNT(rings),
                    {{HIPS, -1}, {thigh, 0}, {thigh + 1, 0.41f}, {thigh + 2, 0.81f}},
                    4,
                    0.05f};
    return add_tube(m, &t);
}

static int add_shoe(mesh *m, int foot)
{
    static const ring rings[] = {{-0.075f, 0, 0},        {-0.07f, 0.03f, 0.03f},  {-0.05f, 0.045f, 0.045f},
                                 {0, 0.048f, 0.05f},     {0.06f, 0.048f, 0.042f}, {0.12f, 0.05f, 0.034f},
                                 {0.16f, 0.04f, 0.026f}, {0.175f, 0.02f, 0.014f}, {0.18f, 0, 0}};
    const tube t = {
        nkw_vec3_add_scaled(mannequin_place(foot), y, -0.02f), z, x, y, rings, COUNT(rings), {{foot, -1}}, 1, 0.01f};
    return add_tube(m, &t);
}

/* An ellipsoid of the head, the tube's axis upwards. */
static int add_ball(mesh *m, nkw_vec3 centre, nkw_vec3 radius)
{
    enum { RINGS = 11 };
    ring rings[RINGS];
    for (int i = 0; i < RINGS; i++) {
        float turn = 0.5f * tau * (float)i / (RINGS - 1), s = nkw_sin(turn);
        rings[i].along = -radius.y * nkw_cos(turn);
        rings[i].across = radius.z * s;
        rings[i].deep = radius.x * s;
    }
    const tube t = {centre, y, z, x, rings, RINGS, {{HEAD, -1}}, 1, 0.01f};
    return add_tube(m, &t);
}

int mannequin_mesh(mesh *m, enum mannequin_part part)
{
    static const nkw_vec3 face = {0.083f, 0.125f, 0.098f}, eye = {0.012f, 0.018f, 0.01f};
    const nkw_vec3 centre = nkw_vec3_add_scaled(mannequin_place(HEAD), y, 0.1f);
    const mesh empty = {NULL, NULL, 0, 0, 0, 0};
    int done = 0;
    *m = empty;
    if (part == PART_BODY)
        done = add_torso(m) && add_arm(m, ARM_L, 1.0f) && add_arm(m, ARM_R, -1.0f) && add_leg(m, THIGH_L) &&
               add_leg(m, THIGH_R);
    else if (part == PART_SHOES)
        done = add_shoe(m, FOOT_L) && add_shoe(m, FOOT_R);
    else if (part == PART_FACE)
        done = add_ball(m, centre, face);
    else {
        const nkw_vec3 left = {0.032f, 0.018f, 0.09f}, right = {-0.032f, 0.018f, 0.09f};
        done = add_ball(m, nkw_vec3_add(centre, left), eye) && add_ball(m, nkw_vec3_add(centre, right), eye);
    }
    set_normals(m);
    return done;
}

/* Cheeks: outwards by up to 3 cm, most at two places of the lower face. */
void mannequin_puff(const mesh *face, nkw_vec3 *moves)
{
    const nkw_vec3 centre = nkw_vec3_add_scaled(mannequin_place(HEAD), y, 0.1f);
    for (size_t i = 0; i < face->vertex_count; i++) {
        nkw_vec3 p = nkw_vec3_sub(face->vertices[i].position, centre);
        nkw_vec3 cheek = {p.x < 0.0f ? -0.055f : 0.055f, -0.04f, 0.06f};
        float far = nkw_vec3_length(nkw_vec3_sub(p, cheek)) / 0.07f, near = nkw_clamp(1.0f - far, 0.0f, 1.0f);
        moves[i] = nkw_vec3_scale(face->vertices[i].normal, 0.03f * near * near * (3.0f - 2.0f * near));
    }
}
