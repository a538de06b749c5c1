/* SPDX-License-Identifier: MIT */
/*
 * An AnimationCurve as an fcurve. Key i has flags and four floats; several keys may share them (KeyAttrRefCount):
 *
 *     0x2 constant, with 0x100 of the next key     0x4 linear     0x8 cubic:
 *     0x200 TCB         floats: tension, continuity, bias
 *     0x400 user        floats: slope to the right, slope to the left of the next key; units per second
 *     otherwise auto    floats: bias to the right, bias to the left of the next key, in percent
 *         0x1000 level beside an equal key, 0x4000 never beyond a neighbour, 0x2000 without the times of the keys
 *     0x1000000, 0x2000000   the third float has weights of four decimals: low half to the right, high half to the
 *                            left of the next key; otherwise a third
 */
#include <math.h>
#include <string.h>

#include <nakawari/dialect.h>
#include <nakawari/scalar.h>

#include "fbx.h"

enum {
    CONSTANT = 0x2,
    CUBIC = 0x8,
    NEXT = 0x100,
    TCB = 0x200,
    USER = 0x400,
    CLAMP = 0x1000,
    NO_TIMES = 0x2000,
    PROGRESSIVE = 0x4000,
    LINEAR = 0x4,
    WEIGHT_RIGHT = 0x1000000,
    WEIGHT_NEXT = 0x2000000
};

/* The arrays of a curve while it is read. */
typedef struct arrays {
    const double *ticks, *values, *flags, *data, *repeats;
    double ticks_per_second;
    size_t count, value_count, flag_count, data_count, repeat_count;
    int is_bits; /* data are the bits of floats as integers */
} arrays;

/* A key and its neighbours. Slopes are units per second. */
typedef struct key {
    double before, after; /* seconds to the neighbours; 0 where there is none */
    double slope_before, slope_after; /* of the lines to them */
    double gap_before, gap_after; /* of their values, absolute */
    double weight_in, weight_out;
    uint32_t flags;
} key;

static float float_of(const arrays *a, size_t index)
{
    float number = 0.0f;
    if (index >= a->data_count)
        return 0.0f;
    if (!a->is_bits)
        return nkw_abs((float)a->data[index]) <= 3e38f ? (float)a->data[index] : 0.0f;
    const double d = a->data[index];
    const uint32_t bits = d >= -2147483648.0 && d < 4294967296.0 ? (uint32_t)(int64_t)d : 0;
    memcpy(&number, &bits, sizeof number);
    return number == number ? number : 0.0f;
}

