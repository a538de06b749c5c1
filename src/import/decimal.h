/* SPDX-License-Identifier: MIT */
/* Numbers of text formats: as programs of every locale write them. */
#ifndef NAKAWARI_IMPORT_DECIMAL_H
#define NAKAWARI_IMPORT_DECIMAL_H

#include <stddef.h>

/*
 * The double nearest to a decimal number: sign, digits, a point or comma, digits, exponent; one digit at least, as in
 * 1, .5, 2., -1e-5 and 0,25. Returns NULL, or why `text` is no number that is finite as a float.
 */
const char *nkwi_decimal(const char *text, size_t length, double *number);

/*
 * The shortest decimal number that nkwi_decimal, or any reader that rounds to the nearest, reads as this float: at most
 * nine significant digits, a point in every locale. Below 1e-14 and from 1e22 there may be nine where fewer would do.
 * 0 in place of a number that is not finite. Returns its length; a 0 follows it.
 */
enum { NKWI_DECIMAL_ROOM = 24 };
size_t nkwi_decimal_write(float number, char *out);

#endif
