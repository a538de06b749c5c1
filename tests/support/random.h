/* SPDX-License-Identifier: MIT */
/*
 * Reproducible inputs: xoshiro256** (Blackman, Vigna, Scrambled Linear Pseudorandom Number Generators,
 * 2018), seeded by splitmix64. Every float below comes from integers alone, so the inputs are the same
 * on every target.
 */
#ifndef NAKAWARI_TESTS_RANDOM_H
#define NAKAWARI_TESTS_RANDOM_H

#include <stdint.h>

#include <nakawari/nakawari.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers to be drawn before a source's own, up to `end`. */
typedef struct random_tape {
    const uint64_t *next, *end;
} random_tape;

typedef struct random_source {
    uint64_t s[4];
    random_tape *tape; /* or NULL, as random_from has it */
    int fine; /* random_unit and random_between take 53 bits, so that every float may come */
} random_source;

random_source random_from(uint64_t seed);
uint64_t random_bits(random_source *r);
/* k / 2^24, k uniform: in [0, 1). */
float random_unit(random_source *r);
/* Uniform in [low, high], except for rounding. */
float random_between(random_source *r, float low, float high);
/* Sign and magnitude 2^low .. 2^high, log-uniform, random significand. */
float random_scaled(random_source *r, int low, int high);
/* Any finite float, by bits: subnormals and both zeros included. */
float random_finite(random_source *r);
nkw_vec3 random_vec3(random_source *r, float low, float high);
/* Uniform on the sphere of directions, unit to a few ULPs. */
nkw_vec3 random_direction(random_source *r);
/* Uniform over rotations, unit to a few ULPs. */
nkw_quat random_rotation(random_source *r);
/* A unit quaternion at about `angle` (radians, between the quaternions on the 3-sphere) from q. */
nkw_quat random_near(random_source *r, nkw_quat q, float angle);

#ifdef __cplusplus
}
#endif

#endif
