/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "data.h"
#include "random_clip.h"
#include "views.h"

static random_clip drawn;
static float block[1 << 16], cache[1 << 13];

/* Three times between the same two keys, or nearly so. */
static uint64_t hash_cached(uint64_t hash, const nkw_clip *clip, float time)
{
    float pose[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], floats[RANDOM_CLIP_FLOATS];
    size_t joints = nkw_clip_describe(clip).joint_count;
    for (int i = 0; i < 3; i++, time += 0.003f) {
        if (nkw_clip_sample_cached(clip, time, bytes_span(cache, sizeof cache), pose_span(pose, joints), floats) !=
            NKW_OK)
            return 0;
        hash = nkw_pose_fingerprint(pose_view(pose, joints), hash);
        hash = nkw_fingerprint_floats(floats, nkw_clip_describe(clip).float_count, hash);
    }
    return hash;
}

uint64_t data_clip(void)
{
    random_source r = random_from(2);
    uint64_t hash = 0;
    for (size_t round = 0; round < 36; round++) {
        NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS));
        size_t bytes;
        float pose[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], floats[RANDOM_CLIP_FLOATS];
        size_t joints = 1 + round * 39 / 35;
        random_clip_draw(&r, joints, (int)(round % 3), &drawn);
        drawn.source.format = round % 4 == 3 ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32;
        if (nkw_clip_build(&drawn.source, bytes_span(block, sizeof block), &bytes, NULL, work) != NKW_OK)
            return 0;
        const nkw_clip *clip = (const nkw_clip *)(const void *)block;
        hash = nkw_clip_fingerprint(clip, hash);
        memset(cache, 0, sizeof cache);
        for (int i = 0; i < 20; i++) {
            nkw_clip_sample(clip, random_between(&r, -0.1f, 1.0f), NULL, pose_span(pose, joints), floats);
            hash = nkw_pose_fingerprint(pose_view(pose, joints), hash);
            hash = nkw_fingerprint_floats(floats, nkw_clip_describe(clip).float_count, hash);
            if (i % 4 == 0)
                hash = hash_cached(hash, clip, random_between(&r, -0.1f, 1.0f));
        }
    }
    return hash;
}
