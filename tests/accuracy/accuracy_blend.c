/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/blend.h> against binary128: one joint, drawn from its seed. */
#include "wide.h"
#include "../support/views.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <string.h>

#define SAMPLES 15000u
#define LAYERS  8

typedef enum part { TURN, NUMBERS } part;

static nkw_trs draw_trs(random_source *r)
{
    nkw_trs trs = {random_vec3(r, -5.0f, 5.0f), random_unit_quat(r), random_vec3(r, 0.5f, 2.0f)};
    return trs;
}

/* Layers alone; and a rest pose to make up for what they leave of the threshold, without masks and with them. */
typedef enum filling { LAYERS_ALONE, FILLED, MASKED } filling;

/* The layers, then the rest pose, and how much each of them counts. */
typedef struct blend {
    float pose[LAYERS + 1][NKW_POSE_FLOATS(1)], mask[LAYERS][NKW_POSE_STRIDE(1)], threshold;
    nkw_pose_layer layer[LAYERS];
    nkw_quat middle;
    wide weight[LAYERS + 1], total;
} blend;

/*
 * Rotations within 0.7 radians of one another, so that all agree on the side; a threshold of one to two times the sum.
 * What is not judged is that of the identity.
 */
static void draw_blend(blend *b, const float *x, int count, filling how, part judged)
{
    random_source r = wide_source(x);
    b->middle = judged == TURN ? random_unit_quat(&r) : nkw_quat_identity();
    b->total = 0;
    for (int i = 0; i <= count; i++) {
        nkw_trs trs = nkw_trs_identity();
        if (judged == TURN)
            trs.rotation = nkw_quat_scale(random_unit_near(&r, b->middle, 0.35f * random_unit(&r)), random_sign(&r));
        else
            trs.translation.x = random_between(&r, -5.0f, 5.0f);
        nkw_pose_from_trs(&trs, pose_span(b->pose[i], 1));
    }
    for (int i = 0; i < count; i++) {
        nkw_pose_layer l = {pose_view(b->pose[i], 1), random_log(&r, 1e-2f, 1.0f),
                            mask_view(how == MASKED ? b->mask[i] : NULL, 1)};
        b->mask[i][0] = how == MASKED ? random_between(&r, 0.1f, 1.0f) : 1.0f;
        b->layer[i] = l;
        b->weight[i] = (wide)l.weight * b->mask[i][0];
        b->total += b->weight[i];
    }
    b->threshold = how == LAYERS_ALONE ? 0.0f : (float)b->total * random_between(&r, 1.0f, 2.0f);
    b->weight[count] = b->threshold > b->total ? b->threshold - b->total : 0;
    b->total += b->weight[count];
}

/* The pose's numbers, the rotation on the side of another one. */
static void numbers_of(const float *pose, nkw_quat side, float v[10])
{
    nkw_trs trs = nkw_pose_get(pose_view(pose, 1), 0);
    put_vec3(v, trs.translation);
    put_quat(v + 3, nkw_quat_dot(trs.rotation, side) < 0.0f ? nkw_quat_negate(trs.rotation) : trs.rotation);
    put_vec3(v + 7, trs.scale);
}

/* The weighted mean: of rotations of 1; of a translation's x of the largest summand, as of any number. */
static double layers_error(const float *x, int count, filling how, part judged)
{
    static blend b;
    static float out[NKW_POSE_FLOATS(1)];
    float v[10];
    wide sum[10] = {0};
    double largest = 0.0;
    draw_blend(&b, x, count, how, judged);
    for (int i = 0; i <= count; i++) {
        numbers_of(b.pose[i], b.middle, v);
        for (int c = 0; c < 10; c++)
            sum[c] += b.weight[i] * v[c];
        largest = b.weight[i] > 0 ? fmax(largest, fabs((double)v[0])) : largest;
    }
    nkw_pose_layers_blend(b.layer, (size_t)count, pose_view(b.pose[count], 1), b.threshold, pose_span(out, 1));
    numbers_of(out, b.middle, v);
    wide_normalize(sum + 3, 4);
    return judged == TURN ? wide_error(v + 3, sum + 3, 4)
                          : accuracy_units((double)v[0], (double)(sum[0] / b.total), largest);
}

