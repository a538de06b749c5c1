/* SPDX-License-Identifier: MIT */
/* Files on which Assimp ends its process, or never ends: a message, and the next file is read. */
#include "program.h"

#include <stdlib.h>

#include "planted.h"

/* The address sanitizer ends a process that reads out of bounds itself. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define READER_ENDED "its reader ended without a document"
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define READER_ENDED "its reader ended without a document"
#endif
#if !defined(READER_ENDED)
#define READER_ENDED "its reader ended by signal "
#endif

/* SMD whose text ends in a name: Assimp 5.2 waits for the quote for ever. */
static const char endless[] = "version 1\n\nnodes\n  0 \"Triang";

/* A triangle with a joint whose weight is that of vertex `%d`: there are 3. */
static const char triangle[] = "xof 0303txt 0032\n"
                               "Frame Root {\n"
                               " FrameTransformMatrix {\n"
                               "  1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.5,0.0,0.0,1.0;;\n"
                               " }\n"
                               " Mesh M {\n"
                               "  3;\n  0.0;0.0;0.0;,\n  1.0;0.0;0.0;,\n  0.0;1.0;0.0;;\n  1;\n  3;0,1,2;;\n"
                               "  XSkinMeshHeader {\n   1;\n   1;\n   1;\n  }\n"
                               "  SkinWeights {\n   \"Root\";\n   1;\n   %d;\n   1.0;\n"
                               "   1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;;\n"
                               "  }\n }\n}\n"
                               "AnimationSet Wave {\n Animation {\n  { Root }\n  AnimationKey {\n   2;\n   2;\n"
                               "   0;3;0.0,0.0,0.0;;,\n   4800;3;0.0,2.0,0.0;;;\n  }\n }\n}\n";

static void write_text(const char *name, const char *format, int number)
{
    FILE *f = fopen(name, "wb");
    assert_non_null(f);
    assert_true(fprintf(f, format, number) > 0);
    assert_int_equal(fclose(f), 0);
}

/* Whether the system has processes: elsewhere all is read in the program, and a fault ends it. */
static void need_processes(void)
{
#if !defined(__unix__) && !defined(__APPLE__)
    skip();
#endif
}

static void an_endless_reader_is_ended(void **state)
{
    (void)state;
    need_processes();
    write_text("endless.smd", endless, 0);
    program_says(1, "endless.smd: its reader was ended by signal ", "info --read-limit 1 endless.smd");
    program_says(2, "not in 1..1000000", "info --read-limit 0 endless.smd");
}

static void a_reader_that_a_signal_ends_is_reported(void **state)
{
    (void)state;
    need_processes();
    write_text("outside.x", triangle, 90000000);
    program_says(1, "outside.x: " READER_ENDED, "info outside.x");
    program_says(1, "outside.x: " READER_ENDED, "convert --normals 30 outside.x -o outside.glb");
}

static void the_next_file_is_read(void **state)
{
    (void)state;
    need_processes();
    planted p = planted_clean();
    p.weights[1][0] = 0.5f;
    planted_write(&p, "planted_next");
    write_text("outside.x", triangle, 90000000);
    int code;
    char *said = program_run(&code, "check outside.x planted_next.gltf 2>&1");
    assert_non_null(strstr(said, "outside.x: " READER_ENDED));
    assert_non_null(strstr(said, "weights-sum"));
    assert_int_equal(code, 1);
    free(said);
}

/* Names, numbers, matrices, keys: all that is printed is the same. */
static void nothing_is_lost_between_the_processes(void **state)
{
    static const char *const commands[] = {"info --json",
                                           "sample --at 0,0.25,1",
                                           "sample --what vertices --at 0.5",
                                           "sample --what matrices --at 0.5",
                                           "check --json",
                                           "convert --form embedded",
                                           "convert --normals 30 --tangents --form embedded",
                                           "convert --form embedded --apply-transforms --fix-facing"};
    (void)state;
    write_text("inside.x", triangle, 1);
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        int code, other;
        char *apart = program_run(&code, "%s inside.x 2>&1", commands[i]);
        char *within = program_run(&other, "%s --in-process inside.x 2>&1", commands[i]);
        assert_string_equal(apart, within);
        assert_int_equal(code, other);
        assert_true(strlen(apart) > 100 || i == 4);
        free(apart);
        free(within);
    }
}

static void the_standard_input_is_read_apart(void **state)
{
    (void)state;
    need_processes();
    write_text("inside.x", triangle, 1);
    write_text("outside.x", triangle, 90000000);
    program_says(0, "Wave", "info - < inside.x");
    program_says(1, "-: " READER_ENDED, "info - < outside.x");
}

/* Matrix keys: a turn by 90 degrees about z, a mirror, a column of zeros, and a turn by 180 degrees. */
static void mirrored_keys_have_a_negative_scale_and_flat_ones_the_rotation_beside_them(void **state)
{
    (void)state;
    write_text("mirror.x",
               "xof 0303txt 0032\nAnimTicksPerSecond {\n %d;\n}\nFrame Root {\n FrameTransformMatrix {\n"
               "  1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;;\n }\n}\n"
               "AnimationSet Wave {\n Animation {\n  { Root }\n  AnimationKey {\n   4;\n   4;\n"
               "   0;16;0.0,1.0,0.0,0.0,-1.0,0.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;;,\n"
               "   1;16;-1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;;,\n"
               "   2;16;1.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;;,\n"
               "   3;16;-1.0,0.0,0.0,0.0,0.0,-1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;;;\n  }\n }\n}\n",
               1);
    char *said = program_run(NULL, "sample --strict --at 0,1,2,3 mirror.x 2>&1");
    assert_non_null(strstr(said, "keys mirror or have no size: they keep the rotation beside them"));
    assert_non_null(strstr(said, "keys mirror: they have a negative scale x"));
    assert_int_equal(lines_with(said, "0.707106"), 1);
    assert_int_equal(lines_with(said, ",1,-1,1,1"), 1);
    assert_int_equal(lines_with(said, ",1,1,0,1"), 1);
    free(said);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_endless_reader_is_ended),
        cmocka_unit_test(a_reader_that_a_signal_ends_is_reported),
        cmocka_unit_test(the_next_file_is_read),
        cmocka_unit_test(nothing_is_lost_between_the_processes),
        cmocka_unit_test(the_standard_input_is_read_apart),
        cmocka_unit_test(mirrored_keys_have_a_negative_scale_and_flat_ones_the_rotation_beside_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
