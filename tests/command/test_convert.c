/* SPDX-License-Identifier: MIT */
/* nakawari convert: what is read is written, with other rates, axes and units. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"

#include <stdlib.h>
#include <sys/stat.h>

#include "planted.h"
#include "samples.h"

/* A conversion of axes that changes nothing writes the document, not the file. */
#define WRITTEN "--axes gltf:gltf"

static void a_written_document_is_the_one_that_was_read(void **state)
{
    (void)state;
    program_says(0, "only what is read", "convert '" NKW_CHARACTER "' " WRITTEN " -o written.glb");
    free(program_run(NULL, "diff '" NKW_CHARACTER "' written.glb"));
    const char *const what[] = {"local", "model", "palette", "vertices", "weights"};
    for (int i = 0; i < 5; i++) {
        char *from = program_run(NULL, "sample '" NKW_CHARACTER "' --clip hop --at 0,0.3,1 --what %s", what[i]);
        char *to = program_run(NULL, "sample written.glb --clip hop --at 0,0.3,1 --what %s", what[i]);
        assert_string_equal(from, to);
        free(from);
        free(to);
    }
}

static void the_forms_of_a_file_have_the_same_content(void **state)
{
    (void)state;
    const char *const forms[] = {"glb", "gltf", "embedded"};
    for (int i = 0; i < 3; i++) {
        free(program_run(NULL, "convert '" NKW_CHARACTER "' " WRITTEN " --form %s -o form%d.gltf", forms[i], i));
        free(program_run(NULL, "diff '" NKW_CHARACTER "' form%d.gltf", i));
        free(program_run(NULL, "convert '" NKW_CHARACTER "' --form %s -o kept%d.gltf", forms[i], i));
        free(program_run(NULL, "diff '" NKW_CHARACTER "' kept%d.gltf", i));
    }
}

static void expect_written_as_read(const char *file)
{
    free(program_run(NULL, "convert '%s' " WRITTEN " -o convert_real.glb", file));
    free(program_run(NULL, "diff '%s' convert_real.glb", file));
    free(program_run(NULL, "convert '%s' -o real.gltf", file));
    free(program_run(NULL, "diff '%s' real.gltf", file));
}

static void real_files_are_written_as_they_are_read(void **state)
{
    (void)state;
    each_sample(expect_written_as_read);
}

/* Files of other formats, where the program reads them. */
static void files_of_other_formats_are_written_as_they_are_read(void **state)
{
    (void)state;
    const char *const names[] = {"arm.bvh", "arm.dae", "arm.fbx", "arm.md5mesh", "arm.x", "bar.obj"};
    for (int i = 0; i < 6; i++) {
        int code;
        free(program_run(&code, "info '" NKW_FIGURES "/../../tests/data/import/%s' >/dev/null 2>&1", names[i]));
        if (code != 0)
            continue;
        free(program_run(NULL,
                         "convert '" NKW_FIGURES "/../../tests/data/import/%s' --unit keep -o 'of other format.gltf'",
                         names[i]));
        free(program_run(NULL, "diff '" NKW_FIGURES "/../../tests/data/import/%s' 'of other format.gltf'", names[i]));
    }
}

/* z up and inches become y up and metres: (10, 20, 30) in is (0.254, 0.762, -0.508) m. */
static void axes_and_units_become_those_of_gltf(void **state)
{
    (void)state;
    int code;
    const char *const file = NKW_FIGURES "/../../tests/data/import/fbx/axes.fbx";
    free(program_run(&code, "info '%s' >/dev/null 2>&1", file));
    if (code != 0)
        return;
    char *said = program_run(NULL, "convert '%s' -o metres.glb 2>&1", file);
    assert_non_null(strstr(said,
                           "axes up z, forward -y, right -x; a unit is 0.0254 m: turned to up y, forward z, right "
                           "-x; lengths multiplied by 0.0254 to 1 m"));
    free(said);
    said = program_run(NULL, "sample metres.glb --at 0");
    assert_non_null(strstr(said, "box,0.254000008,0.761999965,-0.508000016,"));
    free(said);
    free(program_run(NULL, "convert '%s' --axes keep --unit cm -o kept.glb", file));
    said = program_run(NULL, "sample kept.glb --at 1");
    assert_non_null(strstr(said, "box,25.3999996,50.7999992,127,"));
    free(said);
    said = program_run(NULL, "info '%s'", file);
    assert_non_null(strstr(said, "  axes up z, forward -y, right -x; a unit is 0.0254 m\n"));
    free(said);
    program_says(2, "league: not m, cm, mm, km, in, ft, yd or keep", "convert walk.csv --unit league -o x.glb");
}

