/* SPDX-License-Identifier: MIT */
#include "random.h"

#include <float.h>
#include <string.h>

static uint64_t splitmix(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

static uint64_t turned_left(uint64_t x, int k)
{
    return (x << k) | (x >> (64 - k));
}

random_source random_from(uint64_t seed)
{
    random_source r;
    for (int i = 0; i < 4; i++)
        r.s[i] = splitmix(&seed);
    r.tape = NULL;
    r.fine = 0;
    return r;
}

uint64_t random_bits(random_source *r)
{
    if (r->tape && r->tape->next < r->tape->end)
        return *r->tape->next++;
    uint64_t result = turned_left(r->s[1] * 5, 7) * 9;
    uint64_t t = r->s[1] << 17;
    r->s[2] ^= r->s[0];
    r->s[3] ^= r->s[1];
    r->s[1] ^= r->s[2];
    r->s[0] ^= r->s[3];
    r->s[2] ^= t;
    r->s[3] = turned_left(r->s[3], 45);
    return result;
}

static float float_from(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static double unit_number(random_source *r)
{
    uint64_t bits = random_bits(r);
    return r->fine ? (double)(bits >> 11) * 0x1p-53 : (double)(bits >> 40) * 0x1p-24;
}

float random_unit(random_source *r)
{
    double unit = unit_number(r);
    return unit < 1.0 - 0x1p-25 ? (float)unit : 1.0f - 0x1p-24f;
}

/* In binary64: the span and its product with a unit number are exact or rounded the same everywhere. */
float random_between(random_source *r, float low, float high)
{
    double unit = unit_number(r);
    double span = ((double)high - (double)low) * unit;
    return (float)((double)low + span);
}

/* 2^e (1 + k/2^23), e uniform in low .. high - 1; below 2^-126 the last bits are rounded away. */
float random_scaled(random_source *r, int low, int high)
{
    uint64_t bits = random_bits(r);
    uint64_t exponent = (bits >> 32) % (uint64_t)(high > low ? high - low : 1);
    uint64_t scale = (uint64_t)((int64_t)exponent + low + 1023) << 52;
    uint64_t significand = (bits & 0x7FFFFFu) << 29;
    uint64_t sign = (bits >> 31 & 1u) << 63;
    uint64_t whole = sign | scale | significand;
    double x;
    memcpy(&x, &whole, sizeof x);
    return (float)x;
}

float random_finite(random_source *r)
{
    uint32_t bits;
    do {
        bits = (uint32_t)(random_bits(r) >> 32);
    } while ((bits & 0x7F800000u) == 0x7F800000u);
    return float_from(bits);
}

nkw_vec3 random_vec3(random_source *r, float low, float high)
{
    nkw_vec3 v;
    v.x = random_between(r, low, high);
    v.y = random_between(r, low, high);
    v.z = random_between(r, low, high);
    return v;
}

/* A point of the ball of radius 1, not too near its centre, scaled to the sphere. */
nkw_vec3 random_direction(random_source *r)
{
    nkw_vec3 v;
    float xx, yy, zz, square, length;
    do {
        v = random_vec3(r, -1.0f, 1.0f);
        xx = v.x * v.x;
        yy = v.y * v.y;
        zz = v.z * v.z;
        square = (xx + yy) + zz;
    } while (square > 1.0f || square < 0x1p-10f);
    length = nkw_sqrt(square);
    v.x /= length;
    v.y /= length;
    v.z /= length;
    return v;
}

/* Squares of floats are exact in binary64, so a contracted sum would be the same. */
static nkw_quat scaled_to_unit(nkw_quat q)
{
    double x = (double)q.x, y = (double)q.y, z = (double)q.z, w = (double)q.w;
    double xx = x * x, yy = y * y, zz = z * z, ww = w * w;
    float length = nkw_sqrt((float)((xx + yy) + (zz + ww)));
    q.x /= length;
    q.y /= length;
    q.z /= length;
    q.w /= length;
    return q;
}

/* The same on the ball in four dimensions. */
nkw_quat random_rotation(random_source *r)
{
    nkw_quat q;
    float xx, yy, zz, ww, square;
    do {
        q.x = random_between(r, -1.0f, 1.0f);
        q.y = random_between(r, -1.0f, 1.0f);
        q.z = random_between(r, -1.0f, 1.0f);
        q.w = random_between(r, -1.0f, 1.0f);
        xx = q.x * q.x;
        yy = q.y * q.y;
        zz = q.z * q.z;
        ww = q.w * q.w;
        square = (xx + yy) + (zz + ww);
    } while (square > 1.0f || square < 0x1p-10f);
    return scaled_to_unit(q);
}

/*
 * q cos(angle) + p sin(angle), p = q times a random direction taken as a pure quaternion: p has unit length
 * and stands at right angles to q.
 */
nkw_quat random_near(random_source *r, nkw_quat q, float angle)
{
    nkw_vec3 v = random_direction(r);
    double x = (double)q.x, y = (double)q.y, z = (double)q.z, w = (double)q.w;
    double vx = (double)v.x, vy = (double)v.y, vz = (double)v.z;
    double s = (double)nkw_sin(angle), c = (double)nkw_cos(angle);
    double wx = w * vx, yz = y * vz, zy = z * vy;
    double wy = w * vy, zx = z * vx, xz = x * vz;
    double wz = w * vz, xy = x * vy, yx = y * vx;
    double xx = x * vx, yy = y * vy, zz = z * vz;
    double px = s * (wx + (yz - zy)), qx = c * x;
    double py = s * (wy + (zx - xz)), qy = c * y;
    double pz = s * (wz + (xy - yx)), qz = c * z;
    double pw = s * -((xx + yy) + zz), qw = c * w;
    nkw_quat near_q;
    near_q.x = (float)(qx + px);
    near_q.y = (float)(qy + py);
    near_q.z = (float)(qz + pz);
    near_q.w = (float)(qw + pw);
    return scaled_to_unit(near_q);
}
