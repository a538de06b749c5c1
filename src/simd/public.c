/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/nakawari.h>

#include "simd/select.h"

/* nkw_<name>_n of the headers. */
#define KERNEL_PUBLIC(name, parameters, arguments)                                                                     \
    void nkw_##name##_n parameters                                                                                     \
    {                                                                                                                  \
        nkw_batch_for(n)->name arguments;                                                                              \
    }
KERNEL_LIST(KERNEL_PUBLIC)
