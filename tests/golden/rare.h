/* SPDX-License-Identifier: MIT */
/*
 * Inputs for kernels.h that random ones never come near; included where `input` is known. Sums of a number and another
 * times a power of two: the same whether the compiler fuses or not.
 */

/* The second column is nearly the first; in every other round the fourth is nearly the third. */
static nkw_mat4 nearly_singular(const input *i)
{
    nkw_mat4 m = i->n;
    float part = i->t < 0.5f ? 0x1p-14f : 0x1p-19f;
    for (unsigned k = 0; k < 4; k++) {
        m.m[4 + k] = m.m[k] + part * m.m[4 + k];
        m.m[12 + k] = i->order % 2 ? m.m[8 + k] + part * m.m[12 + k] : m.m[12 + k];
    }
    return m;
}

static nkw_mat4 sheared(const input *i)
{
    nkw_mat4 m = i->m;
    for (unsigned k = 0; k < 3; k++) {
        m.m[4 + k] = i->path == NKW_PATH_LONG ? 0.0f : m.m[k] + 0x1p-6f * m.m[4 + k];
        m.m[8 + k] = i->order < 2 ? 0.0f : m.m[8 + k];
    }
    return m;
}

/* One column at a length far from that of the others. */
static nkw_mat4 far_column(const input *i)
{
    nkw_mat4 m = i->m;
    float scale = i->path == NKW_PATH_LONG ? 0x1p62f : i->path == NKW_PATH_SHORT ? 0x1p-62f : 0x1p30f;
    for (unsigned k = 0; k < 3; k++)
        m.m[4 * ((unsigned)i->order % 3) + k] *= scale;
    return m;
}

/* A product with a flat block, which is singular to rounding. */
static nkw_mat3 flattened(const input *i)
{
    nkw_mat3 flat = i->r, m = nkw_mat3_from_mat4(&i->m);
    for (unsigned k = 0; k < 3; k++)
        flat.m[3 * ((unsigned)i->order % 3) + k] = 0.0f;
    return nkw_mat3_mul(&flat, &m);
}

static nkw_mat3 normal(nkw_mat3 m)
{
    return nkw_mat3_normal(&m);
}

static nkw_mat4 affine_inverse(nkw_mat4 m)
{
    return nkw_mat4_inverse_affine(&m);
}

/* A ray and a target exactly opposite to it, and a limb. */
static nkw_quat opposite_aim(const input *i)
{
    nkw_ik_aim aim;
    memset(&aim, 0, sizeof aim);
    aim.forward = i->v[0];
    aim.target = nkw_vec3_negate(i->v[0]);
    aim.weight = 1.0f;
    return nkw_ik_aim_solve(&aim).rotation;
}

static nkw_quat opposite_limb(const input *i)
{
    nkw_ik_two_bone limb;
    memset(&limb, 0, sizeof limb);
    limb.mid = i->v[0];
    limb.end = nkw_vec3_add(i->v[0], i->v[1]);
    limb.target = nkw_vec3_negate(limb.end);
    limb.weight = 1.0f;
    return nkw_ik_two_bone_solve(&limb).root;
}

static nkw_mat3 block(nkw_mat4 m)
{
    return nkw_mat3_from_mat4(&m);
}

static nkw_mat4 inverse(nkw_mat4 m)
{
    return nkw_mat4_inverse(&m);
}

static nkw_mat3 inverse3(nkw_mat3 m)
{
    return nkw_mat3_inverse(&m);
}

static nkw_mat3 orthonormalized(nkw_mat3 m)
{
    return nkw_mat3_orthonormalize(&m);
}

static nkw_trs decomposed(nkw_mat4 m)
{
    return nkw_trs_from_mat4(&m);
}

/* Opposite to v[0] except for 2^-12 of v[1]. */
static nkw_vec3 nearly_opposite(const input *i)
{
    return nkw_vec3_add_scaled(nkw_vec3_negate(i->v[0]), i->v[1], 0x1p-12f);
}

/* The middle angle within 2^-20 of a quarter turn. */
static nkw_quat at_the_pole(const input *i)
{
    nkw_quat quarter = {0.0f, 0x1.6a09e6p-1f, 0.0f, 0x1.6a09e6p-1f}, turn = {0.0f, 0.0f, 0.6f, 0.8f};
    nkw_quat pole = nkw_quat_mul(turn, quarter);
    pole.x = pole.x + 0x1p-20f * i->t;
    return nkw_quat_normalize(pole);
}