static uint32_t bits_of(const arrays *a, size_t index)
{
    uint32_t bits = 0;
    const float number = float_of(a, index);
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

/* The slope from the key before to the key after. */
static double slope_across(const key *k)
{
    return (k->slope_before * k->before + k->slope_after * k->after) / (k->before + k->after);
}

/* As ufbx has it: half of the slope between the neighbours, half of a mean by the times, and the bias. */
static double biased_slope(const key *k, double bias)
{
    const double part = k->before / (k->before + k->after);
    double slope = 0.5 * slope_across(k) + 0.5 * (k->slope_before * (1.0 - part) + k->slope_after * part);
    const double weight = fabs(bias) / 100.0, target = bias > 0.0 ? k->slope_after : k->slope_before;
    if (weight <= 0.0001)
        return slope;
    const double step = target - slope, sign = fabs(step) > 0.00001 ? step : bias;
    slope = slope * (1.0 - weight) + target * weight;
    return slope + (weight > 5.0 ? (sign > 0.0 ? 40.0 : -40.0) * (weight - 5.0) * (weight - 5.0) : 0.0);
}

/* The slope at which a handle ends at the value of its neighbour; 0 in the other direction. */
static double limit_of(double sign, double slope, double weight)
{
    const double limit = weight > 0.0 ? sign * slope / weight : 0.0;
    return limit > 0.0 ? limit : 0.0;
}

static double auto_slope(const key *k, double bias)
{
    const int first = k->before <= 0.0, last = k->after <= 0.0;
    if (first && last)
        return 0.0;
    if (k->flags & CLAMP && ((!first && k->gap_before <= 0.0) || (!last && k->gap_after <= 0.0)))
        return 0.0;
    if (first || last) {
        const double weight = k->flags & NO_TIMES ? 0.0 : fabs(bias) / 100.0 - 5.0;
        const double line = first ? k->slope_after : k->slope_before;
        return k->flags & PROGRESSIVE ? 0.0
                                      : line + (weight > 0.0 ? (bias > 0.0 ? 40.0 : -40.0) * weight * weight : 0.0);
    }
    double slope = k->flags & NO_TIMES ? slope_across(k) : biased_slope(k, bias);
    if (k->flags & PROGRESSIVE) {
        const double sign = slope >= 0.0 ? 1.0 : -1.0;
        double size = sign * slope;
        const double left = limit_of(sign, k->slope_before, k->weight_in);
        const double right = limit_of(sign, k->slope_after, k->weight_out);
        size = size > left ? left : size;
        slope = sign * (size > right ? right : size);
    }
    return slope;
}

/* Kochanek and Bartels, for slopes per second. At an end of the curve the factor is 1, and the line outside is level. */
static void tcb_slopes(const key *k, double t, double c, double b, double *in, double *out)
{
    const double half = k->before > 0.0 && k->after > 0.0 ? 0.5 : 1.0, f = half * (1.0 - t);
    *in = f * ((1.0 + b) * (1.0 - c) * k->slope_before + (1.0 - b) * (1.0 + c) * k->slope_after);
    *out = f * ((1.0 + b) * (1.0 + c) * k->slope_before + (1.0 - b) * (1.0 - c) * k->slope_after);
}

/* What the key before states of the next one. */
typedef struct carry {
    double slope, weight;
} carry;

static void set_slopes(const arrays *a, size_t attribute, key *k, carry *in, nkw_slope_key *out)
{
    const size_t first = 4 * attribute;
    const uint32_t packed = bits_of(a, first + 2), f = k->flags;
    const double third = 1.0 / 3.0, right = (double)float_of(a, first), next = (double)float_of(a, first + 1);
    double slope_in = in->slope, slope_out = right;
    carry following = {next, f & WEIGHT_NEXT ? 1e-4 * (packed >> 16) : third};
    k->weight_in = in->weight;
    k->weight_out = f & WEIGHT_RIGHT ? 1e-4 * (packed & 0xffff) : third;
    out->kind = !(f & CUBIC) ? NKW_FCURVE_LINEAR : NKW_FCURVE_BEZIER;
    if (f & CONSTANT)
        out->kind = f & NEXT ? NKW_FCURVE_CONSTANT_NEXT : NKW_FCURVE_CONSTANT;
    if (out->kind != NKW_FCURVE_BEZIER) {
        const carry line = {out->kind == NKW_FCURVE_LINEAR ? k->slope_after : 0.0, third};
        slope_out = line.slope;
        k->weight_out = third;
        following = line;
    } else if (f & TCB) {
        const carry none = {0.0, third};
        tcb_slopes(k, right, next, (double)float_of(a, first + 2), &slope_in, &slope_out);
        k->weight_out = third;
        following = none;
    } else if (!(f & USER)) {
        const int one = fabs(slope_in + right) <= 0.0001 || k->before <= 0.0 || k->after <= 0.0;
        slope_out = auto_slope(k, right);
        slope_in = one ? (k->after <= 0.0 ? auto_slope(k, -slope_in) : slope_out) : auto_slope(k, -slope_in);
        slope_out = k->after <= 0.0 ? slope_in : slope_out;
    }
    out->in_slope = (float)slope_in, out->out_slope = (float)slope_out;
    out->in_weight = (float)k->weight_in, out->out_weight = (float)k->weight_out;
    out->weighted = NKW_WEIGHTED_BOTH;
    *in = following;
}

static key key_at(const arrays *a, size_t i)
{
    const double t = a->ticks[i] / a->ticks_per_second, v = a->values[i];
    key k = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0 / 3.0, 1.0 / 3.0, LINEAR};
    if (i > 0) {
        k.before = t - a->ticks[i - 1] / a->ticks_per_second;
        k.gap_before = fabs(v - a->values[i - 1]);
        k.slope_before = k.before > 0.0 ? (v - a->values[i - 1]) / k.before : 0.0;
    }
    if (i + 1 < a->count) {
        k.after = a->ticks[i + 1] / a->ticks_per_second - t;
        k.gap_after = fabs(v - a->values[i + 1]);
        k.slope_after = k.after > 0.0 ? (a->values[i + 1] - v) / k.after : 0.0;
    }
    return k;
}

