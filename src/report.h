/* SPDX-License-Identifier: MIT */
/* What a validation gives: its result, and the index of the first offender. */
#ifndef NAKAWARI_REPORT_H
#define NAKAWARI_REPORT_H

#include <nakawari/base.h>

/* *out, where there is one, becomes `bad`, or 0 if all is well. */
static inline nkw_result report(nkw_result result, size_t bad, size_t *out)
{
    if (out)
        *out = result == NKW_OK ? 0 : bad;
    return result;
}

#endif
