/* SPDX-License-Identifier: MIT */
/* nakawari reduce: fewer keys, within the distance that diff confirms; everything else of the file remains. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"

#include <math.h>
#include <stdlib.h>

#include "planted.h"
#include "samples.h"

/* The numbers of a clip in the report. */
typedef struct report {
    unsigned long before, after, bytes_before, bytes_after;
    double distance, floats;
} report;

static report report_of(const char *said, int clip)
{
    report r = {0, 0, 0, 0, 0.0, 0.0};
    const char *line = said;
    for (int i = 0; i < clip + 2; i++) {
        line = strchr(line, '\n');
        assert_non_null(line);
        line++;
    }
    assert_int_equal(sscanf(line, "%*d %lu %lu %lu %lu %lf %lf", &r.before, &r.after, &r.bytes_before, &r.bytes_after,
                            &r.distance, &r.floats),
                     6);
    return r;
}

static void diff_confirms_the_distance_that_was_measured(void **state)
{
    (void)state;
    char *said = program_run(NULL, "reduce --fewest '" NKW_CHARACTER "' --tolerance 0.02 -o reduced.glb");
    double most = 0.0;
    for (int clip = 0; clip < 3; clip++) {
        const report r = report_of(said, clip);
        assert_true(r.after <= r.before && r.bytes_after <= r.bytes_before);
        assert_true(r.distance <= 0.02);
        most = r.distance > most ? r.distance : most;
    }
    assert_true(report_of(said, 0).after < report_of(said, 0).before);
    assert_true(most > 0.0);
    free(said);
    int code;
    free(program_run(NULL, "diff '" NKW_CHARACTER "' reduced.glb --tolerance %.9g", 1.05 * most));
    free(program_run(&code, "diff '" NKW_CHARACTER "' reduced.glb --tolerance %.9g", 0.8 * most));
    assert_int_equal(code, 1);
}

static void lossless_reduction_has_no_difference(void **state)
{
    (void)state;
    planted p = planted_clean();
    for (int k = 0; k < PLANTED_KEYS; k++)
        p.scales[k][0] = p.scales[k][1] = p.scales[k][2] = 1.0f;
    planted_write(&p, "spare");
    char *said = program_run(NULL, "reduce --lossless --fewest spare.gltf --form glb -o lossless.glb");
    const report r = report_of(said, 0);
    assert_true(r.after < r.before);
    expect_near((float)r.distance, 0.0, 0.0);
    free(said);
    program_says(0, "3 joints", "diff spare.gltf lossless.glb");
}

static void keys_of_cubic_curves_keep_their_tangents(void **state)
{
    (void)state;
    planted p = planted_cubic();
    planted_write(&p, "cubic");
    char *said = program_run(NULL, "reduce cubic.gltf --tolerance 0.5 -o cubic.glb");
    assert_true(report_of(said, 0).distance <= 0.5);
    free(said);
    program_says(0, "CUBICSPLINE", "info cubic.glb");
    program_says(0, "kick", "diff --tolerance 0.55 cubic.gltf cubic.glb");
}

static void write_text(const char *path, const char *text)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_true(fputs(text, f) >= 0);
    assert_int_equal(fclose(f), 0);
}

/* Three keys on a line at 0, 1 and 2 s; a camera, extras, an extension, a view of an image. */
static void everything_else_of_the_file_remains(void **state)
{
    (void)state;
    write_text("kept.gltf",
               "{\"asset\":{\"version\":\"2.0\",\"extras\":{\"bufferView\":7,\"x\":0.1}},\"scene\":0,"
               "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"name\":\"eye\",\"camera\":0,\"extras\":{\"kept\":[1,2.5]}}],"
               "\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":0.7,\"znear\":0.01}}],"
               "\"extensionsUsed\":[\"EXT_own\"],\"extensions\":{\"EXT_own\":{\"bufferView\":2}},"
               "\"buffers\":[{\"byteLength\":52,\"uri\":\"data:application/octet-stream;base64,"
               "AAAAAAAAgD8AAABAAAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAQAAAAAAAAAAAa2VwdA==\"}],"
               "\"bufferViews\":[{\"buffer\":0,\"byteLength\":12},{\"buffer\":0,\"byteOffset\":12,\"byteLength\":36},"
               "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":4}],"
               "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"SCALAR\",\"min\":[0],"
               "\"max\":[2]},{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
               "\"animations\":[{\"samplers\":[{\"input\":0,\"output\":1}],\"extras\":5,"
               "\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}}]}]}");
    char *said = program_run(NULL, "reduce kept.gltf --form embedded");
    const char *const parts[] = {"\"extras\":{\"bufferView\":7,\"x\":0.1",
                                 "\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":0.",
                                 "\"extras\":{\"kept\":[1,2.5]}",
                                 "\"extensions\":{\"EXT_own\":{\"bufferView\":0}}",
                                 "\"extras\":5",
                                 "\"byteLength\":36", /* 4 of the extension, 8 of times, 24 of values */
                                 "\"count\":2,\"type\":\"VEC3\""};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if (!strstr(said, parts[i]))
            fail_msg("%s is not in %s", parts[i], said);
    assert_null(strstr(said, "\"count\":3"));
    free(said);
}

