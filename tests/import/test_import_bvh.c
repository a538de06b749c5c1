/* SPDX-License-Identifier: MIT */
/* BVH, as the programs of the field write it; the values are those of the texts. */
#include <math.h>
#include <stdlib.h>

#include <nakawari/scalar.h>

#include "documents.h"
#include "page.h"

#define FILES NKW_TEST_DATA "/reported/bvh/"

static nkw_document *read_file(const char *path)
{
    nkw_document *d;
    nkw_import_error error;
    if (nkw_document_open(path, &d, &error) != NKW_IMPORT_OK)
        print_error("%s:%s: %s\n", error.file, error.place, error.reason);
    assert_int_equal(error.code, NKW_IMPORT_OK);
    assert_string_equal(d->format, "BVH");
    return d;
}

static nkw_document *read_text(const char *text, int adds_offset)
{
    nkw_document *d;
    const nkw_import_memory memory = {text, strlen(text), "text.bvh", NULL, NULL, NULL, adds_offset, 0};
    assert_int_equal(nkw_document_from_memory(&memory, &d, NULL), NKW_IMPORT_OK);
    return d;
}

static int32_t joint_of(const nkw_document *d, const char *name)
{
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        if (strcmp(d->nodes[j].name, name) == 0)
            return (int32_t)j;
    fail_msg("there is no joint %s", name);
    return 0;
}

static const nkw_track *track_of(const nkw_document *d, const char *name, nkw_clip_target target)
{
    const int32_t joint = joint_of(d, name);
    const nkw_document_animation *a = d->animations;
    for (size_t i = 0; i < a->track_count; i++)
        if (a->channels[i].joint == joint && a->tracks[i].target == target)
            return &a->tracks[i].track;
    fail_msg("%s has no such track", name);
    return NULL;
}

static nkw_vec3 vector_at(const nkw_document *d, const char *name, nkw_clip_target target, size_t key)
{
    nkw_vec3 v;
    memcpy(&v, track_of(d, name, target)->values + 3 * key, sizeof v);
    return v;
}

static nkw_quat rotation_at(const nkw_document *d, const char *name, size_t key)
{
    nkw_quat q;
    memcpy(&q, track_of(d, name, NKW_CLIP_ROTATION)->values + 4 * key, sizeof q);
    return q;
}

static nkw_vec3 at(float x, float y, float z)
{
    nkw_vec3 v = {x, y, z};
    return v;
}

static nkw_quat turn(char axis, float degrees)
{
    return nkw_quat_from_axis_angle(at(axis == 'x', axis == 'y', axis == 'z'), nkw_radians_from_degrees(degrees));
}

static nkw_quat product(nkw_quat a, nkw_quat b, nkw_quat c)
{
    return nkw_quat_mul(nkw_quat_mul(a, b), c);
}

static void rotations_are_the_product_of_the_channels_from_left_to_right(void **state)
{
    (void)state;
    nkw_document *d = read_file(NKW_TEST_DATA "/import/arm.bvh");
    assert_int_equal(d->skeleton.joint_count, 4);
    expect_vec3_near(d->nodes[joint_of(d, "hand")].rest.translation, at(0, 1, 0.5f), 0);
    expect_vec3_near(d->nodes[joint_of(d, "EndSite_hand")].rest.translation, at(0, 0.25f, 0), 0);
    expect_vec3_near(vector_at(d, "base", NKW_CLIP_TRANSLATION, 1), at(10, 20, 30), 0);
    expect_rotation_near(rotation_at(d, "base", 1), product(turn('z', 30), turn('x', 40), turn('y', 50)), 3e-7);
    expect_rotation_near(rotation_at(d, "arm", 1), product(turn('y', 10), turn('z', 20), turn('x', 30)), 3e-7);
    expect_rotation_near(rotation_at(d, "base", 2), product(turn('z', 100), turn('x', -40), turn('y', 170)), 3e-7);
    expect_rotation_near(rotation_at(d, "hand", 2), turn('x', -200), 3e-7);
    for (size_t i = 0; i < d->animations->track_count; i++) {
        const nkw_track *t = &d->animations->tracks[i].track;
        for (size_t k = 1; t->width == 4 && k < t->count; k++) {
            const nkw_quat *q = (const nkw_quat *)(const void *)t->values + k;
            assert_true(nkw_quat_dot(q[-1], q[0]) >= 0.0f);
        }
    }
    nkw_document_close(d);
}

#define HEAD(channels)                                                                                                 \
    "HIERARCHY\nROOT a\n{\nOFFSET 1 2 3\nCHANNELS " channels "\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n"

