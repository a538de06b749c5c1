/* SPDX-License-Identifier: MIT */
#include "xml.h"

#include <stdlib.h>
#include <string.h>

nkwi_xml nkwi_xml_begin(const void *data, size_t bytes)
{
    const nkwi_span none = {NULL, 0};
    nkwi_xml xml = {(const char *)data, (const char *)data + bytes, none, none, 0, 0};
    return xml;
}

int nkwi_span_is(nkwi_span span, const char *text)
{
    return span.data && strlen(text) == span.length && memcmp(span.data, text, span.length) == 0;
}

static int is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static int begins(const nkwi_xml *x, const char *text)
{
    size_t length = strlen(text);
    return (size_t)(x->end - x->at) >= length && memcmp(x->at, text, length) == 0;
}

/* Behind the next occurrence of the text, or at the end. */
static void skip_past(nkwi_xml *x, const char *text)
{
    while (x->at < x->end && !begins(x, text))
        x->at++;
    x->at = x->at < x->end ? x->at + strlen(text) : x->end;
}

/* The end of a tag: the next > outside of quotes. */
static const char *tag_end(const nkwi_xml *x)
{
    char quote = 0;
    for (const char *c = x->at; c < x->end; c++) {
        if (quote)
            quote = *c == quote ? 0 : quote;
        else if (*c == '"' || *c == '\'')
            quote = *c;
        else if (*c == '>')
            return c;
    }
    return NULL;
}

static int read_tag(nkwi_xml *x)
{
    const char *end = tag_end(x), *c = x->at + 1;
    if (!end)
        return 0;
    x->closes = c < end && *c == '/';
    x->is_empty = end[-1] == '/';
    c += x->closes;
    x->name.data = c;
    for (; c < end && !is_space(*c) && *c != '/'; c++)
        if (*c == ':')
            x->name.data = c + 1;
    x->name.length = (size_t)(c - x->name.data);
    x->attributes.data = c;
    x->attributes.length = (size_t)(end - c);
    x->at = end + 1;
    return 1;
}

int nkwi_xml_next(nkwi_xml *x)
{
    for (;;) {
        const char *open = x->at < x->end ? (const char *)memchr(x->at, '<', (size_t)(x->end - x->at)) : NULL;
        if (!open)
            return 0;
        x->at = open;
        if (begins(x, "<!--"))
            skip_past(x, "-->");
        else if (begins(x, "<![CDATA["))
            skip_past(x, "]]>");
        else if (begins(x, "<!") || begins(x, "<?"))
            skip_past(x, ">");
        else
            return read_tag(x);
    }
}

int nkwi_xml_opens(const nkwi_xml *x, const char *name)
{
    return !x->closes && nkwi_span_is(x->name, name);
}

nkwi_span nkwi_xml_attribute(const nkwi_xml *x, const char *key)
{
    const char *c = x->attributes.data, *end = c + x->attributes.length;
    nkwi_span value = {NULL, 0};
    while (c < end) {
        while (c < end && is_space(*c))
            c++;
        nkwi_span name = {c, 0};
        while (c < end && !is_space(*c) && *c != '=')
            c++;
        name.length = (size_t)(c - name.data);
        while (c < end && *c != '"' && *c != '\'')
            c++;
        const char *close = c < end ? (const char *)memchr(c + 1, *c, (size_t)(end - c - 1)) : NULL;
        if (!close)
            return value;
        if (nkwi_span_is(name, key)) {
            value.data = c + 1;
            value.length = (size_t)(close - c - 1);
            return value;
        }
        c = close + 1;
    }
    return value;
}

/* A character as UTF-8; returns its bytes. */
static size_t encode(unsigned long code, char out[4])
{
    if (code < 0x80) {
        out[0] = (char)code;
        return 1;
    }
    if (code < 0x800) {
        out[0] = (char)(0xc0 | code >> 6);
        out[1] = (char)(0x80 | (code & 0x3f));
        return 2;
    }
    size_t n = code < 0x10000 ? 3 : 4;
    out[0] = (char)((n == 3 ? 0xe0 : 0xf0) | code >> (6 * (n - 1)));
    for (size_t i = 1; i < n; i++)
        out[i] = (char)(0x80 | (code >> (6 * (n - 1 - i)) & 0x3f));
    return n;
}

/* An entity at &, up to its semicolon: its text, and its length in the source. 0 for none. */
static size_t entity(const char *at, const char *end, char out[4], size_t *n)
{
    static const struct {
        const char *name;
        char c;
    } known[] = {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        size_t length = strlen(known[i].name);
        if ((size_t)(end - at) >= length && memcmp(at, known[i].name, length) == 0) {
            out[0] = known[i].c;
            *n = 1;
            return length;
        }
    }
    char digits[12] = {0};
    size_t length = 0;
    while (length < sizeof digits - 1 && at + 2 + length < end && at[2 + length] != ';') {
        digits[length] = at[2 + length];
        length++;
    }
    if (end - at < 4 || at[1] != '#' || at + 2 + length == end || at[2 + length] != ';')
        return 0;
    unsigned long code = digits[0] == 'x' ? strtoul(digits + 1, NULL, 16) : strtoul(digits, NULL, 10);
    if (code == 0 || code > 0x10ffff)
        return 0;
    *n = encode(code, out);
    return length + 3;
}

void nkwi_xml_text(const nkwi_xml *x, const char *key, char *out, size_t size)
{
    const nkwi_span value = nkwi_xml_attribute(x, key);
    size_t count = 0;
    for (size_t i = 0; i < value.length && count + 4 < size;) {
        size_t n = 1, used = 0;
        out[count] = value.data[i];
        if (value.data[i] == '&')
            used = entity(value.data + i, value.data + value.length, out + count, &n);
        i += used ? used : 1;
        count += n;
    }
    out[count] = 0;
}
