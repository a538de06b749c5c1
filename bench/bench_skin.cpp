/* SPDX-License-Identifier: MIT */
/*
 * Vertices moved by 67 joints. An element is a vertex. Neighbouring vertices hang on neighbouring joints, as in meshes
 * that were ordered for a cache.
 */
#include <cmath>
#include <memory>

#include "bench.h"
#include "peers.h"
#include "random.h"
#include "truth.h"

using namespace bench;

static const size_t joints = 67, most = NKW_SKIN_INFLUENCES;
static const std::vector<size_t> vertices = {64, 1024, 65536};

/* Rotations within a quarter turn of one another, so that no blend of directions comes near to zero. */
alignas(64) static nkw_mat4 palette[joints];
static nkw_mat3 normals[joints];
static nkw_dual_quat duals[joints];

/* Position and normal, as in a vertex buffer. */
struct vertex {
    nkw_vec3 at, normal;
};
static array<vertex> mesh;
static std::vector<nkw_vec3> positions, directions;

/* Joints and weights of `influences` each, in every format. */
struct weighted {
    size_t influences;
    std::vector<uint16_t> joint;
    std::vector<float> weight;
    std::vector<uint8_t> weight8;
    std::vector<uint16_t> weight16;
};

static void draw()
{
    random_source r = random_from(64);
    for (size_t j = 0; j < joints; j++) {
        nkw_quat q = random_near(&r, unit_a[0], random_between(&r, 0, 0.4f));
        nkw_mat3 m = nkw_mat3_from_quat(q);
        palette[j] = nkw_mat4_from_mat3(&m, random_vec3(&r, -1, 1));
        normals[j] = nkw_mat3_normal(&m);
        duals[j] = nkw_dual_quat_from_mat4(&palette[j]);
    }
    for (size_t i = 0; i < pool; i++) {
        mesh.set(i, {point[0][i], random_direction(&r)});
        positions.push_back(mesh[i].at);
        directions.push_back(mesh[i].normal);
    }
}

static std::shared_ptr<weighted> draw_weights(size_t influences)
{
    auto w = std::make_shared<weighted>();
    random_source r = random_from(influences);
    size_t n = pool * influences;
    w->influences = influences;
    w->weight.resize(n), w->weight8.resize(n), w->weight16.resize(n);
    for (size_t i = 0; i < n; i++) {
        size_t vertex = i / influences, k = i % influences;
        w->joint.push_back(static_cast<uint16_t>((vertex / 32 * 5 + random_bits(&r) % 2 + 2 * k) % joints));
        w->weight[i] = random_between(&r, 0.1f, 1);
    }
    nkw_skin_view from = {w->weight.data(), 0, NKW_SKIN_F32};
    nkw_skin_normalize_weights(from, influences, pool, {w->weight8.data(), 0, NKW_SKIN_U8});
    nkw_skin_normalize_weights(from, influences, pool, {w->weight16.data(), 0, NKW_SKIN_U16});
    nkw_skin_normalize_weights(from, influences, pool, {w->weight.data(), 0, NKW_SKIN_F32});
    return w;
}

/* ---- what is right ---- */

/* w M of vertex i, in binary64, three columns and the translation, three rows each. */
static void truth_blend(const weighted &w, const double *weight, size_t i, double *m)
{
    std::fill_n(m, 12, 0.0);
    for (size_t k = 0; k < w.influences; k++)
        for (size_t c = 0; c < 12; c++)
            m[c] += weight[k] * static_cast<double>(palette[w.joint[i * w.influences + k]].m[c / 3 * 4 + c % 3]);
}

static void truth_vertex(const double *m, size_t i, bool unit, double *out)
{
    const float *p = &positions[i].x, *n = &directions[i].x;
    double length = 0;
    for (size_t r = 0; r < 3; r++) {
        out[r] = m[9 + r];
        out[3 + r] = 0;
        for (size_t c = 0; c < 3; c++) {
            out[r] += m[3 * c + r] * static_cast<double>(p[c]);
            out[3 + r] += m[3 * c + r] * static_cast<double>(n[c]);
        }
        length += out[3 + r] * out[3 + r];
    }
    for (size_t r = 3; r < 6; r++)
        out[r] /= unit ? std::sqrt(length) : 1;
}

enum class kind { f32, u8, u16 };

static double weight_of(const weighted &w, kind sort, size_t i)
{
    return sort == kind::f32  ? static_cast<double>(w.weight[i])
           : sort == kind::u8 ? w.weight8[i] / 255.0
                              : w.weight16[i] / 65535.0;
}

