/* SPDX-License-Identifier: MIT */
/* nakawari exercise --object: which triangle of a model is seen, its size, its colours, and files that are none. */
#include "program.h"

#include <math.h>
#include <stdlib.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>

#include "draw/object.h"

#define EXAMPLES NKW_FIGURES "/../examples/"

/* ---- what is seen ---- */

enum { MOST = 64 };
typedef struct model {
    object_triangle triangles[MOST]; /* each channel of a colour is 0 or 0xff */
    size_t count;
} model;

static void add_triangle(model *m, nkw_vec3 a, nkw_vec3 b, nkw_vec3 c, svg_colour colour)
{
    const object_triangle t = {{a, b, c}, colour};
    m->triangles[m->count++] = t;
}

/* A box, its faces counter-clockwise from outside. */
static void add_box(model *m, nkw_vec3 low, nkw_vec3 high, svg_colour colour)
{
    static const int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    nkw_vec3 corner[8];
    for (int i = 0; i < 8; i++) {
        const nkw_vec3 p = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
        corner[i] = p;
    }
    for (int f = 0; f < 6; f++)
        for (int k = 1; k < 3; k++)
            add_triangle(m, corner[faces[f][0]], corner[faces[f][k]], corner[faces[f][k + 1]], colour);
}

static nkw_vec3 vec(float x, float y, float z)
{
    const nkw_vec3 v = {x, y, z};
    return v;
}

/* A wide plate, a block on it near an edge, a bar through the block, three plates that overlap in a circle. */
static model scene_of_boxes(void)
{
    model m = {{{{{0.0f, 0.0f, 0.0f}}, 0}}, 0};
    add_box(&m, vec(-1.0f, -0.1f, -1.0f), vec(1.0f, 0.0f, 1.0f), 0xff0000);
    add_box(&m, vec(0.5f, 0.01f, 0.6f), vec(0.8f, 0.4f, 0.9f), 0x00ff00);
    add_box(&m, vec(-0.9f, 0.15f, 0.7f), vec(0.95f, 0.2f, 0.75f), 0x0000ff);
    add_triangle(&m, vec(-0.9f, 0.10f, -0.9f), vec(-0.7f, 0.10f, -0.9f), vec(-0.1f, 0.6f, -0.1f), 0xffff00);
    add_triangle(&m, vec(-0.9f, 0.6f, -0.5f), vec(-0.2f, 0.10f, -0.8f), vec(-0.9f, 0.6f, -0.3f), 0xff00ff);
    add_triangle(&m, vec(-0.5f, 0.10f, -0.2f), vec(-0.3f, 0.10f, -0.2f), vec(-0.6f, 0.6f, -0.9f), 0x00ffff);
    return m;
}

typedef struct ray {
    double from[3], way[3];
} ray;

