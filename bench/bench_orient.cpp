/* SPDX-License-Identifier: MIT */
/* Interpolation of rotations. Contract of all: the shorter arc, a unit result. */
#include <cmath>

#include "bench.h"
#include "peers.h"
#include "textbook.h"
#include "truth.h"

using namespace bench;

/* One pair for all elements, as the samples between two keys have; times are many. */
static array<nkw_quat> repeated_a, repeated_b;

static reference slerp_of(const array<nkw_quat> &a, const array<nkw_quat> &b)
{
    return [&](size_t i, double *out) {
        truth::slerp(truth::unit(truth::quat(a[i])), truth::unit(truth::quat(b[i])), static_cast<double>(t[i]))
            .put(out);
    };
}

static reference nlerp_of(const array<nkw_quat> &a, const array<nkw_quat> &b)
{
    return [&](size_t i, double *out) {
        truth::nlerp(truth::quat(a[i]), truth::quat(b[i]), static_cast<double>(t[i])).put(out);
    };
}

/* The textbook, with the C library's acos and sine: what a user writes. */
static inline nkw_quat loop_slerp(nkw_quat a, nkw_quat b, float s)
{
    return to(textbook::slerp(textbook::quat<float>(a), textbook::quat<float>(b), s));
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
static void loop_components(const array<nkw_quat> &a, const array<nkw_quat> &b, size_t from, size_t n)
{
    for (size_t i = from; i < from + n; i++) {
        nkw_quat p = {a.part[0][i], a.part[1][i], a.part[2][i], a.part[3][i]};
        nkw_quat q = {b.part[0][i], b.part[1][i], b.part[2][i], b.part[3][i]};
        nkw_quat r = F(p, q, t[i]);
        answer.part[0][i] = r.x, answer.part[1][i] = r.y, answer.part[2][i] = r.z, answer.part[3][i] = r.w;
    }
}

/* A chain that comes back to b would stay there: with one pair for all, results do not go on to the next call. */
template <class T, class F> static void rows(const operation &op, const char *who, const array<nkw_quat> &a, F f)
{
    if (&a != &repeated_a)
        chained<T>(op, who, a, f);
    else
        single(op, who, [f, x = as<T>(a)](size_t i) { return f(x[i], i); });
}

static void slerp(const char *name, const array<nkw_quat> &a, const array<nkw_quat> &b)
{
    operation op = {"orient", name, 4, 52, 78, slerp_of(a, b), 5, 8192, same::rotation};
    rows<nkw_quat>(op, "nkw", a, [&b](nkw_quat x, size_t i) { return nkw_quat_slerp(x, b[i], t[i]); });
    batch(op, "nkw _n", [&](size_t from, size_t n) {
        nkw_quat_slerp_n(view(a, from), view(b, from), t.at + from, quat_out(from), n);
    });
    rows<nkw_quat>(op, "loop", a, [&b](nkw_quat x, size_t i) { return loop_slerp(x, b[i], t[i]); });
    batch(op, "loop", [&](size_t from, size_t n) { loop_components<loop_slerp>(a, b, from, n); });
#ifdef BENCH_CGLM
    rows<cg::quat>(op, "cglm", a, [q = as<cg::quat>(b)](cg::quat x, size_t i) {
        cg::quat c = q[i], r;
        glm_quat_slerp(x.v, c.v, t[i], r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    rows<glm::quat>(op, "glm", a,
                    [q = as<glm::quat>(b)](const glm::quat &x, size_t i) { return glm::slerp(x, q[i], t[i]); });
#endif
#ifdef BENCH_EIGEN
    rows<Eigen::Quaternionf>(op, "Eigen", a, [q = as<Eigen::Quaternionf>(b)](const Eigen::Quaternionf &x, size_t i) {
        return x.slerp(t[i], q[i]);
    });
#endif
#ifdef BENCH_RTM
    rows<nkw_quat>(op, "rtm", a,
                   [&b](nkw_quat x, size_t i) { return rt::quat(rtm::quat_slerp(rt::load(x), rt::load(b[i]), t[i])); });
#endif
#ifdef BENCH_DIRECTXMATH
    rows<nkw_quat>(op, "DirectXMath", a, [&b](nkw_quat x, size_t i) {
        return dx::quat(dx::XMQuaternionSlerp(dx::load(x), dx::load(b[i]), t[i]));
    });
#endif
}

static void nlerp(const char *name, const array<nkw_quat> &a, const array<nkw_quat> &b)
{
    operation op = {"orient", name, 4, 52, 37, nlerp_of(a, b), 4, 4096, same::rotation};
    rows<nkw_quat>(op, "nkw", a, [&b](nkw_quat x, size_t i) { return nkw_quat_nlerp(x, b[i], t[i]); });
    batch(op, "nkw _n", [&](size_t from, size_t n) {
        nkw_quat_nlerp_n(view(a, from), view(b, from), t.at + from, quat_out(from), n);
    });
    rows<nkw_quat>(op, "loop", a, [&b](nkw_quat x, size_t i) { return loop_nlerp(x, b[i], t[i]); });
    batch(op, "loop", [&](size_t from, size_t n) { loop_components<loop_nlerp>(a, b, from, n); });
#ifdef BENCH_CGLM
    rows<cg::quat>(op, "cglm", a, [q = as<cg::quat>(b)](cg::quat x, size_t i) {
        cg::quat c = q[i], r;
        glm_quat_nlerp(x.v, c.v, t[i], r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    /* glm has no nlerp along the shorter arc: its operators make one. */
    rows<glm::quat>(op, "glm", a, [q = as<glm::quat>(b)](const glm::quat &x, size_t i) {
        return glm::normalize(x * (1 - t[i]) + q[i] * (glm::dot(x, q[i]) < 0 ? -t[i] : t[i]));
    });
#endif
#ifdef BENCH_EIGEN
    rows<Eigen::Quaternionf>(op, "Eigen", a, [q = as<Eigen::Quaternionf>(b)](const Eigen::Quaternionf &x, size_t i) {
        float v = x.dot(q[i]) < 0 ? -t[i] : t[i];
        return Eigen::Quaternionf(((1 - t[i]) * x.coeffs() + v * q[i].coeffs()).normalized());
    });
#endif
#ifdef BENCH_RTM
    rows<nkw_quat>(op, "rtm", a,
                   [&b](nkw_quat x, size_t i) { return rt::quat(rtm::quat_lerp(rt::load(x), rt::load(b[i]), t[i])); });
#endif
}

static void log_and_exp()
{
    operation log = {"orient", "quat log", 3, 28, 40, by([](size_t i) { return nkw_quat_log(unit_a[i]); })};
    single(log, "nkw", [](size_t i) { return nkw_quat_log(unit_a[i]); });
    operation exp = {"orient", "quat exp", 4, 28, 40, by([](size_t i) { return nkw_quat_exp(point[0][i]); })};
    single(exp, "nkw", [](size_t i) { return nkw_quat_exp(point[0][i]); });
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
    for (size_t i = 0; i < pool; i++) {
        repeated_a.set(i, unit_a[0]);
        repeated_b.set(i, unit_near[0]);
    }
    slerp("slerp rand", unit_a, unit_b);
    slerp("slerp near", unit_a, unit_near);
    slerp("slerp one pair", repeated_a, repeated_b);
    nlerp("nlerp rand", unit_a, unit_b);
    nlerp("nlerp near", unit_a, unit_near);
    nlerp("nlerp one pair", repeated_a, repeated_b);
    log_and_exp();
});
