/* SPDX-License-Identifier: MIT */
#include "fuzz.h"
#include "../support/views.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined(__SANITIZE_ADDRESS__)
#define GUARD 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define GUARD 0
#endif
#endif
#ifndef GUARD
#define GUARD 64
#endif
#define GUARD_BYTE 0x5c

void fuzz_check(int holds, const char *what, const char *file, int line)
{
    if (holds)
        return;
    fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, what);
    fflush(stderr);
    abort();
}

fuzz fuzz_begin(const uint8_t *data, size_t size)
{
    fuzz f;
    memset(&f, 0, sizeof f);
    f.data = data;
    f.size = size;
    return f;
}

static int is_guard(const unsigned char *p)
{
    int whole = 1;
    for (size_t i = GUARD; i-- > 0;)
        whole &= p[i] == GUARD_BYTE;
    return whole;
}

int fuzz_end(fuzz *f)
{
    for (size_t i = 0; i < f->blocks; i++) {
        unsigned char *memory = f->block[i].memory;
        FUZZ_CHECK(is_guard(memory) && is_guard(memory + GUARD + f->block[i].bytes));
        free(memory);
    }
    return 0;
}

/* ---- From the input ---- */

unsigned char fuzz_byte(fuzz *f)
{
    if (f->size == 0)
        return 0;
    f->size--;
    return *f->data++;
}

uint32_t fuzz_bits(fuzz *f)
{
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++)
        bits = bits << 8 | fuzz_byte(f);
    return bits;
}

size_t fuzz_upto(fuzz *f, size_t n)
{
    size_t bits = fuzz_byte(f);
    if (n > 255)
        bits = bits << 8 | fuzz_byte(f);
    return bits % (n + 1);
}

int fuzz_choice(fuzz *f, int n)
{
    int byte = fuzz_byte(f);
    return byte >= 240 ? byte : byte % (n + 1);
}

size_t fuzz_huge(fuzz *f)
{
    unsigned shift = fuzz_byte(f) % (8 * (unsigned)sizeof(size_t));
    size_t small = fuzz_byte(f);
    size_t power = (size_t)1 << shift;
    return small < 128 ? small : power - 128 + small % 128;
}

