/* SPDX-License-Identifier: MIT */
/** @file A document whose tracks, nodes and meshes may be replaced, and the glTF file of it. */
#ifndef MODEL_H
#define MODEL_H

#include <nakawari/export.h>
#include <nakawari/clip_reduce.h>

#include "command.h"
#include "extent.h"

/** A file that is kept, because it is written again with other animations. */
typedef struct model_source {
    nkw_import_memory memory;
    unsigned char *data;
    char *folder;
    nkw_document *document;
} model_source;

/** Opens a file, or the standard input for "-". Reports errors and returns 0. model_source_close is due either way. */
int model_source_open(model_source *s, const char *path);
void model_source_close(model_source *s);

/** What a subcommand does with such a file: as command_steps. */
typedef struct model_steps {
    int (*check)(const options *o, void *request);
    int (*work)(const model_source *source, void *request);
} model_steps;

/** command_run for files that are kept. */
int model_run(const options_text *text, const struct poptOption *table, int argc, const char **argv,
              const model_steps *steps, void *request);

typedef struct model {
    nkw_document document; /**< a copy of the original, whose arrays are replaced */
    const nkw_document *original;
    nkw_document_animation *animations; /**< document.animations */
    void **blocks;
    size_t block_count;
    int is_obj; /**< whether it is written as OBJ, not as glTF */
    size_t clip; /**< of OBJ: the animation of the document, or INPUT_REST */
    float time; /**< of OBJ: seconds in that clip */
    int embeds; /**< whether outer pictures become part of the file in any case */
    int only_smaller; /**< whether a GLB that would not become smaller is written as it was */
    int mends; /**< whether faults of a glTF file are mended (mend.h) */
    int mends_meshes; /**< whether any of a mesh or a skin was: then a glTF file is written as another one is */
} model;

/** Copies the document and its lists of tracks. Returns 0 and reports without memory. model_close is due either way. */
int model_open(model *m, const nkw_document *d);
void model_close(model *m);
/** Memory of the model, zeros. NULL without memory, which is reported. */
void *model_take(model *m, size_t count, size_t size);
/** The tracks of an animation of the model, to be replaced. */
nkw_clip_track *model_tracks(model *m, size_t animation);

/** How the keys of a clip changed. */
typedef struct model_change {
    size_t keys_before, keys;
    size_t bytes_before, bytes; /**< of key times, those that tracks share once, and values, as floats */
    nkw_reduced error; /**< measured between the original and the model */
} model_change;

/**
 * Reduces the keys of an animation to a distance in model space, at the reach of each joint; morph weights to the same
 * share of 1 as the distance is of the model's size. Unless `fewest`, tracks whose keys would need more bytes, because
 * they share their times, remain. Returns 0 and reports if the library refuses the keys, or without memory.
 */
int model_reduce(model *m, size_t animation, const extent *e, float tolerance, int fewest);
/** Resamples the tracks of an animation at a rate, keys per second. */
int model_resample(model *m, size_t animation, float rate);
/** Measures what changed. */
int model_measure(const model *m, size_t animation, const extent *e, float tolerance, model_change *change);

/** Writes a file. Returns 0 and reports if it cannot be written. */
int model_put_file(const char *path, const void *data, size_t bytes);
/** Whether two paths have the same folder. */
int model_same_folder(const char *a, const char *b);
/** Outer pictures that can be read become part of a copy of the document. Returns 0 without memory, and reports. */
int model_embed_images(model *m, nkw_document *d);

/** The form of a file by its name and the option --form; -1 if there is no such form. */
int model_form(const char *form, const char *path);
/**
 * Copies the document of `source`, changes the copy by `change`, and writes it: with everything else of the source if
 * `keeps`, otherwise what nkw_document_write writes. Outer images become part of a GLB and of a file in another folder;
 * one that cannot is warned of. The report is the standard output unless that receives the file; `form` and `output` are
 * options of the command line. Returns 0 and reports if a step fails.
 */
typedef int (*model_changer)(model *m, const void *request, const extent *e, FILE *report);
int model_rewrite(const model_source *source, int keeps, const char *form, const char *output, model_changer change,
                  const void *request);

/** One line for each clip: keys, bytes and error. `f`: stdout, or stderr if a file is written to stdout. */
void model_report_head(FILE *f, const nkw_document *d);
void model_report(FILE *f, const nkw_document *d, size_t animation, const model_change *c);

/** Reports what an animation lacks. Returns 0. */
int model_complain(const model *m, size_t animation, const char *what);

#endif
