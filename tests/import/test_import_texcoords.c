/* SPDX-License-Identifier: MIT */
/* Texture coordinates: all sets of a mesh, of glTF, OBJ and Collada, in both directions of v. */
#include <stdio.h>

#include <nakawari/export.h>

#include "documents.h"

enum { VERTICES = 3, SETS_MOST = 9 };

/* u and v of a vertex in a set, v downwards: exact in binary, and different for each. */
static float value(size_t set, size_t vertex, size_t component)
{
    return 0.25f * (float)vertex + (float)set / (component == 0 ? 32.0f : 64.0f);
}

/* A glTF file of a triangle with these attributes after POSITION; data.bin has the positions and SETS_MOST sets. */
static nkw_import_result open_gltf(const char *attributes, int v_is_up, nkw_document **d, nkw_import_error *error)
{
    static float data[3 * VERTICES + 2 * VERTICES * SETS_MOST];
    char text[4096], *at = text, *end = text + sizeof text;
    for (size_t i = 0; i < 2 * VERTICES * SETS_MOST; i++)
        data[3 * VERTICES + i] = value(i / (2 * VERTICES), i / 2 % VERTICES, i % 2);
    at += snprintf(at, (size_t)(end - at),
                   "{'asset':{'version':'2.0'},'nodes':[{'mesh':0}],'buffers':[{'uri':'data.bin','byteLength':%zu}],"
                   "'meshes':[{'primitives':[%s]}],'bufferViews':[{'buffer':0,'byteLength':%zu}],'accessors':["
                   "{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'}",
                   sizeof data, attributes, sizeof data);
    for (size_t set = 0; set < SETS_MOST; set++)
        at += snprintf(at, (size_t)(end - at),
                       ",{'bufferView':0,'byteOffset':%zu,'componentType':5126,'count':%d,'type':'VEC2'}",
                       4 * (3 * VERTICES + 2 * VERTICES * set), set == 8 ? 2 : 3);
    snprintf(at, (size_t)(end - at), "]}");
    char *json = quoted(text);
    outer o = {data, sizeof data};
    const nkw_import_memory memory = {json, strlen(json), "test.gltf", NULL, read_outer, &o, 0, v_is_up};
    nkw_import_result result = nkw_document_from_memory(&memory, d, error);
    free(json);
    return result;
}

/* A primitive with sets 0 to sets - 1. */
static void name_sets(size_t sets, char *text, size_t room)
{
    size_t n = (size_t)snprintf(text, room, "{'attributes':{'POSITION':0");
    for (size_t set = 0; set < sets; set++)
        n += (size_t)snprintf(text + n, room - n, ",'TEXCOORD_%zu':%zu", set, 1 + set);
    snprintf(text + n, room - n, "}}");
}

/* Set k has the values of `sets_of`[k]; the vertices are in the order of the file. */
static void expect_sets(const nkw_document_primitive *p, size_t sets, int v_is_up)
{
    assert_int_equal(p->vertex_count, VERTICES);
    assert_int_equal(p->texcoord_count, sets);
    assert_int_equal(p->texcoords == NULL, sets == 0);
    for (size_t set = 0; set < sets; set++)
        for (size_t v = 0; v < VERTICES; v++) {
            const float down = value(set, v, 1);
            expect_near(p->texcoords[set][2 * v], value(set, v, 0), 0);
            expect_near(p->texcoords[set][2 * v + 1], v_is_up ? 1.0f - down : down, 0);
        }
}

static nkw_document *read_sets(size_t sets, int v_is_up)
{
    char attributes[512];
    nkw_document *d;
    nkw_import_error error;
    name_sets(sets, attributes, sizeof attributes);
    if (open_gltf(attributes, v_is_up, &d, &error) != NKW_IMPORT_OK)
        fail_msg("%s: %s", error.place, error.reason);
    return d;
}

static void gltf_has_all_sets(void **state)
{
    (void)state;
    static const size_t counts[] = {0, 1, 2, 8};
    for (size_t i = 0; i < 8; i++) {
        nkw_document *d = read_sets(counts[i / 2], i % 2);
        expect_sets(&d->meshes[0].primitives[0], counts[i / 2], i % 2);
        assert_int_equal(d->warning_count, 0);
        nkw_document_close(d);
    }
}

