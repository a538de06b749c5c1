/* SPDX-License-Identifier: MIT */
/* Each allocation of the readers and writers fails in turn. The linker puts the functions below in place of malloc. */
#include <stdlib.h>

#include <nakawari/export.h>

#include "documents.h"
#include "views.h"

/* Allocations until one fails (-1: none does), and whether all later ones do; those that did; blocks not freed. */
static long until_failure = -1, failures, live;
static int fails_on;

void *__real_malloc(size_t bytes);
void *__real_calloc(size_t count, size_t bytes);
void *__real_realloc(void *block, size_t bytes);
void __real_free(void *block);
void *__wrap_malloc(size_t bytes);
void *__wrap_calloc(size_t count, size_t bytes);
void *__wrap_realloc(void *block, size_t bytes);
void __wrap_free(void *block);
struct json_t;
char *__real_json_dumps(const struct json_t *json, size_t flags);
char *__wrap_json_dumps(const struct json_t *json, size_t flags);

static int fails(void)
{
    if (until_failure < 0)
        return 0;
    if (until_failure > 0) {
        until_failure--;
        return 0;
    }
    until_failure = fails_on ? 0 : -1;
    failures++;
    return 1;
}

void *__wrap_malloc(size_t bytes)
{
    void *block = fails() ? NULL : __real_malloc(bytes);
    live += block != NULL;
    return block;
}

void *__wrap_calloc(size_t count, size_t bytes)
{
    void *block = fails() ? NULL : __real_calloc(count, bytes);
    live += block != NULL;
    return block;
}

void *__wrap_realloc(void *block, size_t bytes)
{
    void *wider = fails() ? NULL : __real_realloc(block, bytes);
    live += wider != NULL && !block;
    return wider;
}

void __wrap_free(void *block)
{
    live -= block != NULL;
    __real_free(block);
}

/* A text that free() frees. */
char *__wrap_json_dumps(const struct json_t *json, size_t flags)
{
    char *text = fails() ? NULL : __real_json_dumps(json, flags);
    live += text != NULL;
    return text;
}

/* An action returns its result; it leaves nothing behind, except `document` while that is read. */
typedef nkw_import_result action(void);

static nkw_document *document;

static void expect_end(nkw_import_result result, const nkw_import_error *error, const void *made)
{
    assert_int_equal(error->code, result);
    assert_int_equal(made == NULL, result != NKW_IMPORT_OK);
    assert_true(result == NKW_IMPORT_OK || error->reason[0] != 0);
}

static nkw_import_result open_character(void)
{
    nkw_document *d;
    nkw_import_error error;
    nkw_import_result result = nkw_document_open(NKW_CHARACTER, &d, &error);
    expect_end(result, &error, d);
    nkw_document_close(d);
    return result;
}

static nkw_import_result open_keys(void)
{
    static const char text[] =
        "{\"columns\":\"tx,ty,tz,qx,qy,qz,qw\",\"rows\":["
        "{\"name\":\"a\",\"time\":1,\"clip\":3,\"values\":[1,2,3,null,null,null,null]},"
        "{\"name\":\"b\",\"time\":0.5,\"clip\":\"c\",\"parent\":\"a\",\"values\":[1,2,3,0,0,1,0]}]}";
    const nkw_import_memory memory = {text, sizeof text - 1, "keys.json", NULL, NULL, NULL, 0, 0};
    nkw_document *d;
    nkw_import_error error;
    nkw_import_result result = nkw_document_from_memory(&memory, &d, &error);
    expect_end(result, &error, d);
    nkw_document_close(d);
    return result;
}

static nkw_import_result open_table(void)
{
    static const char text[] = "name,time,clip,parent,interpolation,tx,ty,tz,yaw,pitch,roll\n"
                               "root,0,walk,,,0,1,2,,,\n"
                               "arm,0,walk,root,STEP,,,,90,0,0\n"
                               "arm,1,walk,,STEP,,,,0,45,0\n"
                               "hand,0,wave,arm,,7,8,9,0,0,90\n";
    const nkw_import_memory memory = {text, sizeof text - 1, "keys.csv", NULL, NULL, NULL, 0, 0};
    nkw_document *d;
    nkw_import_error error;
    nkw_import_result result = nkw_document_from_memory(&memory, &d, &error);
    expect_end(result, &error, d);
    nkw_document_close(d);
    return result;
}

