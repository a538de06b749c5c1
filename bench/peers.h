/* SPDX-License-Identifier: MIT */
/* The other libraries, where this machine has them: BENCH_CGLM, BENCH_GLM, BENCH_EIGEN, BENCH_SLEEF. */
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

#ifdef BENCH_SLEEF
#include "peer_sleef.h"
#endif

#endif