static void all_sets_are_written(void **state)
{
    (void)state;
    static const size_t counts[] = {0, 1, 2, 8};
    for (size_t i = 0; i < 4; i++) {
        nkw_document *d = read_sets(counts[i], 0), *again;
        nkw_gltf_file file;
        nkw_import_error error;
        assert_int_equal(nkw_document_write(d, NKW_GLTF_BINARY, NULL, &file, &error), NKW_IMPORT_OK);
        const nkw_import_memory memory = {file.data, file.bytes, "written", NULL, NULL, NULL, 0, 0};
        assert_int_equal(nkw_document_from_memory(&memory, &again, &error), NKW_IMPORT_OK);
        expect_sets(&again->meshes[0].primitives[0], counts[i], 0);
        nkw_document_close(again);
        nkw_gltf_file_free(&file);
        nkw_document_close(d);
    }
}

/* An accessor that several primitives and sets name is turned once. */
static void shared_accessors_are_turned_once(void **state)
{
    (void)state;
    nkw_document *d;
    nkw_import_error error;
    const char *const shared = "{'attributes':{'POSITION':0,'TEXCOORD_0':1,'TEXCOORD_1':2}},"
                               "{'attributes':{'POSITION':0,'TEXCOORD_0':1,'TEXCOORD_1':1}}";
    assert_int_equal(open_gltf(shared, 1, &d, &error), NKW_IMPORT_OK);
    expect_sets(&d->meshes[0].primitives[0], 2, 1);
    for (size_t set = 0; set < 2; set++)
        for (size_t v = 0; v < VERTICES; v++)
            expect_near(d->meshes[0].primitives[1].texcoords[set][2 * v + 1], 1.0f - value(0, v, 1), 0);
    nkw_document_close(d);
}

static void sets_after_a_gap_are_warned_of(void **state)
{
    (void)state;
    nkw_document *d;
    nkw_import_error error;
    assert_int_equal(open_gltf("{'attributes':{'POSITION':0,'TEXCOORD_0':1,'TEXCOORD_2':3}}", 0, &d, &error),
                     NKW_IMPORT_OK);
    expect_sets(&d->meshes[0].primitives[0], 1, 0);
    assert_int_equal(d->warning_count, 1);
    assert_string_equal(d->warnings[0], "a primitive has 2 sets of texture coordinates, but no TEXCOORD_1: 1 are read");
    nkw_document_close(d);
}

static void a_set_of_another_size_is_refused(void **state)
{
    (void)state;
    nkw_document *d;
    nkw_import_error error;
    /* Accessor 9 has two elements; accessor 0 three components. */
    assert_int_equal(open_gltf("{'attributes':{'POSITION':0,'TEXCOORD_0':1,'TEXCOORD_1':9}}", 0, &d, &error),
                     NKW_IMPORT_INVALID);
    assert_string_equal(error.place, "/meshes/0/primitives/0/attributes/TEXCOORD_1");
    assert_int_equal(open_gltf("{'attributes':{'POSITION':0,'TEXCOORD_0':0}}", 0, &d, &error), NKW_IMPORT_INVALID);
    assert_string_equal(error.place, "/meshes/0/primitives/0/attributes/TEXCOORD_0");
}

/* The base colour of set 1, read, written and read again. */
static void a_picture_has_its_set(void **state)
{
    (void)state;
    nkw_document *d = opened("{'asset':{'version':'2.0'},'images':[{'uri':'a.png'}],'textures':[{'source':0}],"
                             "'materials':[{'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'texCoord':1}}},"
                             "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}]}",
                             NULL, 0);
    nkw_gltf_file file;
    nkw_import_error error;
    for (int again = 0; again < 2; again++) {
        assert_int_equal(d->material_count, 2);
        for (size_t i = 0; i < 2; i++) {
            assert_non_null(d->materials[i].image);
            assert_int_equal(d->materials[i].image_texcoords, 1 - i);
        }
        if (again)
            break;
        assert_int_equal(nkw_document_write(d, NKW_GLTF_TEXT, NULL, &file, &error), NKW_IMPORT_OK);
        const nkw_import_memory memory = {file.data, file.bytes, "written", NULL, read_outer, NULL, 0, 0};
        nkw_document_close(d);
        assert_int_equal(nkw_document_from_memory(&memory, &d, &error), NKW_IMPORT_OK);
        nkw_gltf_file_free(&file);
    }
    nkw_document_close(d);
}