static nkw_import_result open_outer(void)
{
    static const char text[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"data.bin\",\"byteLength\":48}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
        "\"count\":4,\"type\":\"VEC3\"},{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"}],"
        "\"nodes\":[{\"mesh\":0,\"children\":[1]},{}],\"meshes\":[{\"weights\":[0.5],\"primitives\":[{\"attributes\":"
        "{\"POSITION\":0,\"TEXCOORD_0\":1,\"TEXCOORD_1\":1,\"TEXCOORD_3\":1},"
        "\"targets\":[{\"POSITION\":0}]}]}]}";
    static const float numbers[12];
    outer o = {numbers, sizeof numbers};
    const nkw_import_memory memory = {text, sizeof text - 1, "test.gltf", NULL, read_outer, &o, 0, 0};
    nkw_document *d;
    nkw_import_error error;
    nkw_import_result result = nkw_document_from_memory(&memory, &d, &error);
    expect_end(result, &error, d);
    nkw_document_close(d);
    return result;
}

static nkw_import_result open_obj(void)
{
    static const char text[] = "mtllib data.bin\nmtllib no.mtl\nv 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nvt 0 0\n"
                               "vn 0 0 1\nusemtl m\nf 1/1/1 2/1/1 3/1/1\nf 1 2\no a\nl 1 2 3\nx\n";
    static const char material[] = "newmtl m\nKd 1 0 x\nmap_Kd a.png\n";
    outer o = {material, sizeof material - 1};
    const nkw_import_memory memory = {text, sizeof text - 1, "a.obj", NULL, read_outer, &o, 0, 0};
    nkw_obj *obj;
    nkw_import_error error;
    nkw_import_result result = nkw_obj_from_memory(&memory, &obj, &error);
    expect_end(result, &error, obj);
    nkw_obj_close(obj);
    return result;
}

/* Everything that is made on request, of two nodes that share a mesh with a morph target. The document stays valid. */
static nkw_import_result prepare_all(void)
{
    static const char text[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"data.bin\",\"byteLength\":72}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":72}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
        "\"count\":6,\"type\":\"VEC3\"},{\"bufferView\":0,\"componentType\":5126,\"count\":6,\"type\":\"VEC2\"}],"
        "\"nodes\":[{\"mesh\":0,\"scale\":[-1,1,1]},{\"mesh\":0,\"translation\":[1,2,3]}],\"meshes\":[{\"weights\":[0."
        "5],"
        "\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"targets\":[{\"POSITION\":0}]}]}]}";
    static const float numbers[18] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1};
    static const nkw_document_preparation all = {1, 1, 1, 1, 1.0f};
    outer o = {numbers, sizeof numbers};
    const nkw_import_memory memory = {text, sizeof text - 1, "test.gltf", NULL, read_outer, &o, 0, 0};
    const long later = until_failure;
    nkw_document *d;
    nkw_import_error error;
    until_failure = -1;
    assert_int_equal(nkw_document_from_memory(&memory, &d, NULL), NKW_IMPORT_OK);
    until_failure = later;
    nkw_import_result result = nkw_document_prepare(d, &all, &error);
    until_failure = -1;
    expect_end(result, &error, result == NKW_IMPORT_OK ? d : NULL);
    assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_OK);
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        assert_in_range(d->nodes[j].mesh, 0, d->mesh_count - 1);
    for (size_t m = 0; m < d->mesh_count; m++)
        assert_non_null(d->meshes[m].primitives[0].positions);
    nkw_document_close(d);
    return result;
}

static nkw_import_result make_clip(void)
{
    nkw_clip *clip;
    nkw_import_error error;
    nkw_import_result result = nkw_document_clip(document, 0, NKW_CLIP_FLOAT32, &clip, &error);
    expect_end(result, &error, clip);
    nkw_import_free(clip);
    return result;
}