/* A note says how near the keys are to curves of the file, unless they are resampled or are no curves. */
static void the_tolerance_of_curves_is_printed(void **state)
{
    (void)state;
    int code;
    const char *const file = NKW_FIGURES "/../../tests/data/import/fbx/rotation.fbx";
    free(program_run(&code, "info '%s' >/dev/null 2>&1", file));
    if (code != 0)
        return;
    char *said = program_run(NULL, "convert '%s' -o curves.glb 2>&1 >/dev/null", file);
    const char *note = strstr(said, "became CUBICSPLINE, with ");
    unsigned long added;
    double degrees, number;
    assert_non_null(note);
    assert_int_equal(sscanf(note,
                            "became CUBICSPLINE, with %lu more keys: within %lf degrees, other numbers within %lf",
                            &added, &degrees, &number),
                     3);
    assert_true(added > 0);
    assert_true(degrees > 0.0 && degrees <= 4.1e-6 * 57.29577951);
    free(said);
    const char *const others[] = {"convert '%s' --rate 30 -o curves.glb 2>&1",
                                  "convert '%s' --clip rest -o rest.glb 2>&1"};
    for (int i = 0; i < 2; i++) {
        said = program_run(NULL, others[i], file);
        assert_null(strstr(said, "became CUBICSPLINE"));
        free(said);
    }
    said = program_run(NULL, "convert curves.glb -o again.glb 2>&1");
    assert_null(strstr(said, "became CUBICSPLINE"));
    free(said);
}

/* A PNG of eight bytes and more is a picture to the writer. */
static void pictures_of_base_colours_are_written(void **state)
{
    (void)state;
    FILE *f = fopen("picture.gltf", "wb");
    assert_non_null(f);
    fputs("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{}],\"images\":[{\"uri\":\"unused.png\"},{\"name\":\"coat\","
          "\"uri\":\"data:image/png;base64,iVBORw0KGgoAAAAN\"},{\"uri\":\"outer.jpg\"}],\"textures\":[{\"source\":1},"
          "{\"source\":2}],\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":1}}},"
          "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}]}",
          f);
    assert_int_equal(fclose(f), 0);
    char *said = program_run(NULL, "convert picture.gltf " WRITTEN " --form embedded");
    assert_non_null(strstr(said, "\"images\":[{\"name\":\"coat\",\"bufferView\":0,\"mimeType\":\"image/png\"}]"));
    assert_null(strstr(said, "outer.jpg")); /* it is not there */
    assert_null(strstr(said, "\"baseColorTexture\":{\"index\":1}"));
    assert_non_null(strstr(said, "\"baseColorTexture\":{\"index\":0}"));
    free(said);
}

/* ---- outer images ---- */

static void put_file(const char *path, const char *data, size_t bytes)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(data, 1, bytes, f), bytes);
    assert_int_equal(fclose(f), 0);
}

#define PNG  "\x89PNG\r\n\x1a\none"
#define JPEG "\xff\xd8\xfftwo"
#define WEBP "RIFF\x04\0\0\0WEBPthree"
#define KTX2 "\xabKTX 20\xbb\r\n\x1a\nfour"

