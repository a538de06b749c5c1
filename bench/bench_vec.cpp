/* SPDX-License-Identifier: MIT */
/* Vectors of three: sums, products, lengths, and the change between structs and component arrays. */
#include <cmath>

#include "bench.h"
#include "peers.h"

using namespace bench;

static const array<nkw_vec3> &a = point[0], &b = point[1];

static double d(float x)
{
    return static_cast<double>(x);
}

static void dot()
{
    operation op = {"vec",
                    "dot",
                    1,
                    28,
                    5,
                    [](size_t i, double *out) {
                        *out = d(a[i].x) * d(b[i].x) + d(a[i].y) * d(b[i].y) + d(a[i].z) * d(b[i].z); }};
    single(op, "nkw", [](size_t i) { return nkw_vec3_dot(a[i], b[i]); });
    single(op, "loop", [](size_t i) { return a[i].x * b[i].x + a[i].y * b[i].y + a[i].z * b[i].z; });
#ifdef BENCH_GLM
    single(op, "glm", [p = as<glm::vec3>(a), q = as<glm::vec3>(b)](size_t i) { return glm::dot(p[i], q[i]); });
#endif
#ifdef BENCH_EIGEN
    single(op, "Eigen", [p = as<Eigen::Vector3f>(a), q = as<Eigen::Vector3f>(b)](size_t i) { return p[i].dot(q[i]); });
#endif
}

