/* SPDX-License-Identifier: MIT */
/* The outputs of a validate function: the result, and the index of the first element with an error. */
#ifndef NAKAWARI_REPORT_H
#define NAKAWARI_REPORT_H

#include <nakawari/base.h>

/* Stores `bad`, or 0 if the result is NKW_OK, in *out unless out is NULL. Returns the result. */
static inline nkw_result report(nkw_result result, size_t bad, size_t *out)
{
    if (out)
        *out = result == NKW_OK ? 0 : bad;
    return result;
}

#endif
