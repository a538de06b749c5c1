/* SPDX-License-Identifier: MIT */
/* Files in error: a channel that holds the rest pose, and what --repair mends. */
#include "program.h"

#include <math.h>
#include <stdlib.h>

#include "planted.h"

/* The local transform of the knee at a time, as CSV. */
static char *knee_at(const char *time)
{
    return program_run(NULL, "sample held.gltf --at %s 2>/dev/null | grep knee", time);
}

static void a_bad_channel_holds_the_rest_pose(void **state)
{
    (void)state;
    planted p = planted_clean();
    planted_write(&p, "held");
    program_says(0, "", "sample held.gltf --at 0.5");
    char *before = knee_at("0.5"), *held;
    p.translations[3][1] = NAN;
    planted_write(&p, "held");
    program_says(0, "held.gltf: warning: clip kick: joint knee translation: key 3: ", "sample held.gltf --at 0.5");
    program_says(1, "see nakawari check", "reduce --strict held.gltf -o held.glb");
    program_says(1, "/animations/0/channels/1: key 3: ", "sample --strict held.gltf --at 0.5");
    held = knee_at("0.5");
    assert_string_not_equal(before, held);
    assert_non_null(strstr(held, "0,1,0,0,0,0.342020"));
    assert_non_null(strstr(before, "0,1.5,0,0,0,0.342020"));
    free(before);
    free(held);
}

static void the_other_commands_hold_it_too(void **state)
{
    static const char *const commands[] = {"plot held.gltf -o held.svg", "reduce held.gltf -o held.glb",
                                           "bake held.gltf -o held.nkw", "diff held.gltf held.gltf",
                                           "convert held.gltf --rate 10 -o held.glb"};
    (void)state;
    planted p = planted_clean();
    for (int i = 0; i < 4; i++)
        p.rotations[2][i] *= 0.5f;
    planted_write(&p, "held");
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        program_says(0, "joint knee rotation: key 2: ", commands[i]);
    program_says(1, "error: not-unit", "check held.gltf");
    program_says(0, "rotation", "info held.gltf");
}

static void all_channels_may_be_bad(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.times[2] = 0.25f;
    planted_write(&p, "held");
    char *said = program_run(NULL, "sample held.gltf --at 0.5 2>&1");
    assert_int_equal(lines_with(said, "it holds the rest pose"), 3);
    free(said);
}

/* ---- repair ---- */

/* Repairs held.gltf into mended.glb: what is printed has `said`, and check finds neither errors nor warnings. */
static void repairs(const planted *p, const char *said)
{
    planted_write(p, "held");
    program_says(1, ": ", "check held.gltf");
    program_says(0, said, "convert --repair held.gltf -o mended.glb");
    program_says(0, "", "check --no-notes --strict mended.glb");
    program_says(0, "", "sample --strict --at 0 mended.glb");
}

static void keys_are_repaired(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.times[2] = 0.25f;
    repairs(&p, "held.gltf: repaired: channel of knee: 1 keys out of order sorted");
    char *times = program_run(NULL, "info --json mended.glb | grep -c '\"keys\": 5'");
    assert_true(atoi(times) >= 3);
    free(times);
    p = planted_clean();
    p.times[2] = p.times[1];
    repairs(&p, "1 keys that are not finite, of no length or at the time of another removed");
    p = planted_clean();
    p.translations[3][1] = NAN;
    repairs(&p, "1 keys that are not finite");
    p = planted_clean();
    for (int i = 0; i < 4; i++)
        p.rotations[2][i] *= 0.5f;
    repairs(&p, "1 keys normalised");
    char *knee = program_run(NULL, "sample mended.glb --at 1 | grep knee");
    assert_non_null(strstr(knee, "0.0871557")); /* sin 5 degrees */
    free(knee);
    p = planted_cubic();
    p.rotations[3 * 2 + 2][1] = NAN;
    repairs(&p, "tangents that are not finite set to 0");
    p = planted_clean();
    for (int k = 0; k < PLANTED_KEYS; k++)
        p.scales[k][0] = NAN;
    repairs(&p, "none of which can be used: it holds the rest pose");
    p = planted_clean();
    p.times[0] = -0.25f;
    repairs(&p, "note: clip kick begins at -0.25 s: its keys are written 0.25 s later");
}

