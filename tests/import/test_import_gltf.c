/* SPDX-License-Identifier: MIT */
/* What the reader makes of valid glTF files, feature by feature. */
#include <math.h>

#include <nakawari/mat.h>
#include <nakawari/scalar.h>
#include <nakawari/skeleton.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

#include "documents.h"
#include "views.h"

#define ASSET     "'asset':{'version':'2.0'},"
#define BUFFER(n) "'buffers':[{'uri':'data.bin','byteLength':" #n "}],"

static void nodes_are_joints_in_order(void **state)
{
    (void)state;
    nkw_document *d = opened("{" ASSET "'scene':0,'scenes':[{'nodes':[2]},{'name':'second'}],'nodes':["
                             "{'name':'leaf','translation':[1,2,3],'rotation':[0,0,1,0],'scale':[4,5,6]},"
                             "{'children':[0]},{'name':'','children':[1,3]},{'name':'last'}]}",
                             NULL, 0);
    const int32_t parents[] = {-1, 0, 1, 0}, joints[] = {2, 1, 0, 3};
    const nkw_trs leaf = {{1, 2, 3}, {0, 0, 1, 0}, {4, 5, 6}};
    assert_string_equal(d->format, "glTF 2.0");
    assert_string_equal(d->file, "test.gltf");
    assert_int_equal(d->skeleton.joint_count, 4);
    for (size_t i = 0; i < 4; i++) {
        assert_int_equal(d->skeleton.parents[i], parents[i]);
        assert_int_equal(d->joint_of_node[i], joints[i]);
        assert_int_equal(d->nodes[joints[i]].number, i);
        assert_int_equal(d->nodes[i].mesh, NKW_NO_JOINT);
    }
    assert_string_equal(d->nodes[0].name, "node_2");
    assert_string_equal(d->nodes[1].name, "node_1");
    assert_string_equal(d->nodes[2].name, "leaf");
    nkw_trs rest = nkw_pose_get(d->rest, 2);
    assert_memory_equal(&rest, &leaf, sizeof rest);
    assert_int_equal(d->scene, 0);
    assert_int_equal(d->scene_count, 2);
    assert_string_equal(d->scenes[0].name, "scene_0");
    assert_string_equal(d->scenes[1].name, "second");
    assert_int_equal(d->scenes[0].root_count, 1);
    assert_int_equal(d->scenes[0].roots[0], 0);
    nkw_document_close(d);
}

static void a_file_may_have_no_nodes(void **state)
{
    (void)state;
    nkw_document *d = opened("{" ASSET "'scenes':[{}],'materials':[{'name':'red'}]}", NULL, 0);
    assert_int_equal(d->skeleton.joint_count, 0);
    assert_int_equal(d->material_count, 1);
    assert_int_equal(d->scene_count, 1);
    nkw_document_close(d);
    nkw_document_close(opened("{" ASSET "'nodes':[]}", NULL, 0));
}

/* Channels that are no tracks are listed with a reason; the others are read. */
static void channels_that_are_not_read_are_listed(void **state)
{
    (void)state;
    float data[] = {0, 1, 5, 6, 7, 8, 9, 10};
    nkw_document *d = opened(
        "{" ASSET BUFFER(
            32) "'extensionsUsed':['KHR_animation_pointer'],'extensionsRequired':['KHR_animation_pointer'],"
                "'bufferViews':[{'buffer':0,'byteLength':8},{'buffer':0,'byteOffset':8,'byteLength':24}],"
                "'accessors':[{'bufferView':0,'componentType':5126,'count':2,'type':'SCALAR'},"
                "{'bufferView':1,'componentType':5126,'count':2,'type':'VEC3'}],'nodes':[{}],"
                "'animations':[{'samplers':[{'input':0,'output':1}],'channels':["
                "{'sampler':0,'target':{'path':'pointer','extensions':{'KHR_animation_pointer':{'pointer':'/a/0/b'}}}},"
                "{'sampler':0,'target':{'node':0,'path':'scale'}},{'sampler':0,'target':{'path':'scale'}},"
                "{'sampler':0,'target':{'node':0,'path':'weights'}}]}]}",
        data, sizeof data);
    const nkw_document_animation *a = d->animations;
    assert_int_equal(a->track_count, 1);
    assert_int_equal(a->channels[0].number, 1);
    assert_int_equal(a->unread_count, 2);
    assert_int_equal(a->unread[0].number, 0);
    assert_string_equal(a->unread[0].reason, "KHR_animation_pointer /a/0/b is not read");
    assert_int_equal(a->unread[1].number, 3);
    assert_string_equal(a->unread[1].reason, "weights, but the mesh has no morph targets");
    nkw_document_close(d);
}

