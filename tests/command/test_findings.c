/* SPDX-License-Identifier: MIT */
/* nakawari check: what it finds in scenes, skins, motions and in the text of a file, and how it sums up. */
#include "program.h"

#include <math.h>
#include <stdlib.h>

#include "planted.h"

static void write_file(const char *name, const char *text)
{
    FILE *f = fopen(name, "wb");
    assert_non_null(f);
    assert_true(fputs(text, f) >= 0);
    assert_int_equal(fclose(f), 0);
}

/* Replaces a part of found.gltf, which must be in it. */
static void edit(const char *from, const char *to)
{
    static char text[1 << 16], edited[1 << 16];
    FILE *f = fopen("found.gltf", "rb");
    assert_non_null(f);
    text[fread(text, 1, sizeof text - 1, f)] = 0;
    assert_int_equal(fclose(f), 0);
    char *at = strstr(text, from);
    assert_non_null(at);
    snprintf(edited, sizeof edited, "%.*s%s%s", (int)(at - text), text, to, at + strlen(from));
    write_file("found.gltf", edited);
}

/* Fails unless check prints one line of the kind with `detail`, and no line of another kind in `others`. */
static void finds(const char *severity, const char *kind, const char *detail)
{
    char part[128];
    int code;
    char *said = program_run(&code, "check --all --only %s found.gltf 2>&1", kind);
    snprintf(part, sizeof part, ": %s: %s: ", severity, kind);
    if (lines_with(said, "\n") != lines_with(said, part) || lines_with(said, part) == 0 || !strstr(said, detail))
        fail_msg("no lines of '%s' alone with '%s':\n%s", part, detail, said);
    assert_int_equal(code, strcmp(severity, "note") != 0);
    free(said);
}

static void finds_in(const planted *p, const char *severity, const char *kind, const char *detail)
{
    planted_write(p, "found");
    finds(severity, kind, detail);
}

static void finds_nothing(void)
{
    program_says(0, "", "check --strict found.gltf");
}

/* ---- tracks ---- */

static void times_before_zero(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.times[0] = -0.25f;
    finds_in(&p, "warning", "negative-time", "key 0, -0.25 s");
}

static void a_key_far_from_the_others(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.times[4] = 10000.0f;
    finds_in(&p, "warning", "outlier-time", "key 4, 10000 s");
    p = planted_clean();
    for (int k = 1; k < PLANTED_KEYS; k++)
        p.times[k] += 1000.0f;
    finds_in(&p, "warning", "outlier-time", "key 0, 0 s");
}

static void tangents_that_explode(void **state)
{
    (void)state;
    planted p = planted_cubic();
    planted_write(&p, "found");
    program_says(0, "", "check --only overshoot found.gltf");
    p.rotations[3 * 2 + 2][1] = 1e6f;
    finds_in(&p, "warning", "overshoot",
             "key 2, 1 s: warning: overshoot: the out-tangent moves the curve by up to 7.41e+04");
    p = planted_cubic();
    p.rotations[3 * 2][3] = -1e6f;
    finds_in(&p, "warning", "overshoot", "key 2, 1 s: warning: overshoot: the in-tangent");
}

/* 30 keys of a slow turn: CSV. The key at `spike` is `height` above the others; -1: none. */
static void write_wave(int spike, double height)
{
    char text[4096] = "name,parent,time,tx,ty,tz\n";
    for (int k = 0; k < 30; k++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "hand,,%.4f,%.6f,%.6f,0\n", k / 30.0,
                 0.5 * sin(k * 6.2831853 / 29.0), k == spike ? height : 0.0);
    write_file("found.csv", text);
}

static void a_glitch_of_one_frame(void **state)
{
    (void)state;
    write_wave(-1, 0.0);
    program_says(0, "", "check --only spike found.csv");
    write_wave(11, 0.5);
    program_says(1, "joint hand translation: key 11, 0.36", "check --only spike found.csv");
    write_wave(11, 0.0301); /* less than a 25th of the model's size, which is 1 */
    program_says(0, "", "check --only spike found.csv");
}