static void to_doubles(nkw_vec3 v, double out[3])
{
    out[0] = (double)v.x;
    out[1] = (double)v.y;
    out[2] = (double)v.z;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Where the ray meets the front of a triangle (Moeller, Trumbore, 1997); -1 if it does not; NAN close to its rim. */
static double meets(const ray *r, const object_triangle *t)
{
    double a[3], u[3], v[3], w[3], p[3], q[3];
    to_doubles(t->corner[0], a);
    to_doubles(t->corner[1], u);
    to_doubles(t->corner[2], v);
    for (int i = 0; i < 3; i++) {
        u[i] -= a[i];
        v[i] -= a[i];
        w[i] = r->from[i] - a[i];
    }
    cross(r->way, v, p);
    cross(w, u, q);
    const double det = dot(u, p), x = dot(w, p) / det, y = dot(r->way, q) / det, rim = 4e-3;
    if (!(det > 0.0) || x < -rim || y < -rim || x + y > 1.0 + rim)
        return -1.0;
    return x < rim || y < rim || x + y > 1.0 - rim ? (double)NAN : dot(v, q) / det;
}

/* The colour of the front that the ray meets first, 0 for none; -1 if a rim is close. */
static svg_colour seen_by(const ray *r, const model *m)
{
    double least = 1e30;
    svg_colour colour = 0;
    for (size_t i = 0; i < m->count; i++) {
        const double at = meets(r, &m->triangles[i]);
        if (isnan(at))
            return -1;
        if (at >= 0.0 && at < least) {
            least = at;
            colour = m->triangles[i].colour;
        }
    }
    return colour;
}

static int contains(const space_shape *s, svg_point p)
{
    int sides[2] = {0, 0};
    for (int i = 0; i < 3; i++) {
        const svg_point a = s->point[i], b = s->point[(i + 1) % 3];
        sides[(b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0.0f]++;
    }
    return sides[0] == 3 || sides[1] == 3;
}

/* The colour of the last shape at a point, without the light: each channel is below or above a half. */
static svg_colour painted_at(const space_list *list, svg_point p)
{
    svg_colour colour = 0;
    for (size_t i = 0; i < list->count; i++)
        if (contains(&list->shapes[i], p)) {
            const svg_colour lit = list->shapes[i].paint.fill;
            colour = ((lit >> 16 & 255) > 127 ? 0xff0000 : 0) | ((lit >> 8 & 255) > 127 ? 0xff00 : 0) |
                     ((lit & 255) > 127 ? 0xff : 0);
        }
    return colour;
}

enum { SCALE = 100 };

/* The ray of a point of the page; the eye of a perspective of 90 degrees is at the origin of its coordinates. */
static ray ray_of(const nkw_mat4 *view, int is_parallel, svg_point p)
{
    const nkw_mat4 back = nkw_mat4_inverse_rigid(view);
    const float x = p.x / SCALE, y = -p.y / SCALE;
    const nkw_vec3 from = is_parallel ? vec(x, y, 100.0f) : vec(0.0f, 0.0f, 0.0f);
    const nkw_vec3 way = is_parallel ? vec(0.0f, 0.0f, -1.0f) : vec(x, y, -1.0f);
    ray r;
    to_doubles(nkw_mat4_transform_point(&back, from), r.from);
    to_doubles(nkw_mat4_transform_direction(&back, way), r.way);
    return r;
}

static nkw_mat4 view_from(float yaw, float pitch, float distance)
{
    const nkw_quat q = nkw_quat_mul(nkw_quat_from_axis_angle(vec(1.0f, 0.0f, 0.0f), pitch),
                                    nkw_quat_from_axis_angle(vec(0.0f, 1.0f, 0.0f), yaw));
    nkw_mat4 view = nkw_mat4_from_quat(q);
    view.m[14] = -distance;
    return view;
}

/* Returns how many points were compared. `fitted` has the triangles as object_build has moved them. */
static int compare(const object_model *built, const model *fitted, const nkw_mat4 *view, int is_parallel)
{
    const svg_point centre = {0.0f, 0.0f};
    const svg_camera camera = is_parallel ? svg_orthographic(view, centre, SCALE)
                                          : svg_perspective(view, 1.57079633f, centre, SCALE);
    const nkw_mat4 m = nkw_mat4_identity();
    space_list list = {NULL, 0, 0, 0};
    int compared = 0;
    object_paint(&list, &camera, &m, 1.0f, 0, built);
    for (int i = 0; i < 40 * 40; i++) {
        const svg_point p = {3.013f * (float)(i % 40 - 20), 3.017f * (float)(i / 40 - 20)};
        const ray r = ray_of(view, is_parallel, p);
        const svg_colour want = seen_by(&r, fitted);
        if (want < 0)
            continue;
        if (painted_at(&list, p) != want)
            fail_msg("at %g %g: %06lx, not %06lx", (double)p.x, (double)p.y, (unsigned long)painted_at(&list, p),
                     (unsigned long)want);
        compared += want != 0;
    }
    free(list.shapes);
    return compared;
}

static void the_nearest_front_is_seen_from_every_eye(void **state)
{
    (void)state;
    model m = scene_of_boxes();
    object_model built = {NULL, NULL, 0, 0};
    int compared = 0;
    assert_int_equal(object_build(&built, m.triangles, m.count), OBJECT_OK);
    assert_true(built.count > m.count); /* the plates of the circle cannot be sorted without a cut */
    for (int i = 0; i < 24; i++) {
        const nkw_mat4 view = view_from(0.7f * (float)i, 1.5f * sinf((float)i), 1.1f + 0.1f * (float)(i % 4));
        compared += compare(&built, &m, &view, i % 3 == 0);
    }
    assert_true(compared > 5000);
    object_free(&built);
}

static void the_middle_is_at_the_origin_and_the_longest_side_is_one(void **state)
{
    (void)state;
    model m = {{{{{0.0f, 0.0f, 0.0f}}, 0}}, 0};
    object_model built = {NULL, NULL, 0, 0};
    add_box(&m, vec(10.0f, 20.0f, -4.0f), vec(12.0f, 28.0f, -3.0f), 0xff0000);
    assert_int_equal(object_build(&built, m.triangles, m.count), OBJECT_OK);
    for (size_t i = 0; i < 3 * built.count; i++) {
        const nkw_vec3 p = built.nodes[i / 3].triangle.corner[i % 3];
        expect_near(fabsf(p.x), 0.125, 1e-6);
        expect_near(fabsf(p.y), 0.5, 1e-6);
        expect_near(fabsf(p.z), 0.0625, 1e-6);
    }
    object_free(&built);
}

static void a_model_without_size_is_refused(void **state)
{
    (void)state;
    object_model built = {NULL, NULL, 0, 0};
    object_triangle t = {{{1.0f, 2.0f, 3.0f}, {1.0f, 2.0f, 3.0f}, {1.0f, 2.0f, 3.0f}}, 0};
    assert_int_equal(object_build(&built, &t, 0), OBJECT_NO_SIZE);
    assert_int_equal(object_build(&built, &t, 1), OBJECT_NO_SIZE);
    t.corner[1].x = 5.0f;
    assert_int_equal(object_build(&built, &t, 1), OBJECT_NO_SIZE); /* a line */
    t.corner[2].y = (float)INFINITY;
    assert_int_equal(object_build(&built, &t, 1), OBJECT_NO_SIZE);
    object_free(&built);
}

/* ---- the command ---- */

static void write_file(const char *name, const char *text)
{
    FILE *f = fopen(name, "wb");
    assert_non_null(f);
    fputs(text, f);
    assert_int_equal(fclose(f), 0);
}

static char *read_file(const char *name)
{
    enum { ROOM = 1 << 20 };
    FILE *f = fopen(name, "rb");
    char *text = calloc(1, ROOM);
    assert_non_null(f);
    assert_non_null(text);
    assert_true(fread(text, 1, ROOM - 1, f) < ROOM - 1);
    fclose(f);
    return text;
}

static char *picture_of(const char *object, const char *name)
{
    free(program_run(NULL, "exercise '" EXAMPLES "scenes.json' --keys 3 --object '%s' -o .", object));
    return read_file(name);
}

#define FACES "f 1 2 3\nf 1 4 2\n"

/* By powers of two, so that no rounding differs. */
static void the_size_and_the_place_of_a_model_do_not_matter(void **state)
{
    (void)state;
    write_file("small.obj", "v -1 0 0\nv 1 0 0\nv 0 0.5 0\nv 0 0 1\n" FACES);
    write_file("large.obj", "v 3072 4096 512\nv 5120 4096 512\nv 4096 4608 512\nv 4096 4096 1536\n" FACES);
    char *small = picture_of("small.obj", "trajectory-perspective.svg");
    char *large = picture_of("large.obj", "trajectory-perspective.svg");
    char *name = strstr(large, "large.obj: its nose is -z, its top +y");
    assert_non_null(name);
    memcpy(name, "small", 5);
    assert_string_equal(small, large);
    free(small);
    free(large);
}

/* Kd 0.2 1 0.4 in full light, 0.84 + 0.16 of it: between 0x2a 0xd9 0x5a and 0x33 0xff 0x66. */
static void a_model_has_the_colours_of_its_materials(void **state)
{
    (void)state;
    unsigned long colour = 0;
    write_file("paint.mtl", "newmtl a\nKd 0.2 1 0.4\n");
    write_file("paint.obj", "mtllib paint.mtl\nusemtl a\nv -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nf 1 2 3 4\n");
    write_file("level.csv", "name,time,tx,ty,tz\na,0,0,0.5,0\na,1,0,0.5,-1\n");
    free(program_run(NULL, "exercise level.csv --object paint.obj -o ."));
    char *text = read_file("trajectory-perspective.svg");
    const char *last = NULL;
    for (const char *at = text; (at = strstr(at, "stroke-width=\"0.5\"")) != NULL; at++)
        last = at;
    assert_non_null(last);
    while (last > text && strncmp(last, "fill=\"#", 7) != 0)
        last--;
    assert_int_equal(sscanf(last, "fill=\"#%lx", &colour), 1);
    assert_in_range(colour >> 16 & 255, 0x2a, 0x33);
    assert_in_range(colour >> 8 & 255, 0xd9, 0xff);
    assert_in_range(colour & 255, 0x5a, 0x66);
    free(text);
}

static void the_car_flies_in_place_of_the_dart(void **state)
{
    (void)state;
    char *car = picture_of(EXAMPLES "car.obj", "frames.svg");
    assert_null(strstr(car, "fin, on top"));
    assert_non_null(strstr(car, "car.obj: its nose is -z"));
    free(program_run(NULL, "exercise '" EXAMPLES "scenes.json' --keys 3 -o ."));
    char *dart = read_file("frames.svg");
    assert_non_null(strstr(dart, "fin, on top"));
    assert_string_not_equal(car, dart);
    free(car);
    free(dart);
}

static void files_that_are_no_model_are_reported(void **state)
{
    (void)state;
    write_file("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n");
    write_file("points.obj", "v 0 0 0\nv 1 0 0\n");
    write_file("flat.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n");
    program_says(1, "broken.obj:line 4: vertex 7", "exercise '" NKW_KEYS "' --object broken.obj -o .");
    program_says(1, "points.obj: has no faces", "exercise '" NKW_KEYS "' --object points.obj -o .");
    program_says(1, "flat.obj: its faces have no size", "exercise '" NKW_KEYS "' --object flat.obj -o .");
    program_says(1, "--object is a file .obj", "exercise '" NKW_KEYS "' --object '" NKW_CHARACTER "' -o .");
    program_says(1, "none.obj: ", "exercise '" NKW_KEYS "' --object none.obj -o .");
    program_says(2, "--object: not with --check or --trace", "exercise '" NKW_KEYS "' --object broken.obj --trace 1");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_nearest_front_is_seen_from_every_eye),
        cmocka_unit_test(the_middle_is_at_the_origin_and_the_longest_side_is_one),
        cmocka_unit_test(a_model_without_size_is_refused),
        cmocka_unit_test(the_size_and_the_place_of_a_model_do_not_matter),
        cmocka_unit_test(a_model_has_the_colours_of_its_materials),
        cmocka_unit_test(the_car_flies_in_place_of_the_dart),
        cmocka_unit_test(files_that_are_no_model_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
