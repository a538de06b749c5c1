/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/orient.h> against binary128: nlerp along a path, whole turns. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 20000u
#define SLERP   "nkw_quat_slerp_path"
#define NLERP   "nkw_quat_nlerp_path"

/* ---- a, b, t, path, turns ---- */

static void ends_apart(random_source *r, float *x, float low, float high)
{
    nkw_quat a = random_unit_quat(r);
    put_quat(x, a);
    put_quat(x + 4, nkw_quat_scale(random_unit_near(r, a, random_log(r, low, high)), random_sign(r)));
    x[8] = random_unit(r);
    x[9] = (float)(random_bits(r) % 3);
    x[10] = 0.0f;
}

static void any_path(random_source *r, float *x)
{
    ends_apart(r, x, 0.05f, 3.0f);
}

static void near_path(random_source *r, float *x)
{
    ends_apart(r, x, 1e-6f, 0.05f);
    x[9] = (float)NKW_PATH_SHORT;
}

static void some_turns(random_source *r, float *x)
{
    ends_apart(r, x, 0.05f, 3.0f);
    x[8] = random_between(r, -2.0f, 2.0f);
    x[10] = (float)(int)(random_bits(r) % 2001) - 1000.0f;
}

static void turns_inside(random_source *r, float *x)
{
    some_turns(r, x);
    x[8] = random_unit(r);
}

static void near_turns(random_source *r, float *x)
{
    near_path(r, x);
    x[10] = (float)(int)(random_bits(r) % 2001) - 1000.0f;
}

/* The unit directions of a and b, b with the sign of the path, the angle between them, and e at right angles to a. */
static wide wide_arc(const float *x, wide a[4], wide b[4], wide e[4])
{
    wide_from(x, a, 4);
    wide_from(x + 4, b, 4);
    int obtuse = wide_dot(a, b, 4) < 0, path = (int)x[9];
    if (path == NKW_PATH_LONG ? !obtuse : path == NKW_PATH_SHORT && obtuse)
        wide_scale(b, -1, 4);
    wide_normalize(a, 4);
    wide_normalize(b, 4);
    wide cosine = wide_dot(a, b, 4);
    for (int i = 0; i < 4; i++)
        e[i] = b[i] - cosine * a[i];
    wide sine = wide_length(e, 4);
    wide_normalize(e, 4);
    return atan2q(sine, cosine);
}

static void wide_turned(const wide a[4], const wide e[4], wide angle, wide out[4])
{
    for (int i = 0; i < 4; i++)
        out[i] = cosq(angle) * a[i] + sinq(angle) * e[i];
}

static double slerp_turns_error(const float *x)
{
    wide a[4], b[4], e[4], exact[4], h = wide_arc(x, a, b, e);
    float got[4];
    wide t = x[8];
    wide_turned(a, e, t * h + wide_pi() * (t * (wide)x[10]), exact);
    /* The length goes from |a| to |b|. */
    wide_from(x, a, 4);
    wide_from(x + 4, b, 4);
    wide la = wide_length(a, 4), lb = wide_length(b, 4);
    wide_scale(exact, t <= 0 ? la : t >= 1 ? lb : la + t * (lb - la), 4);
    put_quat(got, nkw_quat_slerp_path(quat_at(x), quat_at(x + 4), x[8], (nkw_path)x[9], (int32_t)x[10]));
    return wide_error(got, exact, 4);
}

static double nlerp_path_error(const float *x)
{
    wide a[4], b[4], e[4], p[4], q[4], exact[4], h = wide_arc(x, a, b, e);
    float got[4];
    wide t = x[8];
    if (h > (wide)3.1)
        return 0.0;
    wide_from(x, p, 4);
    wide_from(x + 4, q, 4);
    wide part = t * wide_length(q, 4), rest = (1 - t) * wide_length(p, 4);
    wide angle = atan2q(part * sinq(h), rest + part * cosq(h));
    wide_turned(a, e, angle + wide_pi() * (t * (wide)x[10]), exact);
    put_quat(got, nkw_quat_nlerp_path(quat_at(x), quat_at(x + 4), x[8], (nkw_path)x[9], (int32_t)x[10]));
    return wide_error(got, exact, 4);
}

static const wide_case cases[] = {
    {SLERP, "up to 1000 turns, t in [-2, 2]", some_turns, slerp_turns_error, 11, WIDE_CHECKED},
    {SLERP, "up to 1000 turns, ends 1e-6 .. 0.05 apart", near_turns, slerp_turns_error, 11, WIDE_CHECKED},
    {NLERP, "any path", any_path, nlerp_path_error, 11, WIDE_CHECKED},
    {NLERP, "short, 1e-6 .. 0.05 apart", near_path, nlerp_path_error, 11, WIDE_CHECKED},
    {NLERP, "up to 1000 turns", turns_inside, nlerp_path_error, 11, WIDE_CHECKED},
};

void orient_more(accuracy *a)
{
    wide_search(a, cases, sizeof cases / sizeof cases[0], SAMPLES);
}

#else
/* ISO C forbids an empty file. */
typedef int orient_more_is_skipped;
#endif
