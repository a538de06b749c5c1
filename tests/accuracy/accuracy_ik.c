/* SPDX-License-Identifier: MIT */
/* What <nakawari/ik.h> leaves of the distance and the angle to targets that can be reached, in binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 20000u

/* Root, mid, end, target, pole. */
enum { LIMB = 15 };

static void limb_with(random_source *r, float *x, float low, float high)
{
    nkw_vec3 root = random_vec3(r, -1, 1);
    float a = random_between(r, 0.3f, 1.0f), b = random_between(r, 0.3f, 1.0f);
    nkw_vec3 mid = nkw_vec3_add_scaled(root, random_direction(r), a);
    nkw_vec3 end = nkw_vec3_add_scaled(mid, random_direction(r), b);
    float least = nkw_abs(a - b), reach = least + (a + b - least) * random_between(r, low, high);
    put_vec3(x, root);
    put_vec3(x + 3, mid);
    put_vec3(x + 6, end);
    put_vec3(x + 9, nkw_vec3_add_scaled(root, random_direction(r), reach));
    put_vec3(x + 12, random_bits(r) % 2 ? random_direction(r) : NKW_VEC3_ZERO);
}

static void inside(random_source *r, float *x)
{
    limb_with(r, x, 0.05f, 0.99f);
}

static void nearly_straight(random_source *r, float *x)
{
    limb_with(r, x, 0.99f, 0.99999f);
}

static void rotate(nkw_quat q, wide v[3])
{
    wide w[4], m[9], out[3];
    float f[4];
    put_quat(f, q);
    wide_from(f, w, 4);
    wide_normalize(w, 4);
    wide_mat3_from_quat(w, m);
    for (int i = 0; i < 3; i++)
        out[i] = m[i] * v[0] + m[3 + i] * v[1] + m[6 + i] * v[2];
    for (int i = 0; i < 3; i++)
        v[i] = out[i];
}

/* |end - target| / (a + b) in u, by the rounded rotations. */
static double reach_error(const float *x)
{
    nkw_ik_two_bone limb = {vec3_at(x),      vec3_at(x + 3), vec3_at(x + 6), vec3_at(x + 9),
                            vec3_at(x + 12), {0, 0, 0},      0.0f,           1.0f};
    nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&limb);
    wide u[3], v[3], end[3], t[3];
    for (int i = 0; i < 3; i++) {
        u[i] = (wide)x[3 + i] - x[i];
        v[i] = (wide)x[6 + i] - x[3 + i];
        t[i] = (wide)x[9 + i] - x[i];
    }
    wide length = wide_length(u, 3) + wide_length(v, 3);
    rotate(s.mid, v);
    for (int i = 0; i < 3; i++)
        end[i] = u[i] + v[i];
    rotate(s.root, end);
    for (int i = 0; i < 3; i++)
        end[i] -= t[i];
    return (double)(wide_length(end, 3) / length) * 0x1p24;
}

/* Position, forward, target, up, pole. */
static void aimed(random_source *r, float *x)
{
    put_vec3(x, random_vec3(r, -1, 1));
    put_vec3(x + 3, random_direction(r));
    put_vec3(x + 6, random_vec3(r, -5, 5));
    put_vec3(x + 9, random_direction(r));
    put_vec3(x + 12, random_bits(r) % 2 ? random_direction(r) : NKW_VEC3_ZERO);
}

/* The angle between the rotated ray and the target in u. */
static double aim_error(const float *x)
{
    nkw_ik_aim aim = {vec3_at(x), {0, 0, 0}, vec3_at(x + 3), vec3_at(x + 6), vec3_at(x + 9), vec3_at(x + 12), {0, 0, 0},
                      0.0f,       1.0f};
    wide ray[3], t[3], c[3];
    wide_from(x + 3, ray, 3);
    for (int i = 0; i < 3; i++)
        t[i] = (wide)x[6 + i] - x[i];
    rotate(nkw_ik_aim_solve(&aim).rotation, ray);
    wide_cross(ray, t, c);
    return (double)atan2q(wide_length(c, 3), wide_dot(ray, t, 3)) * 0x1p24;
}

static const wide_case cases[] = {
    {"nkw_ik_two_bone_solve", "targets within reach", inside, reach_error, LIMB, WIDE_CHECKED},
    {"nkw_ik_two_bone_solve", "nearly straight", nearly_straight, reach_error, LIMB, WIDE_CHECKED},
    {"nkw_ik_aim_solve", "rays from the joint", aimed, aim_error, LIMB, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("ik.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
