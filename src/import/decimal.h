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

#endif
