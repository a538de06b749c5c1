/* SPDX-License-Identifier: MIT */
#include "command.h"

#include <stdlib.h>
#include <string.h>

#include <nakawari/base.h>

typedef struct subcommand {
    const char *name, *title; /* argv[0] of its options */
    int (*run)(int argc, const char **argv);
    const char *about;
} subcommand;

static const subcommand subcommands[] = {
    {"bake", "nakawari bake", command_bake, "a clip as a file that maps back, or as a texture of palettes"},
    {"check", "nakawari check", command_check, "what is wrong with a file: one line for each finding"},
    {"convert", "nakawari convert", command_convert, "any file as glTF: resampled, reduced, with other axes"},
    {"diff", "nakawari diff", command_diff, "the largest difference of each joint between two files"},
    {"exercise", "nakawari exercise", command_exercise,
     "the key-frame exercise with keys of one's own: tables, pictures"},
    {"info", "nakawari info", command_info, "what a file contains: clips, channels, keys, bytes"},
    {"parts", "nakawari parts", command_parts, "skinned meshes cut into parts of few bones, as JSON"},
    {"plot", "nakawari plot", command_plot, "curves of joints over time, paths, Euler angles: SVG, PNG"},
    {"reduce", "nakawari reduce", command_reduce, "fewer keys within a distance in model space, as glTF"},
#if defined(NKW_RENDER)
    {"render", "nakawari render", command_render, "pictures of the model at times: PNG, animated PNG, SVG"},
#endif
    {"sample", "nakawari sample", command_sample, "poses, matrices or vertices at times, as CSV, JSON or raw numbers"},
};

enum { SUBCOMMANDS = sizeof subcommands / sizeof subcommands[0] };

static void list(FILE *f)
{
    fputs("Usage: nakawari COMMAND [OPTION...] FILE\n\nReads animated models: glTF 2.0 (.gltf, .glb, .vrm), BVH, OBJ, "
          "keys in CSV and JSON, and,\nwhere it is built with Assimp, FBX, Collada, X, MD5 and others.\n\n",
          f);
    for (int i = 0; i < SUBCOMMANDS; i++)
        fprintf(f, "  %-9s %s\n", subcommands[i].name, subcommands[i].about);
    fputs("\nnakawari COMMAND --help explains a command, with examples. --version prints the version.\n", f);
}

static int version(void)
{
    unsigned number = nkw_version();
    printf("nakawari %u.%u.%u\n", number / 10000, number / 100 % 100, number % 100);
    return output_close(stdout, NULL) ? COMMAND_FINE : COMMAND_FINDINGS;
}

static int misuse(const char *which, const char *what)
{
    fputs("nakawari: ", stderr);
    output_text(stderr, which);
    fprintf(stderr, ": %s\nTry 'nakawari --help'.\n", what);
    return COMMAND_MISUSE;
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        list(stderr);
        return COMMAND_MISUSE;
    }
    for (int i = 0; i < SUBCOMMANDS; i++)
        if (strcmp(argv[1], subcommands[i].name) == 0) {
            const char **arguments = (const char **)argv + 1;
            arguments[0] = subcommands[i].title;
            return subcommands[i].run(argc - 1, arguments);
        }
    if (strcmp(argv[1], "--version") == 0)
        return version();
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        list(stdout);
        return output_close(stdout, NULL) ? COMMAND_FINE : COMMAND_FINDINGS;
    }
    return misuse(argv[1], argv[1][0] == '-' ? "unknown option" : "unknown command");
}
