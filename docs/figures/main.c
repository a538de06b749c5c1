/* SPDX-License-Identifier: MIT */
/* nakawari-figures DIR: draws every figure of the floor pages into DIR. */
#include <stdio.h>
#include <string.h>

#include "figure.h"

static const struct {
    const char *name;
    int (*draw)(const char *path);
} figures[] = {
    {"curve-bases", figure_curve_bases},         {"curve-four", figure_curve_four},
    {"curve-uneven", figure_curve_uneven},       {"curve-tangents", figure_curve_tangents},
    {"orient-speed", figure_orient_speed},       {"orient-paths", figure_orient_paths},
    {"orient-shorter", figure_orient_shorter},   {"orient-euler", figure_orient_euler},
    {"euler-pole", figure_euler_pole},           {"segment-lookup", figure_segment_lookup},
    {"mat-layout", figure_mat_layout},           {"scalar-lerp", figure_scalar_lerp},
    {"clip-layout", figure_clip_layout},         {"skeleton-order", figure_skeleton_order},
    {"skeleton-models", figure_skeleton_models}, {"blend-poses", figure_blend_poses},
    {"palette-layouts", figure_palette_layouts}, {"crowd-lanes", figure_crowd_lanes},
    {"skin-twist", figure_skin_twist},           {"partition-parts", figure_partition_parts},
    {"axes-tools", figure_axes_tools},
};

int main(int argc, char **argv)
{
    char path[1024];
    if (argc != 2 || strlen(argv[1]) + 32 > sizeof path) {
        fputs("usage: nakawari-figures DIR\n", stderr);
        return 2;
    }
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++) {
        sprintf(path, "%s/%s.svg", argv[1], figures[i].name);
        if (!figures[i].draw(path)) {
            perror(path);
            return 1;
        }
    }
    return 0;
}