static void the_output_is_a_pipe_and_the_same_each_time(void **state)
{
    (void)state;
    program_says(0, "clip", "reduce - -o piped.glb < '" NKW_CHARACTER "'");
    program_says(0, "clip", "reduce '" NKW_CHARACTER "' -o named.glb");
    free(program_run(NULL, "reduce '" NKW_CHARACTER "' 2>report.txt >out.glb"));
    program_says(0, "written: ", "--version >/dev/null && cat report.txt");
    program_says(0, "same", "--version >/dev/null && cmp piped.glb named.glb && cmp out.glb named.glb && echo same");
    program_says(0, "walk", "reduce '" NKW_CHARACTER "' -o outer.gltf");
    program_says(0, "same", "--version >/dev/null && test -s outer.bin && echo same");
    program_says(0, "20 joints", "diff outer.gltf named.glb");
}

static void expect_within_the_tolerance(const char *file)
{
    free(program_run(NULL, "reduce '%s' --tolerance 0.01 -o reduce_real.glb", file));
    free(program_run(NULL, "diff --tolerance 0.0105 '%s' reduce_real.glb", file));
    free(program_run(NULL, "reduce --lossless '%s' -o reduce_real.glb", file));
    free(program_run(NULL, "diff --tolerance 1e-6 '%s' reduce_real.glb", file));
}

static void real_files_stay_within_the_tolerance(void **state)
{
    (void)state;
    each_sample(expect_within_the_tolerance);
}

static void misuse_and_missing_files_are_reported(void **state)
{
    (void)state;
    program_says(2, "not a distance", "reduce --tolerance -3 '" NKW_CHARACTER "' -o x.glb");
    program_says(2, "has no tolerance", "reduce --lossless -t 1 '" NKW_CHARACTER "' -o x.glb");
    program_says(2, "not glb, gltf or embedded", "reduce --form fbx '" NKW_CHARACTER "' -o x.glb");
    program_says(1, "no clip fly", "reduce --clip fly '" NKW_CHARACTER "' -o x.glb");
    program_says(1, "cannot be", "reduce no-such-file.glb -o x.glb");
    program_says(1, "cannot be written", "reduce '" NKW_CHARACTER "' -o no/such/folder.glb");
}

/* What sees far: an eased pan of 30 degrees, of a camera that is alone in a file without meshes. */
static void a_camera_keeps_its_angle(void **state)
{
    (void)state;
    FILE *f = fopen("pan.csv", "wb");
    assert_non_null(f);
    fputs("name,time,tx,ty,tz,yaw,pitch,roll\nwall,0,-5,0,0,,,\nwall2,0,5,3,0,,,\n", f);
    for (int i = 0; i <= 120; i++) {
        const double t = i / 120.0, yaw = 30.0 * t * t * (3.0 - 2.0 * t);
        fprintf(f, "Camera,%.9g,0,1,8,%.9g,0,0\n", 4.0 * t, yaw);
    }
    assert_int_equal(fclose(f), 0);
    free(program_run(NULL, "reduce pan.csv -o pan.glb"));
    char *said = program_run(NULL, "sample pan.glb --rate 50 --what local | grep Camera | cut -d, -f2,8-11");
    for (const char *line = said; line && *line; line = strchr(line, '\n') ? strchr(line, '\n') + 1 : NULL) {
        double t, q[4];
        assert_int_equal(sscanf(line, "%lf,%lf,%lf,%lf,%lf", &t, &q[0], &q[1], &q[2], &q[3]), 5);
        t /= 4.0;
        expect_near(2.0 * atan2(q[1], q[3]) * 57.29577951, 30.0 * t * t * (3.0 - 2.0 * t), 0.011);
    }
    free(said);
}

/* A second hand of 8 mm in a hall of 145 m: STEP keys, six degrees each second. */
static void a_small_part_of_a_large_scene_keeps_its_motion(void **state)
{
    (void)state;
    free(program_run(NULL, "reduce '" NKW_FIGURES "/../../tests/data/reported/watch.gltf' -o watch.glb"));
    program_says(0, "second_hand  rotation     STEP              61", "info watch.glb");
}

/* One key less in every array, and a JSON that needs more bytes than they: the file is copied. */
static void a_file_never_becomes_larger(void **state)
{
    (void)state;
    planted p = planted_clean();
    for (int k = 0; k < PLANTED_KEYS; k++)
        p.translations[k][1] = 1.5f;
    planted_write(&p, "small");
    program_says(0, "", "convert small.gltf -o small.glb");
    program_says(0, "note: nothing makes it smaller: it is copied", "reduce small.glb -o smaller.glb");
    program_says(0, "equal", "--version > /dev/null; cmp small.glb smaller.glb && echo equal");
    char *said = program_run(NULL, "reduce --fewest small.glb -o fewest.glb 2>&1");
    assert_null(strstr(said, "copied"));
    free(said);
    program_says(0, "differ", "--version > /dev/null; cmp small.glb fewest.glb | sed s/EOF/differ/");
}

