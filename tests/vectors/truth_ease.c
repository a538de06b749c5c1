/* SPDX-License-Identifier: CC0-1.0 */
/* Penner's easing functions, and steps() of CSS. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

enum { FAMILIES = 10 };

static const char *const names[FAMILIES] = {"sine", "quad", "cubic", "quart",   "quint",
                                            "expo", "circ", "back",  "elastic", "bounce"};

/* The piece of parabola that a bouncing ball follows at x, upside down. */
static wide bounce(wide x)
{
    wide n = (wide)7.5625, d = (wide)11 / 4;
    if (x < 1 / d)
        return n * x * x;
    if (x < 2 / d)
        return n * (x - 3 / (2 * d)) * (x - 3 / (2 * d)) + (wide)0.75;
    if (x < 5 / (2 * d))
        return n * (x - 9 / (4 * d)) * (x - 9 / (4 * d)) + (wide)0.9375;
    return n * (x - 21 / (8 * d)) * (x - 21 / (8 * d)) + (wide)0.984375;
}

static wide ease_in(int family, wide x, int both)
{
    wide c = both ? (wide)170158 / 100000 * 1525 / 1000 : (wide)170158 / 100000;
    wide period = both ? (wide)45 / 100 : (wide)3 / 10;
    switch (family) {
    case 0:
        return 1 - cosq(wide_pi() * x / 2);
    case 5:
        return x == 0 ? 0 : exp2q(10 * (x - 1));
    case 6:
        return 1 - sqrtq(1 - x * x);
    case 7:
        return x * x * ((c + 1) * x - c);
    case 8:
        return x == 0 ? 0 : x == 1 ? 1 : -exp2q(10 * (x - 1)) * sinq((x - 1 - period / 4) * 2 * wide_pi() / period);
    case 9:
        return 1 - bounce(1 - x);
    default:
        return powq(x, family + 1);
    }
}

static void ease_case(const char *kind, int family, int way, float t)
{
    wide x = t, y;
    float f = (float)family, w = (float)way;
    y = way == 0          ? ease_in(family, x, 0)
        : way == 1        ? 1 - ease_in(family, 1 - x, 0)
        : x < (wide)1 / 2 ? ease_in(family, 2 * x, 1) / 2
                          : 1 - ease_in(family, 2 - 2 * x, 1) / 2;
    truth_case(kind, names[family], t == 0.0f || t == 1.0f ? "exact" : NULL);
    truth_in("family", &f, 1);
    truth_in("way", &w, 1);
    truth_in("t", &t, 1);
    truth_out("x", &y, 1);
}

static void steps_case(const char *kind, const char *name, int count, int jump, float t)
{
    wide n = count, m = jump == 2 ? n - 1 : jump == 3 ? n + 1 : n, k = floorq((wide)t * n);
    wide y = (jump == 0 || jump == 3 ? k + 1 : k) / m;
    float c = (float)count, j = (float)jump;
    y = y < 0 ? 0 : y > 1 ? 1 : y;
    truth_case(kind, name, NULL);
    truth_in("count", &c, 1);
    truth_in("jump", &j, 1);
    truth_in("t", &t, 1);
    truth_out("x", &y, 1);
}

void truth_ease(const char *folder)
{
    static const char *const about[] = {
        "Easing: the progress of a value for the progress t of a transition, both from 0 to 1.",
        "ease: family 0 sine, 1 quad, 2 cubic, 3 quart, 4 quint, 5 expo, 6 circ, 7 back, 8 elastic, 9 bounce (Penner "
        "2002);",
        "way 0 in, 1 out, 2 in-out. out(t) = 1 - in(1 - t); in-out is in(2t)/2, then 1 - in(2 - 2t)/2.",
        "back: c = 1.70158, for in-out times 1.525; elastic: period 0.3, for in-out 0.45; expo and elastic are 0 at 0.",
        "steps: CSS; jump 0 start, 1 end, 2 none, 3 both. At a jump the value after it.",
        NULL,
    };
    static const char *const ease[] = {"in family 1", "in way 1", "in t 1", "out x 1 near", NULL};
    static const char *const steps[] = {"in count 1", "in jump 1", "in t 1", "out x 1 near", NULL};
    static const char *const jumps[4] = {"start", "end", "none", "both"};
    truth_open(folder, "ease", about);
    truth_group("ease", ease, 8.0, "one sine, power or root in binary32");
    for (int family = 0; family < FAMILIES; family++)
        for (int way = 0; way < 3; way++) {
            ease_case("ordinary", family, way, random_between(truth_random(), 0.02f, 0.48f));
            ease_case("ordinary", family, way, random_between(truth_random(), 0.52f, 0.98f));
            ease_case("boundary", family, way, way == 1 ? 1.0f : 0.0f);
        }
    ease_case("hostile", 6, 0, 0x1.fffffep-1f);
    ease_case("hostile", 6, 1, 0x1p-24f);
    ease_case("hostile", 0, 0, 0x1p-12f);
    truth_group("steps", steps, 1.0, "a quotient of small integers");
    for (int jump = 0; jump < 4; jump++) {
        for (int i = 0; i < 4; i++)
            steps_case("ordinary", jumps[jump], 2 + i, jump, random_between(truth_random(), 0.05f, 0.95f));
        steps_case("boundary", "at-the-start", 4, jump, 0.0f);
        steps_case("boundary", "at-a-jump", 4, jump, 0.5f);
        steps_case("hostile", "just-before-a-jump", 4, jump, 0x1.fffffep-2f);
    }
    truth_close();
}

#else
typedef int truth_ease_is_skipped;
#endif