/* ---- skins and scenes ---- */

static void inverse_bind_matrices_by_rows(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.inverse_bind[1][13] = 0.0f;
    p.inverse_bind[1][7] = -1.0f;
    finds_in(&p, "error", "transposed-matrix", "of joint knee: its last row is 0 -1 0 1, not 0 0 0 1");
    p = planted_clean();
    p.inverse_bind[1][15] = 100.0f;
    finds_in(&p, "error", "not-affine", "0 0 0 100");
}

static void inverse_bind_matrices_of_another_size(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_write(&p, "found");
    program_says(0, "", "check --only scaled-matrix found.gltf");
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 16; i++)
            p.inverse_bind[j][i] *= i % 4 < 3 ? 100.0f : 1.0f;
    finds_in(&p, "warning", "scaled-matrix", "joints scale vertices by 100 at rest");
}

static void joints_outside_the_scene(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_write(&p, "found");
    edit("\"scenes\":[{\"nodes\":[0,2]}]", "\"scenes\":[{\"nodes\":[2]}]");
    finds("warning", "joint-outside-scene", "2 joints are not in the scene of its mesh, as hip");
    planted_write(&p, "found");
    edit("\"scenes\":[{\"nodes\":[0,2]}]", "\"scenes\":[{\"nodes\":[0,2]},{}]");
    finds("warning", "empty-scene", "scene");
}

static void skeletons_that_do_not_have_the_joints(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_write(&p, "found");
    edit("\"joints\":[0,1]", "\"skeleton\":0,\"joints\":[0,1]");
    finds_nothing();
    edit("\"skeleton\":0", "\"skeleton\":1");
    finds("warning", "wrong-skeleton", "joint hip is not below its skeleton, knee");
}

static void equal_names(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_write(&p, "found");
    edit("\"knee\"", "\"hip\"");
    finds("note", "equal-names", "2 joints have this name");
}

/* ---- the text of the file ---- */

static void matrices_of_animated_nodes(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_write(&p, "found");
    edit("\"translation\":[0,1,0],\"scale\":[1,1,1]", "\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0,1,0,1]");
    finds("error", "animated-matrix", "node knee");
}

static void bounds(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_write(&p, "found");
    edit("\"count\":5,\"type\":\"SCALAR\"", "\"count\":5,\"type\":\"SCALAR\",\"min\":[0],\"max\":[2]");
    edit("\"count\":3,\"type\":\"VEC3\"", "\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,2,0]");
    finds_nothing();
    edit("\"max\":[2]", "\"max\":[3]");
    finds("warning", "wrong-bounds", "min or max of accessor 0 is 1 from its numbers");
    edit("\"max\":[3]", "\"max\":[2]");
    edit("\"max\":[1,2,0]", "\"max\":[1,2.25,0]");
    finds("warning", "wrong-bounds", "mesh skin: warning: wrong-bounds: min or max of accessor 5 is 0.25");
}

static void images_that_are_not_there(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_write(&p, "found");
    edit("\"skins\"", "\"images\":[{\"uri\":\"no%20such.png\"},{\"uri\":\"found.bin\"}],\"skins\"");
    finds("warning", "absent-image", "image 0: no such.png cannot be read");
}

/* ---- motions ---- */

static void a_root_that_drifts(void **state)
{
    (void)state;
    write_file("found.csv", "name,parent,time,tx,ty,tz\nhip,,0,0,0,0\nhip,,1,2,0,0\nknee,hip,0,0,1,0\n"
                            "knee,hip,0.5,0,1.5,0\nknee,hip,1,0,1,0\n");
    program_says(0, "joint hip: note: root-drift: it moves by 2 0 0 from start to end", "check found.csv");
    program_says(0, "", "check --only open-loop --strict found.csv");
    write_file("found.csv", "name,parent,time,tx,ty,tz\nhip,,0,0,0,0\nhip,,1,2,0,0\nknee,hip,0,0,1,0\n"
                            "knee,hip,1,0,2,0\n");
    program_says(0, "joint knee: note: open-loop", "check found.csv");
}

