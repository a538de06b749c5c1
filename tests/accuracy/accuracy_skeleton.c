/* SPDX-License-Identifier: MIT */
/*
 * Errors of <nakawari/skeleton.h> against binary128, drawn from seeds: chains, in which errors add up, and skeletons
 * like a body's.
 */
#include "wide.h"
#include "../support/views.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 1000u
#define MOST    1000

typedef enum shape { CHAIN, BODY } shape;

/* What of the models is judged. */
typedef enum part { AXES, PLACE } part;
typedef enum way { FROM_POSE, FROM_LOCALS } way;

static int32_t parents[MOST];
static float pose[NKW_POSE_FLOATS(MOST)];
static nkw_mat4 models[MOST];
static wide exact[MOST][16];
static wide reach[MOST]; /* the bones from the root on, laid end to end */
static int depth[MOST];

static void draw_joint(random_source *r, shape form, int j, int joints, float low)
{
    float even = random_log(r, low, 1.0f / low);
    nkw_trs trs = {random_vec3(r, -1.0f, 1.0f), random_unit_quat(r), {even, even, even}};
    wide local[16], bone[3];
    int parent = form == CHAIN ? j - 1
                 : j           ? (int)(random_bits(r) % (uint64_t)(j < 8 ? j : 8)) + (j < 8 ? 0 : j - 8)
                               : -1;
    parents[j] = parent;
    nkw_pose_set(pose_span(pose, (size_t)joints), (size_t)j, &trs);
    wide_mat4_from_trs(&trs, local);
    if (parent < 0)
        wide_from(nkw_mat4_identity().m, exact[j], 16);
    wide_mat_mul(parent < 0 ? exact[j] : exact[parent], local, exact[j], 4);
    for (int i = 0; i < 3; i++)
        bone[i] = exact[j][12 + i] - (parent < 0 ? 0 : exact[parent][12 + i]);
    reach[j] = (parent < 0 ? 0 : reach[parent]) + wide_length(bone, 3);
    depth[j] = parent < 0 ? 1 : depth[parent] + 1;
}

/* Axes: 3x3 block of its norm; place: of the bones' length; per joint from the root on. The worst of the skeleton. */
static double models_error(const float *x, shape form, int joints, float low, part judged, way from)
{
    random_source r = wide_source(x);
    nkw_skeleton skeleton = {parents, (size_t)joints};
    double worst = 0.0;
    for (int j = 0; j < joints; j++)
        draw_joint(&r, form, j, joints, low);
    if (from == FROM_POSE) {
        nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, skeleton.joint_count), NULL, NULL, models);
    } else {
        for (int j = 0; j < joints; j++) {
            nkw_trs trs = nkw_pose_get(pose_view(pose, (size_t)joints), (size_t)j);
            models[j] = nkw_mat4_from_trs(&trs);
        }
        nkw_skeleton_models_from_locals(&skeleton, models, NULL, NULL, models);
    }
    for (int j = 0; j < joints; j++) {
        wide want[9];
        float got[9];
        wide_block(exact[j], want);
        for (int i = 0; i < 9; i++)
            got[i] = models[j].m[i / 3 * 4 + i % 3];
        double error =
            judged == AXES ? wide_error(got, want, 9) : wide_error_of(models[j].m + 12, exact[j] + 12, 3, reach[j]);
        worst = fmax(worst, error / depth[j]);
    }
    return worst;
}

#define CASE(name, form, joints, low, judged, from)                                                                    \
    static double name(const float *x)                                                                                 \
    {                                                                                                                  \
        return models_error(x, form, joints, low, judged, from);                                                       \
    }

