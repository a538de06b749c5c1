/* SPDX-License-Identifier: MIT */
/* Collada: what Assimp loses of it. The values follow from the texts. */
#include <stdio.h>

#include <nakawari/clip.h>
#include <nakawari/mat.h>

#include "moment.h"

#define COLLADA NKW_TEST_DATA "/reported/collada/"

static void collada_clips_have_their_names_and_ranges(void **state)
{
    (void)state;
    moment *m = open_file(COLLADA "clips.dae"); /* x of the box: 1 to 5 in the first, 7 to 9 in the second */
    assert_int_equal(m->d->animation_count, 2);
    assert_string_equal(m->d->animations[0].name, "walk"); /* an id without a name */
    assert_string_equal(m->d->animations[1].name, "run");
    play(m, 0.5f);
    expect_vec3_near(local(m, "box").translation, at(3, 2, 3), 1e-6);
    nkw_import_free(m->clip);
    assert_int_equal(nkw_document_clip(m->d, 1, NKW_CLIP_FLOAT32, &m->clip, NULL), NKW_IMPORT_OK);
    play(m, 0.5f);
    expect_vec3_near(local(m, "box").translation, at(8, 2, 3), 1e-6);
    close_file(m);
    m = open_file(COLLADA "oneclip_range.dae"); /* from 1 to 2 of x = t, 0 to 4 */
    assert_int_equal(m->d->animation_count, 1);
    assert_string_equal(m->d->animations[0].name, "mid");
    expect_bits(nkw_clip_describe(m->clip).start, 1.0f);
    expect_bits(nkw_clip_describe(m->clip).end, 2.0f);
    play(m, 1.5f);
    expect_vec3_near(local(m, "box").translation, at(1.5f, 2, 3), 1e-6);
    close_file(m);
}

static void collada_nodes_have_their_names(void **state)
{
    (void)state;
    moment *m = open_file(COLLADA "spacename.dae");
    play(m, 0.5f);
    expect_vec3_near(local(m, "my box").translation, at(3, 2, 3), 1e-6);
    close_file(m);
}

static void collada_keys_without_scale_turn_as_their_neighbours(void **state)
{
    (void)state;
    static const struct {
        const char *file;
        nkw_vec3 scale;
    } flat[] = {{COLLADA "zeroscale.dae", {0, 0, 0}}, {COLLADA "flatscale.dae", {1, 0, 1}}};
    for (int i = 0; i < 2; i++) {
        moment *m = open_file(flat[i].file);
        assert_int_equal(m->d->warning_count, 1);
        play(m, 0.0f);
        expect_vec3_near(local(m, "box").scale, flat[i].scale, 0);
        expect_rotation_near(local(m, "box").rotation, turn('z', 90), 3e-7);
        play(m, 1.0f);
        expect_vec3_near(local(m, "box").scale, at(1, 1, 1), 3e-7);
        expect_rotation_near(local(m, "box").rotation, turn('z', 90), 3e-7);
        close_file(m);
    }
    moment *m = open_file(COLLADA "mirror.dae"); /* x to -x + 4t */
    assert_int_equal(m->d->warning_count, 0);
    play(m, 0.5f);
    expect_vec3_near(nkw_mat4_transform_point(&m->models[joint(m, "box")], at(1, 2, 3)), at(1, 2, 3), 1e-6);
    close_file(m);
}

/* Clips of several animations of one node, of inner animations, of durations that differ; two nodes of one name. */
#define CLIPS NKW_TEST_DATA "/import/clips.dae"

static void collada_clips_have_all_of_their_animations(void **state)
{
    (void)state;
    moment *m = open_file(CLIPS);
    assert_int_equal(m->d->animation_count, 3);
    assert_string_equal(m->d->animations[0].name, "a & b");
    assert_string_equal(m->d->animations[1].name, "c1");
    assert_int_equal(m->d->animations[2].track_count, 0);
    assert_string_equal(m->d->nodes[1].name, "same");
    assert_string_equal(m->d->nodes[2].name, "same");
    play(m, 0.5f);
    expect_vec3_near(nkw_pose_get(pose_view(m->pose, 3), 1).translation, at(2, 1.5f, 3), 1e-6);
    expect_vec3_near(nkw_pose_get(pose_view(m->pose, 3), 2).translation, at(5.5f, 2, 2), 1e-6);
    nkw_import_free(m->clip);
    assert_int_equal(nkw_document_clip(m->d, 1, NKW_CLIP_FLOAT32, &m->clip, NULL), NKW_IMPORT_OK);
    expect_bits(nkw_clip_describe(m->clip).start, 0.5f);
    expect_bits(nkw_clip_describe(m->clip).end, 2.0f);
    play(m, 1.0f);
    expect_vec3_near(nkw_pose_get(pose_view(m->pose, 3), 2).translation, at(6, 2, 3), 1e-6);
    assert_int_equal(m->d->animations[1].track_count, 1); /* of b only, and its translation only */
    close_file(m);
}

