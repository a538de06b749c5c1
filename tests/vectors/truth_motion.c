/* SPDX-License-Identifier: CC0-1.0 */
/* Springs and dampers in closed form. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

/* x'' = -k (x - g) - c x'. */
static void spring_case(const char *kind, const char *name, float k, float c, float x, float v, float g, float h)
{
    wide d = (wide)x - g, a = (wide)c / 2, w2 = (wide)k - a * a, e = expq(-a * h), r = v + a * d, cosine = 1, sine = h;
    if (w2 > 0) {
        wide w = sqrtq(w2);
        cosine = cosq(w * h), sine = sinq(w * h) / w;
    } else if (w2 < 0) {
        wide w = sqrtq(-w2);
        cosine = coshq(w * h), sine = sinhq(w * h) / w;
    }
    wide value = g + e * (d * cosine + r * sine);
    wide velocity = -a * e * (d * cosine + r * sine) + e * (-d * w2 * sine + r * cosine);
    truth_case(kind, name, NULL);
    truth_scale(4.0 * (fabs((double)x) + fabs((double)g) + fabs((double)v)) * fmax(1.0, (double)k));
    truth_in("stiffness", &k, 1);
    truth_in("damping", &c, 1);
    truth_in("value", &x, 1);
    truth_in("velocity", &v, 1);
    truth_in("goal", &g, 1);
    truth_in("h", &h, 1);
    truth_out("value", &value, 1);
    truth_out("velocity", &velocity, 1);
}

static void damper_case(const char *kind, const char *name, float x, float g, float half_life, float h)
{
    wide value = half_life > 0 ? g + ((wide)x - g) * exp2q(-(wide)h / half_life) : (wide)g;
    truth_case(kind, name, NULL);
    truth_scale(fabs((double)x) + fabs((double)g));
    truth_in("value", &x, 1);
    truth_in("goal", &g, 1);
    truth_in("half_life", &half_life, 1);
    truth_in("h", &h, 1);
    truth_out("value", &value, 1);
}

void truth_motion(const char *folder)
{
    static const char *const about[] = {
        "Springs: x'' = -stiffness (x - goal) - damping x', one exact step of h seconds; stiffness 1/s^2, damping 1/s.",
        "damper: x = goal + (x - goal) 2^(-h/half_life).",
        "One step of 2h equals two steps of h.",
        NULL,
    };
    static const char *const spring[] = {"in stiffness 1",   "in damping 1",        "in value 1",
                                         "in velocity 1",    "in goal 1",           "in h 1",
                                         "out value 1 near", "out velocity 1 near", NULL};
    static const char *const damper[] = {"in value 1", "in goal 1",        "in half_life 1",
                                         "in h 1",     "out value 1 near", NULL};
    truth_open(folder, "motion", about);
    truth_group("spring", spring, 4.0, "one rounding of the closed form, times `size`");
    for (int i = 0; i < 9; i++) {
        float k = random_between(truth_random(), 1.0f, 60.0f), ratio = i % 3 == 0 ? 0.3f : i % 3 == 1 ? 0.9f : 2.0f;
        float c = (float)(2.0 * ratio * sqrt((double)k));
        spring_case("ordinary", i % 3 == 2 ? "over-damped" : "under-damped", k, c,
                    random_between(truth_random(), -2, 2), random_between(truth_random(), -3, 3),
                    random_between(truth_random(), -2, 2), random_between(truth_random(), 0.01f, 0.5f));
    }
    spring_case("boundary", "critically-damped", 25.0f, 10.0f, 1.0f, 0.0f, 0.0f, 0.1f);
    spring_case("boundary", "no-time", 25.0f, 10.0f, 1.0f, 2.0f, 0.0f, 0.0f);
    spring_case("boundary", "no-damping", 4.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.5f);
    spring_case("boundary", "no-stiffness", 0.0f, 3.0f, 1.0f, 2.0f, 0.0f, 0.5f);
    spring_case("hostile", "nearly-critically-damped", 25.0f, 0x1.3ffffep3f, 1.0f, 0.0f, 0.0f, 0.1f);
    spring_case("hostile", "one-long-step", 100.0f, 4.0f, 1.0f, 0.0f, 0.0f, 30.0f);
    truth_group("damper", damper, 4.0, "one rounding");
    for (int i = 0; i < 4; i++)
        damper_case("ordinary", "random", random_between(truth_random(), -2, 2), random_between(truth_random(), -2, 2),
                    random_between(truth_random(), 0.05f, 1.0f), random_between(truth_random(), 0.01f, 0.5f));
    damper_case("boundary", "one-half-life", 3.0f, 1.0f, 0.25f, 0.25f);
    damper_case("boundary", "no-time", 3.0f, 1.0f, 0.25f, 0.0f);
    damper_case("hostile", "half-life-0-is-the-goal", 3.0f, 1.0f, 0.0f, 0.1f);
    damper_case("hostile", "a-long-time", 3.0f, 1.0f, 0.1f, 100.0f);
    truth_close();
}

#else
typedef int truth_motion_is_skipped;
#endif
