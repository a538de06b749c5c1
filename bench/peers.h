/* SPDX-License-Identifier: MIT */
/* The other libraries, where this machine has them: BENCH_ and CGLM, GLM, EIGEN, RTM, DIRECTXMATH, SLEEF. */
#ifndef NAKAWARI_BENCH_PEERS_H
#define NAKAWARI_BENCH_PEERS_H

#ifdef BENCH_CGLM
#include <cglm/cglm.h>

/* cglm's arrays as values, so that they can be returned. */
namespace cg
{
struct quat {
    alignas(16) versor v;
};
struct vec {
    vec3 v;
};
struct mat {
    alignas(16) mat4 m;
};
} // namespace cg
#endif

#ifdef BENCH_GLM
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/euler_angles.hpp>
#include <glm/gtx/spline.hpp>
#endif

#ifdef BENCH_EIGEN
#include <Eigen/Geometry>
#endif

#ifdef BENCH_RTM
#include <rtm/matrix3x3f.h>
#include <rtm/matrix3x4f.h>
#include <rtm/matrix4x4f.h>
#include <rtm/quatf.h>

/* rtm's registers, loaded from our structs and stored to them. Its matrices have our bytes; its products the other order. */
namespace rt
{
inline rtm::quatf load(const nkw_quat &q)
{
    return rtm::quat_load(&q.x);
}
inline nkw_quat quat(rtm::quatf q)
{
    nkw_quat out;
    rtm::quat_store(q, &out.x);
    return out;
}
inline rtm::vector4f load(const nkw_vec3 &v)
{
    return rtm::vector_load3(&v.x);
}
inline nkw_vec3 vec3(rtm::vector4f v)
{
    nkw_vec3 out;
    rtm::vector_store3(v, &out.x);
    return out;
}
inline rtm::matrix4x4f load(const nkw_mat4 &m)
{
    return rtm::matrix_set(rtm::vector_load(m.m), rtm::vector_load(m.m + 4), rtm::vector_load(m.m + 8),
                           rtm::vector_load(m.m + 12));
}
inline rtm::matrix3x4f load_affine(const nkw_mat4 &m)
{
    return rtm::matrix_set(rtm::vector_load(m.m), rtm::vector_load(m.m + 4), rtm::vector_load(m.m + 8),
                           rtm::vector_load(m.m + 12));
}
inline rtm::matrix3x3f load(const nkw_mat3 &m)
{
    return rtm::matrix_set(rtm::vector_load3(m.m), rtm::vector_load3(m.m + 3), rtm::vector_load3(m.m + 6));
}
inline nkw_mat4 mat4(rtm::matrix4x4f m)
{
    nkw_mat4 out;
    rtm::vector_store(m.x_axis, out.m);
    rtm::vector_store(m.y_axis, out.m + 4);
    rtm::vector_store(m.z_axis, out.m + 8);
    rtm::vector_store(m.w_axis, out.m + 12);
    return out;
}
/* Sets the last row, which rtm leaves open. */
inline nkw_mat4 mat4(rtm::matrix3x4f m)
{
    return mat4(rtm::matrix4x4f(rtm::matrix_cast(m)));
}
} // namespace rt
#endif

#ifdef BENCH_DIRECTXMATH
#include <DirectXMath.h>

/* The same for DirectXMath. */
namespace dx
{
using namespace DirectX;
inline XMVECTOR load(const nkw_quat &q)
{
    return XMLoadFloat4(reinterpret_cast<const XMFLOAT4 *>(&q));
}
inline nkw_quat quat(XMVECTOR q)
{
    nkw_quat out;
    XMStoreFloat4(reinterpret_cast<XMFLOAT4 *>(&out), q);
    return out;
}
inline XMVECTOR load(const nkw_vec3 &v)
{
    return XMLoadFloat3(reinterpret_cast<const XMFLOAT3 *>(&v));
}
inline nkw_vec3 vec3(XMVECTOR v)
{
    nkw_vec3 out;
    XMStoreFloat3(reinterpret_cast<XMFLOAT3 *>(&out), v);
    return out;
}
inline XMMATRIX load(const nkw_mat4 &m)
{
    return XMLoadFloat4x4(reinterpret_cast<const XMFLOAT4X4 *>(&m));
}
inline nkw_mat4 mat4(const XMMATRIX &m)
{
    nkw_mat4 out;
    XMStoreFloat4x4(reinterpret_cast<XMFLOAT4X4 *>(&out), m);
    return out;
}
} // namespace dx
#endif

#ifdef BENCH_SLEEF
#include "peer_sleef.h"
#endif

#endif
