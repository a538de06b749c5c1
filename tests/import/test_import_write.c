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

/* Channels 0 and 2 have a track, 1 an extension's target. Without channel 0 the others keep what they have. */
static void channels_that_are_left_out_are_not_in_the_file(void **state)
{
    (void)state;
    unsigned char data[8 + 24] = {0, 0, 0, 0, 0, 0, 0x80, 0x3f};
    static const char text[] =
        "{'asset':{'version':'2.0'},'buffers':[{'uri':'data.bin','byteLength':32}],'bufferViews':[{'buffer':0,"
        "'byteLength':8},{'buffer':0,'byteOffset':8,'byteLength':24}],'accessors':[{'bufferView':0,'componentType':"
        "5126,'count':2,'type':'SCALAR','min':[0],'max':[1]},{'bufferView':1,'componentType':5126,'count':2,"
        "'type':'VEC3'}],'nodes':[{}],'animations':[{'samplers':[{'input':0,'output':1}],'channels':["
        "{'sampler':0,'target':{'node':0,'path':'translation'}},{'sampler':0,'target':{'path':'pointer'},'extras':7},"
        "{'sampler':0,'target':{'node':0,'path':'scale'},'extras':8}]}]}";
    nkw_document *d = opened(text, data, sizeof data), *again;
    char *json = quoted(text);
    outer o = {data, sizeof data};
    const nkw_import_memory memory = {json, strlen(json), "test.gltf", NULL, read_outer, &o, 0, 0};
    nkw_document to = *d;
    nkw_document_animation animation = d->animations[0];
    nkw_document_channel channels[2];
    nkw_gltf_file file;
    const nkw_gltf_rewriting rewriting = {&memory, d, &to, 0};
    assert_int_equal(animation.track_count, 2);
    memcpy(channels, animation.channels, sizeof channels);
    animation.channels = channels;
    to.animations = &animation;
    animation.track_count = 1; /* a track of channel 0 alone, then of channel 2 */
    animation.tracks = d->animations[0].tracks + 1;
    assert_int_equal(nkw_gltf_rewrite(&rewriting, NKW_GLTF_TEXT, NULL, &file, NULL), NKW_IMPORT_REFUSED);
    channels[0] = channels[1];
    assert_int_equal(nkw_gltf_rewrite(&rewriting, NKW_GLTF_TEXT, NULL, &file, NULL), NKW_IMPORT_OK);
    const char *unknown = strstr((const char *)file.data, "\"extras\":7"), *last;
    assert_non_null(unknown);
    assert_non_null(last = strstr(unknown, "\"extras\":8"));
    assert_null(strstr((const char *)file.data, "translation"));
    const nkw_import_memory made = {file.data, file.bytes, "made", NULL, NULL, NULL, 0, 0};
    assert_int_equal(nkw_document_from_memory(&made, &again, NULL), NKW_IMPORT_OK);
    assert_int_equal(again->animations[0].track_count, 1);
    assert_int_equal(again->animations[0].unread_count, d->animations[0].unread_count);
    assert_int_equal(again->animations[0].tracks[0].target, NKW_CLIP_SCALE);
    assert_int_equal(again->animations[0].channels[0].number, 1);
    nkw_document_close(again);
    nkw_gltf_file_free(&file);
    animation.track_count = 0;
    assert_int_equal(nkw_gltf_rewrite(&rewriting, NKW_GLTF_TEXT, NULL, &file, NULL), NKW_IMPORT_REFUSED);
    animation.track_count = 2; /* one channel twice */
    animation.tracks = d->animations[0].tracks;
    assert_int_equal(nkw_gltf_rewrite(&rewriting, NKW_GLTF_TEXT, NULL, &file, NULL), NKW_IMPORT_REFUSED);
    free(json);
    nkw_document_close(d);
}

/* ---- values that glTF does not allow ---- */

/* Two triangles and a vertex apart, with a skin of two joints, whose numbers are wrong in every way. */
static struct {
    nkw_vec3 positions[5], normals[5];
    float tangents[20], colors[20], weights[15];
    uint32_t indices[6];
    uint16_t joints[15];
    nkw_mat4 matrices[2];
    int32_t skin_joints[2];
    nkw_document_primitive primitives[2];
    nkw_document_mesh mesh;
    nkw_document_skin skin;
    nkw_document_image image;
    nkw_document_material material;
} wrong;

