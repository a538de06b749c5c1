/* SPDX-License-Identifier: MIT */
/* Lists that grow, and tables from keys to numbers. */
#include <stdlib.h>
#include <string.h>

#include "obj.h"
#include "utf8.h"

static int no_memory(const nkwi_obj *o)
{
    return nkwi_fail(o->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the vertices");
}

void *nkwi_obj_add(nkwi_obj *o, nkwi_obj_list *list, size_t size)
{
    if (list->count == list->room) {
        const size_t room = list->room ? 2 * list->room : 64;
        void *data = room <= UINT32_MAX / 2 && room <= SIZE_MAX / size ? realloc(list->data, room * size) : NULL;
        if (!data) {
            no_memory(o);
            return NULL;
        }
        list->data = data;
        list->room = room;
    }
    return memset((char *)list->data + size * list->count++, 0, size);
}

/* FNV-1a of 32-bit parts, mixed. Source: Fowler, Noll, Vo, The FNV Non-Cryptographic Hash Algorithm, 2011. */
static size_t hash_of(const nkwi_obj_key *key)
{
    uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < 4; i++)
        hash = (hash ^ key->parts[i]) * 1099511628211u;
    return (size_t)(hash ^ hash >> 32);
}

/* The slot of a key, or the empty one for it. */
static uint32_t *slot_of(const nkwi_obj_table *t, const nkwi_obj_key *key)
{
    const nkwi_obj_key *keys = (const nkwi_obj_key *)t->keys.data;
    size_t slot = hash_of(key) & (t->room - 1);
    while (t->slots[slot] > 0 && memcmp(&keys[t->slots[slot] - 1], key, sizeof *key) != 0)
        slot = (slot + 1) & (t->room - 1);
    return &t->slots[slot];
}

/* Twice the slots: at most half of them are in use. */
static int widen(nkwi_obj *o, nkwi_obj_table *t)
{
    const size_t room = t->room ? 2 * t->room : 64;
    uint32_t *slots = (uint32_t *)calloc(room, sizeof *slots);
    if (!slots)
        return no_memory(o);
    free(t->slots);
    t->slots = slots;
    t->room = room;
    for (size_t i = 0; i < t->keys.count; i++)
        *slot_of(t, (const nkwi_obj_key *)t->keys.data + i) = (uint32_t)i + 1;
    return 1;
}

int nkwi_obj_number(nkwi_obj *o, nkwi_obj_table *t, const nkwi_obj_key *key, uint32_t *number)
{
    if (2 * (t->keys.count + 1) > t->room && !widen(o, t))
        return 0;
    uint32_t *slot = slot_of(t, key);
    if (*slot == 0) {
        nkwi_obj_key *added = (nkwi_obj_key *)nkwi_obj_add(o, &t->keys, sizeof *added);
        if (!added)
            return 0;
        *added = *key;
        *slot = (uint32_t)t->keys.count;
    }
    *number = *slot - 1;
    return 1;
}

void nkwi_obj_give(nkwi_obj_table *t)
{
    free(t->keys.data);
    free(t->slots);
}

/* ---- Names ---- */

const char *nkwi_obj_name_of(const nkwi_obj *o, uint32_t name)
{
    return ((const char *const *)o->names.data)[name];
}

static int add_name(nkwi_obj *o, const char *text)
{
    const char *copy = nkwi_document_text(o->document, o->error, text);
    const char **name = copy ? (const char **)nkwi_obj_add(o, &o->names, sizeof *name) : NULL;
    if (name)
        *name = copy;
    return name != NULL;
}

/* By the hash of the text; names of one hash differ in the last part of the key. */
int nkwi_obj_name(nkwi_obj *o, nkwi_obj_word w, uint32_t *number)
{
    uint64_t hash = 14695981039346656037u;
    char *text = (char *)malloc(w.length + 1);
    if (!text)
        return no_memory(o);
    for (size_t i = 0; i < w.length; i++)
        text[i] = (char)(w.text[i] ? w.text[i] : '?');
    text[w.length] = 0;
    nkwi_utf8(text, w.length);
    for (size_t i = 0; i < w.length; i++)
        hash = (hash ^ (unsigned char)text[i]) * 1099511628211u;
    nkwi_obj_key key = {{(uint32_t)hash, (uint32_t)(hash >> 32), (uint32_t)w.length, 0}};
    int done;
    for (;; key.parts[3]++) {
        done = nkwi_obj_number(o, &o->name_table, &key, number);
        if (done && *number == o->names.count)
            done = add_name(o, text);
        if (!done || strcmp(nkwi_obj_name_of(o, *number), text) == 0)
            break;
    }
    free(text);
    return done;
}
