/* SPDX-License-Identifier: MIT */
/* Clips of every kind of track in a crowd, and beside their tracks. */
#include "data.h"
#include "hash.h"
#include "random_clip.h"
#include "views.h"

#define JOINTS 19

static random_clip drawn;
static float block[1 << 15];

static const nkw_clip *build(random_source *r, int variety, nkw_clip_format format)
{
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS));
    size_t bytes;
    random_clip_draw(r, JOINTS, variety, &drawn);
    drawn.source.format = format;
    return nkw_clip_build(&drawn.source, bytes_span(block, sizeof block), &bytes, NULL, work) == NKW_OK
               ? (const nkw_clip *)(const void *)block
               : NULL;
}

uint64_t data_clip_more(void)
{
    static float lanes[NKW_CROWD_POSE_FLOATS(JOINTS)];
    NKW_STACK_WORK(work, NKW_CROWD_SAMPLE_WORK(JOINTS));
    random_source r = random_from(31);
    uint64_t hash = HASH_START;
    for (int i = 0; i < 10; i++) {
        const nkw_clip *clip = build(&r, i % 5, i < 5 ? NKW_CLIP_FLOAT32 : NKW_CLIP_UNORM16);
        float times[NKW_CROWD], differences[4];
        NKW_STACK_WORK(room, NKW_CLIP_DIFFERENCE_WORK(JOINTS, RANDOM_CLIP_FLOATS));
        nkw_clip_error error = {0.0f, 0.0f, 0.0f, 0.0f};
        if (!clip)
            return 0;
        for (size_t k = 0; k < NKW_CROWD; k++)
            times[k] = random_between(&r, -0.1f, 1.3f);
        nkw_crowd_players players = {times, NULL, NKW_CROWD};
        nkw_crowd_poses_span crowd = {lanes, JOINTS};
        nkw_crowd_sample(&players, clip, crowd, work);
        hash = hash_floats(hash, lanes, NKW_CROWD_POSE_FLOATS(JOINTS));
        nkw_clip_difference(clip, &drawn.source, &error, room);
        differences[0] = error.translation, differences[1] = error.rotation;
        differences[2] = error.scale, differences[3] = error.floats;
        hash = hash_floats(hash, differences, 4);
    }
    return hash;
}
