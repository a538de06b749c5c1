/* SPDX-License-Identifier: MIT */
/* nakawari bake: the files are read back by the library, and hold what `sample` prints. */
#include "program.h"

#include <math.h>
#include <stdlib.h>

#include <nakawari/import.h>
#include <nakawari/mat.h>
#include <nakawari/vec.h>

#define CHARACTER "bake '" NKW_CHARACTER "' "
#define JOINTS    20
#define FLOATS    1
#define TIMES     33

static union {
    float aligned;
    unsigned char bytes[1 << 20];
} file;

static size_t read_baked(const char *arguments)
{
    free(program_run(NULL, CHARACTER "%s -o baked.nkw", arguments));
    FILE *f = fopen("baked.nkw", "rb");
    assert_non_null(f);
    size_t bytes = fread(file.bytes, 1, sizeof file.bytes, f);
    fclose(f);
    return bytes;
}

static nkw_document *open_character(void)
{
    nkw_document *d;
    assert_int_equal(nkw_document_open(NKW_CHARACTER, &d, NULL), NKW_IMPORT_OK);
    assert_int_equal(d->skeleton.joint_count, JOINTS);
    assert_int_equal(d->float_count, FLOATS);
    return d;
}

/* ---- clips ---- */

/* A pose with its matrices and morph weights at a time. */
typedef struct moment {
    float pose[NKW_POSE_FLOATS(JOINTS)], floats[FLOATS];
    nkw_mat4 models[JOINTS];
} moment;

static void sample(const nkw_document *d, const nkw_clip *clip, float time, moment *m)
{
    const nkw_pose_span pose = {m->pose, JOINTS};
    assert_int_equal(nkw_clip_sample(clip, time, NULL, pose, m->floats), NKW_OK);
    assert_int_equal(nkw_document_models(d, NKW_VIEW(nkw_pose, pose), NULL, m->models), NKW_OK);
}

/* The largest distance of an origin, and of a point `reach` away on an axis, in the space of the model. */
static double distance(const nkw_mat4 *a, const nkw_mat4 *b, float reach)
{
    double most = 0.0;
    for (int axis = -1; axis < 3; axis++) {
        nkw_vec3 p = {axis == 0 ? reach : 0.0f, axis == 1 ? reach : 0.0f, axis == 2 ? reach : 0.0f};
        nkw_vec3 difference = nkw_vec3_sub(nkw_mat4_transform_point(a, p), nkw_mat4_transform_point(b, p));
        most = fmax(most, (double)nkw_vec3_length(difference));
    }
    return most;
}

/* Over 33 times, the first and the last of them the ends of the clip. */
static double largest_distance(const nkw_document *d, const nkw_clip *a, const nkw_clip *b, double *floats)
{
    static moment x, y;
    double most = 0.0;
    *floats = 0.0;
    for (int k = 0; k < TIMES; k++) {
        float time = nkw_clip_describe(a).start +
                     (nkw_clip_describe(a).end - nkw_clip_describe(a).start) * (float)k / (float)(TIMES - 1);
        sample(d, a, time, &x);
        sample(d, b, time, &y);
        for (size_t j = 0; j < JOINTS; j++)
            most = fmax(most, distance(&x.models[j], &y.models[j], 0.1f));
        *floats = fmax(*floats, fabs((double)x.floats[0] - (double)y.floats[0]));
    }
    return most;
}

/*
 * Each form of each clip against the clip of the file, at the points of joints that nkw_clip_reduce measures. compact:
 * 16 bits, half a step of which is 7.6e-6 of the range of a channel. reduced: the tolerance, which is 1/10000 of the
 * size of 2.54 if none is given.
 */
static void clips_map_back(void **state)
{
    (void)state;
    static const struct {
        const char *form;
        double bound, floats;
    } forms[] = {{"clip", 0.0, 0.0},
                 {"compact", 2e-5, 2e-5},
                 {"reduced", 2.54e-4, 1e-3},
                 {"reduced --tolerance 0.01", 0.01, 1e-2},
                 {"reduced --tolerance 0.00001", 1e-5, 1e-4}};
    nkw_document *d = open_character();
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++)
        for (size_t n = 0; n < d->animation_count; n++) {
            char arguments[128];
            const nkw_clip *clip;
            nkw_clip *want;
            double floats;
            snprintf(arguments, sizeof arguments, "--clip %s --as %s", d->animations[n].name, forms[i].form);
            size_t bytes = read_baked(arguments);
            assert_int_equal(nkw_clip_open(file.bytes, bytes, &clip), NKW_OK);
            assert_int_equal(nkw_clip_describe(clip).bytes, bytes);
            assert_int_equal(nkw_clip_describe(clip).joint_count, JOINTS);
            assert_string_equal(nkw_clip_describe(clip).name, d->animations[n].name);
            for (size_t j = 0; j < JOINTS; j++)
                assert_string_equal(nkw_clip_joint_name(clip, j), d->nodes[j].name);
            for (size_t j = 0; j < JOINTS; j++)
                for (size_t k = 0; k < d->nodes[j].float_count; k++)
                    assert_string_equal(nkw_clip_float_name(clip, d->nodes[j].float_first + k),
                                        d->meshes[d->nodes[j].mesh].target_names[k]);
            assert_true(d->float_count > 0);
            assert_int_equal(nkw_document_clip(d, n, NKW_CLIP_FLOAT32, &want, NULL), NKW_IMPORT_OK);
            expect_bits(nkw_clip_describe(clip).start, nkw_clip_describe(want).start);
            expect_bits(nkw_clip_describe(clip).end, nkw_clip_describe(want).end);
            double most = largest_distance(d, want, clip, &floats);
            if (!(most <= forms[i].bound) || !(floats <= forms[i].floats))
                fail_msg("bake %s: distance %g, morph weights %g", arguments, most, floats);
            nkw_import_free(want);
        }
    nkw_document_close(d);
}

