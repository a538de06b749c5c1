/* SPDX-License-Identifier: MIT */
/* Files in error: a channel that holds the rest pose. */
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bad_channel_holds_the_rest_pose),
        cmocka_unit_test(the_other_commands_hold_it_too),
        cmocka_unit_test(all_channels_may_be_bad),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