/* Two base colours, a normal map, two pictures of extensions, one that is missing and one that is none. */
static void put_pictures(void)
{
    static const char text[] =
        "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{}],\"images\":[{\"uri\":\"in/a%20b.png\"},{\"uri\":\"c.jpg\"},"
        "{\"uri\":\"d.webp\"},{\"uri\":\"e.ktx2\"},{\"uri\":\"missing.png\"},{\"uri\":\"text.png\"}],\"textures\":["
        "{\"source\":0},{\"source\":1},{\"source\":4},{\"source\":5}],\"materials\":[{\"pbrMetallicRoughness\":{"
        "\"baseColorTexture\":{\"index\":0}},\"normalTexture\":{\"index\":1}},{\"pbrMetallicRoughness\":{"
        "\"baseColorTexture\":{\"index\":2}}},{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":3}}}]}";
    mkdir("pictures", 0777);
    mkdir("pictures/in", 0777);
    mkdir("pictures/sub", 0777);
    put_file("pictures/a.gltf", text, sizeof text - 1);
    put_file("pictures/in/a b.png", PNG, sizeof PNG - 1);
    put_file("pictures/c.jpg", JPEG, sizeof JPEG - 1);
    put_file("pictures/d.webp", WEBP, sizeof WEBP - 1);
    put_file("pictures/e.ktx2", KTX2, sizeof KTX2 - 1);
    put_file("pictures/text.png", "text", 4);
}

/* The two that cannot be embedded are named, and nothing else; a second conversion changes nothing. */
static void a_glb_has_its_images(void **state)
{
    (void)state;
    put_pictures();
    free(program_run(NULL, "--version; rm -f pictures/*.glb pictures/sub/*"));
    const char *const written[] = {"pictures/a.glb", "pictures/sub/a.glb", "pictures/sub/a.gltf --form embedded"};
    for (int i = 0; i < 3; i++) {
        char *said = program_run(NULL, "convert pictures/a.gltf -o %s 2>&1", written[i]);
        assert_non_null(strstr(said, "a.gltf: warning: missing.png and 1 more are not in the file"));
        free(said);
        said = program_run(NULL, "--version; cat %.*s | tr -d '\\0'", (int)strcspn(written[i], " "), written[i]);
        assert_non_null(strstr(said, "\"mimeType\":\"image/png\""));
        assert_non_null(strstr(said, "\"mimeType\":\"image/jpeg\""));
        assert_non_null(strstr(said, "\"mimeType\":\"image/webp\""));
        assert_non_null(strstr(said, "\"mimeType\":\"image/ktx2\""));
        assert_non_null(strstr(said, "{\"uri\":\"missing.png\"},{\"uri\":\"text.png\"}]"));
        assert_true(i == 2 || (strstr(said, PNG) && strstr(said, JPEG)));
        assert_null(strstr(said, "c.jpg"));
        assert_null(strstr(said, "a%20b"));
        free(said);
    }
    free(program_run(NULL, "convert pictures/sub/a.glb -o pictures/again.glb"));
    program_says(0, "same", "--version >/dev/null && cmp pictures/a.glb pictures/again.glb && echo same");
}

/* What is written from the document: base colours. */
static void a_new_glb_has_its_base_colours(void **state)
{
    (void)state;
    put_pictures();
    char *said = program_run(NULL, "convert pictures/a.gltf " WRITTEN " -o pictures/new.glb 2>&1");
    assert_non_null(
        strstr(said, "a.gltf: warning: missing.png cannot be read: the file that is written is without it"));
    assert_non_null(strstr(said, "a.gltf: warning: text.png is not in the file"));
    free(said);
    said = program_run(NULL, "--version; cat pictures/new.glb | tr -d '\\0'");
    assert_non_null(strstr(said, "\"bufferView\":0,\"mimeType\":\"image/png\"},"));
    assert_null(strstr(said, "missing.png"));
    assert_non_null(strstr(said, "\"uri\":\"text.png\"}]"));
    assert_non_null(strstr(said, PNG));
    assert_null(strstr(said, "a%20b"));
    free(said);
}

/* Beside the images, a .gltf names them; no picture is warned of that nothing embeds. */
static void a_gltf_beside_its_images_names_them(void **state)
{
    (void)state;
    put_pictures();
    const char *const how[] = {"", WRITTEN};
    for (int i = 0; i < 2; i++) {
        char *said = program_run(NULL, "convert pictures/a.gltf %s -o pictures/b.gltf 2>&1", how[i]);
        assert_null(strstr(said, "warning"));
        free(said);
        said = program_run(NULL, "--version; cat pictures/b.gltf");
        assert_non_null(strstr(said, "\"uri\":\"in/a%20b.png\"}"));
        assert_null(strstr(said, "mimeType"));
        free(said);
    }
}

