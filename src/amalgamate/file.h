/* SPDX-License-Identifier: MIT */
/* The files of the library, and the names that each declares outside of functions. */
#ifndef NAKAWARI_AMALGAMATE_FILE_H
#define NAKAWARI_AMALGAMATE_FILE_H

#include "text.h"

typedef struct file {
    char *path, *stem; /* the stem is of letters, digits and _ */
    text content;
    names own; /* static functions and variables, types, enumeration constants */
    names macros; /* the names after #define, the guard too */
    names list; /* of a list of loops (batch/isa.h): "nkwi_name(parameters)" of those that only the library calls */
    int guarded; /* its first directive is #ifndef GUARD */
    int is_list, wide;
    int open, done; /* it is being expanded; its text is there, outside of any #if */
    size_t *local, local_count; /* where declarations of nkwi_ functions begin that are not static */
} file;

/* All files so far. */
typedef struct files {
    file *file[1024];
    size_t count;
} files;

/* The file `name` as #include "name" of `from` means it: beside it, or in root/src/kernel, root/src, root/include. */
file *files_find(files *all, const char *root, const char *from, const char *name);
file *files_get(files *all, const char *path);

/* The name in "..." of an #include, or NULL; a name in <...> only of <nakawari/...>. Valid until the next call. */
const char *include_name(token directive);
/* The word after # of a directive, and the word after that. */
token directive_word(token directive, token *argument);

#endif