CASE(body_axes, BODY, 67, 1.0f, AXES, FROM_POSE)
CASE(body_places, BODY, 67, 1.0f, PLACE, FROM_POSE)
CASE(scaled_axes, BODY, 67, 0.8f, AXES, FROM_POSE)
CASE(scaled_places, BODY, 67, 0.8f, PLACE, FROM_POSE)
CASE(chain_axes, CHAIN, 67, 1.0f, AXES, FROM_POSE)
CASE(chain_places, CHAIN, 67, 1.0f, PLACE, FROM_POSE)
CASE(pair_axes, CHAIN, 2, 0.8f, AXES, FROM_POSE)
CASE(pair_places, CHAIN, 2, 0.8f, PLACE, FROM_POSE)
CASE(local_axes, BODY, 67, 0.8f, AXES, FROM_LOCALS)

/* The error of the last joint of a chain, whole, not per joint: how it grows. */
static double last_error(const float *x, int joints, part judged)
{
    double error = models_error(x, CHAIN, joints, 1.0f, judged, FROM_POSE);
    wide want[9];
    float got[9];
    int j = joints - 1;
    wide_block(exact[j], want);
    for (int i = 0; i < 9; i++)
        got[i] = models[j].m[i / 3 * 4 + i % 3];
    return error != error   ? error
           : judged == AXES ? wide_error(got, want, 9)
                            : wide_error_of(models[j].m + 12, exact[j] + 12, 3, reach[j]);
}

#define LAST(name, joints, judged)                                                                                     \
    static double name(const float *x)                                                                                 \
    {                                                                                                                  \
        return last_error(x, joints, judged);                                                                          \
    }

LAST(last_axes_67, 67, AXES)
LAST(last_places_67, 67, PLACE)
LAST(last_axes_1000, 1000, AXES)
LAST(last_places_1000, 1000, PLACE)

/* Models of the drawn body back to locals: against the pose that made them, of the local's norm. */
static double back_error(const float *x, int joints)
{
    double worst = models_error(x, BODY, joints, 0.8f, AXES, FROM_POSE);
    static nkw_mat4 locals[MOST];
    nkw_skeleton skeleton = {parents, (size_t)joints};
    if (worst != worst)
        return worst;
    nkw_skeleton_locals_from_models(&skeleton, models, NULL, locals);
    worst = 0.0;
    for (int j = 0; j < joints; j++) {
        wide parent[16], inverse[16], model[16], want[16];
        wide_from(models[j].m, model, 16);
        wide_from(parents[j] < 0 ? nkw_mat4_identity().m : models[parents[j]].m, parent, 16);
        wide_inverse(parent, inverse, 4);
        wide_mat_mul(inverse, model, want, 4);
        worst = fmax(worst, wide_error_of(locals[j].m, want, 12, wide_length(inverse, 12) * wide_length(model, 12)));
    }
    return worst;
}

/* A parent and a joint, each of its own scales: x, y, z by themselves. */
static void uneven_pair(random_source *r, float *x)
{
    for (int j = 0; j < 2; j++) {
        put_vec3(x + 10 * j, random_vec3(r, -1.0f, 1.0f));
        put_quat(x + 10 * j + 3, random_unit_quat(r));
        for (int i = 0; i < 3; i++)
            x[10 * j + 7 + i] = nkw_abs(random_scaled(r, -6, 6));
    }
}

static void far_pair(random_source *r, float *x)
{
    uneven_pair(r, x);
    for (int i = 0; i < 3; i++) {
        x[10 + i] *= nkw_abs(random_scaled(r, -20, 20));
        x[17 + i] *= 0x1p-30f;
    }
}

/* The block and the translation of the local matrix, each of its own norms. */
static double locals_error(const float *x)
{
    static const int32_t above[2] = {NKW_NO_JOINT, 0};
    const nkw_skeleton skeleton = {above, 2};
    nkw_mat4 pair[2], locals[2];
    wide parent[16], inverse[16], model[16], want[16], block[9], inverse_block[9], model_block[9];
    float got[9];
    for (int j = 0; j < 2; j++) {
        const float *f = x + 10 * j;
        nkw_trs trs = {vec3_at(f), quat_at(f + 3), vec3_at(f + 7)};
        pair[j] = nkw_mat4_from_trs(&trs);
    }
    nkw_skeleton_locals_from_models(&skeleton, pair, NULL, locals);
    wide_from(pair[0].m, parent, 16);
    wide_from(pair[1].m, model, 16);
    wide_inverse(parent, inverse, 4);
    wide_mat_mul(inverse, model, want, 4);
    wide_block(want, block);
    wide_block(inverse, inverse_block);
    wide_block(model, model_block);
    for (int i = 0; i < 9; i++)
        got[i] = locals[1].m[i / 3 * 4 + i % 3];
    wide size = wide_length(inverse_block, 9), ways = wide_length(parent + 12, 3) + wide_length(model + 12, 3);
    return fmax(wide_error_of(got, block, 9, size * wide_length(model_block, 9)),
                wide_error_of(locals[1].m + 12, want + 12, 3, size * ways));
}

