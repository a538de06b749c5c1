/* SPDX-License-Identifier: MIT */
/* Matrices: products, inverses, and the matrix of a quaternion. */
#include "bench.h"
#include "peers.h"
#include "truth.h"

using namespace bench;

#ifdef BENCH_CGLM
/* dest = f(m) of matrices passed by value. */
template <void (*F)(mat4, mat4)> static cg::mat cglm_of(cg::mat m)
{
    cg::mat r;
    F(m.m, r.m);
    return r;
}

template <void (*F)(mat4, mat4, mat4)> static cg::mat cglm_by(cg::mat m, size_t i)
{
    cg::mat c = as<cg::mat>(rigid)[i], r;
    F(m.m, c.m, r.m);
    return r;
}
#endif

/* a times rigid[i]; `affine_only` says that the last rows may be left out. */
static void mul(const char *name, bool affine_only)
{
    operation op = {"mat",
                    name,
                    16,
                    192,
                    affine_only ? 63.0 : 112.0,
                    [](size_t i, double *out) { truth::product(affine[i].m, rigid[i].m, 4, out); },
                    6};
    if (affine_only)
        chained<nkw_mat4>(op, "nkw", affine,
                          [](const nkw_mat4 &m, size_t i) { return nkw_mat4_mul_affine(&m, &rigid.at[i]); });
    else
        chained<nkw_mat4>(op, "nkw", affine,
                          [](const nkw_mat4 &m, size_t i) { return nkw_mat4_mul(&m, &rigid.at[i]); });
    chained<nkw_mat4>(op, "loop", affine, [](const nkw_mat4 &m, size_t i) {
        nkw_mat4 out;
        for (int c = 0; c < 4; c++)
            for (int r = 0; r < 4; r++) {
                float sum = 0;
                for (int k = 0; k < 4; k++)
                    sum += m.m[k * 4 + r] * rigid[i].m[c * 4 + k];
                out.m[c * 4 + r] = sum;
            }
        return out;
    });
#ifdef BENCH_CGLM
    if (affine_only)
        chained<cg::mat>(op, "cglm", affine, [](const cg::mat &m, size_t i) { return cglm_by<glm_mul>(m, i); });
    else
        chained<cg::mat>(op, "cglm", affine, [](const cg::mat &m, size_t i) { return cglm_by<glm_mat4_mul>(m, i); });
#endif
#ifdef BENCH_GLM
    chained<glm::mat4>(op, "glm", affine,
                       [b = as<glm::mat4>(rigid)](const glm::mat4 &m, size_t i) { return m * b[i]; });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Matrix4f>(op, "Eigen", affine, [b = as<Eigen::Matrix4f>(rigid)](const Eigen::Matrix4f &m, size_t i) {
        return Eigen::Matrix4f(m * b[i]);
    });
#endif
#ifdef BENCH_RTM
    if (affine_only)
        chained<nkw_mat4>(op, "rtm", affine, [](const nkw_mat4 &m, size_t i) {
            return rt::mat4(rtm::matrix_mul(rt::load_affine(rigid[i]), rt::load_affine(m)));
        });
    else
        chained<nkw_mat4>(op, "rtm", affine, [](const nkw_mat4 &m, size_t i) {
            return rt::mat4(rtm::matrix_mul(rt::load(rigid[i]), rt::load(m)));
        });
#endif
#ifdef BENCH_DIRECTXMATH
    if (!affine_only)
        chained<nkw_mat4>(op, "DirectXMath", affine, [](const nkw_mat4 &m, size_t i) {
            return dx::mat4(dx::XMMatrixMultiply(dx::load(rigid[i]), dx::load(m)));
        });
#endif
}

static void inverse()
{
    operation op = {"mat", "inverse", 16, 128, 140, by([](size_t i) { return nkw_mat4_inverse(&general.at[i]); }),
                    4,     16384};
    chained<nkw_mat4>(op, "nkw", general, [](const nkw_mat4 &m, size_t) { return nkw_mat4_inverse(&m); });
#ifdef BENCH_CGLM
    chained<cg::mat>(op, "cglm", general, [](cg::mat m, size_t) { return cglm_of<glm_mat4_inv>(m); });
    /* 12-bit reciprocals; allowed here, for they are what cglm offers. */
    chained<cg::mat>(op, "cglm fast", general, [](cg::mat m, size_t) { return cglm_of<glm_mat4_inv_fast>(m); });
#endif
#ifdef BENCH_GLM
    chained<glm::mat4>(op, "glm", general, [](const glm::mat4 &m, size_t) { return glm::inverse(m); });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Matrix4f>(op, "Eigen", general,
                             [](const Eigen::Matrix4f &m, size_t) { return Eigen::Matrix4f(m.inverse()); });
#endif
#ifdef BENCH_RTM
    chained<nkw_mat4>(op, "rtm", general,
                      [](const nkw_mat4 &m, size_t) { return rt::mat4(rtm::matrix_inverse(rt::load(m))); });
#endif
#ifdef BENCH_DIRECTXMATH
    chained<nkw_mat4>(op, "DirectXMath", general,
                      [](const nkw_mat4 &m, size_t) { return dx::mat4(dx::XMMatrixInverse(nullptr, dx::load(m))); });
#endif
}

