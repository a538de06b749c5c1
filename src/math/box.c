/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/box.h>
#include <nakawari/vec.h>

#include "lane/f64.h"

/* More than the rounding of a blend of eight matrices and of a product: about 20 u. */
#define BOX_MARGIN 0x1p-19

static int is_empty(const nkw_box *box)
{
    return !(box->low.x <= box->high.x && box->low.y <= box->high.y && box->low.z <= box->high.z);
}

/* The smaller and the greater; a where b is NaN. */
static float least(float a, float b)
{
    return b < a ? b : a;
}

static float greatest(float a, float b)
{
    return b > a ? b : a;
}

static nkw_box join(const nkw_box *a, nkw_vec3 low, nkw_vec3 high)
{
    nkw_box box = {{least(a->low.x, low.x), least(a->low.y, low.y), least(a->low.z, low.z)},
                   {greatest(a->high.x, high.x), greatest(a->high.y, high.y), greatest(a->high.z, high.z)}};
    return box;
}

nkw_box nkw_box_union(const nkw_box *a, const nkw_box *b)
{
    nkw_box box = NKW_BOX_EMPTY;
    box = join(&box, a->low, a->high);
    return join(&box, b->low, b->high);
}

nkw_box nkw_box_from_points(const nkw_vec3 *points, size_t count)
{
    nkw_box box = NKW_BOX_EMPTY;
    for (size_t i = 0; i < count; i++)
        box = join(&box, points[i], points[i]);
    return box;
}

/* One row of the image: centre and half length, in binary64, which is exact to far less than the margin. */
static void transform_row(const nkw_mat4 *m, const nkw_box *box, size_t row, float *low, float *high)
{
    const float from[3] = {box->low.x, box->low.y, box->low.z}, to[3] = {box->high.x, box->high.y, box->high.z};
    double centre = (double)m->m[12 + row], half = 0.0, size = lane_abs64(centre);
    for (size_t c = 0; c < 3; c++) {
        double e = (double)m->m[c * 4 + row], a = (double)from[c], b = (double)to[c];
        double most = lane_abs64(a) > lane_abs64(b) ? lane_abs64(a) : lane_abs64(b);
        centre += e * (0.5 * (a + b));
        half += lane_abs64(e) * (0.5 * (b - a));
        size += lane_abs64(e) * most;
    }
    half += BOX_MARGIN * size;
    *low = (float)(centre - half);
    *high = (float)(centre + half);
}

nkw_box nkw_box_transform(const nkw_box *box, const nkw_mat4 *m)
{
    const nkw_box all = {{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
    nkw_box r;
    if (is_empty(box))
        return NKW_BOX_EMPTY;
    transform_row(m, box, 0, &r.low.x, &r.high.x);
    transform_row(m, box, 1, &r.low.y, &r.high.y);
    transform_row(m, box, 2, &r.low.z, &r.high.z);
    return nkw_vec3_is_finite(r.low) && nkw_vec3_is_finite(r.high) ? r : all;
}
