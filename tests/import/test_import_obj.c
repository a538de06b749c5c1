/* SPDX-License-Identifier: MIT */
/* OBJ and MTL, as the programs of the field write them; the values are those of the texts. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "documents.h"
#include "scene.h"

/* Files in memory: pairs of a name and a text, ended by NULL; it counts the questions. */
typedef struct folder {
    const char *const *files;
    int questions;
} folder;

static size_t read_named(void *user, const char *path, void *out, size_t size)
{
    folder *f = (folder *)user;
    assert_true(path[0] != '/' && strncmp(path, "../", 3) != 0 && !strstr(path, "/../") && strcmp(path, "..") != 0);
    f->questions++;
    for (size_t i = 0; f->files && f->files[i]; i += 2)
        if (strcmp(f->files[i], path) == 0) {
            const size_t length = strlen(f->files[i + 1]);
            if (out)
                memcpy(out, f->files[i + 1], size);
            return size > length ? SIZE_MAX : length;
        }
    return SIZE_MAX;
}

static nkw_document *read_with(const char *text, folder *f)
{
    nkw_document *d;
    nkw_import_error error;
    const nkw_import_memory memory = {text, strlen(text), "folder/text.obj", NULL, read_named, f, 0, 0};
    if (nkw_document_from_memory(&memory, &d, &error) != NKW_IMPORT_OK)
        print_error("%s: %s\n", error.place, error.reason);
    assert_int_equal(error.code, NKW_IMPORT_OK);
    assert_string_equal(d->format, "OBJ");
    assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_OK);
    return d;
}

static nkw_document *read_text(const char *text)
{
    folder none = {NULL, 0};
    return read_with(text, &none);
}

static nkw_vec3 at(float x, float y, float z)
{
    const nkw_vec3 v = {x, y, z};
    return v;
}

static const nkw_document_primitive *primitive(const nkw_document *d, size_t mesh, size_t index)
{
    assert_in_range(mesh, 0, d->mesh_count - 1);
    assert_in_range(index, 0, d->meshes[mesh].primitive_count - 1);
    return &d->meshes[mesh].primitives[index];
}

static nkw_vec3 corner(const nkw_document_primitive *p, size_t index)
{
    assert_in_range(index, 0, p->index_count - 1);
    return p->positions[p->indices[index]];
}

static void expect_corners(const nkw_document_primitive *p, const nkw_vec3 *want, size_t count)
{
    assert_int_equal(p->index_count, count);
    for (size_t i = 0; i < count; i++)
        expect_vec3_near(corner(p, i), want[i], 0);
}

#define THREE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

/* A vertex of such a number was dropped, and the faces took the next ones. */
static void numbers_may_begin_with_a_point(void **state)
{
    (void)state;
    static const struct {
        const char *numbers;
        float x, y, z;
    } list[] = {
        {".5 .25 0", 0.5f, 0.25f, 0.0f}, {"-.5 .25 0", -0.5f, 0.25f, 0.0f},       {"0.5 .25 0", 0.5f, 0.25f, 0.0f},
        {"0 0 .73", 0.0f, 0.0f, 0.73f},  {"+1. 2e-1 -3E+2", 1.0f, 0.2f, -300.0f}, {"\t1\t2 \t 3\t", 1.0f, 2.0f, 3.0f},
        {"1 2 3 0.5", 1.0f, 2.0f, 3.0f},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        char text[200];
        snprintf(text, sizeof text, "v %s\nv 1 0 0\nv 0 1 0\nv 7 7 7\nf 1 2 3\n", list[i].numbers);
        nkw_document *d = read_text(text);
        const nkw_vec3 want[] = {at(list[i].x, list[i].y, list[i].z), at(1, 0, 0), at(0, 1, 0)};
        expect_corners(primitive(d, 0, 0), want, 3);
        assert_int_equal(primitive(d, 0, 0)->vertex_count, 3);
        assert_int_equal(d->warning_count, 0);
        nkw_document_close(d);
    }
}

