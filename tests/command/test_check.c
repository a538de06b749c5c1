/* SPDX-License-Identifier: MIT */
/* nakawari check: each fault is planted in a clean file and is then the only finding. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"

#include <math.h>
#include <stdlib.h>

#include "planted.h"
#include "samples.h"

static size_t count_lines(const char *text)
{
    return lines_with(text, "\n");
}

/* Writes the file and fails unless check ends with `code` and prints `lines` lines, each with `part`. */
static void check_finds(const planted *p, int code, size_t lines, const char *part)
{
    int ended;
    planted_write(p, "planted");
    char *said = program_run(&ended, "check --all planted.gltf 2>&1");
    if (ended != code || count_lines(said) != lines || (lines && lines_with(said, part) != lines))
        fail_msg("exit code %d, not %d, or not %zu lines of '%s':\n%s", ended, code, lines, part, said);
    free(said);
}

static void clean_files_have_no_findings(void **state)
{
    (void)state;
    planted p = planted_clean();
    check_finds(&p, 0, 0, "");
}

static void times(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.times[2] = 0.25f;
    check_finds(&p, 1, 3, "key 2, 0.25 s: error: unsorted-time: 0.25 s before the key before it");
    p = planted_clean();
    p.times[2] = p.times[1];
    check_finds(&p, 1, 3, "key 2, 0.5 s: warning: duplicate-time: the time of the key before it");
    p = planted_clean();
    p.times[2] = nextafterf(p.times[1], 1.0f);
    check_finds(&p, 1, 3, "key 2, 0.50000006 s: warning: short-segment: 5.96e-08 s after");
    p = planted_clean();
    p.times[4] = NAN;
    check_finds(&p, 1, 3, "key 4, nan s: error: not-finite");
}

static void values_that_are_not_finite(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.translations[3][1] = INFINITY;
    check_finds(&p, 1, 1, "clip 0 kick: joint knee translation: key 3, 1.5 s: error: not-finite");
}

static void lengths_of_rotations(void **state)
{
    (void)state;
    planted p = planted_clean();
    for (int i = 0; i < 4; i++)
        p.rotations[1][i] *= 1.1f;
    check_finds(&p, 1, 1, "joint knee rotation: key 1, 0.5 s: error: not-unit: the length of the quaternion is 1.1");
    p = planted_clean();
    for (int i = 0; i < 4; i++)
        p.rotations[1][i] *= 0.998f;
    check_finds(&p, 1, 1, "warning: not-unit: the length of the quaternion is 0.998");
    p = planted_clean();
    p.rotations[1][3] = 0.94f; /* 0.9397 */
    check_finds(&p, 0, 1, "note: rounded-unit");
}

static void arcs(void **state)
{
    (void)state;
    planted p = planted_clean();
    for (int i = 0; i < 4; i++)
        p.rotations[1][i] = -p.rotations[1][i];
    check_finds(&p, 0, 2, "note: sign-flip: its sign is opposite");
    p = planted_clean();
    planted_turn(&p, 1, 0.0);
    planted_turn(&p, 2, 359.0);
    planted_turn(&p, 3, 420.0);
    planted_turn(&p, 4, 360.0);
    check_finds(&p, 0, 1, "key 2, 1 s: note: sign-flip: its sign is opposite to the key before it, 1 degree away");
    p = planted_clean();
    planted_turn(&p, 1, 200.0);
    check_finds(&p, 1, 2, "warning: over-half-turn");
    p = planted_clean();
    planted_turn(&p, 1, 180.0);
    p.rotations[2][2] = 0.0f, p.rotations[2][3] = 1.0f;
    check_finds(&p, 0, 2, "note: half-turn");
}

static void cubic_arcs(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.cubic = 1;
    memset(p.rotations, 0, sizeof p.rotations);
    for (int k = 0; k < PLANTED_KEYS; k++)
        planted_turn(&p, k, 10.0 * (k % 4));
    check_finds(&p, 0, 0, "");
    for (int i = 0; i < 4; i++)
        p.rotations[3 * 4 + 1][i] *= -1.0f;
    check_finds(&p, 1, 1, "key 4, 2 s: warning: long-way: CUBICSPLINE turns 330 degrees");
}