static void matrices_keep_their_shear(void **state)
{
    (void)state;
    float times[] = {0, 1, 5, 6, 7, 8, 9, 10};
    nkw_document *d = opened(
        "{" ASSET BUFFER(
            32) "'bufferViews':[{'buffer':0,'byteLength':8},{'buffer':0,'byteOffset':8,'byteLength':24}],"
                "'accessors':[{'bufferView':0,'componentType':5126,'count':2,'type':'SCALAR'},"
                "{'bufferView':1,'componentType':5126,'count':2,'type':'VEC3'}],"
                "'nodes':[{'matrix':[1,0,0,0,0.5,1,0,0,0,0,1,0,7,8,9,1]},{'matrix':[2,0,0,0,0,2,0,0,0,0,2,0,1,1,1,1]}],"
                "'animations':[{'samplers':[{'input':0,'output':1}],'channels':["
                "{'sampler':0,'target':{'path':'rotation'}},{'sampler':0,'target':{'node':1,'path':'translation'}}]}]}",
        times, sizeof times);
    nkw_mat4 models[2];
    const nkw_mat4 sheared = {{1, 0, 0, 0, 0.5f, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1}};
    assert_non_null(d->nodes[0].matrix);
    assert_null(d->nodes[1].matrix); /* animated */
    expect_near(d->nodes[1].rest.scale.x, 2, 0);
    assert_int_equal(nkw_document_models(d, d->rest, NULL, models), NKW_OK);
    expect_floats_bits(models[0].m, sheared.m, 16);
    assert_int_equal(nkw_document_models(d, pose_view(NULL, 1), NULL, models), NKW_MISMATCHED);
    /* The channel without a node is left out. */
    assert_int_equal(d->animations[0].track_count, 1);
    assert_int_equal(d->animations[0].channels[0].number, 1);
    assert_int_equal(d->animations[0].channels[0].joint, 1);
    assert_int_equal(d->animations[0].channels[0].bytes, 32);
    assert_string_equal(d->animations[0].name, "animation_0");
    nkw_document_close(d);
}

/* max(c / 127, -1) and so on; the extremes of each type. */
static void integers_are_normalised(void **state)
{
    (void)state;
    const unsigned char bytes[40] = {0x80, 0x81, 0x7f, 0,    0, 255,  128, 0,    0x00, 0x80, 0x01, 0x80, 0xff, 0x7f,
                                     0,    0,    0xff, 0xff, 0, 0x80, 0,   0,    0,    0,    0,    0,    0,    0,
                                     0,    0,    0x80, 0x3f, 0, 0,    0,   0x40, 0,    0,    0x40, 0x40};
    const float want[4][3] = {{-1, -1, 1}, {0, 1, 128.0f / 255}, {-1, -1, 1}, {0, 1, 32768.0f / 65535}};
    const char *const text = "{" ASSET BUFFER(
        40) "'bufferViews':[{'buffer':0,'byteLength':40}],'nodes':[{}],'accessors':["
            "{'bufferView':0,'componentType':5126,'byteOffset':28,'count':3,'type':'SCALAR'},"
            "{'bufferView':0,'componentType':5120,'normalized':true,'count':1,'type':'VEC3'},"
            "{'bufferView':0,'componentType':5121,'normalized':true,'byteOffset':4,'count':1,'type':'VEC3'},"
            "{'bufferView':0,'componentType':5122,'normalized':true,'byteOffset':8,'count':1,'type':'VEC3'},"
            "{'bufferView':0,'componentType':5123,'normalized':true,'byteOffset':14,'count':1,'type':'VEC3'},"
            "{'bufferView':0,'componentType':5126,'byteOffset':24,'count':1,'type':'SCALAR'}],'animations':[{'samplers'"
            ":["
            "{'input':5,'output':1},{'input':5,'output':2},{'input':5,'output':3},{'input':5,'output':4}],'channels':["
            "{'sampler':0,'target':{'node':0,'path':'translation'}},{'sampler':1,'target':{'node':0,'path':'scale'}},"
            "{'sampler':2,'target':{'node':0,'path':'translation'}},{'sampler':3,'target':{'node':0,'path':'scale'}}]}]"
            "}";
    nkw_document *d = opened(text, bytes, sizeof bytes);
    for (size_t i = 0; i < 4; i++)
        expect_floats_bits(d->animations[0].tracks[i].track.values, want[i], 3);
    assert_ptr_equal(d->animations[0].tracks[0].track.times, d->animations[0].tracks[3].track.times);
    nkw_document_close(d);
}