static void make_keys(const arrays *a, nkw_slope_key *out)
{
    carry in = {0.0, 1.0 / 3.0};
    size_t attribute = 0;
    double left = a->repeat_count > 0 ? a->repeats[0] : 1e300;
    for (size_t i = 0; i < a->count; i++) {
        key k = key_at(a, i);
        const double flags = attribute < a->flag_count ? a->flags[attribute] : (double)LINEAR;
        k.flags = flags >= -2147483648.0 && flags < 4294967296.0 ? (uint32_t)(int64_t)flags : (uint32_t)LINEAR;
        out[i].time = (float)(a->ticks[i] / a->ticks_per_second);
        out[i].value = (float)a->values[i];
        set_slopes(a, attribute, &k, &in, &out[i]);
        left -= 1.0;
        if (left <= 0.0 && attribute + 1 < a->repeat_count)
            left = a->repeats[++attribute];
    }
    /* A line outside the keys has the slope inside. */
    if (a->count > 0) {
        out[0].in_slope = out[0].out_slope;
        out[a->count - 1].out_slope = out[a->count - 1].in_slope;
    }
}

/* Pre-Extrapolation and Post-Extrapolation: a type, as the code of a letter, and a number of repetitions. */
static nkw_fcurve_outside outside_of(const nkwi_fbx_tree *tree, size_t node, uint32_t *cycles)
{
    static const char letters[] = "CKRAM"; /* constant, slope, repeat, repeat with offset, mirror */
    const nkwi_fbx_value *type = nkwi_fbx_at(tree, nkwi_fbx_below(tree, node, "Type"), 0);
    const nkwi_fbx_value *times = nkwi_fbx_at(tree, nkwi_fbx_below(tree, node, "Repetition"), 0);
    const int letter = !type                                   ? 'C'
                       : type->kind == 'S' && type->bytes == 1 ? type->text[0]
                                                               : (int)(type->integer & 0x7f);
    const char *at = letter ? strchr(letters, letter) : NULL;
    const nkw_fcurve_outside outside = at ? (nkw_fcurve_outside)(at - letters) : NKW_FCURVE_OUTSIDE_HOLD;
    *cycles = times && times->integer > 0 && times->integer < UINT32_MAX ? (uint32_t)times->integer : 0;
    return times && times->integer == 0 && outside >= NKW_FCURVE_OUTSIDE_CYCLE ? NKW_FCURVE_OUTSIDE_HOLD : outside;
}

static const double *numbers(nkwi_fbx *fbx, size_t node, const char *name, size_t *count)
{
    const size_t list = nkwi_fbx_below(&fbx->tree, node, name);
    *count = 0;
    return list == NKWI_FBX_NONE ? NULL : nkwi_fbx_numbers(&fbx->tree, list, fbx->memory, count);
}

int nkwi_fbx_curve_read(nkwi_fbx *fbx, size_t object, nkwi_fbx_curve *out)
{
    const size_t node = fbx->objects[object].node;
    arrays a;
    a.ticks_per_second = fbx->ticks;
    a.ticks = numbers(fbx, node, "KeyTime", &a.count);
    a.values = numbers(fbx, node, "KeyValueFloat", &a.value_count);
    a.flags = numbers(fbx, node, "KeyAttrFlags", &a.flag_count);
    a.data = numbers(fbx, node, "KeyAttrDataFloat", &a.data_count);
    a.repeats = numbers(fbx, node, "KeyAttrRefCount", &a.repeat_count);
    a.is_bits = fbx->tree.is_text && fbx->tree.version >= 7200;
    memset(out, 0, sizeof *out);
    if (fbx->tree.fault)
        return 0;
    a.count = a.count < a.value_count ? a.count : a.value_count;
    nkw_slope_key *slopes = (nkw_slope_key *)nkwi_take(fbx->memory, a.count, sizeof *slopes);
    nkw_fcurve_key *keys = (nkw_fcurve_key *)nkwi_take(fbx->memory, a.count, sizeof *keys);
    if (!slopes || !keys)
        return nkwi_fbx_fail(&fbx->tree, 0, "no memory for the keys");
    make_keys(&a, slopes);
    if (a.count > 0 && nkw_fcurve_from_slope_keys(slopes, a.count, NKW_WEIGHT_FRACTION, keys, NULL) != NKW_OK)
        return fbx->bad_curves++, 1; /* not finite, or not in the order of their times */
    out->curve.keys = keys;
    out->curve.key_count = a.count;
    out->curve.before =
        outside_of(&fbx->tree, nkwi_fbx_below(&fbx->tree, node, "Pre-Extrapolation"), &out->curve.before_cycles);
    out->curve.after =
        outside_of(&fbx->tree, nkwi_fbx_below(&fbx->tree, node, "Post-Extrapolation"), &out->curve.after_cycles);
    out->curve.policy = NKW_HANDLE_NONE;
    return 1;
}
