/* SPDX-License-Identifier: MIT */
/* Plays two clips of a glTF file, the second faded in after a second, and prints the box of the skinned vertices. */
#include <stdio.h>
#include <stdlib.h>

#include <nakawari/import.h>

int main(int argc, char **argv)
{
    nkw_document *document;
    nkw_import_error error;
    nkw_character c;
    nkw_bytes_span block = {NULL, 0};
    if (argc != 2 || nkw_document_open(argv[1], &document, &error) != NKW_IMPORT_OK)
        return fprintf(stderr, "usage: nakawari-play FILE.glb\n"), 1;

    /* The set-up: asks for the size, then builds skeleton, clips, skins and parts into one block. */
    nkw_document_character(document, NKW_CLIP_FLOAT32, block, &block.bytes, NULL, &error);
    block.data = malloc(block.bytes);
    if (!block.data || nkw_document_character(document, NKW_CLIP_FLOAT32, block, &block.bytes, &c, &error))
        return fprintf(stderr, "%s: %s\n", error.place, error.reason), 1;

    /* The memory of a frame. */
    const size_t joints = c.skeleton.joint_count, slots = 2, floats = c.set.float_count;
    const nkw_pose_span pose = {malloc(NKW_POSE_FLOATS(joints) * sizeof(float)), joints};
    nkw_mixer_frame frame = {.pose = pose, .floats = malloc((floats + 1) * sizeof(float))};
    nkw_mat4 *models = malloc(joints * sizeof *models),
             *palette = malloc((c.palette.joint_count + 1) * sizeof *palette);
    nkw_vec3 *vertices = malloc((c.most_vertices + 1) * sizeof *vertices);
    const nkw_work work = {malloc(NKW_MIXER_WORK(slots, joints, floats)), NKW_MIXER_WORK(slots, joints, floats)};
    if (!pose.data || !frame.floats || !models || !palette || !vertices || !work.data)
        return fprintf(stderr, "no memory\n"), 1;

    nkw_mixer mixer = {0};
    for (int k = 0; k <= 120; k++) { /* 2 s at 60 frames a second */
        if (k % 60 == 0 && k / 60 < 2 && (size_t)k / 60 < c.set.clip_count) {
            const nkw_mixer_options play = {
                .clip = (uint32_t)k / 60, .mode = NKW_PLAYBACK_LOOP, .fade = k ? 0.5f : 0.0f};
            nkw_mixer_play(&mixer, &c.set, &play, NULL);
        }
        nkw_mixer_advance(&mixer, &c.set, k ? 1.0 / 60.0 : 0.0, &frame, work);
        nkw_character_palette(&c, NKW_VIEW(nkw_pose, pose), NULL, models, palette);
        nkw_box box = NKW_BOX_EMPTY;
        for (size_t p = 0; p < c.part_count; p++) {
            nkw_character_vertices(&c, p, frame.floats, palette, (nkw_vertices_span){.positions = {vertices, 0}});
            const nkw_box part = nkw_box_from_points(vertices, c.parts[p].skin.vertex_count);
            box = nkw_box_union(&box, &part);
        }
        if (k % 15 == 0)
            printf("%.2f s: %.4f %.4f %.4f to %.4f %.4f %.4f\n", k / 60.0, (double)box.low.x, (double)box.low.y,
                   (double)box.low.z, (double)box.high.x, (double)box.high.y, (double)box.high.z);
    }
    free(work.data), free(vertices), free(palette), free(models), free(frame.floats), free(pose.data), free(block.data);
    nkw_document_close(document);
    return 0;
}