/* The slerp of unit quaternions along the shorter arc, and its angle from `got`, which need not be unit. */
static double angle_from_slerp(const double a[4], const double b[4], double t, nkw_quat got)
{
    const double q[4] = {(double)got.x, (double)got.y, (double)got.z, (double)got.w};
    double c = 0.0, dot = 0.0, length = 0.0, want[4], off = 0.0;
    for (int i = 0; i < 4; i++)
        c += a[i] * b[i];
    const double sign = c < 0.0 ? -1.0 : 1.0, angle = acos(fabs(c));
    for (int i = 0; i < 4; i++) {
        want[i] = (a[i] * sin((1.0 - t) * angle) + sign * b[i] * sin(t * angle)) / sin(angle);
        dot += q[i] * want[i];
        length += q[i] * q[i];
    }
    for (int i = 0; i < 4; i++) {
        double d = q[i] / sqrt(length) - (dot < 0.0 ? -want[i] : want[i]);
        off += d * d;
    }
    return 4.0 * asin(0.5 * sqrt(off));
}

static nkw_quat rotation_of(const nkw_document *d, float time, nkw_mat4 *model)
{
    float pose[NKW_POSE_FLOATS(1)];
    nkw_import_error error;
    nkw_clip *clip;
    assert_int_equal(nkw_document_clip(d, 0, NKW_CLIP_FLOAT32, &clip, &error), NKW_IMPORT_OK);
    nkw_clip_sample(clip, time, NULL, pose_span(pose, 1), NULL);
    nkw_skeleton_models_from_pose(&d->skeleton, pose_view(pose, 1), NULL, NULL, model);
    nkw_import_free(clip);
    return nkw_pose_get(pose_view(pose, 1), 0).rotation;
}

/*
 * Rotations of integers are rounded unit quaternions: lengths of these keys are off by up to 5e-3 in 8 bits. Between
 * keys the reference slerps what each key means, in binary64; the matrices are orthonormal.
 */
static void rotations_of_integers_are_unit(void **state)
{
    (void)state;
    const int keys[3][4] = {{0, 0, 0, 127}, {-90, 0, 0, 90}, {37, -73, 72, -64}};
    struct {
        float times[3];
        signed char bytes[12];
        int16_t shorts[12];
    } data = {{0, 1, 2}, {0}, {0}};
    double units[3][4];
    for (int k = 0; k < 3; k++) {
        double squares = 0.0;
        for (int i = 0; i < 4; i++)
            squares += (double)(keys[k][i] * keys[k][i]);
        for (int i = 0; i < 4; i++) {
            units[k][i] = keys[k][i] / sqrt(squares);
            data.bytes[4 * k + i] = (signed char)keys[k][i];
            data.shorts[4 * k + i] = (int16_t)lround(32767.0 * units[k][i]);
        }
    }
    static const char *const outputs[2] = {"'byteOffset':12,'componentType':5120",
                                           "'byteOffset':24,'componentType':5122"};
    for (int kind = 0; kind < 2; kind++) {
        char text[1000];
        snprintf(text, sizeof text,
                 "{" ASSET BUFFER(
                     48) "'bufferViews':[{'buffer':0,'byteLength':48}],'nodes':[{}],'accessors':["
                         "{'bufferView':0,'componentType':5126,'count':3,'type':'SCALAR'},"
                         "{'bufferView':0,%s,'normalized':true,'count':3,'type':'VEC4'}],'animations':[{'samplers':["
                         "{'input':0,'output':1}],'channels':[{'sampler':0,'target':{'node':0,'path':'rotation'}}]}]}",
                 outputs[kind]);
        nkw_document *d = opened(text, &data, sizeof data);
        for (int i = 0; i < 16; i++) {
            const int k = i / 8;
            nkw_mat4 model;
            nkw_quat got = rotation_of(d, (float)i / 8.0f, &model);
            assert_true(angle_from_slerp(units[k], units[k + 1], (double)i / 8.0 - k, got) < (kind ? 1e-4 : 1e-6));
            for (int c = 0; c < 3; c++) {
                const float *m = model.m + 4 * c;
                expect_near(nkw_sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]), 1.0, 5e-7);
            }
        }
        nkw_document_close(d);
    }
}

