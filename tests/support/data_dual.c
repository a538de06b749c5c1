/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"

static uint64_t hash_dual(uint64_t hash, const nkw_dual_quat *d)
{
    float f[8];
    memcpy(f, d, sizeof f);
    return hash_floats(hash, f, 8);
}

static nkw_dual_quat conjugate(const nkw_dual_quat *d)
{
    nkw_dual_quat r = {nkw_quat_conjugate(d->real), nkw_quat_conjugate(d->dual)};
    return r;
}

/* d or -d, the one whose real part is nearer to that of `side`. */
static nkw_dual_quat aligned(const nkw_dual_quat *d, const nkw_dual_quat *side)
{
    const float sign = nkw_quat_dot(d->real, side->real) < 0.0f ? -1.0f : 1.0f;
    nkw_dual_quat r = {nkw_quat_scale(d->real, sign), nkw_quat_scale(d->dual, sign)};
    return r;
}

uint64_t data_dual(void)
{
    random_source r = random_from(31);
    uint64_t hash = HASH_START;
    nkw_dual_quat sum = nkw_dual_quat_from_rigid(nkw_quat_identity(), NKW_VEC3_ZERO);
    for (int i = 0; i < 500; i++) {
        nkw_vec3 t = random_vec3(&r, -5, 5), p = random_vec3(&r, -2, 2);
        nkw_dual_quat d = nkw_dual_quat_from_rigid(random_rotation(&r), t), back = conjugate(&d), n;
        nkw_mat4 m = nkw_mat4_from_dual_quat(&d);
        nkw_vec3 moved[3];
        for (size_t k = 0; k < 12; k++)
            m.m[k] *= i % 3 ? 1.0f : random_between(&r, -2.0f, 2.0f);
        hash = hash_dual(hash_floats(hash, m.m, 16), &d);
        n = nkw_dual_quat_from_mat4(&m);
        hash = hash_dual(hash, &n);
        sum = nkw_dual_quat_mul(&sum, &back);
        n = aligned(&sum, &d);
        n.dual.x += p.x;
        n.real.y += p.y;
        n = nkw_dual_quat_normalize(&n);
        hash = hash_dual(hash_dual(hash, &sum), &n);
        moved[0] = nkw_dual_quat_transform_point(&d, p);
        moved[1] = nkw_quat_rotate(d.real, p);
        moved[2] = nkw_dual_quat_transform_point(&d, NKW_VEC3_ZERO);
        hash = hash_floats(hash, &moved[0].x, 9);
    }
    return hash;
}