#define LAYERS_CASE(name, count, how, judged)                                                                          \
    static double name(const float *x)                                                                                 \
    {                                                                                                                  \
        return layers_error(x, count, how, judged);                                                                    \
    }

/* A = sum of w_i w_k s_ik q_i q_k^T; returns 0 if all signs agree, or one is not clear in binary32. */
static int mean_form(const blend *b, int count, wide a[16])
{
    wide q[LAYERS][4], s[LAYERS][LAYERS];
    int odd = 0;
    for (int i = 0; i < count; i++) {
        float v[4];
        put_quat(v, nkw_pose_get(pose_view(b->pose[i], 1), 0).rotation);
        wide_from(v, q[i], 4);
    }
    for (int i = 0; i < count; i++)
        for (int k = 0; k < count; k++) {
            const wide dot = wide_dot(q[i], q[k], 4);
            if (dot < 1e-3 && dot > -1e-3)
                return 0;
            s[i][k] = dot < 0 ? -1 : 1;
        }
    for (int i = 0; i < count; i++)
        for (int k = 0; k < count; k++) {
            odd |= s[0][i] * s[i][k] * s[k][0] < 0;
            for (int c = 0; c < 16; c++)
                a[c] += b->weight[i] * b->weight[k] * s[i][k] * q[i][c / 4] * q[k][c % 4];
        }
    return odd;
}

/* Each column of a squared 2^9 times is the eigenvector, unless the two largest eigenvalues are nearly equal. */
static int form_axis(wide a[16], wide axis[4])
{
    for (int n = 0; n < 9; n++) {
        wide m[16] = {0}, trace = a[0] + a[5] + a[10] + a[15];
        for (int c = 0; c < 64; c++)
            m[c / 4] += a[c / 16 * 4 + c % 4] * a[c % 4 * 4 + c / 4 % 4] / (trace * trace);
        memcpy(a, m, sizeof m);
    }
    const wide trace = a[0] + a[5] + a[10] + a[15], length = wide_length(a, 16);
    int largest = 0;
    for (int c = 1; c < 4; c++)
        largest = a[5 * c] > a[5 * largest] ? c : largest;
    memcpy(axis, a + 4 * largest, 4 * sizeof *axis);
    wide_normalize(axis, 4);
    return trace - length < 1e-15 * trace;
}

/* Rotations anywhere, of which no signs make all dot products positive. */
static double odd_error(const float *x)
{
    static blend b;
    static float out[NKW_POSE_FLOATS(1)];
    wide a[16] = {0}, axis[4];
    float v[4];
    random_source r = wide_source(x);
    const int count = 3 + (int)(random_bits(&r) % (LAYERS - 2));
    draw_blend(&b, x, count, LAYERS_ALONE, TURN);
    for (int i = 0; i < count; i++) {
        nkw_trs trs = nkw_trs_identity();
        trs.rotation = random_unit_quat(&r);
        nkw_pose_from_trs(&trs, pose_span(b.pose[i], 1));
    }
    if (!mean_form(&b, count, a) || !form_axis(a, axis))
        return 0.0;
    nkw_pose_layers_blend(b.layer, (size_t)count, pose_view(b.pose[count], 1), 0.0f, pose_span(out, 1));
    put_quat(v, nkw_pose_get(pose_view(out, 1), 0).rotation);
    return wide_error_either(v, axis, 4);
}

LAYERS_CASE(turns_4, 4, LAYERS_ALONE, TURN)
LAYERS_CASE(turns_8, 8, LAYERS_ALONE, TURN)
LAYERS_CASE(turns_filled, 8, FILLED, TURN)
LAYERS_CASE(turns_masked, 8, MASKED, TURN)
LAYERS_CASE(numbers_8, 8, LAYERS_ALONE, NUMBERS)
LAYERS_CASE(numbers_filled_1, 1, FILLED, NUMBERS)
LAYERS_CASE(numbers_filled, 8, FILLED, NUMBERS)
LAYERS_CASE(numbers_masked, 8, MASKED, NUMBERS)

