/* SPDX-License-Identifier: MIT */
#include "bytes.h"

#include <string.h>

void bytes_put_u32(FILE *f, uint32_t value)
{
    for (int shift = 0; shift < 32; shift += 8)
        fputc((int)(value >> shift & 255), f);
}

void bytes_put_f32(FILE *f, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    bytes_put_u32(f, bits);
}