static void inverse_affine()
{
    operation op = {
        "mat", "inverse affine", 16, 128, 70, by([](size_t i) { return nkw_mat4_inverse_affine(&affine.at[i]); })};
    chained<nkw_mat4>(op, "nkw", affine, [](const nkw_mat4 &m, size_t) { return nkw_mat4_inverse_affine(&m); });
#ifdef BENCH_CGLM
    chained<cg::mat>(op, "cglm general", affine, [](cg::mat m, size_t) { return cglm_of<glm_mat4_inv>(m); });
#endif
#ifdef BENCH_GLM
    chained<glm::mat4>(op, "glm", affine, [](const glm::mat4 &m, size_t) { return glm::affineInverse(m); });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Matrix4f>(op, "Eigen", affine, [](const Eigen::Matrix4f &m, size_t) {
        return Eigen::Matrix4f(Eigen::Affine3f(m).inverse(Eigen::Affine).matrix());
    });
#endif
#ifdef BENCH_RTM
    chained<nkw_mat4>(op, "rtm", affine,
                      [](const nkw_mat4 &m, size_t) { return rt::mat4(rtm::matrix_inverse(rt::load_affine(m))); });
#endif
}

static void inverse_rigid()
{
    operation op = {
        "mat", "inverse rigid", 16, 128, 18, by([](size_t i) { return nkw_mat4_inverse_rigid(&rigid.at[i]); })};
    chained<nkw_mat4>(op, "nkw", rigid, [](const nkw_mat4 &m, size_t) { return nkw_mat4_inverse_rigid(&m); });
#ifdef BENCH_CGLM
    chained<cg::mat>(op, "cglm", rigid, [](cg::mat m, size_t) {
        glm_inv_tr(m.m);
        return m;
    });
#endif
#ifdef BENCH_EIGEN
    chained<Eigen::Matrix4f>(op, "Eigen", rigid, [](const Eigen::Matrix4f &m, size_t) {
        return Eigen::Matrix4f(Eigen::Isometry3f(m).inverse().matrix());
    });
#endif
}

static void from_quat()
{
    static const double ones[3] = {1, 1, 1};
    operation op = {"mat", "mat3 from quat",
                    9,     52,
                    24,    [](size_t i, double *out) {
                        truth::rotation(truth::quat(unit_a[i]), ones, out, 3); },
                    6};
    operation op4 = {"mat",
                     "mat4 from quat",
                     16,
                     80,
                     24,
                     [](size_t i, double *out) {
                         for (int k = 0; k < 16; k++)
                             out[k] = k == 15;
                         truth::rotation(truth::quat(unit_a[i]), ones, out, 4);
                     },
                     6};
    single(op, "nkw", [](size_t i) { return nkw_mat3_from_quat(unit_a[i]); });
    single(op4, "nkw", [](size_t i) { return nkw_mat4_from_quat(unit_a[i]); });
#ifdef BENCH_CGLM
    struct cg_mat3 {
        mat3 m;
    };
    single(op, "cglm", [q = as<cg::quat>(unit_a)](size_t i) {
        cg::quat c = q[i];
        cg_mat3 r;
        glm_quat_mat3(c.v, r.m);
        return r;
    });
    single(op4, "cglm", [q = as<cg::quat>(unit_a)](size_t i) {
        cg::quat c = q[i];
        cg::mat r;
        glm_quat_mat4(c.v, r.m);
        return r;
    });
#endif
#ifdef BENCH_GLM
    single(op, "glm", [q = as<glm::quat>(unit_a)](size_t i) { return glm::mat3_cast(q[i]); });
    single(op4, "glm", [q = as<glm::quat>(unit_a)](size_t i) { return glm::mat4_cast(q[i]); });
#endif
#ifdef BENCH_EIGEN
    single(op, "Eigen", [q = as<Eigen::Quaternionf>(unit_a)](size_t i) { return q[i].toRotationMatrix(); });
#endif
#ifdef BENCH_DIRECTXMATH
    single(op4, "DirectXMath", [](size_t i) { return dx::mat4(dx::XMMatrixRotationQuaternion(dx::load(unit_a[i]))); });
#endif
}

/* One matrix on many points. */
static void transform()
{
    operation op = {"mat", "transform points", 3, 24, 18, [](size_t i, double *out) {
                        const float *m = affine[0].m;
                        const double p[4] = {static_cast<double>(point[0][i].x), static_cast<double>(point[0][i].y),
                                             static_cast<double>(point[0][i].z), 1};
                        for (int r = 0; r < 3; r++) {
                            out[r] = 0;
                            for (int k = 0; k < 4; k++)
                                out[r] += static_cast<double>(m[k * 4 + r]) * p[k];
                        }
                    }};
    single(op, "nkw", [](size_t i) { return nkw_mat4_transform_point(&affine.at[0], point[0][i]); });
    batch(op, "nkw _n", [](size_t from, size_t n) {
        nkw_mat4_transform_point_n(&affine.at[0], view(point[0], from), vec3_out(from), n);
    });
#ifdef BENCH_CGLM
    single(op, "cglm", [m = as<cg::mat>(affine), p = as<cg::vec>(point[0])](size_t i) {
        cg::mat c = m[0];
        cg::vec v = p[i], r;
        glm_mat4_mulv3(c.m, v.v, 1, r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    single(op, "glm", [m = as<glm::mat4>(affine), p = as<glm::vec3>(point[0])](size_t i) {
        return glm::vec3(m[0] * glm::vec4(p[i], 1));
    });
#endif
#ifdef BENCH_EIGEN
    single(op, "Eigen", [m = as<Eigen::Matrix4f>(affine), p = as<Eigen::Vector3f>(point[0])](size_t i) {
        return Eigen::Vector3f(m[0].topLeftCorner<3, 3>() * p[i] + m[0].topRightCorner<3, 1>());
    });
#endif
}

static const suite all([] {
    mul("mul", false);
    mul("mul affine", true);
    inverse();
    inverse_affine();
    inverse_rigid();
    from_quat();
    transform();
});
