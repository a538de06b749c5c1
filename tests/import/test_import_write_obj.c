/* SPDX-License-Identifier: MIT */
/* OBJ and MTL that are written: texts by hand, and what readers make of the files. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <nakawari/export.h>

#include "documents.h"
#include "samples.h"

#if defined(NKW_TEST_ASSIMP)
#include <assimp/cimport.h>
#include <assimp/scene.h>
#endif

/* ---- Texts ---- */

static void expect_bytes(const char *data, size_t bytes, const char *want)
{
    if (bytes != strlen(want) || memcmp(data, want, bytes) != 0)
        print_error("got\n%.*s\nwant\n%s\n", (int)bytes, data, want);
    assert_int_equal(bytes, strlen(want));
    assert_memory_equal(data, want, bytes);
}

static nkw_obj_file written(const nkw_document *d, const nkw_obj_writing *writing)
{
    nkw_obj_file file;
    nkw_import_error error;
    const nkw_import_result result = nkw_document_write_obj(d, writing, &file, &error);
    if (result != NKW_IMPORT_OK)
        print_error("%s\n", error.reason);
    assert_int_equal(result, NKW_IMPORT_OK);
    return file;
}

/* Positions, texture coordinates and normals of a triangle; it is drawn with a material and without one. */
static const float triangle[24] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0.25f};
static const char two_nodes[] =
    "{'asset':{'version':'2.0'},'buffers':[{'uri':'data.bin','byteLength':96}],'bufferViews':[{'buffer':0,"
    "'byteLength':36},{'buffer':0,'byteOffset':36,'byteLength':36},{'buffer':0,'byteOffset':72,'byteLength':24}],"
    "'accessors':[{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'},{'bufferView':1,'componentType':5126,"
    "'count':3,'type':'VEC3'},{'bufferView':2,'componentType':5126,'count':3,'type':'VEC2'}],'images':[{'uri':"
    "'my%20wall.png'}],'textures':[{'source':0}],'materials':[{'name':'red wall','alphaMode':'BLEND',"
    "'pbrMetallicRoughness':{'baseColorFactor':[0.5,0,0.25,0.5],'baseColorTexture':{'index':0}}}],'meshes':[{"
    "'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,'TEXCOORD_0':2},'material':0},{'attributes':{'POSITION':0}}]"
    "}],'nodes':[{'name':'a b','mesh':0,'translation':[1,2,3]},{'name':'a_b','mesh':0,'scale':[-1,1,1]}]}";

/* The second node mirrors: its fronts remain fronts. */
static void nodes_are_objects_with_shared_lines(void **state)
{
    (void)state;
    static const char want[] = "mtllib m.mtl\no a_b\nv 1 2 3\nvt 0 1\nvn 0 0 1\nv 2 2 3\nvt 1 1\nv 1 3 3\nvt 0 0.75\n"
                               "usemtl red_wall\nf 1/1/1 2/2/1 3/3/1\nusemtl none\nf 1 2 3\no a_b_1\nv 0 0 0\n"
                               "v -1 0 0\nv 0 1 0\nusemtl red_wall\nf 4/1/1 6/3/1 5/2/1\nusemtl none\nf 4 6 5\n";
    nkw_document *d = opened(two_nodes, triangle, sizeof triangle);
    const nkw_obj_writing writing = {NULL, NULL, "m.mtl", NULL, 0};
    nkw_obj_file file = written(d, &writing);
    expect_bytes(file.data, file.bytes, want);
    expect_bytes(file.materials, file.material_bytes,
                 "newmtl red_wall\nKd 0.5 0 0.25\nd 0.5\nmap_Kd my wall.png\nnewmtl none\nKd 1 1 1\n");
    nkw_obj_file_free(&file);
    assert_null(file.data);
    nkw_document_close(d);
}