/* All subsets and orders of the three rotations. */
static void every_order_of_rotations_is_read(void **state)
{
    (void)state;
    static const char *const orders[] = {"x",  "y",   "z",   "xy",  "xz",  "yx",  "yz", "zx",
                                         "zy", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
    for (size_t i = 0; i < sizeof orders / sizeof *orders; i++) {
        char text[400], channels[120] = "", numbers[40] = "";
        nkw_quat want = {0, 0, 0, 1};
        for (size_t k = 0; orders[i][k]; k++) {
            const float angle = 25.0f * (float)(k + 1) + 7.0f;
            sprintf(channels + strlen(channels), " %crotation", orders[i][k]);
            sprintf(numbers + strlen(numbers), " %g", (double)angle);
            want = nkw_quat_mul(want, turn(orders[i][k], angle));
        }
        snprintf(text, sizeof text,
                 "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS %zu%s } MOTION Frames: 1 Frame Time: 1 %s",
                 strlen(orders[i]), channels, numbers);
        /* The name is the rest of its line. */
        memcpy(strstr(text, " a "), "\na\n", 3);
        memcpy(strstr(text, "ROOT\n"), "ROOT ", 5);
        nkw_document *d = read_text(text, 0);
        expect_rotation_near(rotation_at(d, "a", 0), want, 3e-7);
        nkw_document_close(d);
    }
}

static void positions_replace_the_offset_or_are_added(void **state)
{
    (void)state;
    const char *const files[] = {"abs.bvh", "one.bvh"};
    for (int i = 0; i < 2; i++) {
        char path[256];
        snprintf(path, sizeof path, FILES "%s", files[i]);
        nkw_document *d = read_file(path);
        for (size_t k = 0; k < track_of(d, "Hips", NKW_CLIP_TRANSLATION)->count; k++) {
            expect_near(vector_at(d, "Hips", NKW_CLIP_TRANSLATION, k).y, 90, 0);
            expect_near(vector_at(d, "Knee", NKW_CLIP_TRANSLATION, k).y, -40, 0);
        }
        assert_int_equal(d->warning_count, 0);
        nkw_document_close(d);
    }
    /* The components without a channel are those of the offset. */
    nkw_document *d = read_text(HEAD("1 Yposition") "7\n", 0);
    expect_vec3_near(vector_at(d, "a", NKW_CLIP_TRANSLATION, 0), at(1, 7, 3), 0);
    nkw_document_close(d);
    d = read_text(HEAD("1 Yposition") "7\n", 1);
    expect_vec3_near(vector_at(d, "a", NKW_CLIP_TRANSLATION, 0), at(1, 9, 3), 0);
    nkw_document_close(d);
}

/* Positions of a joint that stay near 0 under an offset are of the other habit, perhaps. */
static void the_other_habit_of_offsets_is_suspected(void **state)
{
    (void)state;
    static const char text[] =
        "HIERARCHY\nROOT a\n{\nOFFSET 0 9 0\nCHANNELS 3 Xposition Yposition Zposition\nJOINT b\n{\n"
        "OFFSET 0 5 0\nCHANNELS 3 Xposition Yposition Zposition\n}\n}\nMOTION\nFrames: 2\n"
        "Frame Time: 0.1\n0 0 0 0 0.1 0\n0 1 0 0 0.2 0\n";
    nkw_document *d = read_text(text, 0);
    assert_int_equal(d->warning_count, 1);
    assert_non_null(strstr(d->warnings[0], "positions of 1 joints are near 0 under an OFFSET"));
    nkw_document_close(d);
    d = read_text(text, 1);
    assert_int_equal(d->warning_count, 0);
    expect_near(vector_at(d, "b", NKW_CLIP_TRANSLATION, 1).y, 5.2f, 1e-6);
    nkw_document_close(d);
}

static void the_dialects_of_the_field_are_read(void **state)
{
    (void)state;
    static const struct {
        const char *file, *joint;
        size_t joints;
        const char *warning;
    } list[] = {
        {"endsite.bvh", "EndSite_Knee", 3, NULL},
        {"endname.bvh", "Toe", 3, NULL},
        {"lower.bvh", "Knee", 3, NULL},
        {"name_space.bvh", "Left Knee", 3, NULL},
        {"spacecolon.bvh", "Knee", 3, NULL},
        {"bom.bvh", "Hips", 3, NULL},
        {"few.bvh", "Hips", 3, "5 frames are stated, 3 are there and are used"},
        {"many.bvh", "Hips", 3, "2 frames are stated, 3 are there and are used"},
        {"ft0.bvh", "Hips", 3, "Frame Time is not positive: 30 frames a second are used"},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        char path[256];
        snprintf(path, sizeof path, FILES "%s", list[i].file);
        nkw_document *d = read_file(path);
        assert_int_equal(d->skeleton.joint_count, list[i].joints);
        joint_of(d, list[i].joint);
        const nkw_track *t = track_of(d, "Hips", NKW_CLIP_ROTATION);
        assert_int_equal(t->count, 3);
        expect_rotation_near(rotation_at(d, "Hips", 1), turn('z', 90), 3e-7);
        assert_int_equal(d->warning_count, list[i].warning != NULL);
        if (list[i].warning)
            assert_string_equal(d->warnings[0], list[i].warning);
        if (list[i].warning && strstr(list[i].warning, "Time"))
            expect_near(t->times[2], 2.0 / 30.0, 1e-8);
        nkw_document_close(d);
    }
}

static void scales_and_two_roots_are_read(void **state)
{
    (void)state;
    nkw_document *d = read_file(FILES "scale9.bvh");
    for (size_t k = 0; k < 3; k++)
        expect_vec3_near(vector_at(d, "Hips", NKW_CLIP_SCALE, k), at(1, 1, 1), 0);
    nkw_document_close(d);
    d = read_file(FILES "tworoots.bvh");
    size_t roots = 0;
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        roots += d->skeleton.parents[j] < 0;
    assert_int_equal(roots, 2);
    assert_int_equal(d->warning_count, 0);
    nkw_document_close(d);
}

/* As the C library reads them, whose numbers depend on the locale. */
static void numbers_of_every_program_are_read(void **state)
{
    (void)state;
    static const char *const numbers[][2] = {{"1e-5", "1e-5"},
                                             {"1e-40", "1e-40"},
                                             {"9.0e1", "90"},
                                             {".5", "0.5"},
                                             {"90.", "90"},
                                             {"+1", "1"},
                                             {"-0.0", "-0.0"},
                                             {"0,25", "0.25"},
                                             {"1E+3", "1000"},
                                             {"123456789.123456789123456789", "123456789.123456789123456789"},
                                             {"0.1", "0.1"},
                                             {"-123.456001", "-123.456001"},
                                             {"3.3999e38", "3.3999e38"},
                                             {"000000000000000000000000000000000000012", "12"},
                                             {"0.00000000000000000000000000000000000012345", "1.2345e-37"},
                                             {"1e-400", "0"}};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char text[300];
        snprintf(text, sizeof text, HEAD("1 Xposition") "%s\n", numbers[i][0]);
        nkw_document *d = read_text(text, 0);
        expect_bits(vector_at(d, "a", NKW_CLIP_TRANSLATION, 0).x, (float)strtod(numbers[i][1], NULL));
        nkw_document_close(d);
    }
}

