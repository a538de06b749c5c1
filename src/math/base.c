/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/base.h>

const char *nkw_result_text(nkw_result result)
{
    switch (result) {
#define NKW_RESULT_CASE(name, text)                                                                                    \
    case name:                                                                                                         \
        return text;
        NKW_RESULTS(NKW_RESULT_CASE)
#undef NKW_RESULT_CASE
    default:
        return "unknown result";
    }
}

unsigned nkw_version(void)
{
    return NKW_VERSION_MAJOR * 10000u + NKW_VERSION_MINOR * 100u + NKW_VERSION_PATCH;
}