static reference blended(std::shared_ptr<weighted> w, kind sort, bool unit, size_t width)
{
    return [=](size_t i, double *out) {
        double weight[most], m[12], both[6];
        for (size_t k = 0; k < w->influences; k++)
            weight[k] = weight_of(*w, sort, i * w->influences + k);
        truth_blend(*w, weight, i, m);
        truth_vertex(m, i, unit, both);
        std::copy_n(both, width, out);
    };
}

/* The normal by the cofactors of the block, det (M^-1)^T; no matrix of the palette mirrors. */
static void truth_inverse(const weighted &w, size_t i, double *out)
{
    double weight[most], m[12], cofactors[12] = {};
    for (size_t k = 0; k < w.influences; k++)
        weight[k] = weight_of(w, kind::f32, i * w.influences + k);
    truth_blend(w, weight, i, m);
    for (size_t c = 0; c < 3; c++)
        for (size_t r = 0; r < 3; r++) {
            const double *p = m + 3 * ((c + 1) % 3), *q = m + 3 * ((c + 2) % 3);
            cofactors[3 * c + r] = p[(r + 1) % 3] * q[(r + 2) % 3] - p[(r + 2) % 3] * q[(r + 1) % 3];
        }
    double position[6];
    truth_vertex(m, i, true, position);
    truth_vertex(cofactors, i, true, out);
    std::copy_n(position, 3, out);
}

/* ---- the library ---- */

static nkw_skin skin_of(const weighted &w, kind sort, size_t n)
{
    nkw_skin_view weights = {sort == kind::f32  ? static_cast<const void *>(w.weight.data())
                             : sort == kind::u8 ? static_cast<const void *>(w.weight8.data())
                                                : static_cast<const void *>(w.weight16.data()),
                             0,
                             sort == kind::f32  ? NKW_SKIN_F32
                             : sort == kind::u8 ? NKW_SKIN_U8
                                                : NKW_SKIN_U16};
    return {n, w.influences, {w.joint.data(), 0, NKW_SKIN_U16}, weights};
}

/* Where the vectors lie, of the mesh and of the answer. */
struct streams {
    nkw_vertices_view in;
    nkw_vertices_span out;
};

static streams interleaved()
{
    char *to = reinterpret_cast<char *>(answer.at);
    const char *from = reinterpret_cast<const char *>(mesh.at);
    return {{{from, 24}, {from + 12, 24}, {}, {}}, {{to, 24}, {to + 12, 24}, {}, {}}};
}

static std::vector<nkw_vec3> moved, turned;

static streams separate(bool directed)
{
    moved.resize(pool), turned.resize(pool);
    streams s = {{{positions.data(), 0}, {}, {}, {}}, {{moved.data(), 0}, {}, {}, {}}};
    if (directed)
        s.in.normals = {directions.data(), 0}, s.out.normals = {turned.data(), 0};
    return s;
}

static void show_separate(size_t n, bool directed)
{
    nkw_vec3 *out = reinterpret_cast<nkw_vec3 *>(answer.at);
    for (size_t i = 0; i < n; i++) {
        out[directed ? 2 * i : i] = moved[i];
        if (directed)
            out[2 * i + 1] = turned[i];
    }
}

static nkw_skin_palette palette_of(const nkw_mat3 *normal_matrices, bool raw)
{
    return {{palette, joints, NKW_PALETTE_MAT4}, {normal_matrices, joints, NKW_PALETTE_NORMAL_MAT3}, {raw, 0, 0}};
}

static void own(const operation &all, std::shared_ptr<weighted> w, kind sort, bool raw)
{
    bool directed = all.width == 6;
    nkw_skin_palette p = palette_of(nullptr, raw);
    for (size_t n : all.sizes) {
        operation op = all;
        op.sizes = {n};
        nkw_skin skin = skin_of(*w, sort, n);
        if (directed)
            whole(op, "nkw interleaved", layout::structs, [=] {
                streams s = interleaved();
                nkw_skin_linear(&skin, &p, s.in, s.out);
            });
        whole(
            op, "nkw separate", layout::structs,
            [=] {
                streams s = separate(directed);
                nkw_skin_linear(&skin, &p, s.in, s.out);
            },
            [=] { show_separate(n, directed); });
    }
}

/* ---- the peers: interleaved vertices, or positions alone ---- */

