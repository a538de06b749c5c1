/* SPDX-License-Identifier: MIT */
/* What is wrong with a file, and where. Functions that can fail return 1, or 0 after nkwi_fail. */
#ifndef NAKAWARI_IMPORT_FAULT_H
#define NAKAWARI_IMPORT_FAULT_H

#include <nakawari/import.h>

/* A step of a JSON pointer: a key, or an index where key is NULL. The root has no parent. */
typedef struct nkwi_place {
    const struct nkwi_place *parent;
    const char *key;
    size_t index;
} nkwi_place;

#if defined(__GNUC__)
#define NKWI_PRINTS(format, first) __attribute__((__format__(__printf__, format, first)))
#else
#define NKWI_PRINTS(format, first)
#endif

/* No error yet, of this file. */
void nkwi_fault_none(nkw_import_error *error, const char *file);

/* Texts of files must not control the terminal: control characters, and bytes that are no UTF-8, become ?. */
void nkwi_tame(char *text);

/* Records an error and returns 0. place NULL: the place stays as it is. */
int nkwi_fail(nkw_import_error *error, const nkwi_place *place, nkw_import_result code, const char *format, ...)
    NKWI_PRINTS(4, 5);

/* The same at a place that is no JSON pointer. */
int nkwi_fail_at(nkw_import_error *error, const char *place, nkw_import_result code, const char *format, ...)
    NKWI_PRINTS(4, 5);

#endif
