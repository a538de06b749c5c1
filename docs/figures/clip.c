/* SPDX-License-Identifier: MIT */
/* A picture of a clip's memory: its sections, and the keys of rotations in blocks of lanes. */
#include "figure.h"

#include <stdio.h>

enum { BLOCK = 16, ROWS = 5, VALUES = 4, NARROW = 4, LANES = 19 }; /* lanes in use, of two blocks */

static const float lane = 17.0f;
static const svg_colour value_colour = 0x1f5fd0, arc_colour = 0xe07b00, fill_colour = 0x9a9aa2;

/* ---- the sections of the block ---- */

static const struct {
    const char *name, *said;
    float width;
    svg_colour colour;
} sections[] = {
    {"head", "version, sizes", 92.0f, 0x55555c},     {"timelines", "one search each", 112.0f, 0x2c8c4a},
    {"groups", "what is alike", 104.0f, 0x2c8c4a},   {"blocks", "where lanes go", 112.0f, 0x2c8c4a},
    {"runs", "of constants", 98.0f, 0x2c8c4a},       {"times", "of the keys", 92.0f, 0x6a4a9c},
    {"constants", "stored once", 104.0f, 0x6a4a9c},  {"keys", "key after key", 92.0f, 0x1f5fd0},
    {"keys", "of the next group", 134.0f, 0x1f5fd0},
};

static void section_strip(svg *s, float x, float y)
{
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        svg_box box = {x, y, sections[i].width - 3.0f, 46.0f};
        svg_paint paint = {svg_mix(0xffffff, sections[i].colour, 0.14f), sections[i].colour, 1.4f, 1.0f, NULL};
        svg_rect(s, box, 4.0f, &paint);
        figure_bold(s, x + box.width / 2.0f, y + 20.0f, 13.0f, FIGURE_INK, 'm', sections[i].name);
        figure_text(s, x + box.width / 2.0f, y + 37.0f, 11.0f, FIGURE_GREY, 'm', sections[i].said);
        x += sections[i].width;
    }
}

/* ---- a key of rotations ---- */

static void lane_cell(svg *s, float x, float y, svg_colour colour, int used)
{
    svg_box box = {x, y, lane - 2.0f, lane - 2.0f};
    svg_paint paint = {used ? svg_mix(0xffffff, colour, 0.35f) : 0xffffff, used ? colour : fill_colour, 1.0f, 1.0f,
                       NULL};
    svg_rect(s, box, 2.0f, &paint);
}

/* `width` lanes of all rows, the first of them number `first`. */
static void lane_block(svg *s, float x, float y, int first, int width)
{
    for (int row = 0; row < ROWS; row++)
        for (int i = 0; i < width; i++)
            lane_cell(s, x + lane * (float)i, y + lane * (float)row, row < VALUES ? value_colour : arc_colour,
                      first + i < LANES);
}

static void row_names(svg *s, float x, float y)
{
    static const char *const names[ROWS] = {"x", "y", "z", "w", "v"};
    for (int row = 0; row < ROWS; row++)
        figure_text(s, x, y + lane * (float)row + 12.0f, 12.0f, row < VALUES ? value_colour : arc_colour, 'e',
                    names[row]);
}

static void key_of_rotations(svg *s, float x, float y, const char *name)
{
    figure_bold(s, x, y - 12.0f, 14.0f, FIGURE_INK, 's', name);
    row_names(s, x - 8.0f, y);
    lane_block(s, x, y, 0, BLOCK);
    lane_block(s, x + lane * (BLOCK + 2.2f), y, BLOCK, NARROW);
    row_names(s, x + lane * (BLOCK + 2.2f) - 8.0f, y);
    figure_text(s, x + lane * 8.0f, y + lane * ROWS + 16.0f, 12.0f, FIGURE_GREY, 'm', "16 lanes");
    figure_text(s, x + lane * (BLOCK + 4.2f), y + lane * ROWS + 16.0f, 12.0f, FIGURE_GREY, 'm', "4 lanes");
}

static void reading(svg *s, float x, float y)
{
    svg_paint value = svg_fill(svg_mix(0xffffff, value_colour, 0.35f), 1.0f);
    svg_paint arc = svg_fill(svg_mix(0xffffff, arc_colour, 0.35f), 1.0f);
    svg_box box = {x, y - 11.0f, 13.0f, 13.0f};
    svg_rect(s, box, 2.0f, &value);
    figure_text(s, x + 22.0f, y, 13.0f, FIGURE_INK, 's', "the key itself: one lane is one joint");
    box.x += 330.0f;
    svg_rect(s, box, 2.0f, &arc);
    figure_text(s, x + 352.0f, y, 13.0f, FIGURE_INK, 's',
                "the arc to the next key, for slerp: computed when the clip is built");
}

int figure_clip_layout(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 984.0f, 414.0f, "A sample reads two neighbouring keys as streams",
                     "One block, in the order of memory. Below, two keys of a group of 19 rotations."))
        return 0;
    section_strip(&s, 24.0f, 100.0f);
    figure_text(
        &s, 24.0f, 180.0f, 13.0f, FIGURE_GREY, 's',
        "A sample between them reads key k with its arcs, and x y z w of key k + 1. White cells are padding.");
    key_of_rotations(&s, 60.0f, 232.0f, "key k");
    key_of_rotations(&s, 554.0f, 232.0f, "key k + 1");
    reading(&s, 60.0f, 376.0f);
    return svg_close(&s);
}