static void pictures_have_the_names_of_the_caller(void **state)
{
    (void)state;
    const char *const names[] = {"-other.png"};
    nkw_document *d = opened(two_nodes, triangle, sizeof triangle);
    const nkw_obj_writing writing = {NULL, NULL, "m", names, 1};
    nkw_obj_file file = written(d, &writing);
    assert_non_null(strstr(file.materials, "map_Kd ./-other.png\n"));
    assert_non_null(strstr(file.data, "\nvt 0 0.25\n")); /* v is upwards already */
    nkw_obj_file_free(&file);
    const nkw_obj_writing bare = {NULL, NULL, NULL, NULL, 0};
    file = written(d, &bare);
    assert_null(file.materials);
    assert_true(file.bytes > 4 && memcmp(file.data, "o a_", 4) == 0 && !strstr(file.data, "usemtl"));
    nkw_obj_file_free(&file);
    nkw_document_close(d);
}

static const char skinned[] =
    "{'asset':{'version':'2.0'},'buffers':[{'uri':'data.bin','byteLength':96}],'bufferViews':[{'buffer':0,"
    "'byteLength':36},{'buffer':0,'byteOffset':36,'byteLength':12},{'buffer':0,'byteOffset':48,'byteLength':48}],"
    "'accessors':[{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'},{'bufferView':1,'componentType':5121,"
    "'count':3,'type':'VEC4'},{'bufferView':2,'componentType':5126,'count':3,'type':'VEC4'}],'meshes':[{'primitives':["
    "{'attributes':{'POSITION':0,'JOINTS_0':1,'WEIGHTS_0':2}}]}],'skins':[{'joints':[0,1]}],'nodes':[{'children':[1]},"
    "{'name':'elbow'},{'name':'arm','mesh':0,'skin':0}]}";

/* By hand: the second joint is a quarter turn about z and a step up: (x, y) to (-y, x + 1). Weights are 1, 1/2, 0. */
static void vertices_are_skinned_at_the_time(void **state)
{
    (void)state;
    struct {
        float positions[9];
        uint8_t joints[12];
        float weights[12];
    } data = {{0, 2, 0, 2, 0, 0, 1, 1, 1}, {0}, {0}};
    for (int i = 0; i < 3; i++) {
        data.joints[4 * i + 1] = 1;
        data.weights[4 * i] = 0.5f * (float)i;
        data.weights[4 * i + 1] = 1.0f - 0.5f * (float)i;
    }
    nkw_document *d = opened(skinned, &data, sizeof data);
    nkw_mat4 models[3] = {nkw_mat4_identity(), nkw_mat4_identity(), nkw_mat4_identity()};
    const float turn[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1};
    memcpy(models[d->joint_of_node[1]].m, turn, sizeof turn);
    const nkw_obj_writing writing = {models, NULL, "unused", NULL, 0};
    nkw_obj_file file = written(d, &writing);
    expect_bytes(file.data, file.bytes, "o arm\nv -2 1 0\nv 1 1.5 0\nv 1 1 1\nf 1 2 3\n");
    assert_null(file.materials);
    nkw_obj_file_free(&file);
    nkw_document_close(d);
}

/* ---- Numbers ---- */

static nkw_document *cloud(const char *text)
{
    nkw_document *d;
    const nkw_import_memory memory = {text, strlen(text), "a.obj", NULL, NULL, NULL, 0, 0};
    assert_int_equal(nkw_document_from_memory(&memory, &d, NULL), NKW_IMPORT_OK);
    return d;
}

/* Of the positions in memory, as the document has them. */
static nkw_obj_file written_positions(nkw_document *d, const float *numbers, size_t count)
{
    static const nkw_obj_writing writing = {NULL, NULL, NULL, NULL, 0};
    const nkw_document_primitive *p = &d->meshes[0].primitives[0];
    assert_int_equal(p->vertex_count, count);
    memcpy((nkw_vec3 *)(size_t)p->positions, numbers, 3 * count * sizeof *numbers);
    return written(d, &writing);
}