/* A triangle with stride, one sparse position, and modes. */
static void accessors_have_strides_and_sparse_elements(void **state)
{
    (void)state;
    struct {
        float positions[4][4], more[3];
        uint16_t index, padding;
    } data = {{{0, 1, 2, 99}, {3, 4, 5, 99}, {6, 7, 8, 99}, {9, 10, 11, 99}}, {20, 21, 22}, 2, 0};
    const char *const text = "{" ASSET BUFFER(
        80) "'bufferViews':[{'buffer':0,'byteLength':64,'byteStride':16},"
            "{'buffer':0,'byteOffset':64,'byteLength':12},{'buffer':0,'byteOffset':76,'byteLength':2}],'accessors':["
            "{'bufferView':0,'componentType':5126,'count':4,'type':'VEC3','sparse':{'count':1,"
            "'indices':{'bufferView':2,'componentType':5123},'values':{'bufferView':1}}},"
            "{'componentType':5126,'count':4,'type':'VEC3','sparse':{'count':1,"
            "'indices':{'bufferView':2,'componentType':5123},'values':{'bufferView':1}}}],"
            "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1}}]},"
            "{'primitives':[{'attributes':{'POSITION':0},'mode':5},{'attributes':{'POSITION':0},'mode':6},"
            "{'attributes':{'POSITION':0},'mode':2},{'attributes':{'POSITION':0},'mode':3},"
            "{'attributes':{'POSITION':0},'mode':0}]}],"
            "'nodes':[{'mesh':0}]}";
    const float want[12] = {0, 1, 2, 3, 4, 5, 20, 21, 22, 9, 10, 11}, normals[12] = {0, 0, 0, 0, 0, 0, 20, 21, 22};
    const uint32_t indices[5][8] = {
        {0, 1, 2, 1, 3, 2}, {1, 2, 0, 2, 3, 0}, {0, 1, 1, 2, 2, 3, 3, 0}, {0, 1, 1, 2, 2, 3}, {0, 1, 2, 3}};
    const size_t counts[5] = {6, 6, 8, 6, 4};
    nkw_document *d = opened(text, &data, sizeof data);
    const nkw_document_primitive *p = d->meshes[0].primitives;
    assert_int_equal(p->vertex_count, 4);
    expect_floats_bits(&p->positions[0].x, want, 12);
    expect_floats_bits(&p->normals[0].x, normals, 12);
    assert_int_equal(p->index_count, 3); /* the fourth vertex is no triangle */
    for (size_t i = 0; i < 5; i++) {
        p = &d->meshes[1].primitives[i];
        assert_int_equal(p->index_count, counts[i]);
        assert_memory_equal(p->indices, indices[i], counts[i] * sizeof(uint32_t));
        assert_int_equal(p->topology, i < 2   ? NKW_DOCUMENT_TRIANGLES
                                      : i < 4 ? NKW_DOCUMENT_LINES
                                              : NKW_DOCUMENT_POINTS);
    }
    nkw_document_close(d);
}

