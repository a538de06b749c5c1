/* SPDX-License-Identifier: MIT */
/* Interpolation of rotations. Contract of all: the shorter arc, a unit result. */
#include <cmath>

#include "bench.h"
#include "peers.h"
#include "truth.h"

using namespace bench;

static reference slerp_of(const array<nkw_quat> &b)
{
    return [&b](size_t i, double *out) {
        truth::slerp(truth::unit(truth::quat(unit_a[i])), truth::unit(truth::quat(b[i])), static_cast<double>(t[i]))
            .put(out);
    };
}

static reference nlerp_of(const array<nkw_quat> &b)
{
    return [&b](size_t i, double *out) {
        truth::nlerp(truth::quat(unit_a[i]), truth::quat(b[i]), static_cast<double>(t[i])).put(out);
    };
}

/* The textbook, with the C library's acos and sine: what a user writes. */
static inline nkw_quat loop_slerp(nkw_quat a, nkw_quat b, float s)
{
    float c = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
    float sign = c < 0 ? -1.0f : 1.0f;
    c *= sign;
    float u = 1 - s, v = s;
    if (c < 0.9995f) {
        float angle = acosf(c), inverse = 1 / sinf(angle);
        u = sinf(u * angle) * inverse;
        v = sinf(v * angle) * inverse;
    }
    v *= sign;
    return {u * a.x + v * b.x, u * a.y + v * b.y, u * a.z + v * b.z, u * a.w + v * b.w};
}

static inline nkw_quat loop_nlerp(nkw_quat a, nkw_quat b, float s)
{
    float c = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
    float u = 1 - s, v = c < 0 ? -s : s;
    nkw_quat q = {u * a.x + v * b.x, u * a.y + v * b.y, u * a.z + v * b.z, u * a.w + v * b.w};
    float k = 1 / sqrtf(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {q.x * k, q.y * k, q.z * k, q.w * k};
}

template <nkw_quat (*F)(nkw_quat, nkw_quat, float)>
static void loop_components(const array<nkw_quat> &b, size_t from, size_t n)
{
    for (size_t i = from; i < from + n; i++) {
        nkw_quat p = {unit_a.part[0][i], unit_a.part[1][i], unit_a.part[2][i], unit_a.part[3][i]};
        nkw_quat q = {b.part[0][i], b.part[1][i], b.part[2][i], b.part[3][i]};
        nkw_quat r = F(p, q, t[i]);
        answer.part[0][i] = r.x, answer.part[1][i] = r.y, answer.part[2][i] = r.z, answer.part[3][i] = r.w;
    }
}

static void slerp(const char *name, const array<nkw_quat> &b)
{
    operation op = {"orient", name, 4, 52, 78, slerp_of(b), 5, 8192, same::rotation};
    chained<nkw_quat>(op, "nkw", unit_a, [&b](nkw_quat a, size_t i) { return nkw_quat_slerp(a, b[i], t[i]); });
    batch(op, "nkw _n", [&b](size_t from, size_t n) {
        nkw_quat_slerp_n(view(unit_a, from), view(b, from), t.at + from, quat_out(from), n);
    });
    chained<nkw_quat>(op, "loop", unit_a, [&b](nkw_quat a, size_t i) { return loop_slerp(a, b[i], t[i]); });
    batch(op, "loop", [&b](size_t from, size_t n) { loop_components<loop_slerp>(b, from, n); });
#ifdef BENCH_CGLM
    chained<cg::quat>(op, "cglm", unit_a, [q = as<cg::quat>(b)](cg::quat a, size_t i) {
        cg::quat c = q[i], r;
        glm_quat_slerp(a.v, c.v, t[i], r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    chained<glm::quat>(op, "glm", unit_a,
                       [q = as<glm::quat>(b)](const glm::quat &a, size_t i) { return glm::slerp(a, q[i], t[i]); });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Quaternionf>(
        op, "Eigen", unit_a,
        [q = as<Eigen::Quaternionf>(b)](const Eigen::Quaternionf &a, size_t i) { return a.slerp(t[i], q[i]); });
#endif
}

static void nlerp(const char *name, const array<nkw_quat> &b)
{
    operation op = {"orient", name, 4, 52, 37, nlerp_of(b), 4, 4096, same::rotation};
    chained<nkw_quat>(op, "nkw", unit_a, [&b](nkw_quat a, size_t i) { return nkw_quat_nlerp(a, b[i], t[i]); });
    batch(op, "nkw _n", [&b](size_t from, size_t n) {
        nkw_quat_nlerp_n(view(unit_a, from), view(b, from), t.at + from, quat_out(from), n);
    });
    chained<nkw_quat>(op, "loop", unit_a, [&b](nkw_quat a, size_t i) { return loop_nlerp(a, b[i], t[i]); });
    batch(op, "loop", [&b](size_t from, size_t n) { loop_components<loop_nlerp>(b, from, n); });
#ifdef BENCH_CGLM
    chained<cg::quat>(op, "cglm", unit_a, [q = as<cg::quat>(b)](cg::quat a, size_t i) {
        cg::quat c = q[i], r;
        glm_quat_nlerp(a.v, c.v, t[i], r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    /* glm has no nlerp along the shorter arc: its operators make one. */
    chained<glm::quat>(op, "glm", unit_a, [q = as<glm::quat>(b)](const glm::quat &a, size_t i) {
        return glm::normalize(a * (1 - t[i]) + q[i] * (glm::dot(a, q[i]) < 0 ? -t[i] : t[i]));
    });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Quaternionf>(
        op, "Eigen", unit_a, [q = as<Eigen::Quaternionf>(b)](const Eigen::Quaternionf &a, size_t i) {
            float v = a.dot(q[i]) < 0 ? -t[i] : t[i];
            return Eigen::Quaternionf(((1 - t[i]) * a.coeffs() + v * q[i].coeffs()).normalized());
        });
#endif
}

static void log_and_exp()
{
    operation log = {"orient", "quat log", 3, 28, 40, by([](size_t i) { return nkw_quat_log(unit_a[i]); })};
    single(log, "nkw", [](size_t i) { return nkw_quat_log(unit_a[i]); });
    batch(log, "nkw _n", [](size_t from, size_t n) { nkw_quat_log_n(view(unit_a, from), vec3_out(from), n); });
    operation exp = {"orient", "quat exp", 4, 28, 40, by([](size_t i) { return nkw_quat_exp(point[0][i]); })};
    single(exp, "nkw", [](size_t i) { return nkw_quat_exp(point[0][i]); });
    batch(exp, "nkw _n", [](size_t from, size_t n) { nkw_quat_exp_n(view(point[0], from), quat_out(from), n); });
    auto loop_log = [](size_t i) {
        nkw_quat q = unit_a[i];
        float s = sqrtf(q.x * q.x + q.y * q.y + q.z * q.z), k = s > 0 ? atan2f(s, q.w) / s : 0;
        return nkw_vec3{k * q.x, k * q.y, k * q.z};
    };
    auto loop_exp = [](size_t i) {
        nkw_vec3 v = point[0][i];
        float a = sqrtf(v.x * v.x + v.y * v.y + v.z * v.z), k = a > 0 ? sinf(a) / a : 1;
        return nkw_quat{k * v.x, k * v.y, k * v.z, cosf(a)};
    };
    single(log, "loop", loop_log);
    single(exp, "loop", loop_exp);
}

static const suite all([] {
    slerp("slerp rand", unit_b);
    slerp("slerp near", unit_near);
    nlerp("nlerp rand", unit_b);
    nlerp("nlerp near", unit_near);
    log_and_exp();
});
