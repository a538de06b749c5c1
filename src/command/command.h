/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The program nakawari: one function for each subcommand, and what they share: options, documents, outputs.
 */
#ifndef COMMAND_H
#define COMMAND_H

#include <stdio.h>

#include <popt.h>

#include <nakawari/import.h>

/** Arguments for "%zu %s": a number and its noun. */
#define COUNT(n, one, many) (n), (n) == 1 ? (one) : (many)

/** The exit codes. */
enum command_code {
    COMMAND_FINE,
    COMMAND_FINDINGS, /**< a finding, or a file that cannot be read or written */
    COMMAND_MISUSE /**< options that make no sense */
};

/* The subcommands: argv[0] is "nakawari NAME". They return an exit code. */
int command_bake(int argc, const char **argv);
int command_check(int argc, const char **argv);
int command_convert(int argc, const char **argv);
int command_diff(int argc, const char **argv);
int command_exercise(int argc, const char **argv);
int command_info(int argc, const char **argv);
int command_parts(int argc, const char **argv);
int command_plot(int argc, const char **argv);
int command_reduce(int argc, const char **argv);
int command_render(int argc, const char **argv); /* only with libpng: NKW_RENDER */
int command_sample(int argc, const char **argv);

/* ---- options.c ---- */

/** The help of a subcommand around its table of options. */
typedef struct options_text {
    const char *usage; /**< "[OPTION...] FILE" */
    const char *about; /**< one sentence or more, each line ends with \n */
    const char *examples; /**< lines, each ends with \n */
    int file_count; /**< the number of arguments that are no options */
    int more; /**< whether there may be more of them */
} options_text;

typedef struct options {
    poptContext context;
    const char **files; /**< the arguments that are no options, then NULL */
    int code; /**< the exit code if options_read returned 0 */
} options;

/**
 * Reads the command line into the variables of the table, which ends with OPTIONS_END. Returns 0 if the program is to
 * end with `code`: after --help, or after a misuse, which is reported on stderr. options_close is due in either case.
 */
int options_read(options *o, const options_text *text, const struct poptOption *table, int argc, const char **argv);
void options_close(options *o);

/** Reports a misuse: "nakawari sample: WHICH: WHAT". Returns COMMAND_MISUSE. */
int options_misuse(const options *o, const char *which, const char *what);

#define OPTIONS_END                                                                                                    \
    {"bvh-offset", 0, POPT_ARG_STRING, NULL, 'b', "of BVH: positions replace OFFSET (default) or add to it", "HABIT"}, \
        {"in-process", 0, POPT_ARG_NONE, NULL, 'i', "read foreign formats in this process, not in a child", NULL},      \
        {"read-limit", 0, POPT_ARG_STRING, NULL, 'l', "CPU seconds of such a child (default: 10, 1 more a MiB)", "S"}, \
        {"quiet", 0, POPT_ARG_NONE, NULL, 'q', "show no progress of long work", NULL},                                 \
        {"help", 'h', POPT_ARG_NONE, NULL, 'h', "print this help", NULL}, POPT_TABLEEND

/** The number of `text`, all of it, finite. Returns 0 if it is none. */
int options_number(const char *text, float *number);
/** The whole number of `text`, 0..SIZE_MAX - 1. Returns 0 if it is none. */
int options_index(const char *text, size_t *index);

/* ---- words.c ---- */

/** The index of `word` among `count` words, -1 if it is none of them. */
int words_find(const char *word, const char *const *words, int count);

/* ---- input.c ---- */

/** Whether positions of BVH are added to the OFFSET of their joint: --bvh-offset. */
void input_set_bvh(int adds_offset);
int input_bvh_adds(void);
/** Whether v of texture coordinates is upwards: --v, "down" (default, NULL) or "up". Returns 0 for another text. */
int input_set_v(const char *direction);
int input_v_is_up(void);
#define INPUT_V(text)                                                                                                  \
    {"v", 0, POPT_ARG_STRING, text, 0, "texture coordinate v: down (default, as glTF) or up", "DIRECTION"}
/**
 * What is made of meshes of the files that are opened: nkw_document_preparation, with the crease in degrees; -1: no
 * normals. Returns 0 if the crease is no angle.
 */
int input_set_preparation(const nkw_document_preparation *preparation);
/** Whether anything is made. */
int input_prepares(void);
const nkw_document_preparation *input_preparation(void);
#define INPUT_PREPARATION(p)                                                                                           \
    {"normals", 0, POPT_ARG_FLOAT, &(p)->crease, 0, "make missing normals; sharper edges stay hard", "DEGREES"},       \
        {"tangents", 0, POPT_ARG_NONE, &(p)->make_tangents, 0, "make missing tangents, by MikkTSpace", NULL},          \
        {"fix-facing", 0, POPT_ARG_NONE, &(p)->fix_facing, 0, "turn triangles to face the same way, outward", NULL},   \
    {                                                                                                                  \
        "apply-transforms", 0, POPT_ARG_NONE, &(p)->apply_transforms, 0, "multiply vertices by their nodes", NULL      \
    }