/* One wave of 60 keys from phase `start` to `end` in turns: at whole turns it closes, at a half only its place does. */
static void write_swing(double turns)
{
    char text[8192] = "name,parent,time,tx,ty,tz\n";
    for (int k = 0; k <= 60; k++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "hand,,%.6f,%.8f,0,0\n", k / 60.0,
                 sin(k / 60.0 * turns * 6.283185307));
    write_file("found.csv", text);
}

static void seams_of_velocity(void **state)
{
    (void)state;
    write_swing(1.0);
    program_says(0, "", "check --strict --only open-loop,velocity-seam,root-drift found.csv");
    write_swing(0.5); /* the velocity is pi at the start, -pi at the end */
    program_says(0, "joint hand: note: velocity-seam: from the end to the start its velocity changes by 6.28",
                 "check found.csv");
}

/* Four steps of 1 m; in the first half of each the foot is on the ground and moves by `slide`, then it is lifted. */
static void write_steps(double slide)
{
    char text[1 << 14] = "name,parent,time,tx,ty,tz\nhip,,0,0,1,0\nhip,,4,4,1,0\n";
    for (int k = 0; k < 4; k++)
        for (int half = 0; half < 3; half++) {
            const double x = k + (half == 0 ? 0.0 : half == 1 ? slide : slide + (1.0 - slide) / 2.0);
            snprintf(text + strlen(text), sizeof text - strlen(text), "LeftFoot,,%.4f,%.6f,%.4f,0\n", k + 0.25 * half,
                     x, half == 2 ? 0.3 : 0.0);
        }
    snprintf(text + strlen(text), sizeof text - strlen(text), "LeftFoot,,4,4,0,0\n");
    write_file("found.csv", text);
}

static void feet_that_slide(void **state)
{
    (void)state;
    write_steps(0.0);
    program_says(0, "", "check --strict --only sliding-foot found.csv");
    write_steps(0.6);
    program_says(0, "joint LeftFoot: note: sliding-foot: on the ground it slides by 2.", "check found.csv");
}

/* Axes that FBX states: z is up, so what moves along y slides; with y up it rises. */
static void feet_slide_on_the_ground_of_the_file(void **state)
{
    (void)state;
    int code;
    free(program_run(&code, "info '" NKW_FIGURES "/../../tests/data/import/fbx/axes.fbx' >/dev/null 2>&1"));
    if (code != 0)
        return;
    const char *const to_foot = "--version >/dev/null; sed -e 's/::box/::LeftFoot/' -e 's/\"d|Z\"$/\"d|Y\"/' "
                                "'" NKW_FIGURES "/../../tests/data/import/fbx/axes.fbx' > found.fbx";
    free(program_run(NULL, "%s", to_foot));
    program_says(0, "joint LeftFoot: note: sliding-foot: on the ground it slides by 20 of the 20", "check found.fbx");
    free(program_run(NULL, "--version >/dev/null; sed -e 's/\"UpAxis\",\\(.*\\),2$/\"UpAxis\",\\1,1/' -e "
                           "'s/\"FrontAxis\",\\(.*\\),1$/\"FrontAxis\",\\1,2/' found.fbx > rises.fbx"));
    program_says(0, "axes up y", "info rises.fbx");
    char *said = program_run(NULL, "check rises.fbx");
    assert_null(strstr(said, "sliding-foot"));
    free(said);
}

/* ---- the summary ---- */

