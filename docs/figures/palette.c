/* SPDX-License-Identifier: MIT */
/* Pictures of memory: a joint of three palettes, and the lanes of a crowd. */
#include "figure.h"

#include <stdio.h>

static const svg_colour axis_colours[5] = {0xd62728, 0x2ca02c, 0x1f5fd0, 0x6a4a9c, 0x9a9aa2};

/* ---- palettes ---- */

/* The colour of an element's column: x y z axis, translation; anything else is grey. */
static svg_colour colour_of(char c)
{
    return axis_colours[c == 'X' ? 0 : c == 'Y' ? 1 : c == 'Z' ? 2 : c == 'T' ? 3 : 4];
}

static void element_cell(svg *s, float x, float y, svg_colour colour, const char *name)
{
    svg_box box = {x, y, 48.0f, 38.0f};
    svg_paint paint = {svg_mix(0xffffff, colour, 0.16f), colour, 1.4f, 1.0f, NULL};
    svg_rect(s, box, 4.0f, &paint);
    figure_bold(s, x + 24.0f, y + 25.0f, 14.0f, FIGURE_INK, 'm', name);
}

/* Names of elements in the order of memory, four to a vector. */
static void strip(svg *s, float y, const char *title, const char *said, const char *const *names, int count)
{
    char bytes[32];
    figure_bold(s, 24.0f, y - 12.0f, 15.0f, FIGURE_INK, 's', title);
    figure_text(s, 190.0f, y - 12.0f, 13.0f, FIGURE_GREY, 's', said);
    for (int i = 0; i < count; i++)
        element_cell(s, 24.0f + 51.0f * (float)i + 12.0f * (float)(i / 4), y, colour_of(names[i][0]), names[i]);
    sprintf(bytes, "%d bytes", count % 100 * 4);
    figure_text(s, 34.0f + 51.0f * (float)count + 12.0f * (float)(count / 4 - 1), y + 24.0f, 13.0f, FIGURE_GREY, 's',
                bytes);
}

int figure_palette_layouts(const char *path)
{
    static const char *const matrix[16] = {"Xx", "Xy", "Xz", "0", "Yx", "Yy", "Yz", "0",
                                           "Zx", "Zy", "Zz", "0", "Tx", "Ty", "Tz", "1"};
    static const char *const rows[12] = {"Xx", "Yx", "Zx", "Tx", "Xy", "Yy", "Zy", "Ty", "Xz", "Yz", "Zz", "Tz"};
    static const char *const dual[8] = {"rx", "ry", "rz", "rw", "dx", "dy", "dz", "dw"};
    svg s;
    if (!figure_open(&s, path, 984.0f, 362.0f, "One joint of three palettes",
                     "The lowest address first, in vectors of four floats. X, Y, Z: the images of the axes; T: the "
                     "translation."))
        return 0;
    strip(&s, 116.0f, "nkw_mat4", "columns: mat4 of GLSL, unchanged", matrix, 16);
    strip(&s, 206.0f, "nkw_mat3x4",
          "rows: three vec4, p' = (dot(row 0, p), dot(row 1, p), dot(row 2, p)), p = (x, y, z, 1)", rows, 12);
    strip(&s, 296.0f, "nkw_dual_quat", "two vec4, the rotation r and d = (t / 2) r: no scale, no shear", dual, 8);
    return svg_close(&s);
}

/* ---- crowds ---- */

enum { LANES = 16, ROWS = 10, USED = 11 };

static const float lane = 22.0f;
static const svg_colour row_colours[ROWS] = {0x6a4a9c, 0x6a4a9c, 0x6a4a9c, 0xe07b00, 0xe07b00,
                                             0xe07b00, 0xe07b00, 0x2c8c4a, 0x2c8c4a, 0x2c8c4a};

static void component_names(svg *s, float x, float y, int rows)
{
    static const char *const names[ROWS] = {"tx", "ty", "tz", "rx", "ry", "rz", "rw", "sx", "sy", "sz"};
    for (int row = 0; row < rows; row++)
        figure_text(s, x - 8.0f, y + lane * (float)row + 14.0f, 12.0f, row_colours[row], 'e', names[row]);
}

/* Rows of lanes, each lane with its number; those from `used` on are empty, `mark` is one that is told apart. */
static void lanes(svg *s, float x, float y, int rows, int used, int mark)
{
    for (int row = 0; row < rows; row++)
        for (int i = 0; i < LANES; i++) {
            char text[16];
            svg_box box = {x + lane * (float)i, y + lane * (float)row, lane - 2.0f, lane - 2.0f};
            svg_colour colour = i < used ? row_colours[row] : FIGURE_PALE;
            float share = i >= used ? 0.0f : i == mark ? 0.85f : 0.22f;
            svg_paint paint = {svg_mix(0xffffff, colour, share), colour, 1.0f, 1.0f, NULL};
            svg_rect(s, box, 2.0f, &paint);
            sprintf(text, "%d", i % 100);
            figure_text(s, box.x + 10.0f, box.y + 14.0f, 10.0f, i == mark && i < used ? 0xffffff : FIGURE_GREY, 'm',
                        text);
        }
}

int figure_crowd_lanes(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 1008.0f, 480.0f, "Lanes are joints, or characters",
                     "One row is one component: 16 floats in one, two or four vectors. Dark: one joint of one "
                     "character."))
        return 0;
    figure_bold(&s, 60.0f, 104.0f, 15.0f, FIGURE_INK, 's', "A pose: one character, a lane for each joint");
    component_names(&s, 60.0f, 124.0f, ROWS);
    lanes(&s, 60.0f, 124.0f, ROWS, USED, 3);
    figure_text(&s, 60.0f, 366.0f, 13.0f, FIGURE_GREY, 's', "11 joints, and padding up to 16.");
    figure_text(&s, 60.0f, 386.0f, 13.0f, FIGURE_GREY, 's', "Joint 3 needs its parent first: joints are not parallel.");
    figure_bold(&s, 560.0f, 104.0f, 15.0f, FIGURE_INK, 's', "A crowd: one joint, a lane for each character");
    component_names(&s, 560.0f, 124.0f, ROWS);
    lanes(&s, 560.0f, 124.0f, ROWS, LANES, 3);
    figure_bold(&s, 560.0f + lane * 17.0f, 240.0f, 13.0f, FIGURE_INK, 's', "joint 0");
    component_names(&s, 560.0f, 364.0f, 3);
    lanes(&s, 560.0f, 364.0f, 3, LANES, 3);
    figure_bold(&s, 560.0f + lane * 17.0f, 396.0f, 13.0f, FIGURE_INK, 's', "joint 1");
    figure_text(&s, 560.0f, 454.0f, 13.0f, FIGURE_GREY, 's',
                "Ten rows for each joint. Parents come first; characters are parallel.");
    return svg_close(&s);
}