/* apply(build(a, ref), ref) against a. */
static double back_error(const float *x, nkw_additive side, part judged)
{
    random_source r = wide_source(x);
    static float a[NKW_POSE_FLOATS(1)], ref[NKW_POSE_FLOATS(1)], out[NKW_POSE_FLOATS(1)];
    nkw_trs want = draw_trs(&r), base = draw_trs(&r);
    nkw_pose_from_trs(&want, pose_span(a, 1));
    nkw_pose_from_trs(&base, pose_span(ref, 1));
    nkw_pose_additive_build(pose_view(a, 1), pose_view(ref, 1), side, pose_span(out, 1));
    nkw_pose_additive_apply(pose_view(ref, 1), pose_view(out, 1), 1.0f, mask_view(NULL, 1), side, pose_span(out, 1));
    nkw_trs got = nkw_pose_get(pose_view(out, 1), 0);
    if (judged == TURN) {
        float g[4], w[4];
        wide exact[4];
        put_quat(g, got.rotation);
        put_quat(w, want.rotation);
        wide_from(w, exact, 4);
        return wide_error(g, exact, 4);
    }
    const float *g = &got.scale.x, *w = &want.scale.x;
    const float *gt = &got.translation.x, *wt = &want.translation.x, *bt = &base.translation.x;
    double worst = 0.0;
    for (int c = 0; c < 3; c++) {
        double magnitude = fabs((double)wt[c] - (double)bt[c]) + fabs((double)wt[c]);
        worst = fmax(worst, accuracy_units((double)g[c], (double)w[c], (double)w[c]));
        worst = fmax(worst, accuracy_units((double)gt[c], (double)wt[c], magnitude));
    }
    return worst;
}

static double local_turn(const float *x)
{
    return back_error(x, NKW_ADDITIVE_LOCAL, TURN);
}

static double parent_turn(const float *x)
{
    return back_error(x, NKW_ADDITIVE_PARENT, TURN);
}

static double numbers_back(const float *x)
{
    return back_error(x, NKW_ADDITIVE_LOCAL, NUMBERS);
}

#define MEAN  "nkw_pose_layers_blend"
#define APPLY "nkw_pose_additive_apply"

static const wide_case cases[] = {
    {MEAN, "rotations, 4 layers", wide_seed, turns_4, 2, WIDE_CHECKED},
    {MEAN, "rotations, 8 layers", wide_seed, turns_8, 2, WIDE_CHECKED},
    {MEAN, "rotations, 8 layers and the rest pose", wide_seed, turns_filled, 2, WIDE_CHECKED},
    {MEAN, "rotations, the same with masks", wide_seed, turns_masked, 2, WIDE_CHECKED},
    {MEAN, "rotations, 3 to 8 layers whose signs disagree", wide_seed, odd_error, 2, WIDE_CHECKED},
    {MEAN, "numbers, 8 layers", wide_seed, numbers_8, 2, WIDE_CHECKED},
    {MEAN, "numbers, a layer and the rest pose", wide_seed, numbers_filled_1, 2, WIDE_CHECKED},
    {MEAN, "numbers, 8 layers and the rest pose", wide_seed, numbers_filled, 2, WIDE_CHECKED},
    {MEAN, "numbers, the same with masks", wide_seed, numbers_masked, 2, WIDE_CHECKED},
    {APPLY, "rotations back, local", wide_seed, local_turn, 2, WIDE_CHECKED},
    {APPLY, "rotations back, in the parent's axes", wide_seed, parent_turn, 2, WIDE_CHECKED},
    {APPLY, "translations and scales back", wide_seed, numbers_back, 2, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("blend.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
