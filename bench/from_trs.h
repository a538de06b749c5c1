/* SPDX-License-Identifier: MIT */
/* The other libraries' matrices of a translation, rotation and scale, and of the reference. */
#ifndef NAKAWARI_BENCH_FROM_TRS_H
#define NAKAWARI_BENCH_FROM_TRS_H

#include <cstring>

#include "peers.h"
#include "truth.h"

namespace truth
{
inline void matrix(const nkw_trs &p, double *out)
{
    const double s[3] = {static_cast<double>(p.scale.x), static_cast<double>(p.scale.y),
                         static_cast<double>(p.scale.z)};
    for (int k = 0; k < 16; k++)
        out[k] = k == 15;
    rotation(unit(quat(p.rotation)), s, out, 4);
    out[12] = static_cast<double>(p.translation.x);
    out[13] = static_cast<double>(p.translation.y);
    out[14] = static_cast<double>(p.translation.z);
}
} // namespace truth

#ifdef BENCH_CGLM
inline cg::mat cglm_matrix(nkw_trs p)
{
    cg::quat q;
    cg::mat r;
    std::memcpy(q.v, &p.rotation, sizeof q.v);
    glm_quat_mat4(q.v, r.m);
    glm_scale(r.m, &p.scale.x);
    std::memcpy(r.m[3], &p.translation, sizeof p.translation);
    return r;
}
#endif

#ifdef BENCH_GLM
inline glm::mat4 glm_matrix(const nkw_trs &p)
{
    glm::mat4 m = glm::mat4_cast(glm::quat(p.rotation.w, p.rotation.x, p.rotation.y, p.rotation.z));
    m = glm::scale(m, glm::vec3(p.scale.x, p.scale.y, p.scale.z));
    m[3] = glm::vec4(p.translation.x, p.translation.y, p.translation.z, 1);
    return m;
}
#endif

#ifdef BENCH_EIGEN
inline Eigen::Affine3f eigen_matrix(const nkw_trs &p)
{
    Eigen::Affine3f m;
    m.fromPositionOrientationScale(Eigen::Vector3f(p.translation.x, p.translation.y, p.translation.z),
                                   Eigen::Quaternionf(p.rotation.w, p.rotation.x, p.rotation.y, p.rotation.z),
                                   Eigen::Vector3f(p.scale.x, p.scale.y, p.scale.z));
    return m;
}
#endif

#endif
