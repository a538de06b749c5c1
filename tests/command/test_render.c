/* SPDX-License-Identifier: MIT */
/* nakawari render: sizes, framing, shading, and the picture of the page. */
#include "program.h"

#include <stdlib.h>

#include <png.h>

#define CHARACTER "render '" NKW_CHARACTER "' "

typedef struct pixels {
    size_t width, height;
    unsigned char *rgb;
} pixels;

static pixels read_png(const char *path)
{
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, path))
        fail_msg("%s: %s", path, image.message);
    image.format = PNG_FORMAT_RGB;
    pixels p = {image.width, image.height, malloc(PNG_IMAGE_SIZE(image))};
    assert_non_null(p.rgb);
    assert_true(png_image_finish_read(&image, NULL, p.rgb, 0, NULL) != 0);
    return p;
}

static pixels render(const char *arguments)
{
    free(program_run(NULL, CHARACTER "%s -o rendered.png", arguments));
    return read_png("rendered.png");
}

/* Whether a pixel of a frame of the sheet is not that of the corner. */
static int drawn(const pixels *p, size_t x, size_t y)
{
    return memcmp(p->rgb + 3 * (y * p->width + x), p->rgb, 3) != 0;
}

/* The box of what is drawn in columns x0..x1 - 1: first and last row and column. */
static void box_of(const pixels *p, size_t x0, size_t x1, size_t box[4])
{
    box[0] = x1, box[1] = x0, box[2] = p->height, box[3] = 0;
    for (size_t y = 0; y < p->height; y++)
        for (size_t x = x0; x < x1; x++)
            if (drawn(p, x, y)) {
                box[0] = x < box[0] ? x : box[0];
                box[1] = x > box[1] ? x : box[1];
                box[2] = y < box[2] ? y : box[2];
                box[3] = y > box[3] ? y : box[3];
            }
}

static void sheets_have_rows_and_columns(void **state)
{
    (void)state;
    pixels p = render("--frames 5 --size 32 --columns 3");
    assert_int_equal(p.width, 96);
    assert_int_equal(p.height, 64);
    /* the cell without a frame is white */
    assert_int_equal(p.rgb[3 * (63 * 96 + 95)], 255);
    assert_int_not_equal(p.rgb[0], 255);
    free(p.rgb);
}

/* 4 % of the height on each side; the model is higher than wide. */
static void the_camera_frames_the_model(void **state)
{
    (void)state;
    size_t box[4];
    pixels p = render("--clip rest --frames 1 --size 200 --yaw 90 --pitch 0");
    box_of(&p, 0, 200, box);
    assert_in_range(box[2], 7, 9);
    assert_in_range(box[3], 190, 192);
    assert_in_range(box[0] + box[1], 197, 203);
    free(p.rgb);
}

static void the_skeleton_is_drawn_over_the_model(void **state)
{
    (void)state;
    pixels without = render("--frames 1"), with = render("--frames 1 --skeleton");
    size_t differ = 0;
    for (size_t i = 0; i < with.width * with.height; i++)
        differ += memcmp(with.rgb + 3 * i, without.rgb + 3 * i, 3) != 0;
    assert_in_range(differ, 300, 6000);
    free(without.rgb);
    free(with.rgb);
}

/* From the front and from behind the outline is mirrored; the face is on one side only. */
static void a_turntable_turns_once(void **state)
{
    (void)state;
    size_t front[4], back[4];
    pixels p = render("--clip rest --frames 2 --turntable --yaw 0 --pitch 0 --size 100");
    box_of(&p, 0, 100, front);
    box_of(&p, 100, 200, back);
    assert_in_range(front[0] + back[1] - 100, 97, 101);
    assert_int_equal(front[2], back[2]);
    size_t differ = 0;
    for (size_t y = 0; y < 30; y++) /* the head */
        for (size_t x = 0; x < 100; x++)
            differ += memcmp(p.rgb + 3 * (200 * y + x), p.rgb + 3 * (200 * y + x + 100), 3) != 0;
    assert_in_range(differ, 50, 3000);
    free(p.rgb);
}

static void a_sequence_is_numbered_files(void **state)
{
    (void)state;
    free(program_run(NULL, CHARACTER "--frames 3 --size 24 --sequence frame-"));
    for (int k = 0; k < 3; k++) {
        char path[32];
        snprintf(path, sizeof path, "frame-%04d.png", k);
        pixels p = read_png(path);
        assert_int_equal(p.width, 24);
        free(p.rgb);
    }
}

/* To renew it: the same arguments with -o docs/figures/command-render.png */
static void the_picture_of_the_page_is_this_one(void **state)
{
    (void)state;
    pixels p = render("--clip walk --frames 4 --skeleton"), page = read_png(NKW_FIGURES "/command-render.png");
    assert_int_equal(p.width, page.width);
    assert_int_equal(p.height, page.height);
    assert_memory_equal(p.rgb, page.rgb, 3 * p.width * p.height);
    free(p.rgb);
    free(page.rgb);
}

static void misuse_and_files_in_error(void **state)
{
    (void)state;
    program_says(0, "Usage: nakawari render", "render --help");
    program_says(2, "not in 16..4096", CHARACTER "--size 8");
    program_says(2, "not in 1..10000", CHARACTER "--frames 0");
    program_says(2, "only one of them", CHARACTER "--at 0 --rate 3");
    program_says(2, "not a list of times", CHARACTER "--at now");
    program_says(2, "not with --output", CHARACTER "--sequence a -o b");
    program_says(1, "choose one clip", CHARACTER "--clip all");
    program_says(1, "more than 10000 frames", CHARACTER "--rate 1000000");
    program_says(1, "exceeds 16384 pixels", CHARACTER "--frames 100 --size 4096");
    program_says(1, "/no/such/folder/x: cannot be written", CHARACTER "-o /no/such/folder/x");
    program_says(1, "no-such-file: ", "render no-such-file");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sheets_have_rows_and_columns),
        cmocka_unit_test(the_camera_frames_the_model),
        cmocka_unit_test(the_skeleton_is_drawn_over_the_model),
        cmocka_unit_test(a_turntable_turns_once),
        cmocka_unit_test(a_sequence_is_numbered_files),
        cmocka_unit_test(the_picture_of_the_page_is_this_one),
        cmocka_unit_test(misuse_and_files_in_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
