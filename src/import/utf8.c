/* SPDX-License-Identifier: MIT */
#include "utf8.h"

/* The bytes of the character at `text` in UTF-8, RFC 3629; 0 for what is no character. */
static size_t character_bytes(const unsigned char *text)
{
    static const struct {
        unsigned char low, high, bytes, least, most; /* of the first byte, and of the second */
    } rows[] = {{0x01, 0x7f, 1, 0, 0},       {0xc2, 0xdf, 2, 0x80, 0xbf}, {0xe0, 0xe0, 3, 0xa0, 0xbf},
                {0xe1, 0xec, 3, 0x80, 0xbf}, {0xed, 0xed, 3, 0x80, 0x9f}, {0xee, 0xef, 3, 0x80, 0xbf},
                {0xf0, 0xf0, 4, 0x90, 0xbf}, {0xf1, 0xf3, 4, 0x80, 0xbf}, {0xf4, 0xf4, 4, 0x80, 0x8f}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (text[0] < rows[i].low || text[0] > rows[i].high)
            continue;
        if (rows[i].bytes > 1 && (text[1] < rows[i].least || text[1] > rows[i].most))
            return 0;
        for (size_t b = 2; b < rows[i].bytes; b++)
            if ((text[b] & 0xc0) != 0x80)
                return 0;
        return rows[i].bytes;
    }
    return 0;
}

void nkwi_utf8(char *text, size_t length)
{
    for (size_t i = 0; i < length;) {
        const size_t step = character_bytes((const unsigned char *)text + i);
        if (step == 0)
            text[i] = '?';
        i += step ? step : 1;
    }
}