static void numbers_are_the_shortest_that_are_read_the_same(void **state)
{
    (void)state;
    const float numbers[] = {
        0.1f,         -0.0f,  1.0f / 3.0f,  16777216.0f, 1e-7f,      -123456.789f,    0.00012345f, 1e10f, 1e9f,
        0.000099999f, 1e-21f, 123456784.0f, -0.5f,       999999.94f, 1.17549435e-38f, INFINITY,    NAN,   1e20f};
    nkw_document *d = cloud("v 1 1 1\nv 2 2 2\nv 3 3 3\nv 4 4 4\nv 5 5 5\nv 6 6 6\n");
    nkw_obj_file file = written_positions(d, numbers, 6);
    expect_bytes(file.data, file.bytes,
                 "o node_1\nv 0.1 0 0.33333334\nv 16777216 1e-7 -123456.79\nv 0.00012345 1e10 1e9\n"
                 "v 0.000099999 1e-21 123456780\nv -0.5 999999.94 117549435e-46\nv 0 0 0\n"
                 "p 1\np 2\np 3\np 4\np 5\np 6\n");
    nkw_obj_file_free(&file);
    nkw_document_close(d);
}

/* The digits of a number without zeros at its ends: each may be the last. */
static int significant(const char *at, const char *end)
{
    int digits = 0, all = 0;
    for (; at < end && *at != 'e'; at++) {
        all += *at >= '0' && *at <= '9' && (all > 0 || *at != '0');
        digits = *at >= '1' && *at <= '9' ? all : digits;
    }
    return digits;
}

/* Any bits: the C library reads the same float, and no number of fewer digits is as good. */
static void numbers_of_any_bits_are_read_the_same(void **state)
{
    (void)state;
    nkw_document *d = cloud("v 0 0 0\n");
    uint32_t bits = 12345;
    for (int i = 0; i < 20000; i++) {
        float numbers[3];
        for (int k = 0; k < 3; k++) {
            bits = 1664525u * bits + 1013904223u;
            memcpy(&numbers[k], &bits, sizeof bits);
            if (!isfinite(numbers[k]) || numbers[k] == 0.0f)
                numbers[k] = 1.5f;
        }
        nkw_obj_file file = written_positions(d, numbers, 1);
        char *at = file.data + strlen("o node_1\nv"), shorter[40];
        for (int k = 0; k < 3; k++) {
            char *start = at;
            assert_true(strtof(start, &at) == numbers[k]);
            const float size = fabsf(numbers[k]);
            const int digits = significant(start, at);
            snprintf(shorter, sizeof shorter, "%.*e", digits - 2, (double)numbers[k]);
            if (digits > 1 && size >= 1e-14f && size < 1e22f)
                assert_true(strtof(shorter, NULL) != numbers[k]);
        }
        nkw_obj_file_free(&file);
    }
    nkw_document_close(d);
}

/* ---- Read again ---- */

enum { CORNER = 8, RECORD = 3 * CORNER + 4 };

/* Triangles as records: of each corner position, normal, texture coordinates; then the colour. */
typedef struct records {
    float *list;
    size_t count;
} records;

/* -0 is 0. */
static void put_floats(float *out, const float *from, size_t count)
{
    for (size_t i = 0; from && i < count; i++)
        out[i] = from[i] + 0.0f;
}

/* `back`: of the document that is written, v as it comes back, 1 - (1 - v). */
static void put_corner(const nkw_document_primitive *p, const nkw_document_vertices_span *at, size_t v, int back,
                       float *out)
{
    put_floats(out, &at->positions[v].x, 3);
    put_floats(out + 3, p->normals ? &at->normals[v].x : NULL, 3);
    if (p->texcoord_count) {
        const float y = p->texcoords[0][2 * v + 1], up = 1.0f - y;
        out[6] = p->texcoords[0][2 * v] + 0.0f;
        out[7] = (back ? 1.0f - up : y) + 0.0f;
    }
}

static void put_triangles(const nkw_document *d, size_t joint, size_t k, const nkw_document_vertices_span *at,
                          int is_mirrored, int back, records *out)
{
    const nkw_document_primitive *p = &d->meshes[d->nodes[joint].mesh].primitives[k];
    for (size_t i = 0; p->topology == NKW_DOCUMENT_TRIANGLES && i < p->index_count; i += 3) {
        float *record = out->list + RECORD * out->count++;
        for (size_t c = 0; c < 3; c++)
            put_corner(p, at, p->indices[i + (is_mirrored && c ? 3 - c : c)], back, record + CORNER * c);
        for (size_t c = 0; c < 4; c++)
            record[3 * CORNER + c] = p->material < 0 ? 1.0f : d->materials[p->material].color[c];
    }
}

