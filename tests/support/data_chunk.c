/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "data.h"
#include "hash.h"
#include "random_clip.h"
#include "views.h"

enum { CHUNKS = 4, JOINTS = 20 };

typedef struct scene {
    random_clip drawn;
    nkw_clip_track tracks[RANDOM_CLIP_TRACKS];
    uint32_t blocks[CHUNKS][64 * 1024];
    unsigned char work[NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS)];
    nkw_chunk manifest[CHUNKS];
    const nkw_clip *clips[CHUNKS];
    float pose[NKW_POSE_FLOATS(JOINTS)], floats[RANDOM_CLIP_FLOATS];
} scene;

static void build(scene *s)
{
    for (size_t k = 0; k < CHUNKS; k++) {
        const float from = 0.25f * (float)k;
        nkw_clip_source source;
        size_t bytes;
        nkw_clip_source_part(&s->drawn.source, from, from + 0.25f, s->tracks, &source);
        nkw_clip_build(&source, bytes_span(s->blocks[k], sizeof s->blocks[k]), &bytes, NULL,
                       work_in(s->work, sizeof s->work));
        s->clips[k] = (const nkw_clip *)(const void *)s->blocks[k];
        s->manifest[k] = nkw_chunk_from_clip(s->clips[k], from, from + 0.25f);
    }
}

uint64_t data_chunk(void)
{
    static scene s;
    uint64_t hash = HASH_START;
    random_source r = random_from(41);
    for (int i = 0; i < 4; i++) {
        random_clip_draw(&r, JOINTS, i, &s.drawn);
        build(&s);
        for (size_t k = 0; k < CHUNKS; k++)
            for (size_t w = 0; w < 2; w++) {
                const float halves[2] = {(float)(s.manifest[k].fingerprint[w] >> 16),
                                         (float)(s.manifest[k].fingerprint[w] & 0xffff)};
                hash = hash_floats(hash, halves, 2);
            }
        s.clips[2] = NULL;
        const nkw_chunks chunks = {s.manifest, s.clips, CHUNKS};
        for (int k = 0; k < 9; k++) {
            nkw_chunks_sample(&chunks, 0.11f * (float)k, pose_span(s.pose, JOINTS), s.floats, NULL);
            for (size_t c = 0; c < 10; c++)
                hash = hash_floats(hash, s.pose + c * NKW_POSE_STRIDE(JOINTS), JOINTS);
            hash = hash_floats(hash, s.floats, s.drawn.source.float_count);
        }
    }
    return hash;
}