/* There and back, through a mirror: every byte. */
static void axes_convert_there_and_back_exactly(void **state)
{
    (void)state;
    const char *const tools[] = {"unity", "blender", "unreal", "unreal-mesh", "usd-z", "opencv-camera", "x,z,-y"};
    program_says(0, "written", "convert '" NKW_CHARACTER "' " WRITTEN " -o there.glb");
    for (size_t i = 0; i < sizeof tools / sizeof *tools; i++) {
        free(program_run(NULL, "convert '" NKW_CHARACTER "' --axes gltf:%s -o other.glb", tools[i]));
        free(program_run(NULL, "convert other.glb --axes %s:gltf -o back.glb", tools[i]));
        program_says(0, "same", "--version >/dev/null && cmp there.glb back.glb && echo same");
    }
}

static double number_of(const char *csv, int column)
{
    const char *at = strchr(csv, '\n') + 1;
    for (int i = 0; i < column; i++)
        at = strchr(at, ',') + 1;
    return strtod(at, NULL);
}

/* (x, y, z) of Y-up is (x, -z, y) of Z-up. */
static void up_and_scale_move_vertices(void **state)
{
    (void)state;
    free(program_run(NULL, "convert '" NKW_CHARACTER "' --up y:z --scale 100 -o z.glb"));
    char *from = program_run(NULL, "sample '" NKW_CHARACTER "' --clip walk --at 0.3 --what vertices");
    char *to = program_run(NULL, "sample z.glb --clip walk --at 0.3 --what vertices");
    const int x = 4;
    expect_near((float)number_of(to, x), 100.0 * number_of(from, x), 1e-3);
    expect_near((float)number_of(to, x + 1), -100.0 * number_of(from, x + 2), 1e-3);
    expect_near((float)number_of(to, x + 2), 100.0 * number_of(from, x + 1), 1e-3);
    free(from);
    free(to);
}

static void keys_of_ones_own_become_a_model(void **state)
{
    (void)state;
    FILE *f = fopen("own.csv", "wb");
    assert_non_null(f);
    fputs("name,time,tx,ty,tz\nball,0,0,0,0\nball,1,1,2,0\nball,2,0,0,0\n", f);
    assert_int_equal(fclose(f), 0);
    free(program_run(NULL, "convert own.csv -o own.glb"));
    program_says(0, "glTF 2.0", "info own.glb");
    program_says(0, "1 joint\n", "diff own.csv own.glb");
}

static void resampled_clips_are_measured(void **state)
{
    (void)state;
    char *said = program_run(NULL, "convert '" NKW_CHARACTER "' --rate 12 -o rate.glb");
    unsigned long before = 0, after = 0;
    double distance = 0.0;
    assert_int_equal(sscanf(strstr(said, "   0  "), "%*d %lu %lu %*u %*u %lf", &before, &after, &distance), 3);
    assert_true(before == 90 && after > 90 && distance < 0.06);
    free(said);
    program_says(0, "12/s", "info rate.glb");
    program_says(0, "walk", "diff --clip walk --tolerance 0.1 '" NKW_CHARACTER "' rate.glb");
    program_says(0, "written", "convert '" NKW_CHARACTER "' --rate 60 --tolerance 0.001 -o both.glb");
    FILE *f = fopen("century.csv", "wb");
    assert_non_null(f);
    fputs("name,time,tx,ty,tz\na,0,0,0,0\na,3e9,1,0,0\n", f);
    assert_int_equal(fclose(f), 0);
    program_says(1, "clip animation_0: more than 33554432 keys at this rate", "convert century.csv --rate 30 -o x.glb");
    program_says(1, "more than 33554432 keys at this rate", "convert century.csv --rate 0.02 -o x.glb");
    program_says(0, "written", "convert century.csv --rate 1e-6 -o x.glb");
    program_says(0, "walk", "diff --clip walk --tolerance 0.05 '" NKW_CHARACTER "' both.glb");
}