static void corners_have_every_form(void **state)
{
    (void)state;
    static const char *const faces[][2] = {
        {"f 1 2 3", ""},
        {"f 1/1 2/2 3/1", "t"},
        {"f 1//1 2//1 3//1", "n"},
        {"f 1/1/1 2/2/1 3/1/1", "tn"},
        {"f 1/ 2/ 3/", ""},
        {"f 1// 2// 3//", ""},
        {"f 1/1/ 2/2/ 3/1/", "t"},
        {"f -3 -2 -1", ""},
        {"f -3/-2/-1 -2/-1/-1 -1/-2/-1", "tn"},
        {"f\t1  2\t3 ", ""},
        {"f 1 2 3 # end", ""},
        {"f 1 2 3#end", ""},
        {"f 1/1 2/2 3", ""},
        {"fo 1 2 3", ""},
        {"f 1 \\\n 2 \\\r\n3", ""},
        {"f 1 2 3 \\", ""},
    };
    const nkw_vec3 want[] = {at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)};
    for (size_t i = 0; i < sizeof faces / sizeof *faces; i++) {
        char text[300];
        snprintf(text, sizeof text, THREE "vt 0 0\nvt 1 .25 0\nvn 0 0 2\n%s", faces[i][0]);
        nkw_document *d = read_text(text);
        const nkw_document_primitive *p = primitive(d, 0, 0);
        expect_corners(p, want, 3);
        assert_int_equal(p->texcoords != NULL, strchr(faces[i][1], 't') != NULL);
        assert_int_equal(p->normals != NULL, strchr(faces[i][1], 'n') != NULL);
        if (p->texcoords) {
            expect_near(p->texcoords[0][2 * p->indices[1]], 1, 0);
            expect_near(p->texcoords[0][2 * p->indices[1] + 1], 0.75, 0);
            expect_near(p->texcoords[0][2 * p->indices[2] + 1], 1, 0);
        }
        if (p->normals)
            expect_vec3_near(p->normals[p->indices[2]], at(0, 0, 2), 0);
        assert_int_equal(d->warning_count, 0);
        nkw_document_close(d);
    }
}

/* Positive numbers may be those of vertices further down, negative ones count back from their line. */
static void numbers_of_vertices_are_of_the_whole_file_or_of_their_line(void **state)
{
    (void)state;
    nkw_document *d = read_text("f 1 2 3\n" THREE "f -3 -2 -1\nv 5 0 0\nf -3 -2 -1\n");
    const nkw_vec3 want[] = {at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 0), at(1, 0, 0),
                             at(0, 1, 0), at(1, 0, 0), at(0, 1, 0), at(5, 0, 0)};
    expect_corners(primitive(d, 0, 0), want, 9);
    assert_int_equal(primitive(d, 0, 0)->vertex_count, 4);
    nkw_document_close(d);
}

static void line_ends_are_those_of_every_system(void **state)
{
    (void)state;
    static const char *const texts[] = {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
                                        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
                                        "\xEF\xBB\xBF# a\\\nv 0 0 0\n\n  v 1 0 0 # b\n\tv 0 1 0\nf 1 2 3"};
    const nkw_vec3 want[] = {at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        nkw_document *d = read_text(texts[i]);
        expect_corners(primitive(d, 0, 0), want, 3);
        nkw_document_close(d);
    }
}

/* Twice the area of the triangles of a primitive in the plane z = 0, all of which turn left. */
static double area_of(const nkw_document_primitive *p)
{
    double sum = 0.0;
    for (size_t i = 0; i < p->index_count; i += 3) {
        const nkw_vec3 a = corner(p, i), b = corner(p, i + 1), c = corner(p, i + 2);
        const double area = ((double)b.x - a.x) * ((double)c.y - a.y) - ((double)b.y - a.y) * ((double)c.x - a.x);
        assert_true(area >= 0.0);
        sum += area;
    }
    return sum;
}

