/* SPDX-License-Identifier: MIT */
/* The tags of an XML text, one after another: for what a reader of the whole file has lost. Nothing is checked. */
#ifndef NAKAWARI_IMPORT_XML_H
#define NAKAWARI_IMPORT_XML_H

#include <stddef.h>

/* A part of the text. */
typedef struct nkwi_span {
    const char *data;
    size_t length;
} nkwi_span;

typedef struct nkwi_xml {
    const char *at, *end; /* what follows the tag */
    nkwi_span name; /* without the prefix of a namespace */
    nkwi_span attributes;
    int closes; /* </name> */
    int is_empty; /* <name/> */
} nkwi_xml;

nkwi_xml nkwi_xml_begin(const void *data, size_t bytes);

/* The next tag; 0 after the last. Comments, CDATA and declarations are passed over. */
int nkwi_xml_next(nkwi_xml *xml);

/* Whether it is the beginning of such an element. */
int nkwi_xml_opens(const nkwi_xml *xml, const char *name);

int nkwi_span_is(nkwi_span span, const char *text);

/* The value of an attribute as in the text; data is NULL where there is none. */
nkwi_span nkwi_xml_attribute(const nkwi_xml *xml, const char *key);

/* The value with its entities replaced, cut to `size` bytes; "" where there is none. */
void nkwi_xml_text(const nkwi_xml *xml, const char *key, char *out, size_t size);

#endif
