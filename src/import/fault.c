/* SPDX-License-Identifier: MIT */
#include "fault.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "utf8.h"

void nkwi_fault_none(nkw_import_error *error, const char *file)
{
    const nkw_import_error none = {NKW_IMPORT_OK, NKW_OK, "", "", ""};
    *error = none;
    size_t length = strlen(file), most = sizeof error->file - 1;
    snprintf(error->file, sizeof error->file, "%s", length > most ? file + (length - most) : file);
}

void nkwi_tame(char *text)
{
    nkwi_utf8(text, strlen(text));
    for (; *text; text++)
        if ((unsigned char)*text < 0x20 || *text == 0x7f)
            *text = '?';
}

static void explain(nkw_import_error *error, nkw_import_result code, const char *format, va_list arguments)
{
    error->code = code;
    vsnprintf(error->reason, sizeof error->reason, format, arguments);
    nkwi_tame(error->reason);
}

/* Appends the pointer to what is at `used`, and returns the length so far. */
static size_t point(const nkwi_place *place, char *text, size_t size)
{
    size_t used = place->parent ? point(place->parent, text, size) : 0;
    int more = 0;
    if (place->parent && place->key)
        more = snprintf(text + used, size - used, "/%s", place->key);
    else if (place->parent)
        more = snprintf(text + used, size - used, "/%zu", place->index);
    return used + (size_t)more < size ? used + (size_t)more : size - 1;
}

int nkwi_fail(nkw_import_error *error, const nkwi_place *place, nkw_import_result code, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    explain(error, code, format, arguments);
    va_end(arguments);
    if (place)
        point(place, error->place, sizeof error->place);
    return 0;
}

int nkwi_fail_at(nkw_import_error *error, const char *place, nkw_import_result code, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    explain(error, code, format, arguments);
    va_end(arguments);
    snprintf(error->place, sizeof error->place, "%s", place);
    return 0;
}
