/* SPDX-License-Identifier: MIT */
/* nakawari convert -o OUT.obj: the model at one time, its materials and pictures. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"

#include <stdlib.h>
#include <sys/stat.h>

static void put_file(const char *path, const char *data, size_t bytes)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(data, 1, bytes, f), bytes);
    assert_int_equal(fclose(f), 0);
}

static void put_text(const char *path, const char *text)
{
    put_file(path, text, strlen(text));
}

static void expect_text(const char *path, const char *want)
{
    char *said = program_run(NULL, "--version > /dev/null; cat '%s'", path);
    assert_string_equal(said, want);
    free(said);
}

/* The positions of `sample`, each once. */
#define PLACES "--what vertices | tail -n +2 | cut -d, -f5-7 | sort -u"

static void vertices_are_those_of_the_time(void **state)
{
    (void)state;
    const struct {
        const char *convert, *sample;
    } cases[] = {{"--clip walk --time 0.4", "--clip walk --at 0.4"},
                 {"--clip hop --time 0.7", "--clip hop --at 0.7"},
                 {"--time 0.25", "--clip 0 --at 0.25"},
                 {"--clip wave", "--clip wave --at 0"},
                 {"", "--clip rest --at 0"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        free(program_run(NULL, "convert '" NKW_CHARACTER "' %s -o at.obj", cases[i].convert));
        char *want = program_run(NULL, "sample '" NKW_CHARACTER "' %s " PLACES, cases[i].sample);
        char *got = program_run(NULL, "sample at.obj --at 0 " PLACES);
        assert_true(strlen(want) > 10000);
        assert_string_equal(got, want);
        free(want);
        free(got);
    }
    char *before = program_run(NULL, "info '" NKW_CHARACTER "' | grep -o '[0-9]* triangles'");
    program_says(0, before, "info at.obj | grep -o '[0-9]* triangles'");
    free(before);
}

static void changes_are_written_too(void **state)
{
    (void)state;
    put_text("one.mtl", "newmtl a b\nKd 1 0.5 0\n");
    put_text("one.obj", "mtllib one.mtl\no it\nv 0 0 0\nv 1 0 0\nv 0 1.5 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a b\n"
                        "f 1/1 2/2 3/3\n");
    free(program_run(NULL, "convert one.obj --scale 2 -o two.obj"));
    expect_text("two.obj", "mtllib two.mtl\no it\nv 0 0 0\nvt 0 0\nv 2 0 0\nvt 1 0\nv 0 3 0\nvt 0 1\nusemtl a_b\n"
                           "f 1/1 2/2 3/3\n");
    expect_text("two.mtl", "newmtl a_b\nKd 1 0.5 0\n");
    free(program_run(NULL, "convert one.obj --up y:z --v up -o up.OBJ"));
    expect_text("up.OBJ", "mtllib up.mtl\no it\nv 0 0 0\nvt 0 0\nv 1 0 0\nvt 1 0\nv 0 0 1.5\nvt 0 1\nusemtl a_b\n"
                          "f 1/1 2/2 3/3\n");
}

/* By hand: sides 4, 1 and 0.5, from -1 2 -0.5 to 3 3 0, to a largest side of 8; y up to z up is (x, -z, y). */
static void models_are_scaled_to_a_size(void **state)
{
    (void)state;
    put_text("flat.obj", "v -1 2 0\nv 3 2 0\nv 1 3 -0.5\nf 1 2 3\n");
    program_says(0, "size 8 x 2 x 1, was 4 x 1 x 0.5\n", "convert flat.obj --size 8 -o eight.obj");
    expect_text("eight.obj", "o node_1\nv -2 4 0\nv 6 4 0\nv 2 6 -1\nf 1 2 3\n");
    program_says(0, "size 8 x 2 x 1,", "info eight.obj");
    program_says(0, "size 2 x 0.25 x 0.5, was 4 x 1 x 0.5\n", "convert flat.obj --up y:z --size 2 -o two.obj");
    expect_text("two.obj", "o node_1\nv -0.5 0 1\nv 1.5 0 1\nv 0.5 0.25 1.5\nf 1 2 3\n");
    put_text("bones.csv", "name,time,parent,tx,ty,tz\na,0,,1,1,1\nb,0,a,0,-3,1\n");
    program_says(0, "size 0 x 6 x 2, was 0 x 3 x 1\n", "convert bones.csv --size 6 -o bones.glb");
    program_says(0, "bones.glb: glTF 2.0", "info bones.glb");
    put_text("point.obj", "v 1 2 3\n");
    program_says(1, "has no size", "convert point.obj --size 1 -o x.obj");
    program_says(2, "not a positive number", "convert flat.obj --size 0 -o x.obj");
    program_says(2, "not with --scale", "convert flat.obj --size 1 --scale 2 -o x.obj");
}

/* The second face has a normal, which is kept; the first gets that of its plane, and a line says so. */
static void missing_normals_are_those_of_faces(void **state)
{
    (void)state;
    put_text("some.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nvn 0.6 0 0.8\nf 1 3 4\nf 1//1 2//1 3//1\nf 1 2 4\n");
    program_says(0, "normals made for 1 of 2 primitives, smooth up to 0 degrees",
                 "convert some.obj --normals 0 -o all.obj");
    expect_text("all.obj", "o node_1\nv 0 0 0\nvn 1 0 0\nv 0 2 0\nv 0 0 2\nvn 0 -1 0\nv 2 0 0\n"
                           "f 1//1 2//1 3//1\nf 1//2 4//2 3//2\nvn 0.6 0 0.8\nf 1//3 4//3 2//3\n");
}

#define PNG "\x89PNG\r\n\x1a\none"

/* A picture in the file, one beside it, one that is missing; two sets of texture coordinates. */
static void put_model(void)
{
    static const char text[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"data:;base64,"
        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\",\"byteLength\":36}],\"bufferViews\":[{\"buffer\":0,"
        "\"byteLength\":36}],\"accessors\":[{"
        "\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},{\"bufferView\":0,\"componentType\":"
        "5126,\"count\":3,\"type\":\"VEC2\"}],\"images\":[{\"uri\":\"data:image/png;base64,iVBORw0KGgpvbmU=\"},{"
        "\"uri\":\"in/a%20b.png\"},{\"uri\":\"missing.png\"}],\"textures\":[{\"source\":0},{\"source\":1},{\"source\":"
        "2}],\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}},{\"pbrMetallicRoughness\":"
        "{\"baseColorTexture\":{\"index\":1}}},{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":2}}}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,\"TEXCOORD_1\":1},\"material\":"
        "1}]}],\"nodes\":[{\"mesh\":0}]}";
    mkdir("obj", 0777);
    mkdir("obj/in", 0777);
    mkdir("obj/sub", 0777);
    put_file("obj/a.gltf", text, sizeof text - 1);
    put_file("obj/in/a b.png", PNG, sizeof PNG - 1);
}

