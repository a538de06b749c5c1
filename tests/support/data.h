/* SPDX-License-Identifier: MIT */
/*
 * The functions on sets of data on fixed inputs: data_<stem>() in data_<stem>.c calls the stem's functions and returns one hash
 * of all results. `golden` compares the hashes with its table, `parity` those of each instruction set with the
 * baseline's.
 */
#ifndef NAKAWARI_TESTS_DATA_H
#define NAKAWARI_TESTS_DATA_H

#include <stdint.h>

#define DATA_LIST(X) \
    X(pose) \
    X(clip) \
    X(blend) \
    X(partition) \
    X(dual) \
    X(palette) \
    X(skin) \
    X(skin_options) \
    X(skeleton) \
    X(crowd) \
    X(clip_more) \
    X(crowd_skin) \
    X(clip_reduce) \
    X(spline) \
    X(ik) \
    X(foot) \
    X(retarget) \
    X(blendspace) \
    X(layer) \
    X(morph) \
    X(bounds) \
    X(mesh) \
    X(transition) \
    X(records) \
    X(clip_motion) \
    X(chunk) \
    X(mixer) \
    X(nurbs) \
    X(polycurve)

#ifdef __cplusplus
extern "C" {
#endif

#define DATA_DECLARE(stem) uint64_t data_##stem(void);
DATA_LIST(DATA_DECLARE)
#undef DATA_DECLARE

#ifdef __cplusplus
}
#endif

#endif