/* The end of a name selects the form in any case. */
static void ends_of_names_may_be_in_capitals(void **state)
{
    (void)state;
    free(program_run(NULL, "convert '" NKW_CHARACTER "' -o UPPER.GLTF"));
    free(program_run(NULL, "convert '" NKW_CHARACTER "' -o upper.gltf"));
    char *said = program_run(NULL, "info UPPER.GLTF --clips | tail -n +2");
    char *other = program_run(NULL, "info upper.gltf --clips | tail -n +2");
    assert_string_equal(said, other);
    free(said);
    free(other);
    FILE *f = fopen("UPPER.GLTF", "rb");
    assert_non_null(f);
    assert_int_equal(fgetc(f), '{');
    fclose(f);
    free(program_run(NULL, "sample '" NKW_CHARACTER "' --at 0 -o UPPER.JSON"));
    f = fopen("UPPER.JSON", "rb");
    assert_non_null(f);
    assert_int_equal(fgetc(f), '{');
    fclose(f);
}

static void one_clip_can_be_chosen(void **state)
{
    (void)state;
    free(program_run(NULL, "convert '" NKW_CHARACTER "' --clip wave -o wave.glb"));
    program_says(0, "1 clip,", "info --clips wave.glb");
    program_says(0, "20 joints", "diff --clip wave '" NKW_CHARACTER "' wave.glb");
    free(program_run(NULL, "convert '" NKW_CHARACTER "' --clip rest -o rest.glb"));
    program_says(0, "0 clips", "info --clips rest.glb");
}

/* The walk of a point along z that turns: in place only its height remains. */
static void root_motion_is_removed(void **state)
{
    (void)state;
    FILE *f = fopen("walk.csv", "wb");
    assert_non_null(f);
    fputs("name,time,tx,ty,tz,yaw,pitch,roll\nhips,0,1,1,0,20,0,0\nhips,1,2,1.5,3,40,0,0\nhips,2,3,1,6,90,0,0\n", f);
    assert_int_equal(fclose(f), 0);
    free(program_run(NULL, "convert walk.csv --in-place plane,yaw -o still.glb"));
    char *said = program_run(NULL, "sample still.glb --at 0,1,2 --what local");
    assert_int_equal(lines_with(said, ",hips,0,1,0,"), 2);
    assert_int_equal(lines_with(said, ",hips,0,1.5,0,"), 1);
    free(said);
    free(program_run(NULL, "convert walk.csv --in-place plane --root hips -o turning.glb"));
    said = program_run(NULL, "sample turning.glb --at 0 --what local");
    assert_int_equal(lines_with(said, ",hips,0,1,0,0,0.173648"), 1);
    free(said);
    program_says(1, "no such joint", "convert walk.csv --in-place plane --root tail -o x.glb");
    program_says(2, "not plane, height", "convert walk.csv --in-place all -o x.glb");
    program_says(2, "x.fbx: only glTF and OBJ are written", "convert walk.csv -o x.fbx");
    program_says(2, "x.bvh: only glTF is written", "reduce walk.csv -o x.bvh");
    program_says(0, "written", "convert walk.csv --form glb -o x.fbx");
    program_says(2, "only with --in-place", "convert walk.csv --root hips -o x.glb");
}

/* A cube of two sizes, without normals; what is made is said, and what the file has is not made again. */
static void missing_normals_and_tangents_are_made_on_request(void **state)
{
    (void)state;
    FILE *f = fopen("cube.obj", "wb");
    assert_non_null(f);
    fputs("v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
          "vt 0 1\nf 1/1 5/2 7/3 3/4\nf 2/1 4/2 8/3 6/4\nf 1/1 2/2 6/3 5/4\nf 3/1 7/2 8/3 4/4\nf 1/1 3/2 4/3 2/4\n"
          "f 8/1 7/2 5/3 6/4\n",
          f);
    assert_int_equal(fclose(f), 0);
    program_says(0, "normals made for 1 of 1 primitives, smooth up to 30 degrees",
                 "convert cube.obj --normals 30 -o cube.glb");
    program_says(0, "24 vertices, 12 triangles", "info cube.glb");
    program_says(0, "size 2 x 2 x 2, from -1 -1 -1 to 1 1 1", "info cube.glb");
    program_says(0, "\"box\":{\"low\":[-1.0,-1.0,-1.0],\"high\":[1.0,1.0,1.0]}", "info --json cube.glb | tr -d ' \\n'");
    program_says(0, "tangents made for 1 of 1 primitives", "convert cube.glb --normals 180 --tangents -o both.glb");
    program_says(0, "normals made for 0 of 1 primitives", "convert both.glb --normals 180 -o again.glb");
    char *said = program_run(NULL, "convert cube.glb -o kept.glb 2>&1");
    assert_int_equal(lines_with(said, "made"), 0);
    free(said);
    program_says(0, "triangles turned: 0", "convert cube.obj --fix-facing -o facing.glb");
    program_says(0, "multiplied by their transforms: 0", "convert cube.obj --apply-transforms -o applied.glb");
}

