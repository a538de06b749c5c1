/* SPDX-License-Identifier: MIT */
/* Quaternions as rotations. */
#include <cmath>

#include "bench.h"
#include "peers.h"
#include "truth.h"

using namespace bench;

static void mul()
{
    operation op = {
        "quat", "mul",
        4,      48,
        28,     [](size_t i, double *out) {
                        truth::mul(truth::quat(unit_a[i]), truth::quat(unit_b[i])).put(out); }};
    chained<nkw_quat>(op, "nkw", unit_a, [](nkw_quat q, size_t i) { return nkw_quat_mul(q, unit_b[i]); });
    batch(op, "nkw _n",
          [](size_t from, size_t n) { nkw_quat_mul_n(view(unit_a, from), view(unit_b, from), quat_out(from), n); });
    auto product = [](nkw_quat a, nkw_quat b) {
        return nkw_quat{a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                        a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
    };
    chained<nkw_quat>(op, "loop", unit_a, [=](nkw_quat q, size_t i) { return product(q, unit_b[i]); });
#ifdef BENCH_CGLM
    chained<cg::quat>(op, "cglm", unit_a, [b = as<cg::quat>(unit_b)](cg::quat a, size_t i) {
        cg::quat c = b[i], r;
        glm_quat_mul(a.v, c.v, r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    chained<glm::quat>(op, "glm", unit_a,
                       [b = as<glm::quat>(unit_b)](const glm::quat &a, size_t i) { return a * b[i]; });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Quaternionf>(
        op, "Eigen", unit_a,
        [b = as<Eigen::Quaternionf>(unit_b)](const Eigen::Quaternionf &a, size_t i) { return a * b[i]; });
#endif
#ifdef BENCH_RTM
    chained<nkw_quat>(op, "rtm", unit_a,
                      [](nkw_quat q, size_t i) { return rt::quat(rtm::quat_mul(rt::load(unit_b[i]), rt::load(q))); });
#endif
#ifdef BENCH_DIRECTXMATH
    chained<nkw_quat>(op, "DirectXMath", unit_a, [](nkw_quat q, size_t i) {
        return dx::quat(dx::XMQuaternionMultiply(dx::load(unit_b[i]), dx::load(q)));
    });
#endif
}

static void rotate()
{
    operation op = {"quat",
                    "rotate",
                    3,
                    40,
                    30,
                    [](size_t i, double *out) {
                        truth::quat q(unit_a[i]),
                            v(static_cast<double>(point[0][i].x), static_cast<double>(point[0][i].y),
                              static_cast<double>(point[0][i].z), 0);
                        double k = 1 / truth::dot(q, q);
                        truth::quat r = truth::mul(truth::mul(q, v), {-q.x, -q.y, -q.z, q.w});
                        out[0] = k * r.x, out[1] = k * r.y, out[2] = k * r.z;
                    },
                    18};
    chained<nkw_vec3>(op, "nkw", point[0], [](nkw_vec3 v, size_t i) { return nkw_quat_rotate(unit_a[i], v); });
    batch(op, "nkw _n", [](size_t from, size_t n) {
        nkw_quat_rotate_n(view(unit_a, from), view(point[0], from), vec3_out(from), n);
    });
#ifdef BENCH_CGLM
    chained<cg::vec>(op, "cglm", point[0], [q = as<cg::quat>(unit_a)](cg::vec v, size_t i) {
        cg::quat c = q[i];
        cg::vec r;
        glm_quat_rotatev(c.v, v.v, r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    chained<glm::vec3>(op, "glm", point[0],
                       [q = as<glm::quat>(unit_a)](const glm::vec3 &v, size_t i) { return q[i] * v; });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Vector3f>(
        op, "Eigen", point[0],
        [q = as<Eigen::Quaternionf>(unit_a)](const Eigen::Vector3f &v, size_t i) { return Eigen::Vector3f(q[i] * v); });
#endif
#ifdef BENCH_RTM
    chained<nkw_vec3>(op, "rtm", point[0], [](nkw_vec3 v, size_t i) {
        return rt::vec3(rtm::quat_mul_vector3(rt::load(v), rt::load(unit_a[i])));
    });
#endif
#ifdef BENCH_DIRECTXMATH
    chained<nkw_vec3>(op, "DirectXMath", point[0], [](nkw_vec3 v, size_t i) {
        return dx::vec3(dx::XMVector3Rotate(dx::load(v), dx::load(unit_a[i])));
    });
#endif
}

static void normalize()
{
    operation op = {"quat", "normalize", 4,
                    32,     12,          [](size_t i, double *out) {
                        truth::unit(truth::quat(unit_a[i])).put(out); }};
    chained<nkw_quat>(op, "nkw", unit_a, [](nkw_quat q, size_t) { return nkw_quat_normalize(q); });
    batch(op, "nkw _n", [](size_t from, size_t n) { nkw_quat_normalize_n(view(unit_a, from), quat_out(from), n); });
#ifdef BENCH_CGLM
    chained<cg::quat>(op, "cglm", unit_a, [](cg::quat q, size_t) {
        glm_quat_normalize(q.v);
        return q;
    });
#endif
#ifdef BENCH_GLM
    chained<glm::quat>(op, "glm", unit_a, [](const glm::quat &q, size_t) { return glm::normalize(q); });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Quaternionf>(op, "Eigen", unit_a,
                                [](const Eigen::Quaternionf &q, size_t) { return q.normalized(); });
#endif
#ifdef BENCH_RTM
    chained<nkw_quat>(op, "rtm", unit_a, [](nkw_quat q, size_t) { return rt::quat(rtm::quat_normalize(rt::load(q))); });
#endif
#ifdef BENCH_DIRECTXMATH
    chained<nkw_quat>(op, "DirectXMath", unit_a,
                      [](nkw_quat q, size_t) { return dx::quat(dx::XMQuaternionNormalize(dx::load(q))); });
#endif
}

static void from_mat3()
{
    operation op = {"quat", "from mat3",   4, 52, 60, by([](size_t i) { return nkw_quat_from_mat3(&turn.at[i]); }), 4,
                    64,     same::rotation};
    single(op, "nkw", [](size_t i) { return nkw_quat_from_mat3(&turn.at[i]); });
#ifdef BENCH_CGLM
    single(op, "cglm", [](size_t i) {
        mat3 m;
        cg::quat r;
        memcpy(m, &turn.at[i], sizeof m);
        glm_mat3_quat(m, r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    single(op, "glm", [m = as<glm::mat3>(turn)](size_t i) { return glm::quat_cast(m[i]); });
#endif
#ifdef BENCH_EIGEN
    single(op, "Eigen", [m = as<Eigen::Matrix3f>(turn)](size_t i) { return Eigen::Quaternionf(m[i]); });
#endif
#ifdef BENCH_RTM
    single(op, "rtm", [](size_t i) { return rt::quat(rtm::quat_from_matrix(rt::load(turn[i]))); });
#endif
#ifdef BENCH_DIRECTXMATH
    single(op, "DirectXMath", [](size_t i) {
        return dx::quat(
            dx::XMQuaternionRotationMatrix(dx::XMLoadFloat3x3(reinterpret_cast<const dx::XMFLOAT3X3 *>(&turn.at[i]))));
    });
#endif
}

static const suite all([] {
    mul();
    rotate();
    normalize();
    from_mat3();
});