/** The name of a file without its folder: the rest of the path. */
const char *input_name(const char *path);
/** The folder of a path, to be freed; NULL without memory. */
char *input_folder(const char *path);
/** The path of a file in the folder of a document, to be freed; NULL without memory. */
char *input_beside(const nkw_document *d, const char *path);
/** All bytes of such a file, to be freed; NULL if it cannot be read, which is not reported. */
unsigned char *input_read_beside(const nkw_document *d, const char *path, size_t *bytes);
/** Prints the warnings of a document on stderr. */
void input_warn(const nkw_document *document);

/**
 * Whether the first `length` characters of `text` name a joint: its name, or, if no node has it as its name, the number
 * of its node in the file.
 */
int input_is_joint(const nkw_document *document, size_t joint, const char *text, size_t length);
/** All bytes of a file, or of the standard input for "-", to be freed. An error is reported; returns NULL. */
unsigned char *input_read(const char *path, size_t *bytes);
/** Reports an error of the import on stderr: "file:place: reason". */
void input_report(const nkw_import_error *error);

/* ---- open.c ---- */

/**
 * Opens a file, or the standard input for "-", and prepares and warns as the options state. What foreign readers read
 * is read in a process of its own (apart.h). An error is reported on stderr; returns NULL.
 */
nkw_document *input_open(const char *path);
/** The same of a file in memory, which is not needed after the call. */
nkw_document *input_open_memory(const nkw_import_memory *memory);
/** What the last of these two calls that failed reported. */
const nkw_import_error *input_error(void);
/** Frees a document of these two. NULL is allowed. */
void input_close(nkw_document *document);
/** Whether all is read in this process: --in-process. */
void input_set_in_process(int in_process);
/**
 * Whether tracks that the library refuses are left out, with a warning, so that their joints hold the rest pose: yes,
 * until --strict or a subcommand that shows faults sets 0.
 */
void input_set_holding(int holds);
#define INPUT_STRICT                                                                                                   \
    {                                                                                                                  \
        "strict", 0, POPT_ARG_NONE, NULL, 's', "refuse a clip with a channel in error, do not hold it at rest", NULL   \
    }

/** Animations of a document: first..first + count - 1. The rest pose is NKW_INPUT_REST. */
#define INPUT_REST SIZE_MAX
typedef struct input_clips {
    size_t first, count;
} input_clips;

/**
 * The animations that --clip names: a number, a name, "all" or "rest". NULL: the first, or the rest pose if there is
 * none. Returns 0 and reports if there is no such animation.
 */
int input_select(const nkw_document *document, const char *clip, input_clips *clips);
/** The name of an animation; "" for INPUT_REST. */
const char *input_clip_name(const nkw_document *document, size_t animation);
/** The number of an animation as printed: -1 for INPUT_REST. */
long input_clip_number(size_t animation);

/* ---- run.c ---- */

/** What a subcommand on one file does with its request: the variables of its table of options. */
typedef struct command_steps {
    int (*check)(const options *o, void *request); /**< returns an exit code; the work is done if it is COMMAND_FINE */
    int (*work)(const nkw_document *document, void *request); /**< returns 0 if it failed, which it reports */
} command_steps;

/** Reads the options, checks the request, opens the file and works on it. Returns the exit code. */
int command_run(const options_text *text, const struct poptOption *table, int argc, const char **argv,
                const command_steps *steps, void *request);

/** Opens a file and works on it. Returns the exit code. */
int command_work(const char *path, const command_steps *steps, void *request);

/* ---- output.c ---- */

/** The file, or the standard output for NULL and "-". Reports an error on stderr and returns NULL. */
FILE *output_open(const char *path);
/** The index of the end of a name, after its last point and in any case, among `count` words; -1 if it is none. */
int output_ending(const char *path, const char *const *words, int count);
/** Whether a name ends as those of pictures, films and models that no command writes: .jpg, .fbx and others. */
int output_is_foreign(const char *path);
/** Makes a folder where there is none. Its parent must exist. Returns 0 and reports on stderr if it cannot. */
int output_folder(const char *path);
/** Closes it. Returns 0 and reports on stderr if anything could not be written. */
int output_close(FILE *f, const char *path);

/** Reports on stderr what a document, or one of its animations, lacks: "FILE: clip NAME: WHAT". Returns 0. */
int output_complain(const nkw_document *d, const nkw_document_animation *animation, const char *what);

/** A number with nine significant digits, which determine a float; "nan" without a sign. */
void output_number(FILE *f, float number);
/** A field of CSV, in quotes if it contains a comma, a quote or a line end. */
void output_field(FILE *f, const char *text);
/** A text on a terminal: control characters become \xNN. */
void output_text(FILE *f, const char *text);

#endif