/* f(i) gives vertex i moved. */
template <class F> static void peer(const operation &all, const char *who, F f)
{
    for (size_t n : all.sizes) {
        operation op = all;
        op.sizes = {n};
        whole(op, who, layout::structs, [=] {
            auto *out = reinterpret_cast<decltype(f(size_t{0})) *>(answer.at);
            for (size_t i = 0; i < n; i++)
                out[i] = f(i);
        });
    }
}

/* In C, without a library: four influences or any, twelve sums. */
static vertex loop_vertex(const weighted &w, size_t i, bool unit)
{
    float m[12] = {0};
    for (size_t k = 0; k < w.influences; k++) {
        float weight = w.weight[i * w.influences + k];
        const float *p = palette[w.joint[i * w.influences + k]].m;
        for (size_t c = 0; c < 12; c++)
            m[c] += weight * p[c / 3 * 4 + c % 3];
    }
    nkw_vec3 p = mesh[i].at, n = mesh[i].normal;
    vertex v = {{m[0] * p.x + m[3] * p.y + m[6] * p.z + m[9], m[1] * p.x + m[4] * p.y + m[7] * p.z + m[10],
                 m[2] * p.x + m[5] * p.y + m[8] * p.z + m[11]},
                {m[0] * n.x + m[3] * n.y + m[6] * n.z, m[1] * n.x + m[4] * n.y + m[7] * n.z,
                 m[2] * n.x + m[5] * n.y + m[8] * n.z}};
    float s = unit ? 1 / sqrtf(v.normal.x * v.normal.x + v.normal.y * v.normal.y + v.normal.z * v.normal.z) : 1;
    v.normal = {s * v.normal.x, s * v.normal.y, s * v.normal.z};
    return v;
}

#ifdef BENCH_GLM
static glm::mat4 glm_blend(const weighted &w, size_t i)
{
    const glm::mat4 *p = reinterpret_cast<const glm::mat4 *>(palette);
    glm::mat4 m(0.0f);
    for (size_t k = 0; k < w.influences; k++)
        m += w.weight[i * w.influences + k] * p[w.joint[i * w.influences + k]];
    return m;
}

struct glm_vertex {
    glm::vec3 at, normal;
};

static glm_vertex glm_moved(const weighted &w, size_t i, bool unit)
{
    const glm_vertex &v = as<glm_vertex>(mesh)[i];
    glm::mat4 m = glm_blend(w, i);
    glm::vec3 n = glm::mat3(m) * v.normal;
    return {glm::vec3(m * glm::vec4(v.at, 1.0f)), unit ? glm::normalize(n) : n};
}
#endif

#ifdef BENCH_CGLM
static vertex cglm_moved(const weighted &w, size_t i, bool unit)
{
    vertex v = mesh[i], out;
    cg::mat m = {GLM_MAT4_ZERO_INIT};
    for (size_t k = 0; k < w.influences; k++) {
        cg::mat p;
        memcpy(p.m, palette[w.joint[i * w.influences + k]].m, sizeof p.m);
        for (size_t c = 0; c < 4; c++)
            glm_vec4_muladds(p.m[c], w.weight[i * w.influences + k], m.m[c]);
    }
    glm_mat4_mulv3(m.m, &v.at.x, 1.0f, &out.at.x);
    glm_mat4_mulv3(m.m, &v.normal.x, 0.0f, &out.normal.x);
    if (unit)
        glm_vec3_normalize(&out.normal.x);
    return out;
}
#endif

#ifdef BENCH_EIGEN
static vertex eigen_moved(const weighted &w, size_t i, bool unit)
{
    const Eigen::Matrix4f *p = reinterpret_cast<const Eigen::Matrix4f *>(palette);
    Eigen::Matrix4f m = Eigen::Matrix4f::Zero();
    for (size_t k = 0; k < w.influences; k++)
        m += w.weight[i * w.influences + k] * p[w.joint[i * w.influences + k]];
    vertex v = mesh[i], out;
    Eigen::Map<const Eigen::Vector3f> at(&v.at.x), normal(&v.normal.x);
    Eigen::Map<Eigen::Vector3f> to(&out.at.x), turned_to(&out.normal.x);
    to = m.topLeftCorner<3, 3>() * at + m.topRightCorner<3, 1>();
    turned_to = m.topLeftCorner<3, 3>() * normal;
    if (unit)
        turned_to.normalize();
    return out;
}
#endif

