/* SPDX-License-Identifier: MIT */
/* Before main, the rounding mode of another library. */
#include <fenv.h>

static void __attribute__((constructor)) round_upward(void)
{
    fesetround(FE_UPWARD);
}