/* A larger tolerance is a smaller file; without one, the float keys are the largest. */
static void smaller_forms_are_smaller(void **state)
{
    (void)state;
    size_t clip = read_baked("--clip walk"), compact = read_baked("--clip walk --as compact");
    size_t fine = read_baked("--clip walk --as reduced --tolerance 0.00001");
    size_t coarse = read_baked("--clip walk --as reduced --tolerance 0.01");
    assert_true(compact < clip);
    assert_true(coarse < fine);
    assert_true(fine < clip);
}

static void a_part_of_a_clip_is_refused(void **state)
{
    (void)state;
    const nkw_clip *clip;
    size_t bytes = read_baked("--clip walk");
    for (size_t n = 0; n < bytes; n += 16)
        assert_int_not_equal(nkw_clip_open(file.bytes, n, &clip), NKW_OK);
}

/* ---- palettes ---- */

static uint32_t u32_at(size_t at)
{
    uint32_t value = 0;
    for (int i = 3; i >= 0; i--)
        value = value << 8 | file.bytes[at + (size_t)i];
    return value;
}

/* The 12 floats at `at` are the first three rows of the matrix of a line of CSV, which is column by column. */
static void expect_rows(const char *line, size_t at)
{
    for (int i = 0; i < 4; i++)
        line = strchr(line, ',') + 1;
    for (int i = 0; i < 16; i++) {
        char *end;
        float want = strtof(line, &end);
        if (i % 4 < 3)
            expect_bits(float_of(u32_at(at + (size_t)(4 * (i % 4) + i / 4) * 4)), want);
        line = end + 1;
    }
}

/* Frames 0, 1/4, 1/2, 3/4, 1 s; 12 floats for each of the 17 joints of the first skin. */
static void palettes_are_rows_of_the_joint_matrices(void **state)
{
    (void)state;
    size_t bytes = read_baked("--clip walk --as palette --rate 4");
    assert_memory_equal(file.bytes, "nkwpalet", 8);
    assert_int_equal(u32_at(8), 1);
    assert_int_equal(u32_at(12), 17);
    assert_int_equal(u32_at(16), 5);
    assert_int_equal(u32_at(28), 0x3f800000);
    assert_int_equal(bytes, 32 + 5 * 17 * 48);
    char *csv = program_run(NULL, "sample '" NKW_CHARACTER "' --clip walk --rate 4 --what palette");
    const char *line = strchr(csv, '\n') + 1;
    for (size_t frame = 0; frame < 5; frame++)
        for (size_t joint = 0; joint < 18; joint++, line = strchr(line, '\n') + 1)
            if (joint < 17) /* the last is of the other skin */
                expect_rows(line, 32 + (frame * 17 + joint) * 48);
    assert_int_equal(*line, 0);
    free(csv);
}

static void misuse_and_files_in_error(void **state)
{
    (void)state;
    program_says(0, "Usage: nakawari bake", "bake --help");
    program_says(2, "not clip, compact", CHARACTER "--as mp4");
    program_says(2, "needed for palettes", CHARACTER "--as palette");
    program_says(2, "only with --as palette", CHARACTER "--rate 30");
    program_says(2, "not a distance", CHARACTER "--tolerance -2");
    program_says(1, "no such skin", CHARACTER "--as palette --rate 30 --skin 2");
    program_says(1, "choose one clip", CHARACTER "--clip all");
    program_says(1, "cannot be written", CHARACTER "-o /no/such/folder/x");
    program_says(1, "no-such-file: ", "bake no-such-file");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clips_map_back),
        cmocka_unit_test(smaller_forms_are_smaller),
        cmocka_unit_test(a_part_of_a_clip_is_refused),
        cmocka_unit_test(palettes_are_rows_of_the_joint_matrices),
        cmocka_unit_test(misuse_and_files_in_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