/*
 * tests/data/import/collada/curves.dae: one node for each kind of curve and target. The values are those of the
 * formulas of the COLLADA 1.4.1 specification. The Bezier curve of (0, 1), (0.5, 1), (1.5, 5), (2, 5) is at the
 * parameter 1/4 at the time 0.453125, with the value 1.625; of evenly spaced times at the time 0.5.
 */
#define CURVES NKW_TEST_DATA "/import/collada/curves.dae"

static nkw_vec3 moved(moment *m, const char *name, float time)
{
    play(m, time);
    return local(m, name).translation;
}

static void collada_curves_have_their_values(void **state)
{
    (void)state;
    moment *m = open_file(CURVES);
    static const char *const pairs[] = {"bezier", "hermite"}; /* tangents with times */
    for (int i = 0; i < 2; i++) {
        expect_vec3_near(moved(m, pairs[i], 0.0f), at(1, 2, 3), 1e-6);
        expect_vec3_near(moved(m, pairs[i], 0.453125f), at(1.625f, 2, 3), 2e-5);
        expect_vec3_near(moved(m, pairs[i], 1.0f), at(3, 2, 3), 2e-5);
        expect_vec3_near(moved(m, pairs[i], 1.546875f), at(4.375f, 2, 3), 2e-5);
    }
    expect_vec3_near(moved(m, "three", 0.453125f), at(1.625f, 0.15625f, 0.3125f), 2e-5);
    expect_vec3_near(moved(m, "bezier1", 0.5f), at(1.625f, 2, 3), 2e-6);
    expect_vec3_near(moved(m, "hermite1", 0.5f), at(2.75f, 2, 3), 2e-6); /* 1.625 + 8 (1/4) (3/4)^2 */
    expect_vec3_near(moved(m, "step", 0.999f), at(1, 2, 3), 0);
    expect_vec3_near(moved(m, "step", 1.0f), at(5, 2, 3), 0);
    expect_vec3_near(moved(m, "step", 1.75f), at(5, 2, 3), 0);
    expect_vec3_near(moved(m, "step", 2.0f), at(2, 2, 3), 0);
    /* Slopes 1 and 3: 1 after the key of tension 1/2, continuity 1/4, bias -1/2; 4 at the next key. (1+4)/2 + (1-4)/8 */
    expect_vec3_near(moved(m, "tcb", 1.5f), at(2.125f, 2, 3), 2e-6);
    expect_vec3_near(moved(m, "cardinal", 0.5f), at(2, 2, 3), 1e-6);
    close_file(m);
}

static void collada_targets_are_members_and_elements(void **state)
{
    (void)state;
    moment *m = open_file(CURVES);
    expect_vec3_near(moved(m, "index", 0.5f), at(0, 2, 3), 1e-6); /* t(1) from 1 to 5 */
    expect_vec3_near(moved(m, "element", 0.5f), at(0, 0, 1), 1e-6); /* column 3, row 2 */
    expect_vec3_near(moved(m, "arm", 0.5f), at(0, 2, 0), 1e-6); /* a node of a sid alone */
    expect_vec3_near(moved(m, "tool", 0.5f), at(1, 0, 0.5f), 1e-6);
    size_t tools = 0;
    for (size_t j = 0; j < m->d->skeleton.joint_count; j++)
        if (strcmp(m->d->nodes[j].name, "tool") == 0) {
            expect_vec3_near(nkw_pose_get(pose_view(m->pose, m->d->skeleton.joint_count), j).translation,
                             at(1, 0, 0.5f), 1e-6);
            tools++;
        }
    assert_int_equal(tools, 2);
    close_file(m);
}

