/* SPDX-License-Identifier: MIT */
/* From model matrices to what skinning and shaders take. An element is a joint. */
#include "bench.h"
#include "peers.h"
#include "truth.h"
#include "views.h"

using namespace bench;

/* Inverse binds: other matrices of the same kind as the models. */
static const size_t apart = 4096;
static const std::vector<size_t> joints = {10, 67, 256, 1000};

static const nkw_mat4 *models()
{
    return rigid.at;
}

static const nkw_mat4 *binds()
{
    return rigid.at + apart;
}

static void joint_matrix(size_t i, double *out)
{
    truth::product(models()[i].m, binds()[i].m, 4, out);
}

/* `fill(n)` writes n elements to answer.at, as structs. */
template <class F> static void row(const operation &op, const char *who, F fill)
{
    for (size_t n : op.sizes) {
        operation one = op;
        one.sizes = {n};
        whole(one, who, layout::structs, [=] { fill(n); });
    }
}

/* f(i) gives element i. */
template <class F> static void peer(const operation &op, const char *who, F f)
{
    row(op, who, [=](size_t n) {
        auto *out = reinterpret_cast<decltype(f(size_t{0})) *>(answer.at);
        for (size_t i = 0; i < n; i++)
            out[i] = f(i);
    });
}

#ifdef BENCH_CGLM
static cg::mat cglm_product(size_t i)
{
    cg::mat m = reinterpret_cast<const cg::mat *>(models())[i], b = reinterpret_cast<const cg::mat *>(binds())[i], r;
    glm_mul(m.m, b.m, r.m);
    return r;
}
#endif
#ifdef BENCH_GLM
static glm::mat4 glm_product(size_t i)
{
    return reinterpret_cast<const glm::mat4 *>(models())[i] * reinterpret_cast<const glm::mat4 *>(binds())[i];
}
#endif
#ifdef BENCH_EIGEN
static Eigen::Affine3f eigen_product(size_t i)
{
    return reinterpret_cast<const Eigen::Affine3f *>(models())[i] *
           reinterpret_cast<const Eigen::Affine3f *>(binds())[i];
}
#endif

static void full()
{
    operation op = {"palette", "4x4", 16, 192, 63, joint_matrix};
    op.sizes = joints;
    row(op, "nkw", [](size_t n) { palette_from_models(models(), n, nullptr, binds(), nullptr, n, answer.at); });
    /* One product after another: wins where it is inlined and there are few. */
    peer(op, "nkw singles", [](size_t i) { return nkw_mat4_mul_affine(&models()[i], &binds()[i]); });
#ifdef BENCH_CGLM
    peer(op, "cglm", cglm_product);
#endif
#ifdef BENCH_GLM
    peer(op, "glm", glm_product);
#endif
#ifdef BENCH_EIGEN
    peer(op, "Eigen", eigen_product);
#endif
}

static void rows()
{
    operation op = {"palette", "3x4", 12, 176, 63, [](size_t i, double *out) {
                        double m[16];
                        joint_matrix(i, m);
                        for (int r = 0; r < 3; r++)
                            for (int c = 0; c < 4; c++)
                                out[4 * r + c] = m[4 * c + r];
                    }};
    op.sizes = joints;
    row(op, "nkw", [](size_t n) {
        palette_3x4_from_models(models(), n, nullptr, binds(), nullptr, n, reinterpret_cast<nkw_mat3x4 *>(answer.at));
    });
#ifdef BENCH_GLM
    peer(op, "glm", [](size_t i) { return glm::mat3x4(glm::transpose(glm_product(i))); });
#endif
#ifdef BENCH_EIGEN
    peer(op, "Eigen",
         [](size_t i) { return Eigen::Matrix<float, 3, 4, Eigen::RowMajor>(eigen_product(i).matrix().topRows<3>()); });
#endif
}

static void dual()
{
    operation op = {"palette",
                    "dual quaternions",
                    8,
                    160,
                    150,
                    [](size_t i, double *out) {
                        nkw_mat4 m = nkw_mat4_mul_affine(&models()[i], &binds()[i]);
                        nkw_dual_quat d = nkw_dual_quat_from_mat4(&m);
                        std::copy_n(&d.real.x, 4, out);
                        std::copy_n(&d.dual.x, 4, out + 4);
                    },
                    0};
    op.sizes = joints;
    row(op, "nkw", [](size_t n) {
        palette_dual_from_models(models(), n, nullptr, binds(), nullptr, n,
                                 reinterpret_cast<nkw_dual_quat *>(answer.at));
    });
#ifdef BENCH_GLM
    peer(op, "glm", [](size_t i) {
        glm::mat4 m = glm_product(i);
        glm::quat q = glm::quat_cast(m);
        q = q.w < 0 ? -q : q;
        glm::quat d = glm::quat(0, 0.5f * m[3][0], 0.5f * m[3][1], 0.5f * m[3][2]) * q;
        return nkw_dual_quat{{q.x, q.y, q.z, q.w}, {d.x, d.y, d.z, d.w}};
    });
#endif
#ifdef BENCH_EIGEN
    peer(op, "Eigen", [](size_t i) {
        Eigen::Affine3f m = eigen_product(i);
        Eigen::Quaternionf q(m.linear());
        if (q.w() < 0)
            q.coeffs() = -q.coeffs();
        Eigen::Vector3f half = 0.5f * m.translation();
        Eigen::Quaternionf d = Eigen::Quaternionf(0, half.x(), half.y(), half.z()) * q;
        return nkw_dual_quat{{q.x(), q.y(), q.z(), q.w()}, {d.x(), d.y(), d.z(), d.w()}};
    });
#endif
}

static void normals()
{
    operation op = {"palette",
                    "normal matrices",
                    9,
                    100,
                    46,
                    by([](size_t i) {
                        const float *m = affine[i].m;
                        nkw_mat3 block = {{m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}};
                        return nkw_mat3_normal(&block);
                    }),
                    0};
    op.sizes = joints;
    row(op, "nkw", [](size_t n) { palette_normals(affine.at, n, reinterpret_cast<nkw_mat3 *>(answer.at)); });
#ifdef BENCH_GLM
    peer(op, "glm", [](size_t i) { return glm::inverseTranspose(glm::mat3(as<glm::mat4>(affine)[i])); });
#endif
#ifdef BENCH_EIGEN
    peer(op, "Eigen",
         [](size_t i) { return Eigen::Matrix3f(as<Eigen::Affine3f>(affine)[i].linear().inverse().transpose()); });
#endif
}

static void inverse_bind()
{
    operation op = {
        "palette", "inverse bind", 16, 128, 82, by([](size_t i) { return nkw_mat4_inverse_affine(&affine[i]); }), 0};
    op.sizes = joints;
    row(op, "nkw", [](size_t n) { inverse_bind_from_models(affine.at, n, nullptr, nullptr, n, answer.at); });
#ifdef BENCH_GLM
    peer(op, "glm", [](size_t i) { return glm::affineInverse(as<glm::mat4>(affine)[i]); });
#endif
#ifdef BENCH_EIGEN
    peer(op, "Eigen", [](size_t i) { return Eigen::Affine3f(as<Eigen::Affine3f>(affine)[i].inverse()); });
#endif
}

static const suite all([] {
    full();
    rows();
    dual();
    normals();
    inverse_bind();
});