static void polygons_become_triangles(void **state)
{
    (void)state;
    nkw_document *d = read_text("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
    const nkw_vec3 want[] = {at(0, 0, 0), at(2, 0, 0), at(3, 1, 0), at(0, 0, 0), at(3, 1, 0),
                             at(2, 2, 0), at(0, 0, 0), at(2, 2, 0), at(0, 2, 0)};
    expect_corners(primitive(d, 0, 0), want, 9);
    nkw_document_close(d);
    /* Concave ones: an arrow, and a comb of which a fan would cover the gaps. */
    d = read_text("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n");
    expect_near((float)area_of(primitive(d, 0, 0)), 2, 0);
    nkw_document_close(d);
    d = read_text("v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\n"
                  "v 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n");
    assert_int_equal(primitive(d, 0, 0)->index_count, 30);
    expect_near((float)area_of(primitive(d, 0, 0)), 2 * 11, 0);
    nkw_document_close(d);
}

/* The area of a concave polygon in any plane, front and back: triangles have the normal of the polygon. */
static void concave_polygons_of_any_plane_keep_their_area(void **state)
{
    (void)state;
    static const float arrow[4][2] = {{0, 0}, {2, 1}, {0, 2}, {1, 1}};
    for (int axis = 0; axis < 3; axis++)
        for (int back = 0; back < 2; back++) {
            char text[400] = "";
            for (int i = 0; i < 4; i++) {
                float v[3] = {7, 7, 7};
                v[(axis + 1) % 3] = arrow[i][back];
                v[(axis + 2) % 3] = arrow[i][!back];
                sprintf(text + strlen(text), "v %g %g %g\n", (double)v[0], (double)v[1], (double)v[2]);
            }
            strcat(text, "f 1 2 3 4\n");
            nkw_document *d = read_text(text);
            const nkw_document_primitive *p = primitive(d, 0, 0);
            assert_int_equal(p->index_count, 6);
            for (size_t t = 0; t < 6; t += 3) {
                const nkw_vec3 a = corner(p, t), b = corner(p, t + 1), c = corner(p, t + 2);
                const nkw_vec3 n = nkw_vec3_cross(nkw_vec3_sub(b, a), nkw_vec3_sub(c, a));
                expect_near((&n.x)[axis], back ? -1 : 1, 0);
            }
            nkw_document_close(d);
        }
}

static void lines_and_points_are_read(void **state)
{
    (void)state;
    nkw_document *d = read_text(THREE "vt 0 0\nl 1/1 2/1 3/1\np 3 1\n");
    const nkw_vec3 lines[] = {at(0, 0, 0), at(1, 0, 0), at(1, 0, 0), at(0, 1, 0)};
    const nkw_vec3 points[] = {at(0, 1, 0), at(0, 0, 0)};
    assert_int_equal(primitive(d, 0, 0)->topology, NKW_DOCUMENT_LINES);
    expect_corners(primitive(d, 0, 0), lines, 4);
    assert_int_equal(primitive(d, 0, 1)->topology, NKW_DOCUMENT_POINTS);
    expect_corners(primitive(d, 0, 1), points, 2);
    nkw_document_close(d);
    d = read_text(THREE); /* a cloud */
    assert_int_equal(primitive(d, 0, 0)->topology, NKW_DOCUMENT_POINTS);
    assert_int_equal(primitive(d, 0, 0)->index_count, 3);
    nkw_document_close(d);
}

static void objects_and_groups_are_nodes_with_a_primitive_for_each_material(void **state)
{
    (void)state;
    nkw_document *d = read_text(THREE "f 1 2 3\no empty\no a\nusemtl x\nf 1 2 3\ng left hand # of it\nusemtl y y\n"
                                      "f 1 2 3\nusemtl x\nf 3 2 1\no b\nf 1 2 3\no a\nusemtl y y\nf 1 2 3\n");
    static const char *const names[] = {"text.obj", "node_1", "a", "left hand", "b"};
    assert_int_equal(d->skeleton.joint_count, 5);
    for (size_t j = 0; j < 5; j++) {
        assert_string_equal(d->nodes[j].name, names[j]);
        assert_int_equal(d->skeleton.parents[j], j == 0 ? NKW_NO_JOINT : 0);
        assert_int_equal(d->nodes[j].mesh, j == 0 ? NKW_NO_JOINT : (int32_t)j - 1);
    }
    static const size_t counts[] = {1, 2, 2, 1};
    static const int32_t materials[][2] = {{NKW_NO_JOINT, 0}, {0, 1}, {1, 0}, {0, 0}};
    assert_int_equal(d->mesh_count, 4);
    for (size_t m = 0; m < 4; m++) {
        assert_int_equal(d->meshes[m].primitive_count, counts[m]);
        for (size_t i = 0; i < counts[m]; i++)
            assert_int_equal(primitive(d, m, i)->material, materials[m][i]);
    }
    assert_int_equal(d->material_count, 2);
    assert_string_equal(d->materials[1].name, "y y");
    assert_int_equal(d->warning_count, 1);
    assert_string_equal(d->warnings[0], "materials that no file defines: 2, the first is x");
    nkw_document_close(d);
}

/* Faces with normals and without are two primitives: no vertex has an attribute that the file does not have. */
static void attributes_are_those_of_the_faces(void **state)
{
    (void)state;
    nkw_document *d = read_text("v 0 0 0 1 0 0.5\nv 1 0 0 1 1 1\nv 0 1 0 0 0 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"
                                "f 2 3 4\nf 1//1 2//1 3\n");
    assert_int_equal(d->meshes[0].primitive_count, 3);
    const nkw_document_primitive *p = primitive(d, 0, 0);
    assert_non_null(p->normals);
    assert_non_null(p->colors);
    const float color[] = {1, 0, 0.5f, 1};
    expect_floats_near(p->colors + 4 * p->indices[0], color, 4, 0);
    assert_null(primitive(d, 0, 1)->normals);
    assert_null(primitive(d, 0, 1)->colors);
    assert_null(primitive(d, 0, 2)->normals);
    assert_non_null(primitive(d, 0, 2)->colors);
    nkw_document_close(d);
}

static void materials_have_colours_opacity_and_pictures(void **state)
{
    (void)state;
    static const char mtl[] =
        "\xEF\xBB\xBF# m\nKd 9 9 9\nnewmtl a # first\r\nNs 10\nKd .5 .25 1e-1 # c\nd 0.5\nTr 0.9\n"
        "map_Kd -s 1 1 1 -o .5 -clamp on -mm 0 1 my picture.png\n"
        "newmtl b #2\n\tKd 2 -1 .5\nTr .75\nmap_Kd dir\\\\skin.jpg\nnewmtl c\nKd .5\nd -halo .25\n"
        "map_Kd my picture.png\nnewmtl d\nKd red\nmap_Kd /abs/olute.png\n";
    const char *const files[] = {"two words.mtl", mtl, NULL};
    folder f = {files, 0};
    const char text[] = "mtllib two words.mtl\n" THREE "usemtl b #2\nf 1 2 3\n";
    nkw_document *d = read_with(text, &f);
    static const float colors[][4] = {
        {0.5f, 0.25f, 0.1f, 0.5f}, {1, 0, 0.5f, 0.25f}, {0.5f, 0.5f, 0.5f, 0.25f}, {1, 1, 1, 1}};
    static const char *const names[] = {"a", "b #2", "c", "d"};
    static const char *const paths[] = {"my picture.png", "dir/skin.jpg", "my picture.png", NULL};
    assert_int_equal(d->material_count, 4);
    for (size_t i = 0; i < 4; i++) {
        assert_string_equal(d->materials[i].name, names[i]);
        expect_floats_near(d->materials[i].color, colors[i], 4, 0);
        assert_non_null(d->materials[i].image);
        if (paths[i])
            assert_string_equal(d->materials[i].image->path, paths[i]);
        else
            assert_null(d->materials[i].image->path);
    }
    assert_ptr_equal(d->materials[0].image, d->materials[2].image);
    assert_int_equal(d->image_count, 3);
    assert_int_equal(primitive(d, 0, 0)->material, 1);
    assert_int_equal(d->bytes, sizeof text - 1 + sizeof mtl - 1);
    assert_int_equal(d->warning_count, 1);
    assert_string_equal(d->warnings[0], "two words.mtl, line 18: a number is expected");
    nkw_document_close(d);
}

static void several_libraries_are_read_once(void **state)
{
    (void)state;
    const char *const files[] = {"a.mtl", "newmtl a\nKd 0 0 0\n", "b.mtl", "newmtl b\nKd 1 0 0", NULL};
    folder f = {files, 0};
    nkw_document *d = read_with("mtllib a.mtl b.mtl\nmtllib a.mtl\nmtllib a.mtl\n" THREE "f 1 2 3\n", &f);
    assert_int_equal(d->material_count, 2);
    assert_int_equal(f.questions, 5); /* the whole line, and the size and the bytes of two files */
    assert_int_equal(d->warning_count, 0);
    nkw_document_close(d);
}

/* A path out of the folder is its last name in the folder. */
static void libraries_are_those_of_the_folder(void **state)
{
    (void)state;
    static const char *const names[] = {"../bar.mtl", "/etc/bar.mtl", "a/../../bar.mtl", "C:\\a\\bar.mtl", ".."};
    const char *const files[] = {"bar.mtl", "newmtl a\n", NULL};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char text[200];
        folder f = {files, 0};
        snprintf(text, sizeof text, "mtllib %s\n" THREE "f 1 2 3\n", names[i]);
        nkw_document *d = read_with(text, &f);
        assert_int_equal(d->material_count, i < 4);
        assert_int_equal(d->warning_count, i >= 4);
        nkw_document_close(d);
    }
    folder f = {NULL, 0};
    nkw_document *d = read_with("mtllib no.mtl\n" THREE "usemtl a\nf 1 2 3\n", &f);
    assert_int_equal(d->warning_count, 1);
    assert_string_equal(d->warnings[0], "the materials of no.mtl are not read: there is no such file");
    nkw_document_close(d);
    d = read_with("mtllib \x1b[1m\x8b.mtl\n" THREE "f 1 2 3\n", &f); /* for a terminal, and for JSON */
    assert_string_equal(d->warnings[0], "the materials of ?[1m?.mtl are not read: there is no such file");
    nkw_document_close(d);
}