static void misuse_is_reported(void **state)
{
    (void)state;
    program_says(2, "not two tools", "convert --axes unity '" NKW_CHARACTER "' -o x.glb");
    program_says(2, "not two tools", "convert --axes unity:x,x,y '" NKW_CHARACTER "' -o x.glb");
    program_says(2, "not z:y or y:z", "convert --up z '" NKW_CHARACTER "' -o x.glb");
    program_says(2, "not with --axes", "convert --up z:y --axes unity:gltf '" NKW_CHARACTER "' -o x.glb");
    program_says(2, "not a positive number", "convert --scale 0 '" NKW_CHARACTER "' -o x.glb");
    program_says(2, "not an angle", "convert --normals -2 '" NKW_CHARACTER "' -o x.glb");
    program_says(2, "not in 0..1000000", "convert --rate -1 '" NKW_CHARACTER "' -o x.glb");
    program_says(1, "cannot be", "convert no-such-file.glb -o x.glb");
}

/* Under an armature of -90 degrees about x and scale 0.01: height y = 1 in the model, a walk along z to 2. */
static void up_is_that_of_the_model_under_a_rotated_armature(void **state)
{
    (void)state;
    FILE *f = fopen("armature.csv", "wb");
    assert_non_null(f);
    fputs("name,time,parent,tx,ty,tz,qx,qy,qz,qw,sx,sy,sz\n"
          "Armature,0,,,,,-0.70710678,0,0,0.70710678,0.01,0.01,0.01\n"
          "Hips,0,Armature,0,0,100,,,,,,,\nHips,1,Armature,0,-200,100,,,,,,,\n",
          f);
    assert_int_equal(fclose(f), 0);
    const struct {
        const char *part;
        double y, z;
    } cases[] = {{"plane", 1, 0}, {"height", 0, 2}};
    for (int i = 0; i < 2; i++) {
        double y, z;
        free(program_run(NULL, "convert armature.csv --in-place %s -o still.glb", cases[i].part));
        char *said = program_run(NULL, "sample still.glb --at 1 --what model | grep Hips | cut -d, -f18,19");
        assert_int_equal(sscanf(said, "%lf,%lf", &y, &z), 2);
        expect_near(y, cases[i].y, 1e-6);
        expect_near(z, cases[i].z, 1e-6);
        free(said);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_written_document_is_the_one_that_was_read),
        cmocka_unit_test(the_forms_of_a_file_have_the_same_content),
        cmocka_unit_test(real_files_are_written_as_they_are_read),
        cmocka_unit_test(files_of_other_formats_are_written_as_they_are_read),
        cmocka_unit_test(axes_and_units_become_those_of_gltf),
        cmocka_unit_test(the_tolerance_of_curves_is_printed),
        cmocka_unit_test(pictures_of_base_colours_are_written),
        cmocka_unit_test(a_glb_has_its_images),
        cmocka_unit_test(a_new_glb_has_its_base_colours),
        cmocka_unit_test(a_gltf_beside_its_images_names_them),
        cmocka_unit_test(axes_convert_there_and_back_exactly),
        cmocka_unit_test(up_and_scale_move_vertices),
        cmocka_unit_test(keys_of_ones_own_become_a_model),
        cmocka_unit_test(resampled_clips_are_measured),
        cmocka_unit_test(ends_of_names_may_be_in_capitals),
        cmocka_unit_test(one_clip_can_be_chosen),
        cmocka_unit_test(root_motion_is_removed),
        cmocka_unit_test(up_is_that_of_the_model_under_a_rotated_armature),
        cmocka_unit_test(missing_normals_and_tangents_are_made_on_request),
        cmocka_unit_test(misuse_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
