/* SPDX-License-Identifier: MIT */
/* Keys of one's own while they are read: rows of a table, in CSV or JSON, or of the exercise's scenes. */
#ifndef NAKAWARI_IMPORT_KEYS_H
#define NAKAWARI_IMPORT_KEYS_H

#include "document.h"
#include "value.h"

/*
 * The numbers of a key: a TRS and a morph weight, then their in-tangents and out-tangents in the same order. Of a table
 * without tangents a row has the first NKWI_VALUES only.
 */
enum { NKWI_VALUES = 11, NKWI_WEIGHT = 10, NKWI_NUMBERS = 3 * NKWI_VALUES };

/* A row: which properties it has (bit k: the nkw_clip_target k), and where it comes from. */
typedef struct nkwi_row {
    size_t line;
    uint32_t clip, node;
    nkw_interpolation interpolation;
    unsigned has;
    int has_angles; /* the rotation is that of angles, about Y, X and Z in this order */
    float time;
    nkw_vec3 angles;
    size_t numbers; /* the first of keys.numbers */
} nkwi_row;

/* The same as the file has it: NULL or empty texts are absent. `has` as above. */
typedef struct nkwi_entry {
    const char *name, *clip, *parent;
    nkw_interpolation interpolation;
    unsigned has;
    int has_angles;
    nkw_vec3 angles;
    float time, numbers[NKWI_NUMBERS];
} nkwi_entry;

/* The rotation of the angles, which the entry keeps. */
void nkwi_entry_turn(nkwi_entry *e, nkw_vec3 angles);

typedef struct nkwi_keys {
    nkwi_document *document;
    nkw_import_error *error;
    size_t line; /* of the row that is read; in JSON its index */
    int is_json;
    json_t *clips, *nodes, *parents; /* objects: the index of a name; an array: the parent of each node, or null */
    nkwi_row *rows;
    size_t row_count, room;
    float *numbers;
    size_t stride; /* floats of a row: NKWI_VALUES or NKWI_NUMBERS */
} nkwi_keys;

/* The first number of a property, and how many there are. */
extern const size_t nkwi_keys_first[4], nkwi_keys_width[4];

/* An error in the row that is read. column NULL: of the whole row. */
int nkwi_keys_fail(nkwi_keys *k, const char *column, nkw_import_result code, const char *reason);
int nkwi_keys_no_memory(nkwi_keys *k);

int nkwi_keys_add(nkwi_keys *k, const nkwi_entry *e);

/*
 * LINEAR rotations of the rows from .. to - 1, which are those of one clip and node, to times and values, which may be
 * NULL; returns their number (keys_turn.c). Where angles of rows that follow each other differ by half a turn or more,
 * keys are added between them, on the line of the angles.
 */
size_t nkwi_keys_turns(const nkwi_keys *k, size_t from, size_t to, float *times, float *values);
/* Returns 0, and the error, where more keys than a limit would be added between two rows. */
int nkwi_keys_check_turns(nkwi_keys *k, size_t from, size_t to);

/* The rows of a text, and of the members "columns" and "rows" of JSON (keys_table.c). */
int nkwi_table_is(const void *data, size_t bytes);
int nkwi_table_read(nkwi_keys *k, const void *data, size_t bytes);
int nkwi_table_are(const nkwi_value *root);
int nkwi_table_read_tree(nkwi_keys *k, const nkwi_value *root);

/* The rows of scenes: JSON whose members are lists of keys (keys_scene.c). */
int nkwi_scenes_are(const nkwi_value *root);
int nkwi_scenes_read(nkwi_keys *k, const nkwi_value *root);

#endif
