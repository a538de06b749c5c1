/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_IMPORT_UTF8_H
#define NAKAWARI_IMPORT_UTF8_H

#include <stddef.h>

/* Replaces the bytes that are no UTF-8 by ?. A byte 0 follows the text. */
void nkwi_utf8(char *text, size_t length);

#endif
