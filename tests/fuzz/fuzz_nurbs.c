/* SPDX-License-Identifier: MIT */
/* Curves of any control points, weights and knots: refused, or finite points; nothing outside of the arrays. */
#include "fuzz.h"

enum { POINTS = 24, WIDTH = 4 };

static nkw_nurbs draw(fuzz *f, int wild)
{
    nkw_nurbs c = {NULL, NULL, NULL, fuzz_upto(f, POINTS), 0, fuzz_upto(f, WIDTH), 0};
    c.degree = fuzz_upto(f, wild ? 20 : c.count > 16 ? 15 : c.count > 0 ? c.count - 1 : 0);
    c.stride = c.width + fuzz_upto(f, 2);
    float *knots = fuzz_floats(f, NKW_NURBS_KNOTS(c.count, c.degree), wild), *weights = fuzz_floats(f, c.count, wild);
    for (size_t k = 1; k < NKW_NURBS_KNOTS(c.count, c.degree) && !wild; k++)
        knots[k] = knots[k - 1] + (knots[k] > 0.0f ? knots[k] : 0.0f);
    for (size_t i = 0; i < c.count && !wild; i++)
        weights[i] = 0.125f + weights[i] * weights[i];
    c.knots = knots;
    c.weights = fuzz_byte(f) % 2 ? weights : NULL;
    c.points = fuzz_floats(f, c.count * c.stride, wild);
    return c;
}

static void check_knots(fuzz *f)
{
    size_t count = fuzz_upto(f, POINTS), degree = fuzz_upto(f, 18), bad;
    float *knots = fuzz_room(f, NKW_NURBS_KNOTS(count, degree)), *points = fuzz_floats(f, count, 0);
    nkw_nurbs_knots_kind kind = (nkw_nurbs_knots_kind)fuzz_choice(f, 1);
    if (nkw_nurbs_make_knots(count, degree, fuzz_float(f), fuzz_float(f), kind, knots) != NKW_OK)
        return;
    nkw_nurbs c = {points, NULL, knots, count, degree, 1, 1};
    nkw_result result = nkw_nurbs_validate(&c, &bad);
    FUZZ_CHECK(result == NKW_OK || result == NKW_TOO_MANY); /* steps below the last place of the knots */
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    int wild = fuzz_byte(&f) % 3 == 0;
    const nkw_nurbs c = draw(&f, wild);
    size_t bad;
    float *at = fuzz_room(&f, 3 * c.width);
    nkw_result result = nkw_nurbs_validate(&c, &bad);
    FUZZ_CHECK(bad < NKW_NURBS_KNOTS(c.count, c.degree));
    for (int i = 0; i < 8; i++) {
        nkw_nurbs_evaluate(&c, fuzz_float(&f),
                           (nkw_motion_span){at, fuzz_byte(&f) % 2 ? at + c.width : NULL, at + 2 * c.width});
        FUZZ_CHECK(result != NKW_OK || wild || fuzz_finite(at, c.width));
    }
    check_knots(&f);
    return fuzz_end(&f);
}