static double body_back(const float *x)
{
    return back_error(x, 67);
}

static double pair_back(const float *x)
{
    return back_error(x, 2);
}

#define MODELS "nkw_skeleton_models_from_pose"

static const wide_case cases[] = {
    {MODELS, "body of 67, axes / depth", wide_seed, body_axes, 2, WIDE_CHECKED},
    {MODELS, "body of 67, places / depth", wide_seed, body_places, 2, WIDE_CHECKED},
    {MODELS, "body, scales 0.8 .. 1.25, axes / depth", wide_seed, scaled_axes, 2, WIDE_CHECKED},
    {MODELS, "body, scales 0.8 .. 1.25, places / depth", wide_seed, scaled_places, 2, WIDE_CHECKED},
    {MODELS, "chain of 67, axes / depth", wide_seed, chain_axes, 2, WIDE_CHECKED},
    {MODELS, "chain of 67, places / depth", wide_seed, chain_places, 2, WIDE_CHECKED},
    {"nkw_skeleton_models_from_locals", "body, scales 0.8 .. 1.25, axes / depth", wide_seed, local_axes, 2,
     WIDE_CHECKED},
    {"nkw_skeleton_locals_from_models", "body, scales 0.8 .. 1.25", wide_seed, body_back, 2, WIDE_CHECKED},
};

/* Fewer numbers to search among. */
static const wide_case pair_cases[] = {
    {MODELS, "2 joints, scales 0.8 .. 1.25, axes / depth", wide_seed, pair_axes, 2, WIDE_CHECKED},
    {MODELS, "2 joints, scales 0.8 .. 1.25, places / depth", wide_seed, pair_places, 2, WIDE_CHECKED},
    {"nkw_skeleton_locals_from_models", "2 joints, scales 0.8 .. 1.25", wide_seed, pair_back, 2, WIDE_CHECKED},
};

static const wide_case uneven_cases[] = {
    {"nkw_skeleton_locals_from_models", "scales 2^-6 .. 2^6", uneven_pair, locals_error, 20, WIDE_CHECKED},
    {"nkw_skeleton_locals_from_models", "child of any size", far_pair, locals_error, 20, WIDE_CHECKED},
};

/* How errors grow along chains at random. */
static const wide_case last_cases[] = {
    {MODELS, "last of a chain of 67, axes", wide_seed, last_axes_67, 2, WIDE_NOTED},
    {MODELS, "last of a chain of 67, place", wide_seed, last_places_67, 2, WIDE_NOTED},
};

static const wide_case long_cases[] = {
    {MODELS, "last of a chain of 1000, axes", wide_seed, last_axes_1000, 2, WIDE_NOTED},
    {MODELS, "last of a chain of 1000, place", wide_seed, last_places_1000, 2, WIDE_NOTED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("skeleton.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    wide_search_seeds(&a, pair_cases, sizeof pair_cases / sizeof pair_cases[0], SAMPLES * 20);
    wide_search(&a, uneven_cases, sizeof uneven_cases / sizeof uneven_cases[0], SAMPLES * 20);
    wide_run(&a, last_cases, sizeof last_cases / sizeof last_cases[0], SAMPLES);
    wide_run(&a, long_cases, sizeof long_cases / sizeof long_cases[0], SAMPLES / 20);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
