/* SPDX-License-Identifier: MIT */
/*
 * Clips of both byte orders: each file was written by a machine of that order, and must be converted on every machine
 * to the blocks that this one builds, byte for byte, with the same fingerprints.
 *
 *     byte_order DIR            compares DIR/clips.little and DIR/clips.big; exit status 1 if a byte differs
 *     byte_order DIR --write    writes the file of this machine's order
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/nakawari.h>

#include "../support/random_clip.h"
#include "../support/views.h"

enum { JOINTS = 5, CLIPS = 4, MOST = 1 << 16 };

/* The clips one after another, each in MOST bytes at most; as words, for their alignment. */
typedef struct blocks {
    size_t bytes[CLIPS];
    uint32_t words[CLIPS][MOST / 4];
} blocks;

static const char *const joint_names[JOINTS] = {"root", "spine", "", "左手", "right hand"};
static const char *const float_names[RANDOM_CLIP_FLOATS] = {"smile", "眉"}; /* NULL: the empty text */
static const nkw_clip_names names = {"walk", joint_names, NULL}, with_floats = {"walk", joint_names, float_names};

/* XXH64 of the blocks of clips.little, by a program of its own and by xxhash-wasm 1.1.0. */
static const uint64_t fingerprints[CLIPS] = {UINT64_C(0x8a3814bd288a7aef), UINT64_C(0x6834594b2f0056c7),
                                             UINT64_C(0xbfaa25a854202c34), UINT64_C(0xc8dc125af3036861)};

/* Reduces the motion of each track to 1/1024, about its first key. */
static void make_small(random_clip *c)
{
    for (size_t i = 0; i < c->source.track_count; i++) {
        const nkw_track *t = &c->tracks[i].track;
        for (size_t at = t->width; at < t->width * t->count; at++)
            c->values[i][at] = nkw_lerp(c->values[i][at % t->width], c->values[i][at], 0x1p-10f);
        for (size_t k = 0; t->kind != NKW_TRACK_FLOATS && k < t->count; k++) {
            nkw_quat q;
            memcpy(&q, c->values[i] + 4 * k, sizeof q);
            q = nkw_quat_normalize(q);
            memcpy(c->values[i] + 4 * k, &q, sizeof q);
        }
    }
}

/*
 * Clip 0 of floats, 1 compact, 2 reduced; 3 reduced to the rounding of floats: its steps are smaller than the distance
 * of its bases to the next floats. Returns 0 after an error.
 */
static int build(int index, blocks *out)
{
    static double room[NKW_CLIP_REDUCE_WORK(RANDOM_CLIP_TRACKS, RANDOM_CLIP_JOINTS, RANDOM_CLIP_FLOATS) / 8 + 2];
    const nkw_work work = work_in(room, sizeof room);
    const nkw_bytes_span block = bytes_span(out->words[index], MOST);
    static random_clip drawn;
    random_source r = random_from(index == 3 ? 8 : 7);
    size_t bad;
    random_clip_draw(&r, JOINTS, index >= 2 ? 0 : 2, &drawn);
    drawn.source.names = index == 1 ? &with_floats : &names;
    drawn.source.format = index == 1 ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32;
    if (index < 2)
        return nkw_clip_build(&drawn.source, block, &out->bytes[index], &bad, work) == NKW_OK;
    if (index == 3)
        make_small(&drawn);
    const float tolerance = index == 2 ? 0.01f : 4e-8f;
    const nkw_clip_reduction reduction = {NULL, tolerance, 0.1f, NULL, NULL, tolerance};
    nkw_clip_reduced reduced;
    nkw_result result = nkw_clip_reduce(&drawn.source, &reduction, block, &reduced, &bad, work);
    out->bytes[index] = reduced.bytes;
    return result == NKW_OK && reduced.packed_count > 0;
}

static int is_little(void)
{
    const uint32_t one = 1;
    return *(const unsigned char *)&one == 1;
}

static FILE *open_file(const char *folder, int little, const char *mode)
{
    char path[1024];
    if (strlen(folder) + 20 > sizeof path)
        return NULL;
    sprintf(path, "%s/clips.%s", folder, little ? "little" : "big");
    return fopen(path, mode);
}

static int write_file(const char *folder, const blocks *b)
{
    FILE *f = open_file(folder, is_little(), "wb");
    int is_written = f != NULL;
    for (int i = 0; is_written && i < CLIPS; i++)
        is_written = fwrite(b->words[i], 1, b->bytes[i], f) == b->bytes[i];
    return f && fclose(f) == 0 && is_written;
}

/* Reads the clips of a file one after another, as large as this machine's, converts and compares them. */
static int compare_file(const char *folder, int little, const blocks *b)
{
    static uint32_t read[MOST / 4], converted[MOST / 4];
    FILE *f = open_file(folder, little, "rb");
    int is_same = f != NULL;
    for (int i = 0; is_same && i < CLIPS; i++) {
        const nkw_clip *clip;
        is_same = fread(read, 1, b->bytes[i], f) == b->bytes[i] &&
                  (nkw_clip_open(read, b->bytes[i], &clip) == NKW_OK) == (little == is_little()) &&
                  nkw_clip_convert(read, b->bytes[i], converted, &clip) == NKW_OK &&
                  memcmp(converted, b->words[i], b->bytes[i]) == 0 &&
                  nkw_clip_fingerprint(clip, 0) == fingerprints[i] &&
                  strcmp(nkw_clip_joint_name(clip, 3), "左手") == 0 &&
                  strcmp(nkw_clip_float_name(clip, 1), i == 1 ? "眉" : "") == 0;
        if (!is_same)
            printf("clips.%s: clip %d differs\n", little ? "little" : "big", i);
    }
    if (!f)
        printf("clips.%s: cannot be read\n", little ? "little" : "big");
    else
        fclose(f);
    return is_same;
}

int main(int argc, char **argv)
{
    static blocks b;
    if (argc < 2)
        return 2;
    for (int i = 0; i < CLIPS; i++)
        if (!build(i, &b)) {
            printf("clip %d is not built\n", i);
            return 1;
        }
    if (argc > 2)
        return strcmp(argv[2], "--write") == 0 ? !write_file(argv[1], &b) : 2;
    int little = compare_file(argv[1], 1, &b), big = compare_file(argv[1], 0, &b);
    return little && big ? 0 : 1;
}
