/* SPDX-License-Identifier: MIT */
/* nakawari render: sizes, framing, colours, formats, and the picture of the page. */
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
    pixels p = render("--plain --clip rest --frames 1 --size 200 --yaw 90 --pitch 0");
    box_of(&p, 0, 200, box);
    assert_in_range(box[2], 7, 9);
    assert_in_range(box[3], 190, 192);
    assert_in_range(box[0] + box[1], 197, 203);
    free(p.rgb);
}

static void the_skeleton_is_drawn_over_the_model(void **state)
{
    (void)state;
    pixels without = render("--plain --frames 1"), with = render("--plain --frames 1 --skeleton");
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
    pixels p = render("--plain --clip rest --frames 2 --turntable --yaw 0 --pitch 0 --size 100");
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

/* The floor and the shadow are below the model; from below there is none. */
static void a_floor_is_below_the_model(void **state)
{
    (void)state;
    pixels without = render("--plain --clip rest --frames 1 --size 100 --pitch -20");
    pixels below = render("--clip rest --frames 1 --size 100 --pitch -20"),
           with = render("--clip rest --frames 1 --size 100");
    assert_memory_equal(below.rgb, without.rgb, 3 * 100 * 100);
    size_t grid = 0;
    for (size_t x = 0; x < 100; x++)
        grid += (size_t)drawn(&with, x, 95);
    assert_in_range(grid, 10, 100);
    for (size_t x = 0; x < 100; x++)
        assert_false(drawn(&with, x, 1));
    free(without.rgb);
    free(below.rgb);
    free(with.rgb);
}

/* ---- colours ---- */

/* A picture of one frame of a document from the front, its middle half as wide as high. */
static pixels render_text(const char *json)
{
    FILE *f = fopen("shape.gltf", "wb");
    assert_non_null(f);
    for (const char *c = json; *c; c++)
        fputc(*c == '\'' ? '"' : *c, f);
    fclose(f);
    free(program_run(NULL, "render shape.gltf --plain --frames 1 --size 64 --yaw 0 --pitch 0 -o shape.png"));
    return read_png("shape.png");
}

static const unsigned char *pixel(const pixels *p, size_t x, size_t y)
{
    return p->rgb + 3 * (y * p->width + x);
}

/* Hexadecimal digits for percent-encoded data. */
static void append_floats(char *text, const float *floats, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t bits = bits_of(floats[i]);
        for (int k = 0; k < 4; k++)
            sprintf(text + strlen(text), "%%%02x", (unsigned)(bits >> 8 * k & 255));
    }
}

/* Two triangles that are a square from -1 to 1 with texture places, and then what `more` adds. */
static pixels render_square(const char *material, const char *images, const char *attributes)
{
    static const float square[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0, /* places */
                                   0,  1,  1, 1, 1,  0, 0, 1, 1, 0,  0,  0, /* in the texture */
                                   0,  0,  1, 0, 0,  1, 0, 0, 1, 0,  0,  1, 0, 0, 1, 0,  0, 1};
    static char data[8192], json[16384];
    data[0] = 0;
    append_floats(data, square, sizeof square / sizeof *square);
    snprintf(json, sizeof json,
             "{'asset':{'version':'2.0'},'nodes':[{'mesh':0}],'buffers':[{'byteLength':192,'uri':'data:,%s'}],"
             "'bufferViews':[{'buffer':0,'byteLength':192}],'accessors':["
             "{'bufferView':0,'componentType':5126,'count':6,'type':'VEC3'},"
             "{'bufferView':0,'byteOffset':72,'componentType':5126,'count':6,'type':'VEC2'},"
             "{'bufferView':0,'byteOffset':120,'componentType':5126,'count':6,'type':'VEC3'}],"
             "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'TEXCOORD_0':1%s},'material':0}]}],%s"
             "'materials':[{'pbrMetallicRoughness':{%s}}]}",
             data, attributes, images, material);
    return render_text(json);
}

static void materials_have_their_base_colour(void **state)
{
    (void)state;
    pixels p = render_square("'baseColorFactor':[1,0,0,1]", "", "");
    assert_in_range(pixel(&p, 32, 32)[0], 180, 255);
    assert_in_range(pixel(&p, 32, 32)[2], 0, 70);
    free(p.rgb);
}