static void what_is_odd_is_a_warning(void **state)
{
    (void)state;
    nkw_document *d = read_text(THREE "f 1 2\ns 1\nvp 0\ncurv 0 1 1 2 \\\n3\nf 1 2 3\nsurf 1\nl 1\n");
    assert_int_equal(d->warning_count, 2);
    assert_string_equal(d->warnings[0], "faces or lines of too few corners are left out: 2");
    assert_string_equal(d->warnings[1], "lines that are not read: 2, the first is line 7");
    assert_int_equal(primitive(d, 0, 0)->index_count, 3);
    nkw_document_close(d);
}

static void broken_files_are_refused_with_their_line(void **state)
{
    (void)state;
    static const struct {
        const char *text, *place, *reason;
    } list[] = {
        {"v 0 0\n", "line 1", "3 numbers are expected, 2 are there"},
        {"v 0 0 0\nv 1 x 0\n", "line 2", "a number is expected"},
        {"v 0 0 1e39\n", "line 1", "the number is not finite as a float"},
        {"v 0 0 nan\n", "line 1", "a number is expected"},
        {"v 1,2,3\n", "line 1", "a number is expected"},
        {"v 0 0 0 0 y\n", "line 1", "a number is expected"},
        {"# c\n\nvt\n", "line 3", "1 numbers are expected, 0 are there"},
        {"vn 1 2\n", "line 1", "3 numbers are expected, 2 are there"},
        {THREE "f 1 2 4\n", "line 4", "vertex 4 does not exist: there are 3"},
        {THREE "f 1/1 2/1 3/1\n", "line 4", "texture coordinate 1 does not exist: there are 0"},
        {THREE "vn 0 0 1\nf 1//1 2//1 3//2\n", "line 5", "normal 2 does not exist: there are 1"},
        {THREE "f 0 1 2\n", "line 4", "0 is out of range: there are 3 so far"},
        {THREE "f -4 1 2\n", "line 4", "-4 is out of range: there are 3 so far"},
        {THREE "f 1 2 4294967297\n", "line 4", "4294967295 is out of range: there are 3 so far"},
        {THREE "f 1 2 - 3\n", "line 4", "a number of a vertex is expected"},
        {THREE "f 1 2 3x\n", "line 4", "a corner is expected: 1, 1/2, 1//3 or 1/2/3"},
        {THREE "f 1 2 /3\n", "line 4", "a corner is expected: 1, 1/2, 1//3 or 1/2/3"},
        {"v 0 0 0\nvt 0\nvn 0 0 1\nf 1/1/1 1/1/1 1/1/1/1\n", "line 4", "a corner is expected: 1, 1/2, 1//3 or 1/2/3"},
        {THREE "f 1, 2, 3\n", "line 4", "a corner is expected: 1, 1/2, 1//3 or 1/2/3"},
        {THREE "f 1 \\\n2 x\n", "line 5", "a corner is expected: 1, 1/2, 1//3 or 1/2/3"},
        {"o a\n", "line 2", "there are no vertices"},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        nkw_document *d;
        nkw_import_error error;
        const nkw_import_memory memory = {list[i].text, strlen(list[i].text), "text.obj", NULL, NULL, NULL, 0, 0};
        assert_int_equal(nkw_document_from_memory(&memory, &d, &error), NKW_IMPORT_INVALID);
        assert_null(d);
        assert_string_equal(error.place, list[i].place);
        assert_string_equal(error.reason, list[i].reason);
    }
}