static void the_worst_of_each_kind_is_printed(void **state)
{
    (void)state;
    int code;
    planted p = planted_clean();
    p.scales[1][1] = -1.0f;
    p.scales[3][1] = -4.0f;
    p.scales[2][2] = -2.0f;
    p.translations[3][1] = INFINITY;
    planted_write(&p, "found");
    char *said = program_run(&code, "check found.gltf");
    assert_int_equal(lines_with(said, "\n"), 2);
    const char *first = strstr(said, "error: not-finite"), *second = strstr(said, "non-positive-scale");
    assert_true(first && second && first < second);
    assert_non_null(strstr(said, "key 3, 1.5 s: warning: non-positive-scale: scale 1.375 -4 1.375 (the worst of 3)"));
    free(said);
    program_says(1, "key 2, 1 s: warning: non-positive-scale", "check --all found.gltf");
    said = program_run(&code, "check --only not-finite found.gltf");
    assert_int_equal(lines_with(said, "\n"), 1);
    free(said);
    program_says(0, "", "check --only weights-sum,open-loop found.gltf");
    program_says(2, "no kind of finding", "check --only weights-sum, found.gltf");
    program_says(2, "no kind of finding", "check --only weight found.gltf");
}

static void json_has_a_schema_and_kinds(void **state)
{
    (void)state;
    int code;
    planted p = planted_clean();
    p.scales[3][1] = -1.0f;
    planted_write(&p, "found");
    char *json = program_run(&code, "check --json found.gltf");
    assert_int_equal(strncmp(json, "{\n \"schema\": 1,\n \"file\": \"found.gltf\",", 37), 0);
    assert_non_null(strstr(json, "\"what\": \"non-positive-scale\",\n   \"severity\": \"warning\",\n   \"count\": 1"));
    free(json);
    json = program_run(NULL, "info --json found.gltf");
    assert_int_equal(strncmp(json, "{\n \"schema\": 1,\n \"file\": \"found.gltf\",", 37), 0);
    free(json);
}

static void a_file_that_cannot_be_read_is_an_object_too(void **state)
{
    static const char *const commands[] = {"check", "info"};
    (void)state;
    write_file("broken.gltf", "{\"asset\":{\"version\":\"2.0\"},\"nodes\":7}");
    for (int i = 0; i < 2; i++) {
        int code;
        char *json = program_run(&code, "%s --json broken.gltf 2>/dev/null", commands[i]);
        assert_int_equal(code, 1);
        assert_non_null(
            strstr(json, "\"file\": \"broken.gltf\",\n \"error\": {\n  \"place\": \"/nodes\",\n  \"reason\": \""));
        free(json);
        json = program_run(&code, "%s --json no-such-file 2>/dev/null", commands[i]);
        assert_int_equal(code, 1);
        assert_non_null(
            strstr(json, "\"file\": \"no-such-file\",\n \"error\": {\n  \"place\": \"\",\n  \"reason\": \"cannot"));
        free(json);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(times_before_zero),
        cmocka_unit_test(a_key_far_from_the_others),
        cmocka_unit_test(tangents_that_explode),
        cmocka_unit_test(a_glitch_of_one_frame),
        cmocka_unit_test(inverse_bind_matrices_by_rows),
        cmocka_unit_test(inverse_bind_matrices_of_another_size),
        cmocka_unit_test(joints_outside_the_scene),
        cmocka_unit_test(skeletons_that_do_not_have_the_joints),
        cmocka_unit_test(equal_names),
        cmocka_unit_test(matrices_of_animated_nodes),
        cmocka_unit_test(bounds),
        cmocka_unit_test(images_that_are_not_there),
        cmocka_unit_test(a_root_that_drifts),
        cmocka_unit_test(seams_of_velocity),
        cmocka_unit_test(feet_that_slide),
        cmocka_unit_test(feet_slide_on_the_ground_of_the_file),
        cmocka_unit_test(the_worst_of_each_kind_is_printed),
        cmocka_unit_test(json_has_a_schema_and_kinds),
        cmocka_unit_test(a_file_that_cannot_be_read_is_an_object_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
