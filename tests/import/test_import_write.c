/* SPDX-License-Identifier: MIT */
/* Documents that are written as glTF and read again. */
#include <math.h>

#include <nakawari/export.h>

#include "documents.h"
#include "random.h"

#define KEYS 8

/* A document of one node with one track. */
static struct {
    nkw_document document;
    nkw_document_node node;
    nkw_document_animation animation;
    nkw_document_channel channel;
    nkw_clip_track track;
    int32_t parent, joint;
    float rest[NKW_POSE_FLOATS(1)], times[KEYS], values[3 * 4 * KEYS];
    unsigned char modes[KEYS];
} one;

static void make(nkw_clip_target target, nkw_interpolation interpolation, size_t count)
{
    const nkw_pose_span pose = {one.rest, 1};
    const size_t width = target == NKW_CLIP_ROTATION ? 4 : 3;
    const nkw_clip_track track = {target,
                                  0,
                                  {one.times, one.values, count, width,
                                   target == NKW_CLIP_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS, interpolation,
                                   NULL}};
    memset(&one, 0, sizeof one);
    nkw_pose_identity(pose);
    one.parent = one.node.mesh = one.node.skin = NKW_NO_JOINT;
    one.node.name = one.animation.name = "a \"name\", \xc3\xa9 and \xff";
    one.node.rest = nkw_pose_get(NKW_VIEW(nkw_pose, pose), 0);
    one.track = track;
    one.animation.tracks = &one.track;
    one.animation.channels = &one.channel;
    one.animation.track_count = 1;
    one.document.file = "made";
    one.document.format = one.document.generator = "";
    one.document.skeleton.parents = &one.parent;
    one.document.skeleton.joint_count = 1;
    one.document.nodes = &one.node;
    one.document.joint_of_node = &one.joint;
    one.document.rest = NKW_VIEW(nkw_pose, pose);
    one.document.animations = &one.animation;
    one.document.animation_count = 1;
    one.document.scene = NKW_NO_JOINT;
    for (size_t k = 0; k < KEYS; k++)
        one.times[k] = 0.5f * (float)k;
}

static nkw_document *written(nkw_gltf_form form)
{
    nkw_gltf_file file;
    nkw_import_error error;
    nkw_document *d = NULL;
    assert_int_equal(nkw_document_write(&one.document, form, "data.bin", &file, &error), NKW_IMPORT_OK);
    outer o = {file.outer, file.outer_bytes};
    const nkw_import_memory memory = {file.data, file.bytes, "written", NULL, read_outer, &o, 0, 0};
    if (nkw_document_from_memory(&memory, &d, &error) != NKW_IMPORT_OK)
        fail_msg("%s: %s", error.place, error.reason);
    nkw_gltf_file_free(&file);
    assert_null(file.data);
    return d;
}

/* The largest difference of both tracks at all times but those of jumps. */
static float difference(const nkw_document *d)
{
    const nkw_track *a = &one.track.track, *b = &d->animations[0].tracks[0].track;
    float largest = 0.0f;
    for (int i = 0; i < 4000; i++) {
        float x[4] = {0}, y[4] = {0}, time = 0.00101f * (float)i;
        nkw_track_sample(a, time, NULL, x);
        nkw_track_sample(b, time, NULL, y);
        for (int k = 0; k < 4; k++)
            largest = fmaxf(largest, fabsf(x[k] - y[k]));
    }
    return largest;
}

static void draw_values(random_source *r)
{
    for (size_t i = 0; i < sizeof one.values / sizeof *one.values; i++)
        one.values[i] = random_between(r, -2.0f, 2.0f);
}

static void tracks_come_back_in_every_form(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 9; i++) {
        make(NKW_CLIP_TRANSLATION, (nkw_interpolation)(i % 3), KEYS);
        draw_values(&r);
        nkw_document *d = written((nkw_gltf_form)(i / 3));
        assert_int_equal(d->animations[0].tracks[0].track.interpolation, i % 3);
        expect_near(difference(d), 0.0, 0.0);
        assert_string_equal(d->nodes[0].name, "a \"name\", ?? and ?");
        nkw_document_close(d);
    }
}

/* glTF has one interpolation for a sampler: STEP segments get a key one ULP before the next. */
static void modes_per_key_become_keys(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 2; i++) {
        make(NKW_CLIP_TRANSLATION, i ? NKW_INTERPOLATION_CUBICSPLINE : NKW_INTERPOLATION_LINEAR, KEYS);
        draw_values(&r);
        for (size_t k = 0; k < KEYS; k++)
            one.modes[k] = (unsigned char)(k % 3 == 0   ? NKW_INTERPOLATION_STEP
                                           : k % 3 == 1 ? NKW_INTERPOLATION_LINEAR
                                           : i          ? NKW_INTERPOLATION_CUBICSPLINE
                                                        : NKW_INTERPOLATION_STEP);
        one.track.track.key_interpolation = one.modes;
        nkw_document *d = written(NKW_GLTF_BINARY);
        assert_int_equal(d->animations[0].tracks[0].track.interpolation, one.track.track.interpolation);
        assert_true(d->animations[0].tracks[0].track.count > KEYS);
        expect_near(difference(d), 0.0, 2e-6);
        nkw_document_close(d);
    }
}