/* By its first word in any file; by its extension where another word is the first. */
static void files_are_known_by_their_first_word_or_their_name(void **state)
{
    (void)state;
    static const struct {
        const char *text, *file;
        nkw_import_result result;
    } list[] = {
        {"# a\n\n g a\nv 0 0 0\n", "-", NKW_IMPORT_OK},
        {"mg 1\nv 0 0 0\n", "a.obj", NKW_IMPORT_OK},
        {"mg 1\nv 0 0 0\n", "A.Obj", NKW_IMPORT_OK},
        {"mg 1\nv 0 0 0\n", "-", NKW_IMPORT_UNKNOWN},
        {"", "a.obj", NKW_IMPORT_UNKNOWN},
        {"# a", "a.obj", NKW_IMPORT_INVALID},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        nkw_document *d;
        const nkw_import_memory memory = {list[i].text, strlen(list[i].text), list[i].file, NULL, NULL, NULL, 0, 0};
        assert_int_equal(nkw_document_from_memory(&memory, &d, NULL), list[i].result);
        nkw_document_close(d);
    }
}

/* Names are UTF-8 in every document. */
static void names_become_utf8(void **state)
{
    (void)state;
    nkw_document *d = read_text(THREE "o \xe7\x90\x83\nusemtl \x8b\x85\nf 1 2 3\n");
    assert_string_equal(d->nodes[1].name, "\xe7\x90\x83");
    assert_string_equal(d->materials[0].name, "??");
    nkw_document_close(d);
}