static size_t count_triangles(const nkw_document *d)
{
    size_t count = 0;
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        for (size_t k = 0; d->nodes[j].mesh >= 0 && k < d->meshes[d->nodes[j].mesh].primitive_count; k++)
            count += d->meshes[d->nodes[j].mesh].primitives[k].index_count;
    return count;
}

static records triangles_of(const nkw_document *d, const nkw_mat4 *models, const float *floats, int back)
{
    records out = {(float *)calloc(1 + count_triangles(d), RECORD * sizeof(float)), 0};
    assert_non_null(out.list);
    for (size_t j = 0; j < d->skeleton.joint_count; j++) {
        const nkw_document_node *n = &d->nodes[j];
        nkw_mat4 *palette = n->skin < 0 ? NULL : (nkw_mat4 *)calloc(d->skins[n->skin].joint_count, sizeof *palette);
        if (palette)
            assert_int_equal(nkw_document_palette(d, (size_t)n->skin, models, palette), NKW_OK);
        for (size_t k = 0; n->mesh >= 0 && k < d->meshes[n->mesh].primitive_count; k++) {
            const nkw_document_primitive *p = &d->meshes[n->mesh].primitives[k];
            nkw_vec3 *room = (nkw_vec3 *)calloc(2 * p->vertex_count + 1, sizeof *room);
            assert_non_null(room);
            const nkw_document_vertices_span at = {room, room + p->vertex_count};
            const nkw_document_moment moment = {models, floats, palette};
            if (back)
                assert_int_equal(nkw_document_vertices(d, j, k, &moment, at), NKW_OK);
            else
                nkw_document_morph(p, NULL, at);
            const int is_rigid = n->skin < 0 || p->influence_count == 0;
            put_triangles(d, j, k, &at, back && is_rigid && nkw_mat4_determinant(&models[j]) < 0.0f, back, &out);
            free(room);
        }
        free(palette);
    }
    return out;
}

static int by_bits(const void *a, const void *b)
{
    return memcmp(a, b, RECORD * sizeof(float));
}

static size_t read_mtl(void *user, const char *path, void *out, size_t size)
{
    const nkw_obj_file *file = (const nkw_obj_file *)user;
    if (strcmp(path, "m.mtl") != 0 || size > file->material_bytes)
        return SIZE_MAX;
    if (out)
        memcpy(out, file->materials, size);
    return file->material_bytes;
}

#if defined(NKW_TEST_ASSIMP)
static int is_near(float a, float b)
{
    return fabsf(a - b) <= 1e-6f * fabsf(b) + 1e-9f;
}

/* Assimp's meshes are those of each object and material, in the order of the file. */
static void expect_assimp(const nkw_obj_file *file, const nkw_document *again, const records *want)
{
    const struct aiScene *scene = aiImportFileFromMemory(file->data, (unsigned)file->bytes, 0, "obj");
    size_t count = 0;
    assert_non_null(scene);
    for (unsigned m = 0; m < scene->mNumMeshes; m++)
        for (unsigned i = 0; i < scene->mMeshes[m]->mNumFaces; i++) {
            const struct aiFace *face = &scene->mMeshes[m]->mFaces[i];
            if (face->mNumIndices != 3)
                continue;
            assert_true(count < want->count);
            for (unsigned c = 0; c < 3; c++) {
                const float *w = want->list + RECORD * count + CORNER * c;
                const struct aiVector3D v = scene->mMeshes[m]->mVertices[face->mIndices[c]];
                assert_true(is_near((float)v.x, w[0]) && is_near((float)v.y, w[1]) && is_near((float)v.z, w[2]));
            }
            count++;
        }
    assert_int_equal(count, want->count);
    assert_int_equal(again->skeleton.joint_count, 1 + scene->mRootNode->mNumChildren);
    aiReleaseImport(scene);
}
#endif