/* Two sets of influences: ten of one vertex in three sets are pruned to eight. */
static void influences_are_joined_and_pruned(void **state)
{
    (void)state;
    struct {
        float position[3];
        unsigned char joints[3][4], weights[3][4];
    } data = {
        {1, 2, 3}, {{0, 1, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 0}}, {{10, 20, 30, 40}, {50, 60, 70, 80}, {90, 5, 0, 0}}};
    const char *const text = "{" ASSET BUFFER(
        36) "'bufferViews':[{'buffer':0,'byteLength':36}],'accessors':["
            "{'bufferView':0,'componentType':5126,'count':1,'type':'VEC3'},"
            "{'bufferView':0,'byteOffset':12,'componentType':5121,'count':1,'type':'VEC4'},"
            "{'bufferView':0,'byteOffset':16,'componentType':5121,'count':1,'type':'VEC4'},"
            "{'bufferView':0,'byteOffset':20,'componentType':5121,'count':1,'type':'VEC4'},"
            "{'bufferView':0,'byteOffset':24,'componentType':5121,'normalized':true,'count':1,'type':'VEC4'},"
            "{'bufferView':0,'byteOffset':28,'componentType':5121,'normalized':true,'count':1,'type':'VEC4'},"
            "{'bufferView':0,'byteOffset':32,'componentType':5121,'normalized':true,'count':1,'type':'VEC4'}],"
            "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'JOINTS_0':1,'WEIGHTS_0':4,'JOINTS_1':2,'WEIGHTS_1':"
            "5,"
            "'JOINTS_2':3,'WEIGHTS_2':6}},{'attributes':{'POSITION':0,'JOINTS_0':1,'WEIGHTS_0':4}}]}],"
            "'skins':[{'joints':[1,2]}],"
            "'nodes':[{'mesh':0,'skin':0},{'translation':[10,0,0]},{'translation':[0,20,0]}]}";
    nkw_document *d = opened(text, &data, sizeof data);
    const nkw_document_primitive *p = d->meshes[0].primitives;
    assert_int_equal(p->influence_count, 12);
    assert_int_equal(p->joints[9], 1);
    expect_bits(p->weights[8], 90.0f / 255);
    assert_int_equal(p->skin.influence_count, 8);
    assert_int_equal(nkw_skin_validate(&p->skin, 2, NULL), NKW_OK);
    assert_int_equal(p[1].influence_count, 4);
    assert_int_equal(p[1].skin.influence_count, 4);
    assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_OK);

    /* 10 + 30 and 20 + 40 of 100 are the weights of the joints. */
    nkw_mat4 models[3], palette[2];
    nkw_vec3 position, normal;
    const nkw_document_vertices_span out = {&position, &normal};
    assert_null(d->skins[0].inverse_bind);
    assert_int_equal(nkw_document_models(d, d->rest, NULL, models), NKW_OK);
    assert_int_equal(nkw_document_palette(d, 0, models, palette), NKW_OK);
    assert_int_equal(nkw_document_palette(d, 1, models, palette), NKW_OUT_OF_RANGE);
    const nkw_document_moment moment = {models, NULL, palette};
    assert_int_equal(nkw_document_vertices(d, 0, 1, &moment, out), NKW_OK);
    nkw_vec3 want = {1 + 4, 2 + 12, 3}, none = {0, 0, 0};
    expect_vec3_near(position, want, 1e-5);
    expect_vec3_bits(normal, none);
    assert_int_equal(nkw_document_vertices(d, 1, 0, &moment, out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_document_vertices(d, 0, 2, &moment, out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_document_vertices(d, 3, 0, &moment, out), NKW_OUT_OF_RANGE);
    nkw_document_close(d);
}

/* Weights of the node are before those of the mesh; floats are in the order of joints. */
static void morph_targets_have_weights(void **state)
{
    (void)state;
    const float data[] = {1, 0, 0, 0, 0, 1, 0, 2, 0, 0, 0, 3, 0, 1, 0.25f, 0.5f, 1, 2};
    const char *const text = "{" ASSET BUFFER(
        72) "'bufferViews':[{'buffer':0,'byteLength':72}],'accessors':["
            "{'bufferView':0,'componentType':5126,'count':1,'type':'VEC3'},"
            "{'bufferView':0,'byteOffset':12,'componentType':5126,'count':1,'type':'VEC3'},"
            "{'bufferView':0,'byteOffset':24,'componentType':5126,'count':1,'type':'VEC3'},"
            "{'bufferView':0,'byteOffset':36,'componentType':5126,'count':1,'type':'VEC3'},"
            "{'bufferView':0,'byteOffset':48,'componentType':5126,'count':2,'type':'SCALAR'},"
            "{'bufferView':0,'byteOffset':56,'componentType':5126,'count':4,'type':'SCALAR'}],"
            "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1},'targets':[{'POSITION':2,'NORMAL':3},"
            "{'POSITION':3}]}],'weights':[0.5,0],'extras':{'targetNames':['smile']}}],"
            "'nodes':[{'children':[1]},{'mesh':0,'weights':[0,2]},{'mesh':0,'scale':[1,4,1]}],"
            "'animations':[{'name':'talk','samplers':[{'input':4,'output':5}],"
            "'channels':[{'sampler':0,'target':{'node':2,'path':'weights'}}]}]}";
    nkw_document *d = opened(text, data, sizeof data);
    const float rest[] = {0, 2, 0.5f, 0};
    assert_int_equal(d->float_count, 4);
    expect_floats_bits(d->rest_floats, rest, 4);
    assert_string_equal(d->meshes[0].target_names[0], "smile");
    assert_string_equal(d->meshes[0].target_names[1], "target_1");
    assert_string_equal(d->animations[0].name, "talk");
    assert_int_equal(d->animations[0].tracks[0].index, 2);
    assert_int_equal(d->animations[0].tracks[0].track.width, 2);
    assert_int_equal(d->nodes[1].float_first, 0);
    assert_int_equal(d->nodes[2].float_first, 2);

    nkw_clip *clip;
    float floats[4];
    nkw_mat4 models[3];
    nkw_vec3 position, normal;
    const nkw_document_vertices_span out = {&position, &normal};
    assert_int_equal(nkw_document_clip(d, 0, NKW_CLIP_FLOAT32, &clip, NULL), NKW_IMPORT_OK);
    assert_int_equal(nkw_clip_sample(clip, 1.0f, NULL, pose_span(NULL, 3), floats), NKW_OK);
    nkw_import_free(clip);
    const float sampled[] = {0, 2, 1, 2};
    expect_floats_bits(floats, sampled, 4);
    assert_int_equal(nkw_document_models(d, d->rest, NULL, models), NKW_OK);
    const nkw_document_moment moment = {models, floats, NULL};
    assert_int_equal(nkw_document_vertices(d, 2, 0, &moment, out), NKW_OK);
    nkw_vec3 want = {1, 4 * 2, 6}, up = {0, 0, 1}; /* the normal is 0 0 1 + 0 0 3 */
    expect_vec3_near(position, want, 0);
    expect_vec3_near(normal, up, 1e-7);
    nkw_document_close(d);
}

/* 'AACAPw' is the float 1 in base64; a text may have a byte order mark. */
static void buffers_are_data_or_files(void **state)
{
    (void)state;
    static const char *const uris[] = {
        "data:application/octet-stream;base64,AACAPwAAgD8AAIA/AACAPw==", "data:;base64,AACAPwAAgD8AAIA_AACAPw",
        "data:application/gltf-buffer,%00%00%80%3F%00%00%80%3f%00%00%80%3F%00%00%80?", "a/b/../.././/dat%61.bin",
        "x/../data.bin"};
    const float ones[] = {1, 1, 1, 1};
    for (size_t i = 0; i < sizeof uris / sizeof *uris; i++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "\xef\xbb\xbf{" ASSET "'buffers':[{'byteLength':16,'uri':'%s'}],'nodes':[{'mesh':0}],"
                 "'bufferViews':[{'buffer':0,'byteLength':16}],"
                 "'accessors':[{'bufferView':0,'componentType':5126,'count':1,'type':'VEC3','byteOffset':4}],"
                 "'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]}]}",
                 uris[i]);
        nkw_document *d = opened(text, ones, sizeof ones);
        expect_floats_bits(&d->meshes[0].primitives[0].positions[0].x, ones, 3);
        nkw_document_close(d);
    }
}

