/* SPDX-License-Identifier: MIT */
/* Handles from their types. */
#include "lane/strict.h"

#include <nakawari/dialect.h>

/* A key with its neighbours: durations and slopes before and after it; those that are missing continue the others. */
typedef struct around {
    double h0, h1, d0, d1; /* durations positive */
    double rise0, rise1; /* from the key to the value of the neighbour */
    int is_end;
} around;

static double slope_of(const nkw_fcurve_key *a, const nkw_fcurve_key *b)
{
    double h = (double)b->time - (double)a->time;
    return h > 0.0 ? ((double)b->value - (double)a->value) / h : (double)b->value - (double)a->value;
}

static double duration_of(const nkw_fcurve_key *a, const nkw_fcurve_key *b)
{
    double h = (double)b->time - (double)a->time;
    return h > 0.0 ? h : 1.0;
}

static around around_key(const nkw_fcurve_key *keys, size_t count, size_t k)
{
    const nkw_fcurve_key *key = keys + k, *before = k > 0 ? key - 1 : key, *after = k + 1 < count ? key + 1 : key;
    around r;
    r.is_end = k == 0 || k + 1 == count;
    r.h0 = k > 0 ? duration_of(before, key) : duration_of(key, after);
    r.h1 = k + 1 < count ? duration_of(key, after) : duration_of(before, key);
    r.d0 = k > 0 ? slope_of(before, key) : slope_of(key, after);
    r.d1 = k + 1 < count ? slope_of(key, after) : slope_of(before, key);
    r.rise0 = (double)before->value - (double)key->value;
    r.rise1 = (double)after->value - (double)key->value;
    return r;
}

static int is_auto(nkw_handle_type type)
{
    return type == NKW_HANDLE_AUTO || type == NKW_HANDLE_AUTO_CLAMPED;
}

static nkw_handle handle_along(double time, double slope)
{
    nkw_handle r = {(float)time, (float)(slope * time)};
    return r;
}

/* The slope m for which a handle of x seconds, of the sign of x, does not pass a neighbour that is `rise` away. */
static double clamped_slope(double m, double x, double rise)
{
    double y = m * x;
    int passes = rise <= 0.0 ? y < rise : y > rise;
    return passes ? rise / x : m;
}

static void set_auto(nkw_fcurve_key *key, const around *r, nkw_handle_types types)
{
    const double part = 1.0 / 2.5614;
    double h0 = r->h0 > 5.0 * r->h1 ? 5.0 * r->h1 : r->h0, h1 = r->h1 > 5.0 * h0 ? 5.0 * h0 : r->h1;
    double m = r->is_end ? 0.0 : 0.5 * (r->d0 + r->d1), in = m, out = m;
    int is_extreme = (r->rise0 <= 0.0 && r->rise1 <= 0.0) || (r->rise0 >= 0.0 && r->rise1 >= 0.0);
    double in_clamped = is_extreme ? 0.0 : clamped_slope(m, -h0 * part, r->rise0);
    double out_clamped = is_extreme ? 0.0 : clamped_slope(m, h1 * part, r->rise1);
    in = types.in == NKW_HANDLE_AUTO_CLAMPED ? in_clamped : in;
    out = types.out == NKW_HANDLE_AUTO_CLAMPED ? out_clamped : out;
    /* The handle that was clamped turns the other one, which is auto too. */
    if (is_auto(types.in) && is_auto(types.out) && in != out && !is_extreme) {
        in = in != m ? in : out;
        out = in;
    }
    if (is_auto(types.in))
        key->in = handle_along(-h0 * part, in);
    if (is_auto(types.out))
        key->out = handle_along(h1 * part, out);
}

/* The handle with its own time and the slope of the other one. */
static nkw_handle aligned(nkw_handle handle, nkw_handle other)
{
    if (other.time == 0.0f)
        return handle;
    return handle_along((double)handle.time, (double)other.value / (double)other.time);
}

void nkw_fcurve_auto_handles(nkw_fcurve_key *keys, size_t count, const nkw_handle_types *types)
{
    for (size_t k = 0; k < count && count > 1; k++) {
        around r = around_key(keys, count, k);
        set_auto(keys + k, &r, types[k]);
        if (types[k].in == NKW_HANDLE_VECTOR)
            keys[k].in = handle_along(-r.h0 / 3.0, r.d0);
        if (types[k].out == NKW_HANDLE_VECTOR)
            keys[k].out = handle_along(r.h1 / 3.0, r.d1);
        if (types[k].out == NKW_HANDLE_ALIGNED)
            keys[k].out = aligned(keys[k].out, keys[k].in);
        else if (types[k].in == NKW_HANDLE_ALIGNED)
            keys[k].in = aligned(keys[k].in, keys[k].out);
    }
}
