/* SPDX-License-Identifier: MIT */
/*
 * Every pair of options of every subcommand, over files of several clips: the program ends by itself with 0, 1 or 2, and
 * what it has written with 0 is read again. Under the sanitizers an error of memory is another code.
 */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"

#include <stdlib.h>

#define MOST 32

typedef struct subcommand {
    const char *name, *reads; /* what reads its output again; NULL: nothing */
    const char *end; /* of the name of its output */
    const char *options[MOST]; /* with a value that is not the default */
} subcommand;

#define CONVERT_OPTIONS                                                                                                \
    "--clip=1", "--clip=2", "--clip=rest", "--rate=7", "--tolerance=0.001", "--tolerance=0.1", "--axes=gltf:unity",    \
        "--axes=x,z,-y:-x,y,z", "--axes=keep", "--unit=cm", "--up=z:y", "--v=up", "--scale=0.01", "--in-place=plane",  \
        "--in-place=height,yaw", "--root=1", "--form=glb", "--form=embedded", "--normals=40", "--tangents",            \
        "--fix-facing", "--apply-transforms", "--time=0.5", "--size=2", "--strict", "--embed", "--repair"

/* --watch does not end; --quiet, --output and --help change no result. */
static const subcommand subcommands[] = {
    {"bake",
     NULL,
     "out",
     {"--clip=1", "--clip=hop", "--as=compact", "--as=reduced", "--as=palette", "--tolerance=0.01", "--rate=7",
      "--skin=0", "--skin=1", "--strict"}},
    {"check",
     NULL,
     NULL,
     {"--json", "--all", "--only=open-loop,spike", "--strict", "--no-notes", "--tolerance=0.01", "--most=1"}},
    {"convert", "info", "out.glb", {CONVERT_OPTIONS}},
    {"convert", "info", "out.obj", {CONVERT_OPTIONS}},
    {"exercise",
     NULL,
     "out",
     {"--clip=1", "--clip=2", "--joint=1", "--keys=4", "--keys=1", "--step=0.3", "--trace=0.4", "--position=bspline",
      "--orientation=euler", "--rule=library", "--check='" NKW_FIGURES "/../examples/student.csv'", "--tolerance=0.01",
      "--angles=degrees", "--matrix=rows", "--object='" NKW_FIGURES "/../../tests/data/import/bar.obj'"}},
    {"info", NULL, NULL, {"--clips", "--reduced", "--tolerance=0.01", "--json"}},
    {"parts", NULL, "out.json", {"--bones=2", "--bones=2,4", "--space=bind", "--v=up"}},
    {"plot",
     NULL,
     "out.svg",
     {"--clip=1", "--clip=hop", "--joint=1", "--joint=1,2", "--what=rotation", "--what=path", "--what=euler",
      "--order=zyx", "--most=2", "--strict"}},
    {"reduce",
     "info",
     "out.glb",
     {"--clip=1", "--clip=2", "--tolerance=0.001", "--tolerance=0.1", "--lossless", "--fewest", "--keep-rest",
      "--form=glb", "--form=embedded", "--strict"}},
    {"sample",
     NULL,
     "out.csv",
     {"--clip=1", "--clip=all", "--clip=rest", "--at=0,0.5,9", "--rate=3", "--what=model", "--what=palette",
      "--what=vertices", "--what=weights", "--json", "--raw", "--strict"}},
};

static const char *const files[] = {NKW_CHARACTER, NKW_KEYS};

/* The long name, without its value. */
static size_t name_length(const char *option)
{
    return strcspn(option, "=");
}

