/* SPDX-License-Identifier: MIT */
/* OBJ with the arrays of the file; the values are those of the texts. */
#include <math.h>

#include "documents.h"

static nkw_vec3 at(float x, float y, float z)
{
    const nkw_vec3 v = {x, y, z};
    return v;
}

static nkw_obj *arrays_of(const char *text)
{
    nkw_obj *obj;
    nkw_import_error error;
    const nkw_import_memory memory = {text, strlen(text), "a.obj", NULL, NULL, NULL, 0, 0};
    if (nkw_obj_from_memory(&memory, &obj, &error) != NKW_IMPORT_OK)
        print_error("%s: %s\n", error.place, error.reason);
    assert_non_null(obj);
    return obj;
}

/* The quad is 1 2 3 and 1 3 4; the line is no triangle; positions that no face uses are there. */
static void arrays_of_the_file_have_numbers_of_their_own(void **state)
{
    (void)state;
    static const uint32_t positions[] = {0, 1, 2, 0, 2, 3, 3, 1, 0}, texcoords[] = {1, 0, 1, 1, 1, 0};
    static const uint32_t normals[] = {0, 0, 1, 0, 1, 0};
    nkw_obj *obj = arrays_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nvt 0.25 1\nvt 0.5 0\nvn 0 0 1\nvn 0 1 0\n"
                             "usemtl a\nf 1/2/1 2/1/1 3/2/2 4/1/1\nl 1 2\nusemtl b\nf -2 2 1/1\n");
    assert_int_equal(obj->position_count, 5);
    assert_int_equal(obj->texcoord_count, 2);
    assert_int_equal(obj->normal_count, 2);
    assert_int_equal(obj->triangle_count, 3);
    expect_vec3_near(obj->positions[4], at(9, 9, 9), 0);
    expect_vec3_near(obj->normals[1], at(0, 1, 0), 0);
    expect_near(obj->texcoords[0], 0.25, 0);
    expect_near(obj->texcoords[1], 0, 0);
    expect_near(obj->texcoords[3], 1, 0);
    assert_memory_equal(obj->position_indices, positions, sizeof positions);
    assert_memory_equal(obj->texcoord_indices, texcoords, sizeof texcoords);
    assert_memory_equal(obj->normal_indices, normals, sizeof normals);
    for (int i = 6; i < 9; i++) {
        assert_int_equal(obj->texcoord_indices[i], i == 8 ? 0 : NKW_OBJ_NONE);
        assert_int_equal(obj->normal_indices[i], NKW_OBJ_NONE);
    }
    assert_string_equal(obj->document->materials[obj->materials[1]].name, "a");
    assert_string_equal(obj->document->materials[obj->materials[2]].name, "b");
    assert_int_equal(obj->document->meshes[0].primitives[1].topology, NKW_DOCUMENT_LINES);
    nkw_obj_close(obj);
    nkw_obj_close(NULL);
}

/* Normals of the faces, for each corner: the arrays are an nkw_mesh. */
static void arrays_of_the_file_are_a_mesh(void **state)
{
    (void)state;
    static char work[NKW_MESH_WORK(2) + 16];
    nkw_obj *obj = arrays_of("v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 2 3\nf 1 3 4\n");
    const nkw_mesh mesh = {obj->positions, obj->position_count, obj->position_indices, obj->triangle_count};
    const nkw_work room = {work + (16 - (size_t)work % 16) % 16, NKW_MESH_WORK(2)};
    nkw_vec3 normals[6];
    assert_int_equal(nkw_mesh_normals(&mesh, 0.0f, normals, NULL, room), NKW_OK);
    for (int i = 0; i < 6; i++)
        expect_vec3_near(normals[i], i < 3 ? at(0, 0, 1) : at(1, 0, 0), 0);
    nkw_obj_close(obj);
}

/* Sides 4, 1 and 0.5: to 2 they are halved, to 3 they are 3, 0.75 and 0.375. */
static void arrays_are_scaled_to_a_size(void **state)
{
    (void)state;
    nkw_obj *obj = arrays_of("v -1 2 0\nv 3 2 0\nv 1 3 -0.5\nf 1 2 3\n");
    const nkw_document_primitive *drawn = &obj->document->meshes[0].primitives[0];
    expect_vec3_near(nkw_obj_scale(obj, 2.0f), at(2, 0.5f, 0.25f), 0);
    expect_vec3_near(obj->positions[1], at(1.5f, 1, 0), 0);
    expect_vec3_near(drawn->positions[drawn->indices[2]], at(0.5f, 1.5f, -0.25f), 0);
    expect_vec3_near(drawn->box.low, at(-0.5f, 1, -0.25f), 0);
    expect_vec3_near(nkw_obj_scale(obj, 3.0f), at(3, 0.75f, 0.375f), 0);
    const float wrong[] = {0.0f, -1.0f, INFINITY, NAN};
    for (int i = 0; i < 4; i++)
        expect_vec3_near(nkw_obj_scale(obj, wrong[i]), at(3, 0.75f, 0.375f), 0);
    nkw_obj_close(obj);
    obj = arrays_of("v 5 5 5\n");
    expect_vec3_near(nkw_obj_scale(obj, 1.0f), at(0, 0, 0), 0);
    expect_vec3_near(obj->positions[0], at(5, 5, 5), 0);
    assert_int_equal(obj->triangle_count, 0);
    nkw_obj_close(obj);
}

static void only_obj_has_such_arrays(void **state)
{
    (void)state;
    static const char json[] = "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{}]}", broken[] = "v 1 2 3\nf 1 2 4\n";
    nkw_obj *obj;
    nkw_import_error error;
    nkw_import_memory memory = {json, sizeof json - 1, "a.gltf", NULL, NULL, NULL, 0, 0};
    assert_int_equal(nkw_obj_from_memory(&memory, &obj, &error), NKW_IMPORT_UNSUPPORTED);
    assert_null(obj);
    assert_string_equal(error.reason, "the format is glTF 2.0, not OBJ");
    memory.data = broken;
    memory.bytes = sizeof broken - 1;
    assert_int_equal(nkw_obj_from_memory(&memory, &obj, NULL), NKW_IMPORT_INVALID);
    assert_null(obj);
    assert_int_equal(nkw_obj_open("no such file.obj", &obj, &error), NKW_IMPORT_UNREADABLE);
    assert_null(obj);
    assert_int_equal(nkw_obj_open(NKW_TEST_DATA "/import/bar.obj", &obj, NULL), NKW_IMPORT_OK);
    assert_int_equal(obj->triangle_count, 6);
    assert_string_equal(obj->document->materials[obj->materials[0]].name, "red");
    nkw_obj_close(obj);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays_of_the_file_have_numbers_of_their_own),
        cmocka_unit_test(arrays_of_the_file_are_a_mesh),
        cmocka_unit_test(arrays_are_scaled_to_a_size),
        cmocka_unit_test(only_obj_has_such_arrays),
    };
    return cmocka_run_group_tests_name("import_obj_arrays", tests, NULL, NULL);
}