/* Positions in one pass and normals in another: the blend of the matrices twice. It has won nowhere. */
static void two_passes(const operation &all, std::shared_ptr<weighted> w)
{
    for (size_t n : all.sizes) {
        operation op = all;
        op.sizes = {n};
        nkw_skin skin = skin_of(*w, kind::f32, n);
        whole(op, "nkw two passes", layout::structs, [=] {
            nkw_skin_palette p = palette_of(nullptr, false);
            streams first = interleaved(), second = first;
            first.in.normals = second.in.positions = {};
            nkw_skin_linear(&skin, &p, first.in, first.out);
            nkw_skin_linear(&skin, &p, second.in, second.out);
        });
    }
}

/* The ways to the positions as tangents. */
static void with_tangents(std::shared_ptr<weighted> w)
{
    operation op = {"skin", "4, tangents too", 6, 96, 180, blended(w, kind::f32, true, 6), 16};
    for (size_t n : vertices) {
        op.sizes = {n};
        nkw_skin skin = skin_of(*w, kind::f32, n);
        whole(op, "nkw interleaved", layout::structs, [=] {
            static std::vector<nkw_vec3> tangents(pool);
            nkw_skin_palette p = palette_of(nullptr, false);
            streams s = interleaved();
            s.in.tangents = {positions.data(), 0}, s.out.tangents = {tangents.data(), 0};
            nkw_skin_linear(&skin, &p, s.in, s.out);
        });
#ifdef BENCH_GLM
        whole(op, "glm", layout::structs, [=] {
            static std::vector<glm::vec3> tangents(pool);
            glm_vertex *out = reinterpret_cast<glm_vertex *>(answer.at);
            for (size_t i = 0; i < n; i++) {
                const glm_vertex &v = as<glm_vertex>(mesh)[i];
                glm::mat4 m = glm_blend(*w, i);
                out[i] = {glm::vec3(m * glm::vec4(v.at, 1.0f)), glm::normalize(glm::mat3(m) * v.normal)};
                tangents[i] = glm::normalize(glm::mat3(m) * glm::vec3(positions[i].x, positions[i].y, positions[i].z));
            }
        });
#endif
    }
}

static void linear(const std::string &name, std::shared_ptr<weighted> w, bool raw)
{
    double k = static_cast<double>(w->influences);
    operation op = {"skin", name, 6, 48 + 6 * k, 24 * k + 42, blended(w, kind::f32, !raw, 6), 16};
    op.sizes = vertices;
    own(op, w, kind::f32, raw);
    if (w->influences == 4 && !raw)
        two_passes(op, w);
    peer(op, "loop", [=](size_t i) { return loop_vertex(*w, i, !raw); });
#ifdef BENCH_CGLM
    peer(op, "cglm", [=](size_t i) { return cglm_moved(*w, i, !raw); });
#endif
#ifdef BENCH_GLM
    peer(op, "glm", [=](size_t i) { return glm_moved(*w, i, !raw); });
#endif
#ifdef BENCH_EIGEN
    peer(op, "Eigen", [=](size_t i) { return eigen_moved(*w, i, !raw); });
#endif
}

static void positions_alone(std::shared_ptr<weighted> w)
{
    operation op = {"skin", "4, positions alone", 3, 48, 114, blended(w, kind::f32, true, 3), 16};
    op.sizes = vertices;
    own(op, w, kind::f32, false);
    peer(op, "loop", [=](size_t i) { return loop_vertex(*w, i, false).at; });
#ifdef BENCH_GLM
    peer(op, "glm", [=](size_t i) { return glm::vec3(glm_blend(*w, i) * glm::vec4(as<glm_vertex>(mesh)[i].at, 1)); });
#endif
}

/* Weights in whole numbers; and normals by matrices of their own. The peers would be those of floats. */
static void formats(std::shared_ptr<weighted> w)
{
    operation op = {"skin", "4, weights of 8 bits", 6, 60, 142, blended(w, kind::u8, true, 6), 16};
    op.sizes = vertices;
    own(op, w, kind::u8, false);
    op.name = "4, weights of 16 bits", op.bytes = 64;
    op.truth = blended(w, kind::u16, true, 6);
    own(op, w, kind::u16, false);
    op.name = "4, normal matrices", op.bytes = 72, op.flops = 210;
    op.truth = blended(w, kind::f32, true, 6);
    for (size_t n : vertices) {
        operation one = op;
        one.sizes = {n};
        whole(one, "nkw interleaved", layout::structs, [=] {
            nkw_skin_palette p = palette_of(normals, false);
            nkw_skin skin = skin_of(*w, kind::f32, n);
            streams s = interleaved();
            nkw_skin_linear(&skin, &p, s.in, s.out);
        });
    }
}