static float float_from(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static float special(uint32_t bits)
{
    static const uint32_t list[] = {0x7fc00000u, 0x7f800000u, 0xff800000u, 0x7f7fffffu, 0xff7fffffu, 0x00000001u,
                                    0x80000000u, 0x00800000u, 0x3f800000u, 0xbf800000u, 0x5d800000u, 0x4b800000u};
    return float_from(list[bits % (sizeof list / sizeof *list)]);
}

static float float_of_kind(unsigned kind, uint32_t bits)
{
    return kind % 4 == 0 ? float_from(bits) : kind % 4 == 1 ? special(bits) : (float)(bits % 4096) / 512.0f - 4.0f;
}

float fuzz_float(fuzz *f)
{
    unsigned kind = fuzz_byte(f);
    return float_of_kind(kind, kind % 4 == 1 ? fuzz_byte(f) : fuzz_bits(f));
}

random_source fuzz_source(fuzz *f)
{
    return random_from(fuzz_bits(f));
}

/* ---- Memory ---- */

void *fuzz_block(fuzz *f, size_t bytes)
{
    unsigned char *memory = malloc(2 * GUARD + (bytes ? bytes : 1));
    fuzz_check(memory != NULL && f->blocks < FUZZ_BLOCKS, "there is memory", __FILE__, __LINE__);
    memset(memory, GUARD_BYTE, 2 * GUARD + bytes);
    memset(memory + GUARD, 0xa5, bytes);
    f->block[f->blocks].memory = memory;
    f->block[f->blocks].bytes = bytes;
    f->blocks++;
    return memory + GUARD;
}

float *fuzz_room(fuzz *f, size_t floats)
{
    return fuzz_block(f, floats * sizeof(float));
}

/* One in 8 .. one in 256 elements of a wild array is anything. */
static uint64_t rarity(fuzz *f, int wild)
{
    return wild ? (uint64_t)8 << fuzz_byte(f) % 6 : 0;
}

static int strikes(random_source *r, uint64_t rare)
{
    return rare && random_bits(r) % rare == 0;
}

static float anything(random_source *r)
{
    uint64_t bits = random_bits(r);
    return float_of_kind((unsigned)(bits >> 62), (uint32_t)bits);
}

float *fuzz_floats(fuzz *f, size_t count, int wild)
{
    float *v = fuzz_room(f, count);
    random_source r = fuzz_source(f);
    uint64_t rare = rarity(f, wild);
    for (size_t i = 0; i < count; i++)
        v[i] = strikes(&r, rare) ? anything(&r) : random_between(&r, -4.0f, 4.0f);
    return v;
}

void *fuzz_bytes(fuzz *f, size_t bytes)
{
    unsigned char *v = fuzz_block(f, bytes);
    random_source r = fuzz_source(f);
    unsigned mask = fuzz_byte(f);
    for (size_t i = 0; i < bytes; i++)
        v[i] = (unsigned char)(random_bits(&r) & mask);
    return v;
}

int32_t *fuzz_links(fuzz *f, size_t n, size_t count, int wild)
{
    int32_t *v = fuzz_block(f, n * sizeof *v);
    random_source r = fuzz_source(f);
    uint64_t rare = rarity(f, wild);
    for (size_t i = 0; i < n; i++)
        v[i] = strikes(&r, rare) ? (int32_t)(uint32_t)random_bits(&r) : (int32_t)(random_bits(&r) % (count + 1)) - 1;
    return v;
}

int32_t *fuzz_parents(fuzz *f, size_t n, int wild)
{
    int32_t *v = fuzz_block(f, n * sizeof *v);
    random_source r = fuzz_source(f);
    uint64_t rare = rarity(f, wild);
    for (size_t i = 0; i < n; i++) {
        uint64_t bits = random_bits(&r);
        v[i] = i == 0 || bits % 16 == 0 ? -1 : bits % 4 ? (int32_t)i - 1 : (int32_t)((bits >> 8) % i);
        if (strikes(&r, rare))
            v[i] = bits % 2 ? (int32_t)(uint32_t)(bits >> 16) : (int32_t)((bits >> 16) % n);
    }
    return v;
}

float *fuzz_pose(fuzz *f, size_t joints, int wild)
{
    float *pose = fuzz_floats(f, NKW_POSE_FLOATS(joints), 1);
    random_source r = fuzz_source(f);
    uint64_t rare = rarity(f, wild);
    for (size_t j = 0; j < joints; j++) {
        nkw_trs trs = {random_vec3(&r, -4, 4), random_rotation(&r), random_vec3(&r, 0.5f, 2)};
        nkw_pose_set(pose_span(pose, joints), j, &trs);
        if (strikes(&r, rare))
            pose[random_bits(&r) % 10 * NKW_POSE_STRIDE(joints) + j] = anything(&r);
    }
    return pose;
}

nkw_mat4 *fuzz_matrices(fuzz *f, size_t n, int wild)
{
    nkw_mat4 *m = fuzz_block(f, n * sizeof *m);
    random_source r = fuzz_source(f);
    uint64_t rare = rarity(f, wild);
    for (size_t i = 0; i < n; i++) {
        nkw_trs trs = {random_vec3(&r, -4, 4), random_rotation(&r), random_vec3(&r, 0.5f, 2)};
        m[i] = nkw_mat4_from_trs(&trs);
        if (strikes(&r, rare))
            m[i].m[random_bits(&r) % 16] = anything(&r);
    }
    return m;
}

/* ---- Promises ---- */

int fuzz_finite(const float *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!(v[i] - v[i] == 0.0f))
            return 0;
    return 1;
}

int fuzz_same(const float *a, const float *b, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (memcmp(a + i, b + i, sizeof *a) != 0 && !(a[i] != a[i] && b[i] != b[i]))
            return 0;
    return 1;
}

int fuzz_affine(const nkw_mat4 *m, size_t n)
{
    static const float last[4] = {0, 0, 0, 1};
    for (size_t i = 0; i < n; i++)
        for (size_t c = 0; c < 4; c++)
            if (!fuzz_same(&m[i].m[4 * c + 3], last + c, 1))
                return 0;
    return 1;
}
