/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/blend.h> against binary128: one joint, drawn from its seed. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 40000u
#define LAYERS  8

typedef enum part { TURN, NUMBERS } part;

static nkw_trs draw_trs(random_source *r)
{
    nkw_trs trs = {random_vec3(r, -5.0f, 5.0f), random_unit_quat(r), random_vec3(r, 0.5f, 2.0f)};
    return trs;
}

static nkw_quat rotation_of(const nkw_trs *trs, nkw_quat side)
{
    return nkw_quat_dot(trs->rotation, side) < 0.0f ? nkw_quat_negate(trs->rotation) : trs->rotation;
}

/*
 * The weighted mean of layers within 0.7 radians of one rotation, so that all agree on the side; of 1 for
 * rotations, of the largest summand for translation and scale.
 */
static double layers_error(const float *x, int count, part judged)
{
    random_source r = wide_source(x);
    static float pose[LAYERS][NKW_POSE_FLOATS(1)], out[NKW_POSE_FLOATS(1)];
    nkw_pose_layer layer[LAYERS];
    nkw_trs trs[LAYERS];
    wide sum[10] = {0}, total = 0, largest[10] = {0};
    nkw_quat middle = random_unit_quat(&r);
    for (int i = 0; i < count; i++) {
        nkw_pose_layer l = {pose[i], random_log(&r, 1e-2f, 1.0f), NULL};
        trs[i] = draw_trs(&r);
        trs[i].rotation = nkw_quat_scale(random_unit_near(&r, middle, 0.35f * random_unit(&r)), random_sign(&r));
        nkw_pose_identity(pose[i], 1);
        nkw_pose_set(pose[i], 1, 0, &trs[i]);
        layer[i] = l;
        total += l.weight;
    }
    for (int i = 0; i < count; i++) {
        float v[10];
        put_vec3(v, trs[i].translation);
        put_quat(v + 3, rotation_of(&trs[i], middle));
        put_vec3(v + 7, trs[i].scale);
        for (int c = 0; c < 10; c++) {
            wide term = layer[i].weight * (wide)v[c];
            sum[c] += term;
            largest[c] = (wide)fabs((double)v[c]) > largest[c] ? (wide)fabs((double)v[c]) : largest[c];
        }
    }
    nkw_pose_blend_layers(layer, (size_t)count, pose[0], 1, 0.0f, out);
    nkw_trs got = nkw_pose_get(out, 1, 0);
    float g[10];
    put_vec3(g, got.translation);
    put_quat(g + 3, got.rotation);
    put_vec3(g + 7, got.scale);
    if (judged == TURN) {
        wide_normalize(sum + 3, 4);
        return wide_error_either(g + 3, sum + 3, 4);
    }
    double worst = 0.0;
    for (int c = 0; c < 10; c += c == 2 ? 5 : 1)
        worst = fmax(worst, accuracy_units((double)g[c], (double)(sum[c] / total), (double)largest[c]));
    return worst;
}

static double turns_4(const float *x)
{
    return layers_error(x, 4, TURN);
}

static double turns_8(const float *x)
{
    return layers_error(x, 8, TURN);
}

static double numbers_8(const float *x)
{
    return layers_error(x, 8, NUMBERS);
}

/* apply(build(a, ref), ref) against a. */
static double back_error(const float *x, nkw_additive side, part judged)
{
    random_source r = wide_source(x);
    static float a[NKW_POSE_FLOATS(1)], ref[NKW_POSE_FLOATS(1)], out[NKW_POSE_FLOATS(1)];
    nkw_trs want = draw_trs(&r), base = draw_trs(&r);
    nkw_pose_from_trs(&want, 1, a);
    nkw_pose_from_trs(&base, 1, ref);
    nkw_pose_additive_build(a, ref, 1, side, out);
    nkw_pose_additive_apply(ref, out, 1, side, 1.0f, NULL, out);
    nkw_trs got = nkw_pose_get(out, 1, 0);
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

#define MEAN  "nkw_pose_blend_layers"
#define APPLY "nkw_pose_additive_apply"

static const wide_case cases[] = {
    {MEAN, "rotations, 4 layers", wide_seed, turns_4, 2, WIDE_CHECKED},
    {MEAN, "rotations, 8 layers", wide_seed, turns_8, 2, WIDE_CHECKED},
    {MEAN, "translations and scales, 8 layers", wide_seed, numbers_8, 2, WIDE_CHECKED},
    {APPLY, "rotations back, local", wide_seed, local_turn, 2, WIDE_CHECKED},
    {APPLY, "rotations back, in the parent's axes", wide_seed, parent_turn, 2, WIDE_CHECKED},
    {APPLY, "translations and scales back", wide_seed, numbers_back, 2, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("blend.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