static void inverse_normals(std::shared_ptr<weighted> w)
{
    operation op = {"skin", "4, inverse normals", 6, 72, 182, [=](size_t i, double *out) { truth_inverse(*w, i, out); },
                    16};
    for (size_t n : vertices) {
        op.sizes = {n};
        whole(op, "nkw interleaved", layout::structs, [=] {
            nkw_skin_palette p = palette_of(nullptr, false);
            p.options.inverse_normals = 1;
            nkw_skin skin = skin_of(*w, kind::f32, n);
            streams s = interleaved();
            nkw_skin_linear(&skin, &p, s.in, s.out);
        });
    }
}

/* ---- dual quaternions ---- */

static void truth_dual(const weighted &w, size_t i, double *out)
{
    double sum[8] = {0}, m[12];
    size_t first = i * w.influences, largest = first;
    for (size_t k = first; k < first + w.influences; k++)
        largest = w.weight[k] > w.weight[largest] ? k : largest;
    for (size_t k = first; k < first + w.influences; k++) {
        const nkw_dual_quat &d = duals[w.joint[k]];
        double side = truth::dot(truth::quat(duals[w.joint[largest]].real), truth::quat(d.real)) < 0 ? -1 : 1;
        for (size_t c = 0; c < 8; c++)
            sum[c] += side * static_cast<double>(w.weight[k]) *
                      static_cast<double>(c < 4 ? (&d.real.x)[c] : (&d.dual.x)[c - 4]);
    }
    truth::quat real(sum[0], sum[1], sum[2], sum[3]), dual(sum[4], sum[5], sum[6], sum[7]);
    double length = std::sqrt(truth::dot(real, real));
    real = truth::unit(real);
    truth::quat move =
        truth::mul(truth::sum(dual, 2 / length, dual, 0), truth::quat(-real.x, -real.y, -real.z, real.w));
    const double one[3] = {1, 1, 1};
    truth::rotation(real, one, m, 3);
    m[9] = move.x, m[10] = move.y, m[11] = move.z;
    truth_vertex(m, i, true, out);
}

#ifdef BENCH_GLM
static glm_vertex glm_dual(const weighted &w, size_t i)
{
    const glm::quat *d = reinterpret_cast<const glm::quat *>(duals);
    size_t first = i * w.influences, largest = first;
    for (size_t k = first; k < first + w.influences; k++)
        largest = w.weight[k] > w.weight[largest] ? k : largest;
    glm::quat side = d[2 * w.joint[largest]], real(0, 0, 0, 0), dual(0, 0, 0, 0);
    for (size_t k = first; k < first + w.influences; k++) {
        glm::quat r = d[2 * w.joint[k]], e = d[2 * w.joint[k] + 1];
        float s = glm::dot(side, r) < 0 ? -w.weight[k] : w.weight[k];
        real = real + r * s;
        dual = dual + e * s;
    }
    float scale = 1 / glm::length(real);
    real = real * scale, dual = dual * scale;
    glm::vec3 r(real.x, real.y, real.z), e(dual.x, dual.y, dual.z);
    glm::vec3 move = 2.0f * (real.w * e - dual.w * r + glm::cross(r, e));
    const glm_vertex &v = as<glm_vertex>(mesh)[i];
    return {v.at + 2.0f * glm::cross(r, glm::cross(r, v.at) + real.w * v.at) + move,
            v.normal + 2.0f * glm::cross(r, glm::cross(r, v.normal) + real.w * v.normal)};
}
#endif

static void dual(std::shared_ptr<weighted> w)
{
    operation all = {"skin", "4, dual quaternions", 6, 72, 150, [=](size_t i, double *out) { truth_dual(*w, i, out); },
                     16};
    all.sizes = vertices;
    for (size_t n : vertices) {
        operation op = all;
        op.sizes = {n};
        nkw_skin skin = skin_of(*w, kind::f32, n);
        whole(op, "nkw interleaved", layout::structs, [=] {
            streams s = interleaved();
            nkw_skin_dual_quat(&skin, {duals, joints, NKW_PALETTE_DUAL_QUAT}, s.in, s.out);
        });
    }
#ifdef BENCH_GLM
    peer(all, "glm", [=](size_t i) { return glm_dual(*w, i); });
#endif
}

static const suite all([] {
    draw();
    for (size_t k : {1u, 2u, 4u, 8u})
        linear(std::to_string(k) + (k == 1 ? " influence" : " influences"), draw_weights(k), false);
    auto four = draw_weights(4);
    linear("4, raw normals", four, true);
    positions_alone(four);
    with_tangents(four);
    formats(four);
    inverse_normals(four);
    dual(four);
});