static void cross()
{
    operation op = {"vec", "cross", 3, 36, 9, [](size_t i, double *out) {
                        out[0] = d(a[i].y) * d(b[i].z) - d(a[i].z) * d(b[i].y);
                        out[1] = d(a[i].z) * d(b[i].x) - d(a[i].x) * d(b[i].z);
                        out[2] = d(a[i].x) * d(b[i].y) - d(a[i].y) * d(b[i].x);
                    }};
    chained<nkw_vec3>(op, "nkw", a, [](nkw_vec3 p, size_t i) { return nkw_vec3_cross(p, b[i]); });
#ifdef BENCH_CGLM
    chained<cg::vec>(op, "cglm", a, [q = as<cg::vec>(b)](cg::vec p, size_t i) {
        cg::vec c = q[i], r;
        glm_vec3_cross(p.v, c.v, r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    chained<glm::vec3>(op, "glm", a,
                       [q = as<glm::vec3>(b)](const glm::vec3 &p, size_t i) { return glm::cross(p, q[i]); });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Vector3f>(op, "Eigen", a, [q = as<Eigen::Vector3f>(b)](const Eigen::Vector3f &p, size_t i) {
        return Eigen::Vector3f(p.cross(q[i]));
    });
#endif
}

static void normalize()
{
    operation op = {"vec", "normalize", 3, 24, 9, [](size_t i, double *out) {
                        double n = std::sqrt(d(a[i].x) * d(a[i].x) + d(a[i].y) * d(a[i].y) + d(a[i].z) * d(a[i].z));
                        out[0] = d(a[i].x) / n, out[1] = d(a[i].y) / n, out[2] = d(a[i].z) / n;
                    }};
    chained<nkw_vec3>(op, "nkw", a, [](nkw_vec3 p, size_t) { return nkw_vec3_normalize(p); });
    batch(op, "nkw _n", [](size_t from, size_t n) { nkw_vec3_normalize_n(view(a, from), vec3_out(from), n); });
    chained<nkw_vec3>(op, "loop", a, [](nkw_vec3 p, size_t) {
        float k = 1 / sqrtf(p.x * p.x + p.y * p.y + p.z * p.z);
        return nkw_vec3{p.x * k, p.y * k, p.z * k};
    });
#ifdef BENCH_CGLM
    chained<cg::vec>(op, "cglm", a, [](cg::vec p, size_t) {
        glm_vec3_normalize(p.v);
        return p;
    });
#endif
#ifdef BENCH_GLM
    chained<glm::vec3>(op, "glm", a, [](const glm::vec3 &p, size_t) { return glm::normalize(p); });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Vector3f>(op, "Eigen", a,
                             [](const Eigen::Vector3f &p, size_t) { return Eigen::Vector3f(p.normalized()); });
#endif
#ifdef BENCH_RTM
    chained<nkw_vec3>(op, "rtm", a, [](nkw_vec3 p, size_t) { return rt::vec3(rtm::vector_normalize3(rt::load(p))); });
#endif
#ifdef BENCH_DIRECTXMATH
    chained<nkw_vec3>(op, "DirectXMath", a,
                      [](nkw_vec3 p, size_t) { return dx::vec3(dx::XMVector3Normalize(dx::load(p))); });
#endif
}

static void lerp()
{
    operation op = {"vec", "lerp", 3, 40, 15, [](size_t i, double *out) {
                        const double p[3] = {d(a[i].x), d(a[i].y), d(a[i].z)}, q[3] = {d(b[i].x), d(b[i].y), d(b[i].z)};
                        for (int k = 0; k < 3; k++)
                            out[k] = p[k] + d(t[i]) * (q[k] - p[k]);
                    }};
    chained<nkw_vec3>(op, "nkw", a, [](nkw_vec3 p, size_t i) { return nkw_vec3_lerp(p, b[i], t[i]); });
    batch(op, "nkw _n",
          [](size_t from, size_t n) { nkw_vec3_lerp_n(view(a, from), view(b, from), t.at + from, vec3_out(from), n); });
    chained<nkw_vec3>(op, "loop", a, [](nkw_vec3 p, size_t i) {
        return nkw_vec3{p.x + t[i] * (b[i].x - p.x), p.y + t[i] * (b[i].y - p.y), p.z + t[i] * (b[i].z - p.z)};
    });
    batch(op, "loop", [](size_t from, size_t n) {
        for (size_t k = 0; k < 3; k++)
            for (size_t i = from; i < from + n; i++)
                answer.part[k][i] = a.part[k][i] + t[i] * (b.part[k][i] - a.part[k][i]);
    });
#ifdef BENCH_CGLM
    chained<cg::vec>(op, "cglm", a, [q = as<cg::vec>(b)](cg::vec p, size_t i) {
        cg::vec c = q[i], r;
        glm_vec3_lerp(p.v, c.v, t[i], r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    chained<glm::vec3>(op, "glm", a,
                       [q = as<glm::vec3>(b)](const glm::vec3 &p, size_t i) { return glm::mix(p, q[i], t[i]); });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Vector3f>(op, "Eigen", a, [q = as<Eigen::Vector3f>(b)](const Eigen::Vector3f &p, size_t i) {
        return Eigen::Vector3f(p + t[i] * (q[i] - p));
    });
#endif
#ifdef BENCH_RTM
    chained<nkw_vec3>(op, "rtm", a, [](nkw_vec3 p, size_t i) {
        return rt::vec3(rtm::vector_lerp(rt::load(p), rt::load(b[i]), t[i]));
    });
#endif
#ifdef BENCH_DIRECTXMATH
    chained<nkw_vec3>(op, "DirectXMath", a, [](nkw_vec3 p, size_t i) {
        return dx::vec3(dx::XMVectorLerp(dx::load(p), dx::load(b[i]), t[i]));
    });
#endif
}

/* From structs to components and back. */
static void packing()
{
    operation op = {"vec", "unpack", 3, 24, 0, by([](size_t i) { return a[i]; })};
    batch(op, "nkw _n", [](size_t from, size_t n) { nkw_vec3_unpack_n(a.at + from, vec3_out(from), n); });
    batch(op, "loop", [](size_t from, size_t n) {
        for (size_t i = from; i < from + n; i++)
            answer.part[0][i] = a[i].x, answer.part[1][i] = a[i].y, answer.part[2][i] = a[i].z;
    });
    operation back = {"vec", "pack", 3, 24, 0, by([](size_t i) { return a[i]; })};
    into_structs(back, "nkw _n", [](size_t from, size_t n) {
        nkw_vec3_pack_n(view(a, from), reinterpret_cast<nkw_vec3 *>(answer.at) + from, n);
    });
    single(back, "loop", [](size_t i) { return nkw_vec3{a.part[0][i], a.part[1][i], a.part[2][i]}; });
}

static const suite all([] {
    dot();
    cross();
    normalize();
    lerp();
    packing();
});
