/* SPDX-License-Identifier: MIT */
/* Euler angles of the order XYZ, which all the peers have, away from the pole, where they all are exact. */
#include <cmath>

#include "bench.h"
#include "peers.h"

using namespace bench;

static const nkw_euler_order order = NKW_EULER_XYZ;

/* The rotations of the angles, so that every library finds the same angles again. */
static array<nkw_quat> turned;
static array<nkw_mat3> turned_mat3;
static array<nkw_mat4> turned_mat4;

static void draw()
{
    for (size_t i = 0; i < pool; i++) {
        nkw_mat3 m = nkw_mat3_from_euler(angles[i], order);
        turned.set(i, nkw_quat_from_euler(angles[i], order));
        turned_mat3.set(i, m);
        turned_mat4.set(i, nkw_mat4_from_mat3(&m, {0, 0, 0}));
    }
}

static void to_quat()
{
    operation op = {"euler", "quat from euler", 4, 28, 80, by([](size_t i) { return turned[i]; }), 4,
                    64,      same::rotation};
    single(op, "nkw", [](size_t i) { return nkw_quat_from_euler(angles[i], order); });
    single(op, "loop", [](size_t i) {
        float cx = cosf(angles[i].x / 2), cy = cosf(angles[i].y / 2), cz = cosf(angles[i].z / 2);
        float sx = sinf(angles[i].x / 2), sy = sinf(angles[i].y / 2), sz = sinf(angles[i].z / 2);
        return nkw_quat{sx * cy * cz + cx * sy * sz, cx * sy * cz - sx * cy * sz, cx * cy * sz + sx * sy * cz,
                        cx * cy * cz - sx * sy * sz};
    });
#ifdef BENCH_GLM
    /*
     * glm makes quaternions of the order ZYX only: three quaternions of one axis each would be slower than its
     * matrix.
     */
    single(op, "glm by matrix",
           [](size_t i) { return glm::quat_cast(glm::eulerAngleXYZ(angles[i].x, angles[i].y, angles[i].z)); });
#endif
#ifdef BENCH_EIGEN
    single(op, "Eigen", [](size_t i) {
        return Eigen::Quaternionf(Eigen::AngleAxisf(angles[i].x, Eigen::Vector3f::UnitX()) *
                                  Eigen::AngleAxisf(angles[i].y, Eigen::Vector3f::UnitY()) *
                                  Eigen::AngleAxisf(angles[i].z, Eigen::Vector3f::UnitZ()));
    });
#endif
}

/* cglm and glm write 4x4 matrices, the library 3x3: rows of the 4x4 form, for all. */
static void to_matrix()
{
    operation op = {"euler", "matrix from euler", 16, 76, 80, by([](size_t i) { return turned_mat4[i]; }), 4, 64};
    single(op, "nkw", [](size_t i) {
        nkw_mat3 m = nkw_mat3_from_euler(angles[i], order);
        return nkw_mat4_from_mat3(&m, {0, 0, 0});
    });
#ifdef BENCH_CGLM
    single(op, "cglm", [a = as<cg::vec>(angles)](size_t i) {
        cg::vec v = a[i];
        cg::mat r;
        glm_euler_xyz(v.v, r.m);
        return r;
    });
#endif
#ifdef BENCH_GLM
    single(op, "glm", [](size_t i) { return glm::eulerAngleXYZ(angles[i].x, angles[i].y, angles[i].z); });
#endif
#ifdef BENCH_EIGEN
    single(op, "Eigen", [](size_t i) {
        Eigen::Matrix4f m = Eigen::Matrix4f::Identity();
        m.topLeftCorner<3, 3>() = Eigen::Quaternionf(Eigen::AngleAxisf(angles[i].x, Eigen::Vector3f::UnitX()) *
                                                     Eigen::AngleAxisf(angles[i].y, Eigen::Vector3f::UnitY()) *
                                                     Eigen::AngleAxisf(angles[i].z, Eigen::Vector3f::UnitZ()))
                                      .toRotationMatrix();
        return m;
    });
#endif
}

static void to_angles()
{
    operation of_quat = {
        "euler", "euler from quat", 3, 28, 150, by([](size_t i) { return nkw_euler_from_quat(turned[i], order); })};
    operation of_mat = {"euler", "euler from matrix",
                        3,       48,
                        190,     by([](size_t i) { return nkw_euler_from_mat3(&turned_mat3.at[i], order); })};
    single(of_quat, "nkw", [](size_t i) { return nkw_euler_from_quat(turned[i], order); });
    single(of_mat, "nkw", [](size_t i) { return nkw_euler_from_mat3(&turned_mat3.at[i], order); });
    single(of_quat, "loop", [](size_t i) {
        nkw_quat q = turned[i];
        float s = 2 * (q.x * q.z + q.w * q.y);
        return nkw_vec3{atan2f(2 * (q.w * q.x - q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y)),
                        asinf(s < -1  ? -1
                              : s > 1 ? 1
                                      : s),
                        atan2f(2 * (q.w * q.z - q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))};
    });
#ifdef BENCH_CGLM
    single(of_mat, "cglm", [m = as<cg::mat>(turned_mat4)](size_t i) {
        cg::mat c = m[i];
        cg::vec r;
        glm_euler_angles(c.m, r.v);
        return r;
    });
#endif
#ifdef BENCH_GLM
    single(of_mat, "glm", [m = as<glm::mat4>(turned_mat4)](size_t i) {
        glm::vec3 r;
        glm::extractEulerAngleXYZ(m[i], r.x, r.y, r.z);
        return r;
    });
#endif
    /* Eigen's eulerAngles keeps the first angle in 0..pi: other angles of the same rotation, so it stands not here. */
}

static const suite all([] {
    draw();
    to_quat();
    to_matrix();
    to_angles();
});