static void rotations_of_mixed_modes_are_refused(void **state)
{
    (void)state;
    nkw_gltf_file file;
    nkw_import_error error;
    make(NKW_CLIP_ROTATION, NKW_INTERPOLATION_CUBICSPLINE, KEYS);
    memset(one.modes, NKW_INTERPOLATION_CUBICSPLINE, KEYS);
    one.modes[3] = NKW_INTERPOLATION_LINEAR;
    one.track.track.key_interpolation = one.modes;
    assert_int_equal(nkw_document_write(&one.document, NKW_GLTF_BINARY, NULL, &file, &error), NKW_IMPORT_UNSUPPORTED);
    assert_string_equal(error.place, "/animations/0/channels/0");
    assert_null(file.data);
}

static void jumps_become_times_one_ulp_apart(void **state)
{
    (void)state;
    make(NKW_CLIP_TRANSLATION, NKW_INTERPOLATION_LINEAR, KEYS);
    one.times[3] = one.times[4];
    for (size_t k = 0; k < KEYS; k++)
        one.values[3 * k] = k < 4 ? 1.0f : 2.0f;
    nkw_document *d = written(NKW_GLTF_BINARY);
    const nkw_track *t = &d->animations[0].tracks[0].track;
    assert_int_equal(t->count, KEYS);
    for (size_t k = 1; k < KEYS; k++)
        assert_true(t->times[k] > t->times[k - 1]);
    expect_bits(t->times[3], nextafterf(t->times[4], 0.0f));
    expect_near(difference(d), 0.0, 1e-6);
    nkw_document_close(d);
}

/*
 * Times and values, then normalised integers, whose type remains where values are exact. Others become floats, which
 * are normalised as the integers were.
 */
static void integers_of_replaced_keys_remain_integers(void **state)
{
    (void)state;
    unsigned char data[12 + 12] = {0, 0, 0, 0,   0, 0, 0x80, 0x3f, 0, 0, 0,   0x40,
                                   0, 0, 0, 127, 0, 0, 0,    127,  0, 0, 127, 0};
    static const char text[] =
        "{'asset':{'version':'2.0'},'buffers':[{'uri':'data.bin','byteLength':24}],'bufferViews':[{'buffer':0,"
        "'byteLength':12},{'buffer':0,'byteOffset':12,'byteLength':12}],'accessors':[{'bufferView':0,'componentType':"
        "5126,'count':3,'type':'SCALAR','min':[0],'max':[2]},{'bufferView':1,'componentType':5120,'normalized':true,"
        "'count':3,'type':'VEC4'}],'nodes':[{}],'animations':[{'samplers':[{'input':0,'output':1}],'channels':["
        "{'sampler':0,'target':{'node':0,'path':'rotation'}}]}]}";
    nkw_document *d = opened(text, data, sizeof data), *again;
    char *json = quoted(text);
    outer o = {data, sizeof data};
    const nkw_import_memory memory = {json, strlen(json), "test.gltf", NULL, read_outer, &o, 0, 0};
    nkw_document to = *d;
    nkw_document_animation animation = d->animations[0];
    nkw_clip_track track = animation.tracks[0];
    float times[2] = {0.0f, 2.0f}, values[8];
    memcpy(values, track.track.values, 4 * sizeof *values);
    memcpy(values + 4, track.track.values + 8, 4 * sizeof *values);
    track.track.times = times, track.track.values = values, track.track.count = 2;
    animation.tracks = &track;
    to.animations = &animation;
    const nkw_gltf_rewriting rewriting = {&memory, d, &to, 0};
    for (int i = 0; i < 2; i++) {
        nkw_gltf_file file;
        nkw_import_error error;
        values[1] = i ? 0.3f : 0.0f;
        assert_int_equal(nkw_gltf_rewrite(&rewriting, NKW_GLTF_TEXT, NULL, &file, &error), NKW_IMPORT_OK);
        assert_true((strstr((const char *)file.data, "\"componentType\":5120") == NULL) == i);
        const nkw_import_memory made = {file.data, file.bytes, "made", NULL, NULL, NULL, 0, 0};
        assert_int_equal(nkw_document_from_memory(&made, &again, &error), NKW_IMPORT_OK);
        const nkw_track *got = &again->animations[0].tracks[0].track;
        assert_int_equal(got->kind, i ? NKW_TRACK_ROTATION : NKW_TRACK_ROTATION_NORMALIZED);
        for (size_t k = 0; k < 8; k++)
            expect_near(got->values[k], (double)values[k] / (i && k < 4 ? sqrt(1.0 + 0.09) : 1.0), i ? 1e-7 : 0.0);
        nkw_document_close(again);
        nkw_gltf_file_free(&file);
    }
    to.animation_count = 0;
    nkw_gltf_file file;
    assert_int_equal(nkw_gltf_rewrite(&rewriting, NKW_GLTF_TEXT, NULL, &file, NULL), NKW_IMPORT_REFUSED);
    free(json);
    nkw_document_close(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tracks_come_back_in_every_form),
        cmocka_unit_test(modes_per_key_become_keys),
        cmocka_unit_test(rotations_of_mixed_modes_are_refused),
        cmocka_unit_test(jumps_become_times_one_ulp_apart),
        cmocka_unit_test(integers_of_replaced_keys_remain_integers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