static void extensions_that_change_nothing_are_ignored(void **state)
{
    (void)state;
    nkw_document *d = opened("{'asset':{'version':'2.1','minVersion':'2.0','generator':'hand'},'nodes':[{}],"
                             "'extensionsUsed':['VRMC_vrm','EXT_x'],'extensionsRequired':['KHR_materials_unlit'],"
                             "'extensions':{'VRM':{'deep':[[[{}]]]}},'materials':[{'pbrMetallicRoughness':"
                             "{'baseColorFactor':[0.5,0.25,0,1]}},{'name':'m'}]}",
                             NULL, 0);
    assert_string_equal(d->generator, "hand");
    assert_int_equal(d->material_count, 2);
    expect_bits(d->materials[0].color[1], 0.25f);
    expect_bits(d->materials[1].color[1], 1.0f);
    assert_string_equal(d->materials[1].name, "m");
    nkw_document_close(d);
}

/* Images of base colours: a data URI, a buffer view, an outer file; and five that are none. */
static void images_of_base_colours_are_kept(void **state)
{
    (void)state;
    const unsigned char bytes[] = {0x89, 'P', 'N', 'G'};
    nkw_document *d =
        opened("{" ASSET BUFFER(
                   4) "'bufferViews':[{'buffer':0,'byteOffset':1,'byteLength':3}],'nodes':[{}],"
                      "'images':[{'uri':'data:image/png;base64,AAECAw==','name':'a'},{'bufferView':0},"
                      "{'uri':'skins/fox%20red.png'},{'uri':'../x.png'},{'bufferView':7},{'uri':'data:,unused'}],"
                      "'textures':[{'source':0},{'source':1},{'source':2},{'source':3},{'source':4},{}],'materials':["
                      "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}},"
                      "{'pbrMetallicRoughness':{'baseColorTexture':{'index':1}}},"
                      "{'pbrMetallicRoughness':{'baseColorTexture':{'index':2}}},"
                      "{'pbrMetallicRoughness':{'baseColorTexture':{'index':3}}},"
                      "{'pbrMetallicRoughness':{'baseColorTexture':{'index':4}}},"
                      "{'pbrMetallicRoughness':{'baseColorTexture':{'index':5}}},"
                      "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'texCoord':1}}},"
                      "{'pbrMetallicRoughness':{'baseColorTexture':{'index':9}}},{}]}",
               bytes, sizeof bytes);
    const nkw_document_image *image[9];
    for (size_t i = 0; i < 9; i++)
        image[i] = d->materials[i].image;
    assert_int_equal(d->image_count, 6);
    assert_string_equal(image[0]->name, "a");
    assert_int_equal(image[0]->bytes, 4);
    assert_memory_equal(image[0]->data, "\0\1\2\3", 4);
    assert_int_equal(image[1]->bytes, 3);
    assert_memory_equal(image[1]->data, "PNG", 3);
    assert_null(image[2]->data);
    assert_string_equal(image[2]->path, "skins/fox red.png");
    assert_true(!image[3]->data && !image[3]->path && !image[4]->data && !image[4]->path);
    assert_true(!image[5] && image[6] == image[0] && !image[7] && !image[8]);
    assert_true(d->materials[0].image_texcoords == 0 && d->materials[6].image_texcoords == 1);
    assert_null(d->images[5].data); /* of no material */
    nkw_document_close(d);
}