/* The same triangles with the same bits, and each node as an object. */
static void expect_same(const nkw_document *d, const nkw_mat4 *models, const float *floats)
{
    const nkw_obj_writing writing = {models, floats, "m.mtl", NULL, 0};
    nkw_obj_file file = written(d, &writing);
    nkw_document *again;
    const nkw_import_memory memory = {file.data, file.bytes, "m.obj", NULL, read_mtl, &file, 0, 0};
    assert_int_equal(nkw_document_from_memory(&memory, &again, NULL), NKW_IMPORT_OK);
    assert_int_equal(again->warning_count, 0);
    records want = triangles_of(d, models, floats, 1), got = triangles_of(again, NULL, NULL, 0);
#if defined(NKW_TEST_ASSIMP)
    expect_assimp(&file, again, &want);
#endif
    assert_int_equal(got.count, want.count);
    qsort(want.list, want.count, RECORD * sizeof(float), by_bits);
    qsort(got.list, got.count, RECORD * sizeof(float), by_bits);
    assert_memory_equal(got.list, want.list, want.count * RECORD * sizeof(float));
    free(want.list);
    free(got.list);
    nkw_document_close(again);
    nkw_obj_file_free(&file);
}

/* At rest, and at two times of the first animation. */
static void expect_file(const char *path)
{
    nkw_document *d;
    nkw_clip *clip;
    assert_int_equal(nkw_document_open(path, &d, NULL), NKW_IMPORT_OK);
    assert_int_equal(nkw_document_clip(d, 0, NKW_CLIP_FLOAT32, &clip, NULL), NKW_IMPORT_OK);
    const size_t joints = d->skeleton.joint_count;
    const nkw_clip_description of = nkw_clip_describe(clip);
    const nkw_pose_span pose = {(float *)calloc(nkw_pose_floats(joints), sizeof(float)), joints};
    float *floats = (float *)calloc(d->float_count + 1, sizeof *floats);
    nkw_mat4 *models = (nkw_mat4 *)calloc(joints, sizeof *models);
    assert_true(pose.data && floats && models);
    for (int i = 0; i < 3; i++) {
        const float time = of.start + 0.3f * (float)i * (of.end - of.start);
        assert_int_equal(nkw_clip_sample(clip, time, NULL, pose, floats), NKW_OK);
        assert_int_equal(nkw_document_models(d, i ? NKW_VIEW(nkw_pose, pose) : d->rest, NULL, models), NKW_OK);
        expect_same(d, models, i ? floats : NULL);
    }
    free(pose.data);
    free(floats);
    free(models);
    nkw_import_free(clip);
    nkw_document_close(d);
}

static void what_is_written_is_read_with_the_same_bits(void **state)
{
    (void)state;
    nkw_document *d = opened(two_nodes, triangle, sizeof triangle);
    nkw_mat4 models[2];
    assert_int_equal(nkw_document_models(d, d->rest, NULL, models), NKW_OK);
    expect_same(d, models, NULL);
    nkw_document_close(d);
    expect_file(NKW_CHARACTER);
    expect_file(NKW_TEST_DATA "/import/bar.obj");
}

static void real_models_are_read_with_the_same_bits(void **state)
{
    (void)state;
    each_sample(expect_file);
    expect_file(NKW_DATA_DIR "/obj/capsule_3m.obj");
}

static void what_has_no_meshes_is_refused(void **state)
{
    (void)state;
    static const nkw_obj_writing writing = {NULL, NULL, NULL, NULL, 0};
    nkw_document *d = opened("{'asset':{'version':'2.0'},'nodes':[{}]}", NULL, 0);
    nkw_obj_file file;
    nkw_import_error error;
    assert_int_equal(nkw_document_write_obj(d, &writing, &file, &error), NKW_IMPORT_UNSUPPORTED);
    assert_null(file.data);
    assert_string_equal(error.reason, "there are no meshes");
    nkw_document_close(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_are_objects_with_shared_lines),
        cmocka_unit_test(pictures_have_the_names_of_the_caller),
        cmocka_unit_test(vertices_are_skinned_at_the_time),
        cmocka_unit_test(numbers_are_the_shortest_that_are_read_the_same),
        cmocka_unit_test(numbers_of_any_bits_are_read_the_same),
        cmocka_unit_test(what_is_written_is_read_with_the_same_bits),
        cmocka_unit_test(real_models_are_read_with_the_same_bits),
        cmocka_unit_test(what_has_no_meshes_is_refused),
    };
    return cmocka_run_group_tests_name("import_write_obj", tests, NULL, NULL);
}
