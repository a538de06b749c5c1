/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "simd/select.h"

const nkw_batch *nkw_batch_selected(void)
{
    return nkw_batch_for((size_t)-1);
}

const nkw_batch *nkw_batch_selected_for(size_t n)
{
    return nkw_batch_for(n);
}
