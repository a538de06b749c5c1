/* SPDX-License-Identifier: MIT */
/* Files, and the names of files in files. */
#ifndef NAKAWARI_IMPORT_FILE_H
#define NAKAWARI_IMPORT_FILE_H

#include <stddef.h>

#include "fault.h"

/* The most bytes of all files of a document together. */
#define NKWI_BYTES_MOST ((size_t)(SIZE_MAX > 0xffffffffu ? 0xffffffffu : SIZE_MAX / 4))

/* A whole file, to be freed with free(); anything that can be read to its end, a pipe too. */
int nkwi_file_read(nkw_import_error *error, const char *path, void **data, size_t *bytes);

/* The folder of a path with its last separator, to be freed with free(); NULL if there is no memory. */
char *nkwi_folder_of(const char *path);

/* An nkw_import_reader of the folder `user`, a text that is empty or ends with a separator. */
size_t nkwi_folder_reader(void *user, const char *path, void *out, size_t size);

/*
 * The path of a relative URI: percent-decoded, without . and .. and empty names. `path` has room for the URI. Returns
 * NULL, or why the URI names no file of the folder.
 */
const char *nkwi_path_from_uri(const char *uri, char *path);

/* The same of a path as it is, in which a backslash is a separator too. */
const char *nkwi_path_from_name(const char *name, char *path);

/*
 * The bytes of a data URI, at most `room`, in `out`. Returns NULL, or what is wrong with it. *bytes is their number,
 * counted also beyond the room.
 */
const char *nkwi_bytes_from_uri(const char *uri, unsigned char *out, size_t room, size_t *bytes);

#endif
