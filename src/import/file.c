/* SPDX-License-Identifier: MIT */
#include "file.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Twice the room, from 64 KiB on. */
static int grow(void **data, size_t *room)
{
    size_t more = *room ? 2 * *room : (size_t)1 << 16;
    void *wider = realloc(*data, more);
    if (!wider)
        return 0;
    *data = wider;
    *room = more;
    return 1;
}

static int read_stream(nkw_import_error *error, FILE *stream, void **data, size_t *bytes)
{
    size_t room = 0, got = 1;
    while (got > 0) {
        if (*bytes == room && !grow(data, &room))
            return nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for a file of more than %zu bytes", *bytes);
        got = fread((char *)*data + *bytes, 1, room - *bytes, stream);
        *bytes += got;
        if (*bytes > NKWI_BYTES_MOST)
            return nkwi_fail(error, NULL, NKW_IMPORT_TOO_LARGE, "the file has more than %zu bytes", NKWI_BYTES_MOST);
    }
    if (ferror(stream))
        return nkwi_fail(error, NULL, NKW_IMPORT_UNREADABLE, "cannot be read: %s", strerror(errno));
    return 1;
}

int nkwi_file_read(nkw_import_error *error, const char *path, void **data, size_t *bytes)
{
    *data = NULL;
    *bytes = 0;
    errno = 0;
    FILE *stream = fopen(path, "rb");
    if (!stream)
        return nkwi_fail(error, NULL, NKW_IMPORT_UNREADABLE, "cannot be read: %s", strerror(errno));
    int done = read_stream(error, stream, data, bytes);
    fclose(stream);
    if (!done) {
        free(*data);
        *data = NULL;
    }
    return done;
}

static int is_separator(char c)
{
#if defined(_WIN32)
    return c == '/' || c == '\\' || c == ':';
#else
    return c == '/';
#endif
}

char *nkwi_folder_of(const char *path)
{
    size_t length = strlen(path);
    while (length > 0 && !is_separator(path[length - 1]))
        length--;
    char *folder = (char *)malloc(length + 1);
    if (folder) {
        memcpy(folder, path, length);
        folder[length] = 0;
    }
    return folder;
}

static size_t size_of(FILE *stream)
{
    if (fseek(stream, 0, SEEK_END) != 0)
        return SIZE_MAX;
    long end = ftell(stream);
    return end < 0 || fseek(stream, 0, SEEK_SET) != 0 ? SIZE_MAX : (size_t)end;
}

size_t nkwi_folder_reader(void *user, const char *path, void *out, size_t size)
{
    const char *folder = (const char *)user;
    size_t before = strlen(folder), after = strlen(path) + 1;
    char *whole = (char *)malloc(before + after);
    if (!whole)
        return SIZE_MAX;
    memcpy(whole, folder, before);
    memcpy(whole + before, path, after);
    FILE *stream = fopen(whole, "rb");
    free(whole);
    if (!stream)
        return SIZE_MAX;
    size_t bytes = size_of(stream);
    if (bytes != SIZE_MAX && out && fread(out, 1, size, stream) != size)
        bytes = SIZE_MAX;
    fclose(stream);
    return bytes;
}

/* The value of a hexadecimal digit, or -1. */
static int digit_of(char c)
{
    static const char digits[] = "0123456789abcdefABCDEF";
    const char *at = c ? strchr(digits, c) : NULL;
    int place = at ? (int)(at - digits) : -1;
    return place < 16 ? place : place - 6;
}

/* The byte at *uri, decoded, and *uri past it; -1 for a % without two digits. */
static int decoded(const char **uri)
{
    const char *at = *uri;
    *uri += 1;
    if (*at != '%')
        return (unsigned char)*at;
    int high = digit_of(at[1]), low = high < 0 ? -1 : digit_of(at[2]);
    *uri += 2;
    return low < 0 ? -1 : 16 * high + low;
}

/* Ends the last name of a path of `length` bytes: resolves . and .. and empty names. Returns the length, -1 above. */
static ptrdiff_t end_name(char *path, ptrdiff_t start, ptrdiff_t length)
{
    ptrdiff_t size = length - start;
    if (size == 0 || (size == 1 && path[start] == '.'))
        return start;
    if (size != 2 || path[start] != '.' || path[start + 1] != '.')
        return length;
    if (start == 0)
        return -1;
    for (start--; start > 0 && path[start - 1] != '/';)
        start--;
    return start;
}

/* The next character of a path, and *text past it; -1 for a % without two digits. */
static int next_character(const char **text, int is_uri)
{
    if (is_uri)
        return decoded(text);
    int c = (unsigned char)*(*text)++;
    return c == '\\' ? '/' : c;
}

static const char *tidy_path(const char *text, int is_uri, char *path)
{
    ptrdiff_t length = 0, start = 0;
    if (*text == '/')
        return "is an absolute path";
    while (*text) {
        int c = next_character(&text, is_uri);
        if (c < 0)
            return "has a % without two hexadecimal digits";
        if (c < 0x20 || c == 0x7f || c == '\\' || c == ':')
            return c == ':' ? "is no relative path" : "has a character that no portable path has";
        if (c != '/') {
            path[length++] = (char)c;
            continue;
        }
        length = end_name(path, start, length);
        if (length < 0)
            return "leaves the folder of the file";
        if (length > 0 && path[length - 1] != '/')
            path[length++] = '/';
        start = length;
    }
    length = end_name(path, start, length);
    if (length < 0)
        return "leaves the folder of the file";
    path[length] = 0;
    return length == 0 || path[length - 1] == '/' ? "names no file" : NULL;
}

const char *nkwi_path_from_uri(const char *uri, char *path)
{
    return tidy_path(uri, 1, path);
}

const char *nkwi_path_from_name(const char *name, char *path)
{
    return tidy_path(name, 0, path);
}

/* The value of a character of base64 and of base64url, or -1. */
static int sextet_of(char c)
{
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' || c == '-' ? 62 : c == '/' || c == '_' ? 63 : -1;
}

/* RFC 4648: four characters are three bytes; the end may have = or not. */
static const char *from_base64(const char *text, unsigned char *out, size_t room, size_t *bytes)
{
    uint32_t bits = 0;
    size_t count = 0, sextets = 0;
    for (; *text && *text != '='; text++) {
        int sextet = sextet_of(*text);
        if (sextet < 0)
            return "has a character that is not base64";
        bits = bits << 6 | (uint32_t)sextet;
        if (++sextets % 4 == 1)
            continue;
        if (count < room)
            out[count] = (unsigned char)(bits >> (6 - 2 * ((sextets - 1) % 4)) & 0xff);
        count++;
    }
    *bytes = count;
    return sextets % 4 == 1 || text[strspn(text, "=")] ? "has base64 of a wrong length" : NULL;
}

const char *nkwi_bytes_from_uri(const char *uri, unsigned char *out, size_t room, size_t *bytes)
{
    static const char base64[] = ";base64";
    const char *comma = strchr(uri, ',');
    size_t tail = sizeof base64 - 1, count = 0;
    *bytes = 0;
    if (!comma)
        return "has no comma after its media type";
    if ((size_t)(comma - uri) >= tail && memcmp(comma - tail, base64, tail) == 0)
        return from_base64(comma + 1, out, room, bytes);
    for (uri = comma + 1; *uri; count++) {
        int c = decoded(&uri);
        if (c < 0)
            return "has a % without two hexadecimal digits";
        if (count < room)
            out[count] = (unsigned char)c;
    }
    *bytes = count;
    return NULL;
}