static void colours_of_vertices_have_alpha(void **state)
{
    (void)state;
    const unsigned char bytes[32] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x33, 0xff, 0, 0x66, 0, 0, 0};
    const float three[4] = {0, 0.2f, 1, 1}, four[4] = {0, 0.2f, 1, 0};
    nkw_document *d =
        opened("{" ASSET BUFFER(32) "'bufferViews':[{'buffer':0,'byteLength':32}],'nodes':[{}],"
                                    "'accessors':[{'bufferView':0,'componentType':5126,'count':1,'type':'VEC3'},"
                                    "{'bufferView':0,'componentType':5121,'normalized':true,'byteOffset':12,"
                                    "'count':1,'type':'VEC3'},{'bufferView':0,'componentType':5121,"
                                    "'normalized':true,'byteOffset':12,'count':1,'type':'VEC4'}],'meshes':[{"
                                    "'primitives':[{'attributes':{'POSITION':0,'COLOR_0':1}},"
                                    "{'attributes':{'POSITION':0,'COLOR_0':2}},{'attributes':{'POSITION':0}}]}]}",
               bytes, sizeof bytes);
    expect_floats_bits(d->meshes[0].primitives[0].colors, three, 4);
    expect_floats_bits(d->meshes[0].primitives[1].colors, four, 4);
    assert_null(d->meshes[0].primitives[2].colors);
    nkw_document_close(d);
}

