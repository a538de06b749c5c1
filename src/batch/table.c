/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/table.h"

/* The prototype that -Wmissing-prototypes asks for; src/simd/select.h has one for each instruction set. */
extern const nkw_batch NKW_PER_ISA(nkw_batch);

const nkw_batch NKW_PER_ISA(nkw_batch) = {
#define KERNEL_ENTRY(name, parameters, arguments) NKW_PER_ISA(nkw_batch_##name),
    KERNEL_LIST(KERNEL_ENTRY)
    KERNEL_INNER_LIST(KERNEL_ENTRY)
#undef KERNEL_ENTRY
};
