/* SPDX-License-Identifier: MIT */
/* Reduced clips of every kind of track. */
#include "data.h"
#include "random_clip.h"
#include "views.h"

#define JOINTS 33

static random_clip drawn;
static float block[1 << 17];
static double work[NKW_CLIP_REDUCE_WORK(RANDOM_CLIP_TRACKS, JOINTS, RANDOM_CLIP_FLOATS) / 8 + 2];
static int32_t parents[JOINTS];

uint64_t data_clip_reduce(void)
{
    random_source r = random_from(47);
    uint64_t hash = 0;
    for (int i = 0; i < 4; i++) {
        float pose[NKW_POSE_FLOATS(JOINTS)], floats[RANDOM_CLIP_FLOATS], numbers[4];
        const nkw_clip_reduction reduction = {parents, i < 2 ? 1e-3f : 1e-1f, 0.5f, NULL, NULL, 1e-3f};
        const nkw_bytes_span span = {block, sizeof block};
        nkw_clip_reduced reduced;
        random_clip_draw(&r, JOINTS, i % 4 == 3 ? 2 : i % 2, &drawn);
        for (size_t j = 0; j < JOINTS; j++)
            parents[j] = j % 8 == 0 ? -1 : (int32_t)j - 1;
        if (nkw_clip_reduce(&drawn.source, &reduction, span, &reduced, NULL, work_in(work, sizeof work)) != NKW_OK)
            return 0;
        const nkw_clip *clip = (const nkw_clip *)(const void *)block;
        numbers[0] = reduced.distance, numbers[1] = reduced.share, numbers[2] = reduced.floats;
        numbers[3] = (float)(int)(reduced.bytes + reduced.constant_count + reduced.packed_count);
        hash = nkw_clip_fingerprint(clip, nkw_fingerprint_floats(numbers, 4, hash));
        for (int k = 0; k < 40; k++) {
            nkw_clip_sample(clip, random_clip_time(&r, &drawn, k), NULL, pose_span(pose, JOINTS), floats);
            hash = nkw_pose_fingerprint(pose_view(pose, JOINTS), hash);
            hash = nkw_fingerprint_floats(floats, nkw_clip_describe(clip).float_count, hash);
        }
    }
    return hash;
}
