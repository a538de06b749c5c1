/* SPDX-License-Identifier: MIT */
/** @file Numbers as little-endian bytes. */
#ifndef BYTES_H
#define BYTES_H

#include <stdint.h>
#include <stdio.h>

void bytes_put_u32(FILE *f, uint32_t value);
void bytes_put_f32(FILE *f, float value);

#endif
