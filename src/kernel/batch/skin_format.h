/* SPDX-License-Identifier: MIT */
/* The formats of skin.h: the joint index or the weight at an address. */
#ifndef NAKAWARI_SKIN_FORMAT_H
#define NAKAWARI_SKIN_FORMAT_H

#include "lane/strict.h"

#include <string.h>

#include <nakawari/skin.h>

static inline size_t skin_format_size(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 ? 1 : format == NKW_SKIN_U16 ? 2 : 4;
}

static inline int skin_format_is_joint(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 || format == NKW_SKIN_U16 || format == NKW_SKIN_U32 || format == NKW_SKIN_F32;
}

static inline int skin_format_is_weight(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 || format == NKW_SKIN_U16 || format == NKW_SKIN_F32;
}

/* The bytes from vertex to vertex. */
static inline size_t skin_stride(size_t stride, nkw_skin_format format, size_t influence_count)
{
    return stride ? stride : influence_count * skin_format_size(format);
}

/* The weight at p; 0 in a format that is not for weights. */
static inline float skin_weight(const unsigned char *p, nkw_skin_format format)
{
    uint16_t u16;
    float f32;
    switch (format) {
    case NKW_SKIN_U8:
        return (float)*p / 255.0f;
    case NKW_SKIN_U16:
        memcpy(&u16, p, sizeof u16);
        return (float)u16 / 65535.0f;
    case NKW_SKIN_F32:
        memcpy(&f32, p, sizeof f32);
        return f32;
    default:
        return 0.0f;
    }
}

/* What is no joint: beyond every palette. */
#define SKIN_NO_JOINT UINT32_MAX
/* Floats up to it have all whole numbers. */
#define SKIN_FLOAT_JOINTS 0x1p24f

/* The whole number 0 .. 2^24 that a float is; SKIN_NO_JOINT for all others, NaN too. */
static inline uint32_t skin_joint_of_float(float f)
{
    const int32_t j = (int32_t)(f >= 0.0f && f <= SKIN_FLOAT_JOINTS ? f : 0.0f);
    return (float)j == f ? (uint32_t)j : SKIN_NO_JOINT;
}

/* The joint index at p; 0 in a format that is not for joints. */
static inline uint32_t skin_joint(const unsigned char *p, nkw_skin_format format)
{
    uint16_t u16;
    uint32_t u32;
    float f32;
    switch (format) {
    case NKW_SKIN_U8:
        return *p;
    case NKW_SKIN_U16:
        memcpy(&u16, p, sizeof u16);
        return u16;
    case NKW_SKIN_U32:
        memcpy(&u32, p, sizeof u32);
        return u32;
    case NKW_SKIN_F32:
        memcpy(&f32, p, sizeof f32);
        return skin_joint_of_float(f32);
    default:
        return 0;
    }
}

#endif