#define MATERIAL(n) "newmtl material_" n "\nKd 1 1 1\nmap_Kd "

static void pictures_are_files_beside_it(void **state)
{
    (void)state;
    put_model();
    char *said = program_run(NULL, "convert obj/a.gltf -o obj/b.obj 2>&1");
    assert_int_equal(lines_with(said, "written is set 0 of 2"), 1);
    assert_int_equal(lines_with(said, "OBJ has no clips"), 0); /* and neither has the file */
    assert_int_equal(lines_with(said, "warning"), 0);
    free(said);
    expect_text("obj/b.mtl", MATERIAL("0") "b_0.png\n" MATERIAL("1") "in/a b.png\n" MATERIAL("2") "missing.png\n");
    expect_text("obj/b_0.png", PNG);
    said = program_run(NULL, "convert obj/a.gltf -o obj/sub/c.obj 2>&1");
    assert_int_equal(lines_with(said, "missing.png: warning: cannot be read, and is not copied"), 1);
    free(said);
    expect_text("obj/sub/c.mtl", MATERIAL("0") "c_0.png\n" MATERIAL("1") "c_1.png\n" MATERIAL("2") "missing.png\n");
    expect_text("obj/sub/c_1.png", PNG);
    program_says(0, "1 triangle,", "info obj/sub/c.obj");
}

static void what_obj_cannot_hold_is_said(void **state)
{
    (void)state;
    program_says(0, "note: OBJ has no clips, skins and morph targets: written is clip walk at 0.4 s",
                 "convert '" NKW_CHARACTER "' --clip walk --time 0.4 -o x.obj");
    program_says(0, "note: OBJ has no clips, skins and morph targets: written is the rest pose",
                 "convert '" NKW_CHARACTER "' -o x.obj");
    program_says(1, "choose one clip", "convert '" NKW_CHARACTER "' --clip all -o x.obj");
    program_says(1, "no clip nothing", "convert '" NKW_CHARACTER "' --clip nothing -o x.obj");
    program_says(2, "only with -o FILE.obj", "convert '" NKW_CHARACTER "' --time 1 -o x.glb");
    program_says(2, "not with -o FILE.obj", "convert '" NKW_CHARACTER "' --form glb -o x.obj");
    program_says(2, "not a number of seconds", "convert '" NKW_CHARACTER "' --time 1s -o x.obj");
    program_says(1, "cannot be written", "convert '" NKW_CHARACTER "' -o no-such-folder/x.obj");
    put_text("keys.csv", "name,time,tx,ty,tz\na,0,1,0,0\na,1,2,0,0\n");
    program_says(1, "there are no meshes", "convert keys.csv -o x.obj");
    program_says(2, "only glTF is written", "reduce '" NKW_CHARACTER "' -o x.obj");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_are_those_of_the_time), cmocka_unit_test(changes_are_written_too),
        cmocka_unit_test(models_are_scaled_to_a_size),    cmocka_unit_test(missing_normals_are_those_of_faces),
        cmocka_unit_test(pictures_are_files_beside_it),   cmocka_unit_test(what_obj_cannot_hold_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
