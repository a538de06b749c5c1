/* SPDX-License-Identifier: MIT */
/* Calls of the small algebra that a compiler without optimisation does not inline. */
#include <nakawari/nakawari.h>

#if !NKW_INLINE
#error "C++ does not inline"
#endif

nkw_vec3 own_copies(const nkw_trs *trs, nkw_quat q, float t)
{
    nkw_mat4 m = nkw_mat4_from_trs(trs), inverse = nkw_mat4_inverse_rigid(&m);
    nkw_mat4 product = nkw_mat4_mul(&m, &inverse), affine = nkw_mat4_mul_affine(&m, &inverse);
    nkw_vec3 p = nkw_vec3_lerp(nkw_mat4_translation(&product), nkw_mat4_translation(&affine), t);
    nkw_vec3 (*rotate)(nkw_quat, nkw_vec3) = nkw_quat_rotate;
    return nkw_vec3_hermite(p, rotate(nkw_quat_normalize(q), p), nkw_vec3_normalize(p), nkw_vec3_cross(p, p), t);
}