/* Cut at every length, and with every byte changed: an error or a document whose indices are valid. */
static void broken_bytes_are_survived(void **state)
{
    (void)state;
    static const char text[] = "mtllib a.mtl\no a\nv 0 0 0 1 1 1\nv 1 0 0\nv 1 1e0 0\nv 0.1 .9 0 1\nvt 0 1\nvn 0 0 1\n"
                               "usemtl m\nf 1/1/1 2/1/1 3/1/1 -1/1/1\ng b \\\nc\nl 1 2 \\\n 3\np -1\n";
    static const char mtl[] = "newmtl m\nKd 1 .5 0\nd .5\nmap_Kd -s 1 2 a.png\n";
    const char *files[] = {"a.mtl", mtl, NULL};
    folder f = {files, 0};
    static const char bytes[] = {0, '\n', '\r', '\\', '#', '/', '-', '9', ' ', '.', 'x', (char)0xff};
    char *copy = (char *)malloc(sizeof text), *other = (char *)malloc(sizeof mtl);
    assert_non_null(copy);
    assert_non_null(other);
    for (size_t i = 0; i < sizeof text + sizeof mtl - 2; i++)
        for (size_t b = 0; b <= sizeof bytes; b++) {
            const size_t k = i < sizeof text - 1 ? i : i - (sizeof text - 1);
            char *changed = i < sizeof text - 1 ? copy : other;
            memcpy(copy, text, sizeof text);
            memcpy(other, mtl, sizeof mtl);
            files[1] = other;
            changed[k] = b < sizeof bytes ? bytes[b] : changed[k];
            const size_t length = b == sizeof bytes && changed == copy ? k : sizeof text - 1;
            char *exact = (char *)malloc(length + 1);
            assert_non_null(exact);
            memcpy(exact, copy, length);
            nkw_document *d;
            nkw_import_error error;
            const nkw_import_memory memory = {exact, length, "a.obj", NULL, read_named, &f, 0, 0};
            if (nkw_document_from_memory(&memory, &d, &error) != NKW_IMPORT_OK)
                assert_true(error.reason[0]);
            else
                assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_OK);
            for (size_t m = 0; d && m < d->mesh_count; m++)
                for (size_t p = 0; p < d->meshes[m].primitive_count; p++)
                    for (size_t v = 0; v < d->meshes[m].primitives[p].index_count; v++)
                        assert_true(d->meshes[m].primitives[p].indices[v] < d->meshes[m].primitives[p].vertex_count);
            nkw_document_close(d);
            free(exact);
        }
    free(copy);
    free(other);
}