/* v of OBJ is upwards in the file: 0.3 as it is, or 1 - 0.3 in binary32. */
static void obj_has_one_set(void **state)
{
    (void)state;
    const char *const text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .1 .3\nf 1/1 2/1 3/1\n";
    for (int v_is_up = 0; v_is_up < 2; v_is_up++) {
        nkw_document *d;
        const nkw_import_memory memory = {text, strlen(text), "a.obj", NULL, NULL, NULL, 0, v_is_up};
        assert_int_equal(nkw_document_from_memory(&memory, &d, NULL), NKW_IMPORT_OK);
        const nkw_document_primitive *p = &d->meshes[0].primitives[0];
        assert_int_equal(p->texcoord_count, 1);
        expect_near(p->texcoords[0][0], 0.1f, 0);
        expect_near(p->texcoords[0][1], v_is_up ? 0.3f : 1.0f - 0.3f, 0);
        nkw_document_close(d);
    }
}

#if defined(NKW_TEST_ASSIMP)
/* A Collada file of a triangle with `sets` inputs TEXCOORD; v of the file is 1 - value. */
static char *collada(size_t sets)
{
    const size_t room = 16384;
    char *text = (char *)malloc(room);
    size_t n;
    assert_non_null(text);
    n = (size_t)snprintf(
        text, room,
        "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
        "<asset><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id=\"g\" name=\"g\"><mesh><source "
        "id=\"p\">"
        "<float_array id=\"pa\" count=\"9\">0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor source=\"#pa\" "
        "count=\"3\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param "
        "name=\"Z\" "
        "type=\"float\"/></accessor></technique_common></source>");
    for (size_t set = 0; set < sets; set++) {
        n += (size_t)snprintf(text + n, room - n, "<source id=\"t%zu\"><float_array id=\"ta%zu\" count=\"6\">", set,
                              set);
        for (size_t v = 0; v < VERTICES; v++)
            n += (size_t)snprintf(text + n, room - n, "%.9g %.9g ", (double)value(set, v, 0),
                                  1.0 - (double)value(set, v, 1));
        n += (size_t)snprintf(text + n, room - n,
                              "</float_array><technique_common><accessor source=\"#ta%zu\" count=\"3\" stride=\"2\">"
                              "<param name=\"S\" type=\"float\"/><param name=\"T\" type=\"float\"/></accessor>"
                              "</technique_common></source>",
                              set);
    }
    n += (size_t)snprintf(text + n, room - n,
                          "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices><triangles "
                          "count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>");
    for (size_t set = 0; set < sets; set++)
        n += (size_t)snprintf(text + n, room - n,
                              "<input semantic=\"TEXCOORD\" source=\"#t%zu\" offset=\"0\" set=\"%zu\"/>", set, set);
    snprintf(text + n, room - n,
             "<p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene "
             "id=\"s\"><node id=\"n\" name=\"n\"><instance_geometry url=\"#g\"/></node></visual_scene>"
             "</library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>");
    return text;
}

static void collada_has_all_sets(void **state)
{
    (void)state;
    static const size_t counts[] = {0, 1, 2, 8};
    for (size_t i = 0; i < 8; i++) {
        char *text = collada(counts[i / 2]);
        nkw_document *d;
        nkw_import_error error;
        const nkw_import_memory memory = {text, strlen(text), "a.dae", NULL, NULL, NULL, 0, (int)(i % 2)};
        if (nkw_document_from_memory(&memory, &d, &error) != NKW_IMPORT_OK)
            fail_msg("%s: %s", error.place, error.reason);
        expect_sets(&d->meshes[0].primitives[0], counts[i / 2], (int)(i % 2));
        nkw_document_close(d);
        free(text);
    }
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gltf_has_all_sets),
        cmocka_unit_test(all_sets_are_written),
        cmocka_unit_test(shared_accessors_are_turned_once),
        cmocka_unit_test(sets_after_a_gap_are_warned_of),
        cmocka_unit_test(a_set_of_another_size_is_refused),
        cmocka_unit_test(a_picture_has_its_set),
        cmocka_unit_test(obj_has_one_set),
#if defined(NKW_TEST_ASSIMP)
        cmocka_unit_test(collada_has_all_sets),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