static void broken_files_are_refused_with_their_line(void **state)
{
    (void)state;
    static const struct {
        const char *text, *place;
    } list[] = {
        {"HIERARCHY\n", "line 2"},
        {"HIERARCHY\nMOTION\n", "line 2"},
        {"HIERARCHY\nJOINT a\n{\n", "line 2"},
        {"HIERARCHY\nROOT \n{\n}\n", "line 2"},
        {"HIERARCHY\nROOT a\n OFFSET 0 0 0\n", "line 3"},
        {"HIERARCHY\nROOT a\n{\nOFFSET 0 0\n}\n", "line 5"},
        {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 nan\n}\n", "line 4"},
        {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 1e39\n}\n", "line 4"},
        {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0.0-7.5\n}\n", "line 4"},
        {"HIERARCHY\nROOT a\n{\nCHANNELS 10 Xposition\n}\n", "line 4"},
        {"HIERARCHY\nROOT a\n{\nCHANNELS 2 Xposition Xposition\n}\n", "line 4"},
        {"HIERARCHY\nROOT a\n{\nCHANNELS 1 Wposition\n}\n", "line 4"},
        {"HIERARCHY\nROOT a\n{\nCHANNELS 1 Xposition\nCHANNELS 1 Yposition\n}\n", "line 5"},
        {"HIERARCHY\nROOT a\n{\nEnd\n{\n}\n}\n", "line 5"},
        {"HIERARCHY\nROOT a\n{\n}\n}\nMOTION\n", "line 5"},
        {"HIERARCHY\nROOT a\n{\n}\nMOTION\nFrame Time: 1\n", "line 6"},
        {"HIERARCHY\nROOT a\n{\n}\nMOTION\nFrames: -1\n", "line 6"},
        {"HIERARCHY\nROOT a\n{\n}\nMOTION\nFrames: 1\nFrame Time:\n", "line 8"},
        {HEAD("1 Xposition") "1\nx\n", "line 11"},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        nkw_document *d;
        nkw_import_error error;
        const nkw_import_memory memory = {list[i].text, strlen(list[i].text), "text.bvh", NULL, NULL, NULL, 0, 0};
        assert_int_equal(nkw_document_from_memory(&memory, &d, &error), NKW_IMPORT_INVALID);
        assert_null(d);
        assert_string_equal(error.place, list[i].place);
    }
}

