/* SPDX-License-Identifier: MIT */
/* Collada: what Assimp loses of it. The values follow from the texts. */
#include <stdio.h>

#include <nakawari/clip.h>
#include <nakawari/mat.h>

#include "import/xml.h"
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
    assert_int_equal(m->d->animations[1].track_count, 3); /* of b only */
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

/* Reads the tags of a text that ends with its last byte. */
static void read_tags(const char *text, size_t bytes)
{
    char *copy = malloc(bytes + !bytes), value[32];
    assert_non_null(copy);
    memcpy(copy, text, bytes);
    nkwi_xml x = nkwi_xml_begin(copy, bytes);
    for (const char *last = x.at; nkwi_xml_next(&x); last = x.at) {
        assert_true(x.at > last && x.at <= x.end);
        assert_true(x.name.data + x.name.length <= x.end);
        nkwi_xml_text(&x, "name", value, sizeof value);
        assert_true(strlen(value) < sizeof value);
        nkwi_xml_attribute(&x, "none");
    }
    free(copy);
}

static void tags_of_broken_texts_are_within_the_text(void **state)
{
    (void)state;
    size_t bytes;
    char *text = text_of(&bytes);
    for (size_t n = 0; n < bytes; n++) {
        char was = text[n];
        read_tags(text, n);
        text[n] = "<>'/ \"&#"[n % 8];
        read_tags(text, bytes);
        text[n] = was;
    }
    free(text);
}

static void tags_have_their_attributes(void **state)
{
    (void)state;
    static const char text[] = "<?xml?><!DOCTYPE a><!-- <no/> --><c:a b='1' \n"
                               " c = \"x>&lt;&#228;&#x65e5;&no;\"/><![CDATA[<b>]]></a>";
    char value[32];
    nkwi_xml x = nkwi_xml_begin(text, sizeof text - 1);
    assert_true(nkwi_xml_next(&x) && nkwi_xml_opens(&x, "a") && x.is_empty);
    assert_true(nkwi_span_is(nkwi_xml_attribute(&x, "b"), "1"));
    nkwi_xml_text(&x, "c", value, sizeof value);
    assert_string_equal(value, "x><\xc3\xa4\xe6\x97\xa5&no;");
    nkwi_xml_text(&x, "d", value, sizeof value);
    assert_string_equal(value, "");
    assert_true(nkwi_xml_next(&x) && x.closes && nkwi_span_is(x.name, "a"));
    assert_false(nkwi_xml_next(&x));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(collada_clips_have_their_names_and_ranges),
        cmocka_unit_test(collada_nodes_have_their_names),
        cmocka_unit_test(collada_keys_without_scale_turn_as_their_neighbours),
        cmocka_unit_test(collada_clips_have_all_of_their_animations),
        cmocka_unit_test(files_that_are_cut_are_refused),
        cmocka_unit_test(tags_of_broken_texts_are_within_the_text),
        cmocka_unit_test(tags_have_their_attributes),
    };
    return cmocka_run_group_tests_name("import_collada", tests, NULL, NULL);
}