static void scales(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.scales[3][1] = -1.0f;
    check_finds(&p, 1, 1, "joint knee scale: key 3, 1.5 s: warning: non-positive-scale: scale 1.375 -1 1.375");
    p.scales[3][1] = 0.0f;
    check_finds(&p, 0, 1, "joint knee scale: key 3, 1.5 s: note: non-positive-scale");
    p = planted_clean();
    p.rest_scale[2] = -1.0f;
    check_finds(&p, 1, 1, "node knee: warning: non-positive-scale: scale 1 1 -1");
}

static void keys_that_waste_memory(void **state)
{
    (void)state;
    planted p = planted_clean();
    for (int k = 0; k < PLANTED_KEYS; k++)
        p.scales[k][0] = p.scales[k][1] = p.scales[k][2] = 1.0f;
    check_finds(&p, 0, 1, "joint knee scale: note: constant: 5 keys within a distance of 0: one is enough");
    p = planted_clean();
    for (int k = 0; k < PLANTED_KEYS; k++)
        p.translations[k][1] = 1.0f + 0.25f * (float)(k < 3 ? k : 4 - k);
    check_finds(&p, 0, 1, "joint knee translation: note: spare-keys: 2 of 5 keys can be dropped");
}

static void constant_tracks_with_tangents(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.cubic = 1;
    memset(p.rotations, 0, sizeof p.rotations);
    for (int k = 0; k < PLANTED_KEYS; k++)
        planted_turn(&p, k, 40.0);
    check_finds(&p, 0, 1, "joint knee rotation: note: constant: 5 keys within a distance of 0: one is enough");
    p.rotations[3 * 2 + 2][0] = 1.0f; /* the out-tangent of key 2: the values are equal, the curve is not constant */
    check_finds(&p, 0, 0, "");
    p.rotations[3 * 2 + 2][0] = 0.0f;
    p.rotations[3 * 3][0] = 1.0f; /* the in-tangent of key 3 */
    check_finds(&p, 0, 0, "");
    p.rotations[3 * 3][0] = 0.0f;
    p.rotations[0][0] = 1.0f; /* before the first key and after the last one there is no segment */
    p.rotations[3 * 4 + 2][0] = 1.0f;
    check_finds(&p, 0, 1, "note: constant");
}

static void loops(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_turn(&p, 4, 180.0);
    check_finds(&p, 0, 1, "clip 0 kick: joint knee: note: open-loop: the end of the clip is 2.");
    program_says(1, "open-loop", "check --strict planted.gltf");
    program_says(0, "", "check --no-notes --strict planted.gltf");
    FILE *f = fopen("loop.csv", "wb");
    assert_non_null(f);
    fputs("name,parent,time,tx,ty,tz\nhip,,0,0,0,0\nhip,,1,0.1,0.2,0.3\nknee,hip,0,0.7,1.3,0.9\n", f);
    assert_int_equal(fclose(f), 0);
    program_says(0, "joint hip: note: root-drift", "check loop.csv"); /* the knee moves with it */
}

static void vertices(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.weights[1][0] = 0.5f;
    check_finds(&p, 1, 1, "mesh skin: vertex 1: warning: weights-sum: primitive 0, 1 vertex");
    p = planted_clean();
    p.weights[2][0] = -0.75f;
    check_finds(&p, 1, 1,
                "mesh skin: vertex 2: error: bad-weight: primitive 0, 1 vertex: a weight is negative or "
                "not finite, the worst -0.75");
    p.weights[1][0] = -1.5f;
    check_finds(&p, 1, 1, "not finite, the worst -1.5");
    p = planted_clean();
    p.weights[2][0] = -0.75f;
    p.weights[0][1] = NAN;
    check_finds(&p, 1, 1,
                "vertex 0: error: bad-weight: primitive 0, 2 vertices: a weight is negative or not finite, "
                "the worst nan");
    p = planted_clean();
    p.joints[2][1] = 2;
    check_finds(&p, 1, 1, "mesh skin: vertex 2: error: joint-out-of-range: primitive 0, 1 vertex");
    p = planted_clean();
    p.joints[0][3] = 9;
    check_finds(&p, 1, 1, "mesh skin: vertex 0: warning: unused-joint-out-of-range");
}