static void make_wrong(const char *format)
{
    static const nkw_vec3 positions[5] = {{0, 0, 0}, {1, 0, 0}, {1, 0, -1}, {0, 0, -1}, {9, 9, 9}};
    static const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    static const float weights[15] = {0.3f, 0.3f, 0.3f,  5.0f, 0.0f, 1.0f, -1.0f, 2.0f,
                                      0.0f, NAN,  0.25f, 0.5f, 1.0f, 0.0f, 0.0f};
    static const uint16_t joints[15] = {0, 1, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 0};
    make(NKW_CLIP_TRANSLATION, NKW_INTERPOLATION_LINEAR, 2);
    memset(&wrong, 0, sizeof wrong);
    memcpy(wrong.positions, positions, sizeof positions);
    memcpy(wrong.indices, indices, sizeof indices);
    memcpy(wrong.weights, weights, sizeof weights);
    memcpy(wrong.joints, joints, sizeof joints);
    wrong.normals[0] = (nkw_vec3){0, 5, 0};
    wrong.normals[1] = (nkw_vec3){3e30f, 4e30f, 0};
    wrong.normals[2] = (nkw_vec3){NAN, 0, 0};
    wrong.tangents[0] = 2.0f, wrong.tangents[3] = -7.0f;
    wrong.colors[0] = -3.0f, wrong.colors[1] = 1.5f, wrong.colors[2] = NAN, wrong.colors[3] = 0.25f;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++)
            wrong.matrices[i].m[5 * k] = i ? 2.0f : 1.0f;
    wrong.matrices[0].m[15] = 1.0000001f;
    wrong.matrices[1].m[12] = 6.0f;
    const nkw_document_primitive p = {.topology = NKW_DOCUMENT_TRIANGLES,
                                      .vertex_count = 5,
                                      .positions = wrong.positions,
                                      .normals = wrong.normals,
                                      .tangents = wrong.tangents,
                                      .colors = wrong.colors,
                                      .indices = wrong.indices,
                                      .index_count = 6,
                                      .joints = wrong.joints,
                                      .weights = wrong.weights,
                                      .influence_count = 3};
    wrong.primitives[0] = p;
    wrong.mesh.name = wrong.skin.name = wrong.image.name = wrong.material.name = "wrong";
    wrong.mesh.primitives = wrong.primitives;
    wrong.mesh.primitive_count = 2; /* the second one has no vertices */
    wrong.primitives[1].topology = NKW_DOCUMENT_TRIANGLES;
    wrong.skin.joints = wrong.skin_joints;
    wrong.skin.inverse_bind = wrong.matrices;
    wrong.skin.joint_count = 2;
    wrong.image.path = "picture.png";
    wrong.material.color[3] = 1.0f;
    wrong.material.image = &wrong.image;
    one.node.mesh = one.node.skin = 0;
    one.document.format = format;
    one.document.meshes = &wrong.mesh;
    one.document.skins = &wrong.skin;
    one.document.images = &wrong.image;
    one.document.materials = &wrong.material;
    one.document.mesh_count = one.document.skin_count = one.document.image_count = one.document.material_count = 1;
}

static double length_of(const float *v)
{
    return sqrt((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1] + (double)v[2] * (double)v[2]);
}

static void what_is_written_is_valid(void **state)
{
    (void)state;
    make_wrong("Some Importer");
    nkw_document *d = written(NKW_GLTF_TEXT);
    assert_int_equal(d->meshes[0].primitive_count, 1);
    const nkw_document_primitive *p = &d->meshes[0].primitives[0];
    for (size_t v = 0; v < 5; v++) {
        double sum = 0.0;
        float rounded = 0.0f;
        for (size_t i = 0; i < p->influence_count; i++) {
            const float w = p->weights[v * p->influence_count + i];
            assert_true(w >= 0.0f);
            for (size_t k = 0; k < i; k++) /* a joint has one weight */
                assert_true(w == 0.0f || p->weights[v * p->influence_count + k] == 0.0f ||
                            p->joints[v * p->influence_count + k] != p->joints[v * p->influence_count + i]);
            sum += (double)w;
            rounded += w;
        }
        assert_true(fabs(sum - 1.0) < 6e-8);
        assert_true(rounded == 1.0f);
        assert_true(fabs(length_of(&p->normals[v].x) - 1.0) < 2e-7);
        assert_true(fabs(length_of(p->tangents + 4 * v) - 1.0) < 2e-7);
        assert_true(fabsf(p->tangents[4 * v + 3]) == 1.0f);
    }
    assert_true(fabsf(p->weights[0] - 2.0f / 3.0f) < 1e-6f);
    assert_true(p->weights[4] == 1.0f && p->joints[4] == 1); /* 5 and 1 of joint 1, 0 of joint 0: one weight */
    assert_true(p->normals[0].y == 1.0f && p->tangents[3] == -1.0f);
    assert_true(fabsf(p->normals[1].x - 0.6f) < 1e-6f && fabsf(p->normals[1].y - 0.8f) < 1e-6f);
    assert_true(p->normals[2].y == 1.0f); /* of its triangles, which face up */
    assert_true(p->normals[4].z == 1.0f); /* of none */
    assert_true(p->colors[0] == 0.0f && p->colors[1] == 1.0f && p->colors[2] == 1.0f && p->colors[3] == 0.25f);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++)
            assert_true(d->skins[0].inverse_bind[i].m[4 * k + 3] == (k == 3 ? 1.0f : 0.0f));
    assert_true(d->skins[0].inverse_bind[1].m[12] == 3.0f && d->skins[0].inverse_bind[1].m[0] == 1.0f);
    assert_int_equal(d->material_count, 2); /* the same without its picture, for a part without texture coordinates */
    assert_int_equal(p->material, 1);
    assert_null(d->materials[1].image);
    nkw_document_close(d);
}

/* The faults of a glTF file are its own: `check` names them. */
static void values_of_gltf_are_copied(void **state)
{
    (void)state;
    make_wrong("glTF 2.0");
    nkw_document *d = written(NKW_GLTF_BINARY);
    const nkw_document_primitive *p = &d->meshes[0].primitives[0];
    assert_memory_equal(p->normals, wrong.normals, sizeof wrong.normals);
    assert_memory_equal(p->tangents, wrong.tangents, sizeof wrong.tangents);
    for (size_t v = 0; v < 5; v++)
        assert_memory_equal(p->weights + v * p->influence_count, wrong.weights + 3 * v, 3 * sizeof(float));
    assert_memory_equal(d->skins[0].inverse_bind, wrong.matrices, sizeof wrong.matrices);
    assert_int_equal(d->material_count, 1);
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
        cmocka_unit_test(channels_that_are_left_out_are_not_in_the_file),
        cmocka_unit_test(what_is_written_is_valid),
        cmocka_unit_test(values_of_gltf_are_copied),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