static size_t size_of(const char *path)
{
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    assert_int_equal(fseek(f, 0, SEEK_END), 0);
    const long size = ftell(f);
    fclose(f);
    return (size_t)size;
}

#define BAR NKW_TEST_DATA "/import/bar"

static void a_file_has_the_materials_of_its_folder(void **state)
{
    (void)state;
    nkw_document *d;
    assert_int_equal(nkw_document_open(BAR ".obj", &d, NULL), NKW_IMPORT_OK);
    assert_int_equal(d->meshes[0].primitive_count, 2);
    const nkw_document_primitive *quad = primitive(d, 0, 0), *sides = primitive(d, 0, 1);
    assert_int_equal(quad->index_count, 6);
    assert_int_equal(quad->vertex_count, 4);
    assert_int_equal(sides->index_count, 12);
    assert_int_equal(sides->vertex_count, 5);
    expect_vec3_near(quad->normals[0], at(0, -1, 0), 0);
    assert_null(sides->normals);
    assert_string_equal(d->nodes[0].name, "bar.obj");
    assert_string_equal(d->nodes[1].name, "bar");
    assert_int_equal(d->material_count, 2);
    assert_string_equal(d->materials[quad->material].name, "red");
    expect_near(d->materials[quad->material].color[2], 0.5, 0);
    assert_string_equal(d->materials[sides->material].name, "blue");
    assert_int_equal(d->bytes, size_of(BAR ".obj") + size_of(BAR ".mtl"));
    nkw_document_close(d);
}

/* Blender's capsule, as the exercise reads it. */
static void a_model_at_hand_is_read(void **state)
{
    (void)state;
    nkw_document *d;
    if (!scene_folder_is_there())
        skip();
    assert_int_equal(nkw_document_open(NKW_DATA_DIR "/obj/capsule_3m.obj", &d, NULL), NKW_IMPORT_OK);
    assert_int_equal(primitive(d, 0, 0)->index_count, 3 * 312);
    assert_string_equal(d->nodes[1].name, "\xe7\x90\x83");
    assert_int_equal(d->warning_count, 1);
    nkw_document_close(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_may_begin_with_a_point),
        cmocka_unit_test(corners_have_every_form),
        cmocka_unit_test(numbers_of_vertices_are_of_the_whole_file_or_of_their_line),
        cmocka_unit_test(line_ends_are_those_of_every_system),
        cmocka_unit_test(polygons_become_triangles),
        cmocka_unit_test(concave_polygons_of_any_plane_keep_their_area),
        cmocka_unit_test(lines_and_points_are_read),
        cmocka_unit_test(objects_and_groups_are_nodes_with_a_primitive_for_each_material),
        cmocka_unit_test(attributes_are_those_of_the_faces),
        cmocka_unit_test(materials_have_colours_opacity_and_pictures),
        cmocka_unit_test(several_libraries_are_read_once),
        cmocka_unit_test(libraries_are_those_of_the_folder),
        cmocka_unit_test(what_is_odd_is_a_warning),
        cmocka_unit_test(broken_files_are_refused_with_their_line),
        cmocka_unit_test(files_are_known_by_their_first_word_or_their_name),
        cmocka_unit_test(names_become_utf8),
        cmocka_unit_test(broken_bytes_are_survived),
        cmocka_unit_test(a_file_has_the_materials_of_its_folder),
        cmocka_unit_test(a_model_at_hand_is_read),
    };
    return cmocka_run_group_tests_name("import_obj", tests, NULL, NULL);
}