/* A frame that is not complete is left out, with a warning; a file without frames has no clip. */
static void frames_may_be_missing(void **state)
{
    (void)state;
    nkw_document *d = read_text(HEAD("2 Xposition Yposition") "1 2 3\n", 0);
    assert_int_equal(track_of(d, "a", NKW_CLIP_TRANSLATION)->count, 1);
    assert_int_equal(d->warning_count, 1);
    nkw_document_close(d);
    d = read_text("HIERARCHY\nROOT a\n{\nOFFSET 1 2 3\n}\nMOTION\nFrames: 0\nFrame Time: 0.1\n", 0);
    assert_int_equal(d->animation_count, 0);
    nkw_document_close(d);
}

/* A captured walk in centimetres, within 0.1 mm and 1 mm at 10 cm. */
static void a_captured_walk_has_the_bytes_of_the_page(void **state)
{
    (void)state;
    const char *path = NKW_DATA_DIR "/motion/cmu_12_01_walk.bvh";
    FILE *there = fopen(path, "rb");
    if (!there)
        skip();
    fclose(there);
    nkw_document *d = read_file(path);
    const nkw_document_animation *a = &d->animations[0];
    const nkw_clip_source source = {a->tracks, a->track_count, d->skeleton.joint_count, 0, {NULL, 0}, NULL,
                                    NKW_CLIP_FLOAT32, NULL};
    const size_t most = NKW_CLIP_REDUCE_WORK(a->track_count, source.joint_count, 0);
    const nkw_work work = {malloc(most), most};
    nkw_bytes_span block = {NULL, 0};
    size_t floats, bytes[2], bad;
    assert_non_null(work.data);
    assert_int_equal(nkw_clip_build(&source, block, &floats, &bad, work), NKW_TOO_SMALL);
    for (int i = 0; i < 2; i++) {
        const nkw_clip_reduction reduction = {d->skeleton.parents, i ? 0.1f : 0.01f, 10, NULL, NULL, 1e-3f};
        nkw_clip_reduced reduced;
        if (!block.data) {
            assert_int_equal(nkw_clip_reduce(&source, &reduction, block, &reduced, &bad, work), NKW_TOO_SMALL);
            block.bytes = reduced.bytes;
            block.data = malloc(block.bytes);
            assert_non_null(block.data);
        }
        assert_int_equal(nkw_clip_reduce(&source, &reduction, block, &reduced, &bad, work), NKW_OK);
        bytes[i] = reduced.bytes;
    }
    expect_page("subjects/clip/clip.md", "| a walk of %lu joints, %lu keys at 120 Hz, in centimetres, by "
                                     "[`nakawari/import.h`](../../import.md) | %lu | %lu | %lu |",
                (unsigned long)source.joint_count, (unsigned long)a->tracks[0].track.count, (unsigned long)floats,
                (unsigned long)bytes[0], (unsigned long)bytes[1]);
    free(block.data);
    free(work.data);
    nkw_document_close(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rotations_are_the_product_of_the_channels_from_left_to_right),
        cmocka_unit_test(every_order_of_rotations_is_read),
        cmocka_unit_test(positions_replace_the_offset_or_are_added),
        cmocka_unit_test(the_other_habit_of_offsets_is_suspected),
        cmocka_unit_test(the_dialects_of_the_field_are_read),
        cmocka_unit_test(scales_and_two_roots_are_read),
        cmocka_unit_test(numbers_of_every_program_are_read),
        cmocka_unit_test(broken_files_are_refused_with_their_line),
        cmocka_unit_test(frames_may_be_missing),
        cmocka_unit_test(a_captured_walk_has_the_bytes_of_the_page),
    };
    return cmocka_run_group_tests_name("import_bvh", tests, NULL, NULL);
}