static void collada_transforms_are_in_their_order(void **state)
{
    (void)state;
    moment *m = open_file(CURVES);
    for (int i = 1; i < 8; i++) { /* two turns in two seconds */
        play(m, 0.25f * (float)i);
        expect_rotation_near(local(m, "turns").rotation, turn('z', 90.0f * (float)i), 1e-5);
    }
    play(m, 0.5f); /* T(1,0,0) Rz(45) T(2,0,0) S(1,1/2,1) */
    expect_vec3_near(local(m, "order").translation, at(2.41421356f, 1.41421356f, 0), 2e-5);
    expect_rotation_near(local(m, "order").rotation, turn('z', 45), 1e-5);
    expect_vec3_near(local(m, "order").scale, at(1, 0.5f, 1), 1e-6);
    play(m, 2.0f);
    expect_vec3_near(local(m, "order").scale, at(1, -1, 1), 1e-6);
    expect_vec3_near(local(m, "look").translation, at(5, 0, 0), 1e-6);
    expect_rotation_near(local(m, "look").rotation, turn('y', 90), 1e-6);
    close_file(m);
}

static void collada_matrices_without_a_rotation_have_that_beside(void **state)
{
    (void)state;
    moment *m = open_file(CURVES);
    play(m, 1.5f);
    expect_vec3_near(local(m, "flat").translation, at(1.5f, 3, 4.5f), 1e-6);
    expect_vec3_near(local(m, "flat").scale, at(0.5f, 0.5f, 0.5f), 1e-6);
    expect_rotation_near(local(m, "flat").rotation, turn('z', 90), 1e-6);
    play(m, 0.5f);
    expect_vec3_near(local(m, "flat").scale, at(0.5f, 0.5f, 0.5f), 1e-6);
    expect_rotation_near(local(m, "flat").rotation, turn('z', 90), 1e-6);
    expect_vec3_near(local(m, "mirror").translation, at(1, 0, 0), 1e-6);
    expect_vec3_near(local(m, "mirror").scale, at(-1, 1, 1), 1e-6);
    expect_rotation_near(local(m, "mirror").rotation, turn('z', 0), 1e-6);
    close_file(m);
}

static int says(const moment *m, const char *part)
{
    for (size_t i = 0; i < m->d->warning_count; i++)
        if (strstr(m->d->warnings[i], part))
            return 1;
    return 0;
}

static void collada_says_what_it_does_not_read(void **state)
{
    (void)state;
    moment *m = open_file(CURVES);
    assert_int_equal(m->d->animation_count, 1);
    assert_true(says(m, "CARDINAL"));
    assert_true(says(m, "scale of 0"));
    assert_true(says(m, "1 morph controllers"));
    assert_int_equal(m->d->warning_count, 3);
    const nkw_document_animation *a = &m->d->animations[0];
    assert_int_equal(a->unread_count, 3);
    assert_string_equal(a->unread[0].reason, "weights(1): no part of a document");
    assert_string_equal(a->unread[1].reason, "nobody/t.X: its target is not in the file");
    assert_string_equal(a->unread[2].reason, "bezier/t.W: no member of its target");
    close_file(m);
}

/* The text of the file; to be freed. */
static char *text_of(size_t *bytes)
{
    char *text = malloc(8192);
    FILE *f = fopen(CLIPS, "rb");
    assert_true(text && f);
    *bytes = fread(text, 1, 8192, f);
    fclose(f);
    assert_in_range(*bytes, 1000, 8191);
    return text;
}

static void files_that_are_cut_are_refused(void **state)
{
    (void)state;
    size_t bytes;
    char *text = text_of(&bytes);
    for (size_t n = 0; n + 1 < bytes; n++) { /* all but the last line break */
        nkw_document *d;
        const nkw_import_memory memory = {text, n, "a.dae", NULL, NULL, NULL, 0, 0};
        nkw_document_from_memory(&memory, &d, NULL);
        assert_null(d);
    }
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(collada_clips_have_their_names_and_ranges),
        cmocka_unit_test(collada_nodes_have_their_names),
        cmocka_unit_test(collada_keys_without_scale_turn_as_their_neighbours),
        cmocka_unit_test(collada_clips_have_all_of_their_animations),
        cmocka_unit_test(collada_curves_have_their_values),
        cmocka_unit_test(collada_targets_are_members_and_elements),
        cmocka_unit_test(collada_transforms_are_in_their_order),
        cmocka_unit_test(collada_matrices_without_a_rotation_have_that_beside),
        cmocka_unit_test(collada_says_what_it_does_not_read),
        cmocka_unit_test(files_that_are_cut_are_refused),
    };
    return cmocka_run_group_tests_name("import_collada", tests, NULL, NULL);
}
