/* SPDX-License-Identifier: MIT */
/* Errors of playback.h. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <quadmath.h>

static void offsets(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++)
        x[i] = random_between(r, -10.0f, 10.0f);
    x[3] = (float)(int)random_between(r, -1e6f, 1e6f);
}

static double offset_error(const float *x)
{
    wide moved = x[3] * ((wide)x[2] - x[1]), want = x[0] + moved;
    float got = nkw_playback_offset(x[0], x[1], x[2], (double)x[3]);
    return wide_error_of(&got, &want, 1, fabsq((wide)x[0]) + fabsq(moved));
}

static void rotations(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++)
        put_quat(x + 4 * i, random_unit_quat(r));
    x[12] = (float)(int)(random_sign(r) * random_log(r, 1.0f, 1e7f));
}

static double quat_error(const float *x)
{
    wide v[4], a[4], b[4], c[4], half[3], want[4];
    wide_from(x, v, 4);
    wide_from(x + 4, a, 4);
    wide_from(x + 8, b, 4);
    wide_scale(b, wide_dot(a, b, 4) < 0 ? -1 : 1, 4);
    wide_scale(a, -1, 3);
    wide_quat_mul(b, a, c);
    wide_normalize(c, 4);
    wide_quat_log(c, half);
    wide_scale(half, x[12], 3);
    wide_quat_exp(half, c);
    wide_quat_mul(c, v, want);
    nkw_quat got = nkw_quat_playback_offset(quat_at(x), quat_at(x + 4), quat_at(x + 8), (double)x[12]);
    return wide_error(&got.x, want, 4);
}

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("playback.h", argc, argv);
    static const wide_case cases[] = {
        {"nkw_playback_offset", "a million cycles", offsets, offset_error, 4, WIDE_CHECKED},
        {"nkw_quat_playback_offset", "10 million cycles", rotations, quat_error, 13, WIDE_CHECKED},
    };
    wide_search(&a, cases, sizeof cases / sizeof *cases, 20000);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