static void vertices_are_repaired(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.weights[1][0] = 0.5f;
    repairs(&p, "mesh skin: 1 vertices whose joints or weights were wrong");
    p.weights[0][1] = NAN;
    p.weights[2][0] = -0.5f;
    repairs(&p, "mesh skin: 3 vertices");
    p = planted_clean();
    p.joints[2][1] = 9;
    p.joints[0][3] = 7;
    repairs(&p, "mesh skin: 2 vertices");
    p = planted_clean();
    memset(p.weights[1], 0, sizeof p.weights[1]);
    repairs(&p, "mesh skin: 1 vertices");
}

static void matrices_are_repaired(void **state)
{
    (void)state;
    planted p = planted_clean();
    char *good, *mended;
    planted_write(&p, "held");
    good = program_run(NULL, "sample held.gltf --at 0.7 --what vertices | cut -d, -f2-");
    p.inverse_bind[1][13] = 0.0f;
    p.inverse_bind[1][7] = -1.0f;
    repairs(&p, "skin bones: 1 inverse bind matrices transposed");
    mended = program_run(NULL, "sample mended.glb --at 0.7 --what vertices | cut -d, -f2-");
    assert_string_equal(good, mended);
    free(mended);
    p = planted_clean();
    p.inverse_bind[1][0] = NAN;
    repairs(&p, "skin bones: 1 inverse bind matrices made of the rest pose");
    mended = program_run(NULL, "sample mended.glb --at 0.7 --what vertices | cut -d, -f2-");
    assert_string_equal(good, mended);
    free(mended);
    free(good);
}

/* What cannot be mended is listed, and a file without a fault is not changed. */
static void what_remains_is_listed(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.scales[3][1] = -1.0f;
    planted_write(&p, "held");
    program_says(0, "mended.glb: clip 0 kick: joint knee scale: key 3, 1.5 s: warning: non-positive-scale",
                 "convert --repair held.gltf -o mended.glb");
    p = planted_clean();
    planted_write(&p, "held");
    char *said = program_run(NULL, "convert --repair held.gltf -o mended.glb 2>&1");
    assert_null(strstr(said, "repaired"));
    free(said);
    program_says(0, "", "convert held.gltf -o plain.glb");
    assert_int_equal(system("cmp -s mended.glb plain.glb"), 0);
    program_says(2, "--repair: not with -o FILE.obj", "convert --repair held.gltf -o mended.obj");
}

/* Without --repair a fault is copied, and said. */
static void copied_faults_are_said(void **state)
{
    (void)state;
    planted p = planted_clean();
    p.weights[1][0] = -0.5f;
    planted_write(&p, "held");
    program_says(0, "note: ", "convert held.gltf -o copied.glb");
    program_says(0, "what is wrong in the file is copied: see nakawari check", "convert held.gltf -o copied.glb");
    p = planted_clean();
    planted_write(&p, "held");
    char *said = program_run(NULL, "convert held.gltf -o copied.glb 2>&1");
    assert_null(strstr(said, "note"));
    free(said);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bad_channel_holds_the_rest_pose),
        cmocka_unit_test(the_other_commands_hold_it_too),
        cmocka_unit_test(all_channels_may_be_bad),
        cmocka_unit_test(keys_are_repaired),
        cmocka_unit_test(vertices_are_repaired),
        cmocka_unit_test(matrices_are_repaired),
        cmocka_unit_test(what_remains_is_listed),
        cmocka_unit_test(copied_faults_are_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
