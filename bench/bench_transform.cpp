/* SPDX-License-Identifier: MIT */
/* Translation, rotation and scale. */
#include <cmath>

#include "bench.h"
#include "from_trs.h"

using namespace bench;

static void to_matrix()
{
    operation op = {
        "transform", "mat4 from trs", 16, 104, 37, [](size_t i, double *out) { truth::matrix(place[i], out); }, 8};
    single(op, "nkw", [](size_t i) { return nkw_mat4_from_trs(&place.at[i]); });
    batch(op, "nkw _n", [](size_t from, size_t n) { nkw_mat4_from_trs_n(view(place, from), mat4_out(from), n); });
#ifdef BENCH_CGLM
    single(op, "cglm", [](size_t i) { return cglm_matrix(place[i]); });
#endif
#ifdef BENCH_GLM
    single(op, "glm", [](size_t i) { return glm_matrix(place[i]); });
#endif
#ifdef BENCH_EIGEN
    single(op, "Eigen", [](size_t i) { return Eigen::Matrix4f(eigen_matrix(place[i]).matrix()); });
#endif
#ifdef BENCH_RTM
    single(op, "rtm", [](size_t i) {
        const nkw_trs &p = place[i];
        return rt::mat4(rtm::matrix_from_qvv(rt::load(p.rotation), rt::load(p.translation), rt::load(p.scale)));
    });
#endif
#ifdef BENCH_DIRECTXMATH
    single(op, "DirectXMath", [](size_t i) {
        const nkw_trs &p = place[i];
        return dx::mat4(dx::XMMatrixAffineTransformation(dx::load(p.scale), dx::XMVectorZero(), dx::load(p.rotation),
                                                         dx::load(p.translation)));
    });
#endif
}

static void from_matrix()
{
    operation op = {
        "transform", "trs from mat4", 10, 104, 110, by([](size_t i) { return nkw_trs_from_mat4(&affine.at[i]); }), 4,
        64,          same::transform};
    single(op, "nkw", [](size_t i) { return nkw_trs_from_mat4(&affine.at[i]); });
#ifdef BENCH_GLM
    single(op, "glm", [](size_t i) {
        const float *m = affine[i].m;
        glm::vec3 x(m[0], m[1], m[2]), y(m[4], m[5], m[6]), z(m[8], m[9], m[10]);
        glm::vec3 s(glm::length(x), glm::length(y), glm::length(z));
        glm::quat q = glm::quat_cast(glm::mat3(x / s.x, y / s.y, z / s.z));
        return nkw_trs{{m[12], m[13], m[14]}, {q.x, q.y, q.z, q.w}, {s.x, s.y, s.z}};
    });
#endif
#ifdef BENCH_DIRECTXMATH
    single(op, "DirectXMath", [](size_t i) {
        dx::XMVECTOR s, q = dx::XMVectorZero(), p;
        dx::XMMatrixDecompose(&s, &q, &p, dx::load(affine[i]));
        return nkw_trs{dx::vec3(p), dx::quat(q), dx::vec3(s)};
    });
#endif
}

static void mul()
{
    operation op = {"transform", "trs mul", 10,
                    120,         64,        by([](size_t i) { return nkw_trs_mul(&place.at[i], &place_b.at[i]); })};
    single(op, "nkw", [](size_t i) { return nkw_trs_mul(&place.at[i], &place_b.at[i]); });
#ifdef BENCH_GLM
    single(op, "glm", [](size_t i) {
        const nkw_trs &a = place[i], &b = place_b[i];
        glm::quat p(a.rotation.w, a.rotation.x, a.rotation.y, a.rotation.z),
            q(b.rotation.w, b.rotation.x, b.rotation.y, b.rotation.z);
        glm::vec3 s(a.scale.x, a.scale.y, a.scale.z), u(b.scale.x, b.scale.y, b.scale.z);
        glm::vec3 v(a.translation.x, a.translation.y, a.translation.z),
            w(b.translation.x, b.translation.y, b.translation.z);
        glm::vec3 at = v + p * (s * w), scale = s * u;
        glm::quat r = p * q;
        return nkw_trs{{at.x, at.y, at.z}, {r.x, r.y, r.z, r.w}, {scale.x, scale.y, scale.z}};
    });
#endif
}

static const suite all([] {
    to_matrix();
    from_matrix();
    mul();
});