/* The rotation turns; the translation is at rest in one file and the scale, which is 1 at rest, in both. */
static void channels_at_rest_are_left_out(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.rest_scale[0] = p.rest_scale[1] = p.rest_scale[2] = 1.25f;
    for (int k = 0; k < PLANTED_KEYS; k++)
        p.scales[k][0] = p.scales[k][1] = p.scales[k][2] = 1.25f;
    planted_write(&p, "rest");
    program_says(0, "1 channel left out: equal to the rest pose", "reduce --lossless rest.gltf -o rest_out.glb");
    char *said = program_run(NULL, "info rest_out.glb");
    assert_non_null(strstr(said, "rotation"));
    assert_non_null(strstr(said, "translation"));
    assert_int_equal(lines_with(said, " scale "), 0);
    free(said);
    program_says(0, "3 joints", "diff rest.gltf rest_out.glb");
    program_says(0, "", "check rest_out.glb");
    said = program_run(NULL, "reduce --keep-rest rest.gltf -o rest_kept.glb");
    assert_null(strstr(said, "left out"));
    free(said);
    program_says(0, " scale ", "info rest_kept.glb");
    p.scales[PLANTED_KEYS - 1][2] = nextafterf(1.25f, 2.0f); /* the last key, by one unit */
    planted_write(&p, "almost");
    said = program_run(NULL, "reduce --lossless almost.gltf -o rest_kept.glb");
    assert_null(strstr(said, "left out"));
    free(said);
    p = planted_clean(); /* a rest pose that the scale does not have */
    for (int k = 0; k < PLANTED_KEYS; k++)
        p.scales[k][0] = p.scales[k][1] = p.scales[k][2] = 1.25f;
    planted_write(&p, "other");
    said = program_run(NULL, "reduce --lossless other.gltf -o rest_kept.glb");
    assert_null(strstr(said, "left out"));
    free(said);
}

/* A rotation that is at rest as a negative quaternion, alone in its clip: one channel stays, with its ends. */
static void a_clip_at_rest_keeps_one_channel(void **state)
{
    (void)state;
    planted p = planted_clean();
    for (int k = 0; k < PLANTED_KEYS; k++)
        for (int c = 0; c < 4; c++) {
            p.rotations[k][c] = c == 3 ? -1.0f : 0.0f;
            if (c < 3)
                p.scales[k][c] = 1.0f, p.translations[k][c] = c == 1;
        }
    planted_write(&p, "still");
    program_says(0, "2 channels left out", "reduce still.gltf -o still.glb");
    program_says(0, "kick         1       1        2          0          2", "info still.glb");
    program_says(0, "knee   scale", "info still.glb");
    program_says(0, "3 joints", "diff still.gltf still.glb");
}

/* What is at rest lasts longest: a clip ends when it did. */
static void a_clip_ends_when_it_did(void **state)
{
    (void)state;
    write_text("wait.csv", "name,time,tx,ty,tz\nstill,0,1,2,3\nstill,4,1,2,3\n"
                           "other,0,3,2,1\nother,4,3,2,1\nmoves,0,0,0,0\nmoves,1,0,5,0\nmoves,2,1,0,0\n");
    program_says(0, "written", "convert wait.csv -o wait.glb");
    program_says(0, "1 channel left out", "reduce wait.glb -o waited.glb");
    program_says(0, " 2       2        5          0          4", "info waited.glb");
}

/* Values that are equal byte for byte are in the file once. */
static void equal_values_are_shared(void **state)
{
    (void)state;
    planted p = planted_clean();
    size_t outputs[2];
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < PLANTED_KEYS; k++)
            for (int c = 0; c < 3; c++) {
                p.translations[k][c] = 1.5f;
                p.scales[k][c] = i ? 1.5f : 1.25f;
            }
        planted_write(&p, "shared");
        program_says(0, "", "reduce shared.gltf --form embedded -o shared_out.gltf");
        char *text = program_run(NULL, "--version > /dev/null; grep -o '\"componentType\"' shared_out.gltf");
        outputs[i] = lines_with(text, "componentType");
        free(text);
    }
    assert_int_equal(outputs[0], outputs[1] + 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_camera_keeps_its_angle),
        cmocka_unit_test(a_small_part_of_a_large_scene_keeps_its_motion),
        cmocka_unit_test(diff_confirms_the_distance_that_was_measured),
        cmocka_unit_test(lossless_reduction_has_no_difference),
        cmocka_unit_test(keys_of_cubic_curves_keep_their_tangents),
        cmocka_unit_test(everything_else_of_the_file_remains),
        cmocka_unit_test(the_output_is_a_pipe_and_the_same_each_time),
        cmocka_unit_test(real_files_stay_within_the_tolerance),
        cmocka_unit_test(misuse_and_missing_files_are_reported),
        cmocka_unit_test(a_file_never_becomes_larger),
        cmocka_unit_test(equal_values_are_shared),
        cmocka_unit_test(channels_at_rest_are_left_out),
        cmocka_unit_test(a_clip_at_rest_keeps_one_channel),
        cmocka_unit_test(a_clip_ends_when_it_did),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