/* What is written is the document, also where memory was missing for sharing its keys. */
static void expect_document(const nkw_gltf_file *file)
{
    const long left = until_failure;
    outer o = {file->outer, file->outer_bytes};
    const nkw_import_memory memory = {file->data, file->bytes, "written", NULL, read_outer, &o, 0, 0};
    nkw_document *d;
    until_failure = -1;
    assert_int_equal(nkw_document_from_memory(&memory, &d, NULL), NKW_IMPORT_OK);
    assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_OK);
    assert_int_equal(d->skeleton.joint_count, document->skeleton.joint_count);
    for (size_t i = 0; i < document->animation_count; i++)
        assert_int_equal(d->animations[i].track_count, document->animations[i].track_count);
    nkw_document_close(d);
    until_failure = left;
}

static nkw_import_result write_as(nkw_gltf_form form)
{
    nkw_gltf_file file;
    nkw_import_error error;
    nkw_import_result result = nkw_document_write(document, form, "data.bin", &file, &error);
    expect_end(result, &error, file.data);
    assert_true(result == NKW_IMPORT_OK || (file.bytes == 0 && !file.outer && file.outer_bytes == 0));
    if (result == NKW_IMPORT_OK)
        expect_document(&file);
    nkw_gltf_file_free(&file);
    return result;
}

static nkw_import_result write_glb(void)
{
    return write_as(NKW_GLTF_BINARY);
}

static nkw_import_result write_text(void)
{
    return write_as(NKW_GLTF_TEXT);
}

static nkw_import_result write_two(void)
{
    return write_as(NKW_GLTF_OUTER);
}

static nkw_import_result write_obj(void)
{
    static const nkw_obj_writing writing = {NULL, NULL, "m.mtl", NULL, 0};
    nkw_obj_file file;
    nkw_import_error error;
    nkw_import_result result = nkw_document_write_obj(document, &writing, &file, &error);
    expect_end(result, &error, file.data);
    nkw_obj_file_free(&file);
    return result;
}

/*
 * Every allocation of an action fails once: alone, and with all after it. No block is lost. Returns how many they are.
 * needs_all: whether the action cannot do without one of them.
 */
static long expect_answers(action *run, int needs_all)
{
    const long before = live;
    long n = 0;
    for (fails_on = 0; fails_on < 2; fails_on++)
        for (n = 0, failures = 1; failures > 0; n++) {
            until_failure = n;
            failures = 0;
            nkw_import_result result = run();
            until_failure = -1;
            assert_int_equal(live, before);
            assert_int_equal(result, failures > 0 && (needs_all || result != NKW_IMPORT_OK) ? NKW_IMPORT_NO_MEMORY
                                                                                            : NKW_IMPORT_OK);
        }
    return n;
}

static void readers_answer_each_allocation_that_fails(void **state)
{
    (void)state;
    assert_true(expect_answers(open_character, 1) > 20);
    assert_true(expect_answers(open_outer, 1) > 10);
    assert_true(expect_answers(open_keys, 1) > 8);
    assert_true(expect_answers(open_table, 1) > 8);
    assert_true(expect_answers(open_obj, 1) > 30);
    assert_true(expect_answers(prepare_all, 1) > 30);
}

static void clips_and_writers_answer_each_allocation_that_fails(void **state)
{
    (void)state;
    assert_int_equal(nkw_document_open(NKW_CHARACTER, &document, NULL), NKW_IMPORT_OK);
    assert_int_equal(expect_answers(make_clip, 1), 3);
    assert_true(expect_answers(write_glb, 0) > 3);
    assert_true(expect_answers(write_text, 0) > 3);
    assert_true(expect_answers(write_two, 0) > 3);
    assert_true(expect_answers(write_obj, 1) > 30);
    nkw_document_close(document);
    assert_int_equal(live, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(readers_answer_each_allocation_that_fails),
        cmocka_unit_test(clips_and_writers_answer_each_allocation_that_fails),
    };
    return cmocka_run_group_tests_name("import_memory", tests, NULL, NULL);
}