static void inverse_bind_matrices(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.inverse_bind[1][0] = 0.0f;
    check_finds(&p, 1, 1, "skin bones: warning: singular-matrix: inverse bind matrix 1 of joint knee");
    p.inverse_bind[1][0] = NAN;
    check_finds(&p, 1, 1, "skin bones: error: not-finite: inverse bind matrix 1 of joint knee");
}

static void json_has_the_findings(void **state)
{
    (void)state;
    int code;
    planted p = planted_clean();
    p.scales[3][1] = -1.0f;
    planted_write(&p, "planted");
    char *json = program_run(&code, "check --json planted.gltf");
    assert_int_equal(code, 1);
    assert_non_null(strstr(json, "\"errors\": 0,\n \"warnings\": 1,\n \"notes\": 0,"));
    assert_non_null(strstr(json, "\"what\": \"non-positive-scale\",\n   \"clip\": 0,"));
    assert_non_null(strstr(json, "\"key\": 3,\n   \"time\": 1.5,"));
    free(json);
}

static void many_findings_are_cut(void **state)
{
    (void)state;
    planted p = planted_clean();
    for (int k = 0; k < PLANTED_KEYS; k++)
        p.scales[k][0] = -1.0f;
    planted_write(&p, "planted");
    program_says(1, "key 2, 1 s: warning: non-positive-scale: and more of these are not printed",
                 "check --all --most 2 planted.gltf");
}

static void many_files_are_checked(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_write(&p, "planted_a");
    program_says(0, "", "check planted_a.gltf planted_a.gltf");
    program_says(1, "no-such-file: ", "check planted_a.gltf no-such-file planted_a.gltf");
    p.scales[3][1] = -1.0f;
    planted_write(&p, "planted_b");
    program_says(1, "planted_b.gltf: clip 0", "check planted_a.gltf planted_b.gltf planted_a.gltf");
}

static void misuse_and_files_in_error(void **state)
{
    (void)state;
    program_says(2, "only one file can be the standard input", "check - - < /dev/null");
    program_says(0, "Usage: nakawari check", "check --help");
    program_says(2, "not a distance", "check --tolerance -3 x");
    program_says(2, "not a positive number", "check --most 0 x");
    program_says(1, "no-such-file: ", "check no-such-file");
    program_says(2, "FILE: missing", "check --strict");
}

/* Models that people use: no error and no warning. */
static void expect_no_alarm(const char *file)
{
    int code;
    char *said = program_run(&code, "check '%s' 2>&1", file);
    const size_t alarms = lines_with(said, ": warning: ") + lines_with(said, ": error: ");
    if (alarms != lines_with(said, "absent-image")) /* the pictures of some of them are not there */
        fail_msg("%s", said);
    free(said);
}

static void real_files_raise_no_alarm(void **state)
{
    (void)state;
    program_says(0, "", "check '" NKW_CHARACTER "'");
    each_sample(expect_no_alarm);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clean_files_have_no_findings),
        cmocka_unit_test(times),
        cmocka_unit_test(values_that_are_not_finite),
        cmocka_unit_test(lengths_of_rotations),
        cmocka_unit_test(arcs),
        cmocka_unit_test(cubic_arcs),
        cmocka_unit_test(scales),
        cmocka_unit_test(keys_that_waste_memory),
        cmocka_unit_test(constant_tracks_with_tangents),
        cmocka_unit_test(loops),
        cmocka_unit_test(vertices),
        cmocka_unit_test(inverse_bind_matrices),
        cmocka_unit_test(json_has_the_findings),
        cmocka_unit_test(many_findings_are_cut),
        cmocka_unit_test(many_files_are_checked),
        cmocka_unit_test(misuse_and_files_in_error),
        cmocka_unit_test(real_files_raise_no_alarm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