static void run_pair(const subcommand *s, const char *file, const char *first, const char *second)
{
    int code;
    char output[64] = "";
    if (s->end)
        snprintf(output, sizeof output, "-o pair-%s-%s", s->name, s->end);
    free(program_run(&code, "%s '%s' %s %s %s >/dev/null 2>&1", s->name, file, first, second, output));
    if (code < 0 || code > 2)
        fail_msg("%s %s %s %s ends with %d", s->name, file, first, second, code);
    if (code != 0 || !s->reads)
        return;
    free(program_run(&code, "%s 'pair-%s-%s' >/dev/null 2>&1", s->reads, s->name, s->end));
    if (code != 0)
        fail_msg("%s %s %s %s has written a file that %s refuses", s->name, file, first, second, s->reads);
}

static void run_pairs(const subcommand *s)
{
    for (size_t f = 0; f < sizeof files / sizeof *files; f++)
        for (int i = 0; i < MOST && s->options[i]; i++) {
            run_pair(s, files[f], s->options[i], "");
            for (int k = i + 1; k < MOST && s->options[k]; k++)
                if (name_length(s->options[i]) != name_length(s->options[k]) ||
                    strncmp(s->options[i], s->options[k], name_length(s->options[i])) != 0)
                    run_pair(s, files[f], s->options[i], s->options[k]);
        }
}

static void every_pair_of_options_ends_and_writes_what_is_read(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof subcommands / sizeof *subcommands; i++)
        run_pairs(&subcommands[i]);
}

/* Each option that the help prints is in the list above. */
static void every_option_is_paired(void **state)
{
    (void)state;
    const char *const others[] = {"--output",     "--quiet",      "--help",      "--watch",
                                  "--bvh-offset", "--in-process", "--read-limit"};
    const size_t other_count = sizeof others / sizeof *others;
    for (size_t i = 0; i < sizeof subcommands / sizeof *subcommands; i++) {
        const subcommand *s = &subcommands[i];
        char *help = program_run(NULL, "%s --help", s->name);
        for (const char *line = help; line; line = strchr(line + 1, '\n')) {
            const char *option = strstr(line, "--"), *end = strchr(line + 1, '\n');
            size_t indent = strspn(line, "\n ");
            if (!option || (end && option > end) || (option != line + indent && strncmp(option - 2, ", ", 2) != 0))
                continue;
            size_t length = strcspn(option, "= ,\n");
            int found = 0;
            for (int k = 0; k < MOST && s->options[k]; k++)
                found |= name_length(s->options[k]) == length && strncmp(s->options[k], option, length) == 0;
            for (size_t k = 0; k < other_count; k++)
                found |= strlen(others[k]) == length && strncmp(others[k], option, length) == 0;
            if (!found)
                fail_msg("%s: %.*s is in no pair", s->name, (int)length, option);
        }
        free(help);
    }
}

/* The figures of a chosen clip are those that it has among all. */
static void a_chosen_clip_is_converted_as_among_all(void **state)
{
    (void)state;
    const char *const clips[] = {"0", "1", "2"}, *const how[] = {"--rate=7", "--tolerance=0.05", "--rate=9 --scale=2"};
    for (int h = 0; h < 3; h++) {
        free(program_run(NULL, "convert '" NKW_CHARACTER "' %s --axes gltf:gltf -o all.glb 2>/dev/null", how[h]));
        for (int c = 0; c < 3; c++) {
            free(program_run(NULL, "convert '" NKW_CHARACTER "' %s --axes gltf:gltf --clip %s -o one.glb 2>/dev/null",
                             how[h], clips[c]));
            char *one = program_run(NULL, "sample one.glb --clip 0 --rate 11 --what model | cut -d, -f2-");
            char *all = program_run(NULL, "sample all.glb --clip %s --rate 11 --what model | cut -d, -f2-", clips[c]);
            assert_string_equal(one, all);
            free(one);
            free(all);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pair_of_options_ends_and_writes_what_is_read),
        cmocka_unit_test(every_option_is_paired),
        cmocka_unit_test(a_chosen_clip_is_converted_as_among_all),
    };
    return cmocka_run_group_tests_name("command pairs", tests, NULL, NULL);
}
