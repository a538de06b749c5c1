/* SPDX-License-Identifier: MIT */
/*
 * What the benches of tracks, poses and skins play: a skeleton and a clip in which every joint has keys for its translation,
 * rotation and scale, 1/30 s apart.
 */
#ifndef NAKAWARI_BENCH_SCENE_H
#define NAKAWARI_BENCH_SCENE_H

#include <memory>
#include <vector>

#include <nakawari/nakawari.h>

namespace bench
{

/* The parents of `joints` joints, depth first, in chains and branches at most 12 deep; of fewer, the first of these. */
std::vector<int32_t> draw_parents(size_t joints);

/* Local transforms as a character's: bones shorter than 1, any rotation, scale within a tenth of 1. */
nkw_trs local_at(size_t i);

struct scene {
    size_t joints, keys;
    nkw_interpolation mode;
    std::vector<float> times, values, pose;
    std::vector<nkw_clip_track> tracks; /* 3 j, 3 j + 1, 3 j + 2: translation, rotation and scale of joint j */
    std::vector<float> blocks[2]; /* of each format */
    std::vector<uint32_t> cursors;

    const nkw_clip *clip(int format) const
    {
        return reinterpret_cast<const nkw_clip *>(blocks[format].data());
    }
    /* By the tracks alone. */
    nkw_trs joint_at(size_t joint, float time) const;
};

/*
 * still: every so many tracks one that keeps its first key; 0: none. noisy: every so many joints one whose rotation is
 * the identity with the noise of exporters: components of 1e-29 to 1e-23, and a w that is 1 or the float below; 0:
 * none.
 */
std::shared_ptr<scene> draw_scene(size_t joints, size_t keys, nkw_interpolation mode = NKW_INTERPOLATION_LINEAR,
                                  size_t still = 0, size_t noisy = 0);

/* What stands in many programs: track by track, each with its own search and glm's slerp. */
nkw_trs joint_by_hand(const scene &s, size_t joint, float time);

} // namespace bench

#endif
