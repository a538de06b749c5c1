/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/skin.h> against binary128: one vertex and its joints, drawn from its seed. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 15000u
#define MOST    8

static const nkw_skin_options usual = {0, 0, 0}, inverse = {0, 1, 0}, divided = {0, 0, 1};

/* Of the position, of the normal's direction, of the normal's length. */
typedef enum part { POSITION, NORMAL, LENGTH } part;

typedef struct vertex {
    nkw_mat4 matrix[MOST];
    nkw_dual_quat dual[MOST];
    float weight[MOST];
    unsigned char joint[MOST];
    nkw_vec3 position, normal, moved, turned;
} vertex;

/* `spread` radians between the joints' rotations, scales low .. 1 / low. */
static vertex draw_vertex(const float *x, int influences, float low, float spread)
{
    random_source r = wide_source(x);
    vertex v;
    nkw_quat middle = random_unit_quat(&r);
    for (int e = 0; e < influences; e++) {
        nkw_vec3 scale = {random_log(&r, low, 1.0f / low), random_log(&r, low, 1.0f / low),
                          random_log(&r, low, 1.0f / low)};
        nkw_trs trs = {random_vec3(&r, -2.0f, 2.0f), random_unit_near(&r, middle, 0.5f * spread * random_unit(&r)),
                       scale};
        v.matrix[e] = nkw_mat4_from_trs(&trs);
        v.dual[e] = nkw_dual_quat_from_rigid(nkw_quat_scale(trs.rotation, random_sign(&r)), trs.translation);
        v.weight[e] = random_unit(&r) + 0.01f;
        v.joint[e] = (unsigned char)e;
    }
    nkw_skin_view in = {v.weight, 0, NKW_SKIN_F32};
    nkw_skin_span out = {v.weight, 0, NKW_SKIN_F32};
    nkw_skin_normalize_weights(in, (size_t)influences, 1, out);
    v.position = random_vec3(&r, -2.0f, 2.0f);
    v.normal = random_direction(&r);
    return v;
}