/* The character of the examples: two skins, morph targets, three clips. */
static void the_character_of_the_examples_is_read(void **state)
{
    (void)state;
    nkw_document *d;
    nkw_import_error error;
    assert_int_equal(nkw_document_open(NKW_CHARACTER, &d, &error), NKW_IMPORT_OK);
    assert_int_equal(nkw_document_validate(d, &error), NKW_IMPORT_OK);
    assert_int_equal(d->animation_count, 3);
    assert_int_equal(d->skin_count, 2);
    assert_true(d->float_count > 0);
    size_t joints = d->skeleton.joint_count, skinned = 0;
    float *pose = (float *)calloc(nkw_pose_floats(joints), sizeof *pose);
    float *floats = (float *)calloc(d->float_count, sizeof *floats);
    nkw_mat4 *models = (nkw_mat4 *)calloc(joints, sizeof *models),
             *palette = (nkw_mat4 *)calloc(joints, sizeof *models);
    assert_true(pose && floats && models && palette);
    for (size_t i = 0; i < d->animation_count; i++) {
        nkw_clip *clip;
        assert_int_equal(nkw_document_clip(d, i, NKW_CLIP_FLOAT32, &clip, &error), NKW_IMPORT_OK);
        float middle = 0.5f * (nkw_clip_describe(clip).start + nkw_clip_describe(clip).end);
        assert_int_equal(nkw_clip_sample(clip, middle, NULL, pose_span(pose, joints), floats), NKW_OK);
        nkw_import_free(clip);
        assert_int_equal(nkw_document_models(d, pose_view(pose, joints), NULL, models), NKW_OK);
        for (size_t j = 0; j < joints; j++) {
            if (d->nodes[j].mesh == NKW_NO_JOINT)
                continue;
            size_t count = d->meshes[d->nodes[j].mesh].primitives[0].vertex_count;
            nkw_vec3 *vertices = (nkw_vec3 *)calloc(count, 2 * sizeof *vertices);
            assert_non_null(vertices);
            const nkw_document_vertices_span out = {vertices, vertices + count};
            assert_int_equal(nkw_document_palette(d, (size_t)d->nodes[j].skin, models, palette), NKW_OK);
            const nkw_document_moment moment = {models, floats, palette};
            assert_int_equal(nkw_document_vertices(d, j, 0, &moment, out), NKW_OK);
            for (size_t v = 0; v < count; v++) {
                expect_near(nkw_vec3_length(vertices[v]), 0, 10);
                expect_near(nkw_vec3_length(out.normals[v]), 1, 1e-6);
            }
            skinned += count;
            free(vertices);
        }
    }
    assert_true(skinned > 100);
    free(palette);
    free(models);
    free(floats);
    free(pose);
    nkw_document_close(d);
}

/* A clip of the rest pose, for an animation that does not exist. */
static void documents_without_animations_have_a_rest_clip(void **state)
{
    (void)state;
    nkw_document *d = opened("{" ASSET "'nodes':[{'translation':[1,2,3]}]}", NULL, 0);
    nkw_clip *clip;
    float pose[NKW_POSE_FLOATS(1)];
    assert_int_equal(nkw_document_clip(d, 7, NKW_CLIP_FLOAT32, &clip, NULL), NKW_IMPORT_OK);
    assert_int_equal(nkw_clip_sample(clip, 1.0f, NULL, pose_span(pose, 1), NULL), NKW_OK);
    expect_bits(nkw_pose_get(pose_view(pose, 1), 0).translation.y, 2.0f);
    nkw_import_free(clip);
    nkw_document_close(d);
    nkw_document_close(NULL);
    nkw_import_free(NULL);
}

/* Spaces may pad the JSON chunk; some programs write zeros. */
static void zeros_behind_the_json_of_a_glb_are_read_with_a_warning(void **state)
{
    (void)state;
    static const char json[28] = "{\"asset\":{\"version\":\"2.0\"}}";
    const uint32_t head[5] = {0x46546c67, 2, 48, 28, 0x4e4f534a};
    unsigned char bytes[48];
    nkw_document *d;
    memcpy(bytes, head, sizeof head);
    memcpy(bytes + 20, json, sizeof json);
    const nkw_import_memory memory = {bytes, sizeof bytes, "a.glb", NULL, NULL, NULL, 0, 0};
    assert_int_equal(nkw_document_from_memory(&memory, &d, NULL), NKW_IMPORT_OK);
    assert_int_equal(d->warning_count, 1);
    nkw_document_close(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_are_joints_in_order),
        cmocka_unit_test(a_file_may_have_no_nodes),
        cmocka_unit_test(channels_that_are_not_read_are_listed),
        cmocka_unit_test(matrices_keep_their_shear),
        cmocka_unit_test(integers_are_normalised),
        cmocka_unit_test(rotations_of_integers_are_unit),
        cmocka_unit_test(accessors_have_strides_and_sparse_elements),
        cmocka_unit_test(influences_are_joined_and_pruned),
        cmocka_unit_test(morph_targets_have_weights),
        cmocka_unit_test(buffers_are_data_or_files),
        cmocka_unit_test(extensions_that_change_nothing_are_ignored),
        cmocka_unit_test(images_of_base_colours_are_kept),
        cmocka_unit_test(colours_of_vertices_have_alpha),
        cmocka_unit_test(the_character_of_the_examples_is_read),
        cmocka_unit_test(documents_without_animations_have_a_rest_clip),
        cmocka_unit_test(zeros_behind_the_json_of_a_glb_are_read_with_a_warning),
    };
    return cmocka_run_group_tests_name("import_gltf", tests, NULL, NULL);
}