static void vertices_have_their_colour(void **state)
{
    (void)state;
    pixels p = render_square("'baseColorFactor':[1,1,0.5,1]", "", ",'COLOR_0':2");
    assert_in_range(pixel(&p, 32, 32)[0], 0, 70);
    assert_in_range(pixel(&p, 32, 32)[2], 120, 200);
    free(p.rgb);
}

/* A texture of four texels, red and green above blue and white, in a file beside the model. */
static void textures_are_drawn(void **state)
{
    (void)state;
    static const unsigned char texels[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.format = PNG_FORMAT_RGB;
    image.width = image.height = 2;
    assert_true(png_image_write_to_file(&image, "texels.png", 0, texels, 0, NULL));
    pixels p = render_square("'baseColorTexture':{'index':0}",
                             "'textures':[{'source':0}],'images':[{'uri':'texels.png'}],", "");
    const unsigned char *red = pixel(&p, 18, 18), *green = pixel(&p, 46, 18), *blue = pixel(&p, 18, 46);
    assert_true(red[0] > 150 && red[1] < 90 && red[2] < 90);
    assert_true(green[0] < 90 && green[1] > 150 && green[2] < 90);
    assert_true(blue[0] < 90 && blue[1] < 90 && blue[2] > 150);
    assert_true(pixel(&p, 46, 46)[0] > 150 && pixel(&p, 46, 46)[1] > 150);
    free(p.rgb);
}

/* A missing texture, and one that is no PNG, leave the base colour. */
static void textures_that_cannot_be_read_are_left_out(void **state)
{
    (void)state;
    static const char *const uris[] = {"missing.png", "data:image/jpeg;base64,/9j/4A==", "shape.gltf"};
    for (size_t i = 0; i < sizeof uris / sizeof *uris; i++) {
        char images[128];
        snprintf(images, sizeof images, "'textures':[{'source':0}],'images':[{'uri':'%s'}],", uris[i]);
        pixels p = render_square("'baseColorFactor':[0,1,0,1],'baseColorTexture':{'index':0}", images, "");
        assert_in_range(pixel(&p, 32, 32)[1], 180, 255);
        assert_in_range(pixel(&p, 32, 32)[0], 0, 70);
        free(p.rgb);
    }
}

/* A line from corner to corner, half of it behind a triangle, and a point. */
static void points_and_lines_are_drawn(void **state)
{
    (void)state;
    static const float places[] = {-1, -1, 0, 1, 1, 0, -1, 0.8f, 0, 0, -2, 1, 3, -2, 1, 0, 2, 1};
    static char data[8192], json[16384];
    data[0] = 0;
    append_floats(data, places, sizeof places / sizeof *places);
    snprintf(json, sizeof json,
             "{'asset':{'version':'2.0'},'nodes':[{'mesh':0}],'buffers':[{'byteLength':72,'uri':'data:,%s'}],"
             "'bufferViews':[{'buffer':0,'byteLength':72}],'accessors':["
             "{'bufferView':0,'componentType':5126,'count':2,'type':'VEC3'},"
             "{'bufferView':0,'byteOffset':24,'componentType':5126,'count':1,'type':'VEC3'},"
             "{'bufferView':0,'byteOffset':36,'componentType':5126,'count':3,'type':'VEC3'}],'meshes':[{'primitives':["
             "{'attributes':{'POSITION':2}},{'attributes':{'POSITION':0},'mode':1,'material':0},"
             "{'attributes':{'POSITION':1},'mode':0,'material':0}]}],"
             "'materials':[{'pbrMetallicRoughness':{'baseColorFactor':[1,0,0,1]}}]}",
             data);
    pixels p = render_text(json);
    size_t red_left = 0, red_right = 0, red_above = 0;
    for (size_t y = 0; y < 64; y++)
        for (size_t x = 0; x < 64; x++) {
            const unsigned char *c = pixel(&p, x, y);
            const int red = c[0] > c[1] + 80;
            red_left += (size_t)(red && x < 16);
            red_right += (size_t)(red && x > 32);
            red_above += (size_t)(red && y < 24);
        }
    assert_in_range(red_left, 10, 80);
    assert_in_range(red_above, 3, 20); /* the point: the line is behind the triangle there */
    assert_in_range(red_right, 0, 1);
    free(p.rgb);
}

/* A file of joints only: its skeleton is drawn. */
static void joints_without_meshes_are_drawn(void **state)
{
    (void)state;
    FILE *f = fopen("joints.csv", "wb");
    assert_non_null(f);
    fputs("name,parent,time,tx,ty,tz\nhip,,0,0,0,0\nknee,hip,0,0,-1,0\n", f);
    fclose(f);
    free(program_run(NULL, "render joints.csv --plain --frames 1 --size 64 --yaw 0 --pitch 0 -o joints.png"));
    pixels p = read_png("joints.png");
    assert_true(drawn(&p, 32, 32));
    assert_false(drawn(&p, 20, 32));
    free(p.rgb);
}

/* A model that goes from 0 to 10 m: the camera frames all of its way, or moves with it. */
static void the_camera_follows(void **state)
{
    (void)state;
    size_t left[4], right[4];
    FILE *f = fopen("away.csv", "wb");
    assert_non_null(f);
    fputs("name,parent,time,tx,ty,tz\nhip,,0,0,0,0\nhip,,1,10,0,0\nknee,hip,0,0,-1,0\n", f);
    fclose(f);
    free(program_run(NULL, "render away.csv --plain --at 0,1 --size 64 --yaw 0 --pitch 0 -o away.png"));
    pixels p = read_png("away.png");
    box_of(&p, 0, 64, left);
    box_of(&p, 64, 128, right);
    assert_true(left[1] < 16 && right[0] > 64 + 48);
    free(p.rgb);
    free(program_run(NULL, "render away.csv --plain --follow --at 0,1 --size 64 --yaw 0 --pitch 0 -o away.png"));
    p = read_png("away.png");
    box_of(&p, 0, 64, left);
    box_of(&p, 64, 128, right);
    assert_true(left[0] > 24 && left[1] < 40 && left[3] - left[2] > 50);
    assert_int_equal(right[0], left[0] + 64);
    assert_int_equal(right[3], left[3]);
    free(p.rgb);
}

/* ---- formats ---- */

static void svg_has_the_triangles_of_each_frame(void **state)
{
    (void)state;
    char *svg = program_run(NULL, CHARACTER "--clip walk --frames 2 --size 100 --format svg"), *other;
    assert_int_equal(lines_with(svg, "<polygon"), 2 * 2424);
    assert_int_equal(lines_with(svg, "<clipPath"), 2);
    assert_int_equal(lines_with(svg, "nan"), 0);
    assert_string_equal(svg + strlen(svg) - 7, "</svg>\n");
    free(program_run(NULL, CHARACTER "--clip walk --frames 2 --size 100 -o rendered.svg"));
    other = program_run(NULL, "--version > /dev/null; cat rendered.svg");
    assert_string_equal(svg, other);
    free(svg);
    free(other);
    svg = program_run(NULL, CHARACTER "--clip walk --frames 1 --size 100 --format svg --skeleton --plain");
    assert_int_equal(lines_with(svg, "<circle"), 2 * 17); /* joints and their rims */
    assert_int_equal(lines_with(svg, "<path"), 0);
    free(svg);
}

static uint32_t u32_at(const unsigned char *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

/* An animated PNG while it is read: chunk after chunk. */
typedef struct film {
    unsigned char bytes[1 << 20];
    size_t size, at;
    uint32_t sequence;
    unsigned char canvas[3 * 48 * 48];
} film;

static const unsigned char *chunk(film *f, const char *name, size_t *length)
{
    const unsigned char *p = f->bytes + f->at;
    assert_true(f->at + 12 <= f->size);
    *length = u32_at(p);
    assert_true(*length <= f->size - f->at - 12);
    if (memcmp(p + 4, name, 4) != 0)
        return NULL;
    f->at += *length + 12;
    return p + 8;
}

static size_t put_chunk(unsigned char *out, const char *name, const unsigned char *data, size_t length)
{
    uint32_t sum = 0xffffffffu;
    for (size_t i = 0; i < 4; i++)
        out[i] = (unsigned char)(length >> (24 - 8 * i) & 255);
    memcpy(out + 4, name, 4);
    if (length)
        memcpy(out + 8, data, length);
    for (size_t i = 4; i < length + 8; i++) {
        sum ^= out[i];
        for (int k = 0; k < 8; k++)
            sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0);
    }
    for (size_t i = 0; i < 4; i++)
        out[length + 8 + i] = (unsigned char)(~sum >> (24 - 8 * i) & 255);
    return length + 12;
}

/* The next frame, drawn on the canvas. Returns its milliseconds. */
static unsigned next_frame(film *f, int first)
{
    static unsigned char png[1 << 20];
    size_t length, count = 0;
    const unsigned char *control = chunk(f, "fcTL", &length), *data;
    assert_non_null(control);
    assert_int_equal(length, 26);
    assert_int_equal(u32_at(control), f->sequence++);
    size_t width = u32_at(control + 4), height = u32_at(control + 8), x = u32_at(control + 12),
           y = u32_at(control + 16);
    assert_true(width > 0 && x + width <= 48 && height > 0 && y + height <= 48);
    unsigned char header[13] = {0, 0, 0, (unsigned char)width, 0, 0, 0, (unsigned char)height, 8, 2, 0, 0, 0};
    memcpy(png, f->bytes, 8);
    count = 8 + put_chunk(png + 8, "IHDR", header, 13);
    while ((data = chunk(f, first ? "IDAT" : "fdAT", &length)) != NULL) {
        if (!first)
            assert_int_equal(u32_at(data), f->sequence++);
        count += put_chunk(png + count, "IDAT", first ? data : data + 4, first ? length : length - 4);
    }
    count += put_chunk(png + count, "IEND", NULL, 0);
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    assert_true(png_image_begin_read_from_memory(&image, png, count));
    image.format = PNG_FORMAT_RGB;
    assert_true(png_image_finish_read(&image, NULL, f->canvas + 3 * (48 * y + x), 3 * 48, NULL) != 0);
    return (unsigned)(control[20] << 8 | control[21]) * 1000 / (unsigned)(control[22] << 8 | control[23]);
}

/* Frames of an animation are those of a sequence, each until the next; without the end, which is the start. */
static void an_animated_png_has_the_frames_of_a_sequence(void **state)
{
    (void)state;
    static film f;
    size_t length;
    FILE *stream;
    f.sequence = 0;
    free(program_run(NULL, CHARACTER "--clip walk --rate 5 --size 48 -o rendered.apng"));
    free(program_run(NULL, CHARACTER "--clip walk --frames 5 --size 48 --sequence film-"));
    stream = fopen("rendered.apng", "rb");
    assert_non_null(stream);
    f.size = fread(f.bytes, 1, sizeof f.bytes, stream);
    fclose(stream);
    f.at = 8;
    assert_non_null(chunk(&f, "IHDR", &length));
    const unsigned char *control = chunk(&f, "acTL", &length);
    assert_non_null(control);
    assert_int_equal(u32_at(control), 5);
    assert_int_equal(u32_at(control + 4), 0); /* without end */
    for (int k = 0; k < 5; k++) {
        char path[32];
        snprintf(path, sizeof path, "film-%04d.png", k);
        assert_int_equal(next_frame(&f, k == 0), 200);
        pixels p = read_png(path);
        assert_memory_equal(f.canvas, p.rgb, sizeof f.canvas);
        free(p.rgb);
    }
    assert_non_null(chunk(&f, "IEND", &length));
    assert_int_equal(f.at, f.size);
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
    program_says(2, "x.jpg: only .png, .apng and .svg are written", CHARACTER "-o x.jpg");
    program_says(2, "not in 0..10000", CHARACTER "--frames -1");
    program_says(2, "only one of them", CHARACTER "--at 0 --rate 3");
    program_says(2, "not a list of times", CHARACTER "--at now");
    program_says(2, "not with --output", CHARACTER "--sequence a -o b");
    program_says(2, "not as apng", CHARACTER "--sequence a --format apng");
    program_says(2, "not png, apng or svg", CHARACTER "--format gif");
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
        cmocka_unit_test(a_floor_is_below_the_model),
        cmocka_unit_test(materials_have_their_base_colour),
        cmocka_unit_test(vertices_have_their_colour),
        cmocka_unit_test(textures_are_drawn),
        cmocka_unit_test(textures_that_cannot_be_read_are_left_out),
        cmocka_unit_test(points_and_lines_are_drawn),
        cmocka_unit_test(joints_without_meshes_are_drawn),
        cmocka_unit_test(the_camera_follows),
        cmocka_unit_test(svg_has_the_triangles_of_each_frame),
        cmocka_unit_test(an_animated_png_has_the_frames_of_a_sequence),
        cmocka_unit_test(the_picture_of_the_page_is_this_one),
        cmocka_unit_test(misuse_and_files_in_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