static void skin(vertex *v, int influences, int is_dual, nkw_skin_options options)
{
    size_t joint_count = (size_t)influences;
    nkw_skin s = {1, joint_count, {v->joint, 0, NKW_SKIN_U8}, {v->weight, 0, NKW_SKIN_F32}};
    nkw_skin_palette palette = {
        {v->matrix, joint_count, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, options};
    nkw_palette_view duals = {v->dual, joint_count, NKW_PALETTE_DUAL_QUAT};
    nkw_vertices_view in = {{&v->position, 0}, {&v->normal, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{&v->moved, 0}, {&v->turned, 0}, {NULL, 0}, {NULL, 0}};
    if (is_dual)
        nkw_skin_dual_quat(&s, duals, in, out);
    else
        nkw_skin_linear(&s, &palette, in, out);
}

static void transform(const wide m[16], const float p[3], wide w, wide out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i] * w;
}

/* The cofactors of the block of m, det (m^-1)^T, as a matrix; its direction is that of the inverse transpose. */
static void cofactors_of(const wide m[16], wide out[16])
{
    wide det;
    for (int i = 0; i < 16; i++)
        out[i] = 0;
    for (int c = 0; c < 3; c++)
        for (int r = 0; r < 3; r++) {
            const int c1 = 4 * ((c + 1) % 3), c2 = 4 * ((c + 2) % 3), r1 = (r + 1) % 3, r2 = (r + 2) % 3;
            out[4 * c + r] = m[c1 + r1] * m[c2 + r2] - m[c1 + r2] * m[c2 + r1];
        }
    det = m[0] * out[0] + m[1] * out[1] + m[2] * out[2];
    for (int i = 0; i < 16; i++)
        out[i] = det < 0 ? -out[i] : out[i];
}

static double judge(const vertex *v, const wide m[16], wide magnitude, part judged)
{
    float p[3], n[3], moved[3], turned[3];
    wide exact[3];
    put_vec3(p, v->position);
    put_vec3(n, v->normal);
    put_vec3(moved, v->moved);
    put_vec3(turned, v->turned);
    if (judged == LENGTH)
        return wide_unit_error(turned, 3);
    transform(m, judged == POSITION ? p : n, judged == POSITION, exact);
    if (judged == POSITION)
        return wide_error_of(moved, exact, 3, magnitude);
    wide_normalize(exact, 3);
    return wide_error(turned, exact, 3);
}

/* Positions: of the sum of weight |matrix| |(p, 1)|, Frobenius norms of the first three rows. */
static double linear_error(const float *x, int influences, float low, part judged, nkw_skin_options options)
{
    vertex v = draw_vertex(x, influences, low, 1.0f);
    float p[4] = {v.position.x, v.position.y, v.position.z, 1.0f};
    wide sum[16] = {0}, normal[16], m[16], point[4], magnitude = 0;
    skin(&v, influences, 0, options);
    wide_from(p, point, 4);
    for (int e = 0; e < influences; e++) {
        wide_from(v.matrix[e].m, m, 16);
        m[15] = 0;
        magnitude += v.weight[e] * wide_length(m, 16) * wide_length(point, 4);
        for (int i = 0; i < 16; i++)
            sum[i] += v.weight[e] * m[i];
    }
    cofactors_of(sum, normal);
    return judge(&v, options.inverse_normals && judged == NORMAL ? normal : sum, magnitude, judged);
}

static void add_dual(const nkw_dual_quat *d, const nkw_quat side, wide weight, wide real[4], wide dual[4])
{
    float q[4], e[4];
    wide w = nkw_quat_dot(d->real, side) < 0.0f ? -weight : weight;
    put_quat(q, d->real);
    put_quat(e, d->dual);
    for (int i = 0; i < 4; i++) {
        real[i] += w * q[i];
        dual[i] += w * e[i];
    }
}

/* The rotation of the blend, and 2 dual real* / |real|^2. */
static void motion_of(const wide real[4], const wide dual[4], wide m[16])
{
    wide block[9], conjugate[4] = {-real[0], -real[1], -real[2], real[3]}, t[4], n2 = wide_dot(real, real, 4);
    wide_mat3_from_quat(real, block);
    wide_quat_mul(dual, conjugate, t);
    for (int i = 0; i < 16; i++)
        m[i] = i % 4 == 3 ? 0 : i < 12 ? block[i / 4 * 3 + i % 4] : 2 * t[i - 12] / n2;
}

/* Positions: of |p| + the sum of weight |translation|. */
static double dual_error(const float *x, int influences, part judged)
{
    vertex v = draw_vertex(x, influences, 1.0f, 1.0f);
    wide real[4] = {0}, dual[4] = {0}, m[16], point[3], magnitude;
    float p[3];
    int most = 0;
    skin(&v, influences, 1, usual);
    for (int e = 1; e < influences; e++)
        most = v.weight[e] > v.weight[most] ? e : most;
    put_vec3(p, v.position);
    wide_from(p, point, 3);
    magnitude = wide_length(point, 3);
    for (int e = 0; e < influences; e++) {
        wide t[3];
        wide_from(v.matrix[e].m + 12, t, 3);
        magnitude += v.weight[e] * wide_length(t, 3);
        add_dual(&v.dual[e], v.dual[most].real, v.weight[e], real, dual);
    }
    motion_of(real, dual, m);
    return judge(&v, m, magnitude, judged);
}

#define LINEAR(name, influences, low, judged, options)                                                                 \
    static double name(const float *x)                                                                                 \
    {                                                                                                                  \
        return linear_error(x, influences, low, judged, options);                                                      \
    }
#define DUAL(name, influences, judged)                                                                                 \
    static double name(const float *x)                                                                                 \
    {                                                                                                                  \
        return dual_error(x, influences, judged);                                                                      \
    }

LINEAR(linear_1, 1, 0.5f, POSITION, usual)
LINEAR(linear_4, 4, 0.5f, POSITION, usual)
LINEAR(linear_8, 8, 0.5f, POSITION, usual)
LINEAR(linear_normal, 4, 1.0f, NORMAL, usual)
LINEAR(linear_normal_8, 8, 1.0f, NORMAL, usual)
LINEAR(linear_length, 8, 0.5f, LENGTH, usual)
LINEAR(inverse_1, 1, 0.5f, NORMAL, inverse)
LINEAR(inverse_normal, 4, 1.0f, NORMAL, inverse)
LINEAR(inverse_normal_8, 8, 1.0f, NORMAL, inverse)
LINEAR(inverse_scaled, 4, 0.5f, NORMAL, inverse)
LINEAR(inverse_length, 8, 0.5f, LENGTH, inverse)
LINEAR(divided_4, 4, 0.5f, POSITION, divided)
LINEAR(divided_8, 8, 0.5f, POSITION, divided)
DUAL(dual_1, 1, POSITION)
DUAL(dual_4, 4, POSITION)
DUAL(dual_8, 8, POSITION)
DUAL(dual_normal, 4, NORMAL)
DUAL(dual_normal_8, 8, NORMAL)
DUAL(dual_length, 8, LENGTH)

#define MATRICES "nkw_skin_linear"
#define DUALS    "nkw_skin_dual_quat"

static const wide_case cases[] = {
    {MATRICES, "positions, 1 influence", wide_seed, linear_1, 2, WIDE_CHECKED},
    {MATRICES, "positions, 4 influences", wide_seed, linear_4, 2, WIDE_CHECKED},
    {MATRICES, "positions, 8 influences", wide_seed, linear_8, 2, WIDE_CHECKED},
    {MATRICES, "normals, 4 influences, rigid", wide_seed, linear_normal, 2, WIDE_CHECKED},
    {MATRICES, "normals, 8 influences, rigid", wide_seed, linear_normal_8, 2, WIDE_CHECKED},
    {MATRICES, "length of normals, 8 influences", wide_seed, linear_length, 2, WIDE_CHECKED},
    {MATRICES, "inverse normals, 1 influence, scales 0.5 to 2", wide_seed, inverse_1, 2, WIDE_CHECKED},
    {MATRICES, "inverse normals, 4 influences, rigid", wide_seed, inverse_normal, 2, WIDE_CHECKED},
    {MATRICES, "inverse normals, 8 influences, rigid", wide_seed, inverse_normal_8, 2, WIDE_CHECKED},
    {MATRICES, "inverse normals, 4 influences, scales 0.5 to 2", wide_seed, inverse_scaled, 2, WIDE_CHECKED},
    {MATRICES, "length of inverse normals, 8 influences", wide_seed, inverse_length, 2, WIDE_CHECKED},
    {MATRICES, "positions divided, 4 influences", wide_seed, divided_4, 2, WIDE_CHECKED},
    {MATRICES, "positions divided, 8 influences", wide_seed, divided_8, 2, WIDE_CHECKED},
    {DUALS, "positions, 1 influence", wide_seed, dual_1, 2, WIDE_CHECKED},
    {DUALS, "positions, 4 influences", wide_seed, dual_4, 2, WIDE_CHECKED},
    {DUALS, "positions, 8 influences", wide_seed, dual_8, 2, WIDE_CHECKED},
    {DUALS, "normals, 4 influences", wide_seed, dual_normal, 2, WIDE_CHECKED},
    {DUALS, "normals, 8 influences", wide_seed, dual_normal_8, 2, WIDE_CHECKED},
    {DUALS, "length of normals, 8 influences", wide_seed, dual_length, 2, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("skin.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
