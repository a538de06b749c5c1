/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_BATCH_RUN_H
#define NAKAWARI_BATCH_RUN_H

#include <stdint.h>

/* Lanes lane..lane + count - 1 of a clip's group go to floats to..to + count - 1 of each component of the output. */
typedef struct nkw_run {
    uint32_t lane, to, count;
} nkw_run;

#endif
