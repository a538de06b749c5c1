/* SPDX-License-Identifier: MIT */
/* The pictures about orientation: all frames of the animation, and Euler angles against slerp. */
#include "picture.h"
#include "draw/sphere.h"

#include <stdio.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

enum { FRAMES_PER_SECOND = 5, SAMPLES = 96 };
static const svg_colour euler_colour = 0xc2185b, slerp_colour = 0x00796b;

/* ---- all frames ---- */

static size_t frame_count(const scene *s)
{
    return scene_times(s, FRAMES_PER_SECOND);
}

static int is_key(const scene *s, float time)
{
    size_t k = 0;
    while (k < s->count && s->keys[k].time != time)
        k++;
    return k < s->count;
}

static int is_frame(const scene *s, float time)
{
    size_t i = 0;
    while (i < frame_count(s) && scene_time(s, FRAMES_PER_SECOND, i) != time)
        i++;
    return i < frame_count(s);
}

static nkw_mat4 frame(const scene *s, size_t i, nkw_orientation_method method)
{
    return scene_place(s, scene_time(s, FRAMES_PER_SECOND, i), NKW_POSITION_HERMITE, method);
}

static void frame_shadows(svg *out, const scene *s, const svg_camera *camera, nkw_orientation_method method,
                          float length)
{
    svg_begin(out, 0.22f);
    for (size_t i = 0; i < frame_count(s); i++) {
        nkw_mat4 m = frame(s, i, method);
        object_shadow(out, camera, &m, length, s->object);
    }
    svg_end(out);
}

/* The way of the object, a little behind the objects on it. */
static void frame_way(space_list *list, const scene *s, const svg_camera *camera)
{
    svg_paint paint = svg_stroke(0x85858f, 1.3f, 1.0f);
    nkw_vec3 ends[2];
    for (size_t i = 0; i < scene_times(s, 8 * FRAMES_PER_SECOND); i++) {
        nkw_mat4 m =
            scene_place(s, scene_time(s, 8 * FRAMES_PER_SECOND, i), NKW_POSITION_HERMITE, NKW_ORIENTATION_STEP);
        ends[i % 2] = nkw_mat4_translation(&m);
        if (i > 0)
            space_add(list, camera, ends, 2, space_distance(camera, ends[0]) + 0.2f, &paint);
    }
}

/* The keys in full colours, also those between two frames; the frames between in pale ones. */
static int frame_objects(svg *out, const scene *s, const svg_camera *camera, nkw_orientation_method method,
                         float length)
{
    space_list list = {NULL, 0, 0, 0};
    frame_way(&list, s, camera);
    for (size_t i = 0; i < frame_count(s); i++) {
        nkw_mat4 m = frame(s, i, method);
        object_paint(&list, camera, &m, length, !is_key(s, scene_time(s, FRAMES_PER_SECOND, i)), s->object);
    }
    for (size_t k = 0; k < s->count; k++)
        if (!is_frame(s, s->keys[k].time)) {
            nkw_mat4 m = scene_place(s, s->keys[k].time, NKW_POSITION_HERMITE, method);
            object_paint(&list, camera, &m, length, 0, s->object);
        }
    return space_paint(&list, out);
}

static void frame_numbers(svg *out, const scene *s, const svg_camera *camera)
{
    svg_font font = {15.0f, 0x1d1d22, 'm', 1, 0xffffff};
    char text[SVG_DIGITS];
    for (size_t k = 0; k < s->count; k++)
        svg_text(out, picture_outward(s, camera, k, 62.0f), &font, picture_key_name(s, k, text));
}

int picture_frames(const scene *s, const char *path)
{
    svg out;
    const svg_box box = {24.0f, 84.0f, 1052.0f, 560.0f};
    const svg_point centre = {550.0f, 380.0f};
    const float length = 0.42f;
    svg_paint border = svg_stroke(0x9a9aa2, 1.0f, 1.0f);
    svg_camera camera = svg_perspective(&s->view, PICTURE_FOV, centre, 448.0f);
    if (!svg_sheet_open(&out, path, 1100.0f, 684.0f,
                      "Every frame, 0.2 s apart: position by Hermite, orientation by slerp",
                      "Between two keys the object turns about one axis at constant speed, on the shorter path."))
        return 0;
    svg_begin_clip(&out, box);
    space_floor(&out, &camera, box);
    frame_shadows(&out, s, &camera, NKW_ORIENTATION_SLERP, length);
    int ok = frame_objects(&out, s, &camera, NKW_ORIENTATION_SLERP, length);
    frame_numbers(&out, s, &camera);
    svg_end(&out);
    svg_rect(&out, box, 0.0f, &border);
    picture_object_legend(&out, s, svg_at(36.0f, 664.0f));
    return svg_close(&out) && ok;
}

/* ---- Euler angles against slerp ---- */

static nkw_mat4 turned(const scene *s, float time, nkw_orientation_method method)
{
    return scene_sample(s, time, NKW_POSITION_LINEAR, method);
}

static nkw_quat rotation_of(const nkw_mat4 *m)
{
    const nkw_mat3 block = nkw_mat3_from_mat4(m);
    return nkw_quat_from_mat3(&block);
}

/* The angle between the two methods at a time, radians. */
static float difference(const scene *s, float time)
{
    nkw_mat4 e = turned(s, time, NKW_ORIENTATION_EULER), q = turned(s, time, NKW_ORIENTATION_SLERP);
    return nkw_quat_angle(rotation_of(&e), rotation_of(&q));
}

/* Sample i: SAMPLES in each segment between two keys. */
static float sample_time(const scene *s, size_t i)
{
    const size_t segment = i / SAMPLES < s->count - 1 ? i / SAMPLES : s->count - 2;
    return scene_segment_time(s, segment, (float)(i - segment * SAMPLES) / (float)SAMPLES);
}

/* The segment in which the methods come to differ most. */
static size_t worst_segment(const scene *s)
{
    size_t worst = 0;
    float most = -1.0f;
    for (size_t i = 0; i < (s->count - 1) * SAMPLES; i++) {
        float d = difference(s, sample_time(s, i));
        if (d > most) {
            most = d;
            worst = i / SAMPLES;
        }
    }
    return worst;
}

/* An eye that looks 25 degrees down, turned about the vertical; yaw 0 looks along -z of the world. */
static nkw_mat4 upright_view(float yaw)
{
    nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    return nkw_mat4_from_quat(
        nkw_quat_mul(nkw_quat_from_axis_angle(x, 0.436332313f), nkw_quat_from_axis_angle(y, -yaw)));
}

static nkw_vec3 nose(const scene *s, float time, nkw_orientation_method method)
{
    nkw_mat4 m = turned(s, time, method);
    nkw_vec3 z = {-m.m[8], -m.m[9], -m.m[10]};
    return z;
}

static nkw_vec3 top(const scene *s, float time, nkw_orientation_method method)
{
    nkw_mat4 m = turned(s, time, method);
    nkw_vec3 y = {m.m[4], m.m[5], m.m[6]};
    return y;
}

/* The yaw of the eye that an axis of the object, on the mean over a segment, points to. */
static float facing_yaw(const scene *s, size_t segment, nkw_vec3 (*axis)(const scene *, float, nkw_orientation_method))
{
    nkw_vec3 sum = NKW_VEC3_ZERO;
    for (int i = 0; i <= 8; i++) {
        sum = nkw_vec3_add(sum, axis(s, scene_segment_time(s, segment, 0.125f * (float)i), NKW_ORIENTATION_EULER));
        sum = nkw_vec3_add(sum, axis(s, scene_segment_time(s, segment, 0.125f * (float)i), NKW_ORIENTATION_SLERP));
    }
    return nkw_atan2(sum.x, sum.z);
}

enum { STRIP = 7 };

static int strip_object(svg *out, const scene *s, const nkw_mat4 *turn, svg_point at, float yaw)
{
    space_list list = {NULL, 0, 0, 0};
    nkw_mat4 view = upright_view(yaw), m = *turn;
    m.m[12] = m.m[13] = m.m[14] = 0.0f;
    svg_camera camera = svg_orthographic(&view, at, 112.0f);
    object_paint(&list, &camera, &m, 1.0f, 0, s->object);
    return space_paint(&list, out);
}

static int strip(svg *out, const scene *s, size_t segment, float yaw)
{
    svg_font euler = {14.0f, euler_colour, 's', 1, SVG_NONE}, slerp = {14.0f, slerp_colour, 's', 1, SVG_NONE};
    svg_font time = {12.0f, 0x2b2b30, 'm', 0, SVG_NONE};
    char text[SVG_DIGITS], digits[SVG_DIGITS];
    int ok = 1;
    svg_text(out, svg_at(28.0f, 180.0f), &euler, "Euler angles");
    svg_text(out, svg_at(28.0f, 310.0f), &slerp, "slerp");
    svg_text(out, svg_at(28.0f, 392.0f), &svg_sheet_text, "apart by");
    for (int i = 0; i < STRIP; i++) {
        float t = scene_segment_time(s, segment, (float)i / (float)(STRIP - 1)), x = 196.0f + 136.0f * (float)i;
        nkw_mat4 e = turned(s, t, NKW_ORIENTATION_EULER), q = turned(s, t, NKW_ORIENTATION_SLERP);
        ok &= strip_object(out, s, &e, svg_at(x, 178.0f), yaw) && strip_object(out, s, &q, svg_at(x, 308.0f), yaw);
        sprintf(text, "%.16s s", svg_number(digits, t, 2));
        svg_text(out, svg_at(x, 108.0f), &time, text);
        sprintf(text, "%.16s\302\260", svg_number(digits, nkw_degrees_from_radians(difference(s, t)), 0));
        svg_text(out, svg_at(x, 392.0f), &time, text);
    }
    return ok;
}

/* ---- both methods, the keys in which they differ ---- */

/* The keys from the segment on in which the methods differ most. */
enum { CLOSE_KEYS = 3 };

/* A camera that looks 55 degrees down on the way of the object, with room for an object at each side, in a box. */
static svg_camera close_camera(const scene *s, svg_box box, float length)
{
    nkw_vec3 x = {1.0f, 0.0f, 0.0f};
    nkw_mat4 view = nkw_mat4_from_quat(nkw_quat_from_axis_angle(x, 0.959931089f));
    view.m[14] = -10.0f;
    svg_camera camera = svg_orthographic(&view, svg_at(0.0f, 0.0f), 1.0f);
    svg_point low = {1e9f, 1e9f}, high = {-1e9f, -1e9f};
    for (size_t i = 0; i < frame_count(s); i++) {
        nkw_mat4 m = frame(s, i, NKW_ORIENTATION_STEP);
        svg_point p = svg_project(&camera, nkw_mat4_translation(&m));
        low = svg_at(nkw_min(low.x, p.x), nkw_min(low.y, p.y));
        high = svg_at(nkw_max(high.x, p.x), nkw_max(high.y, p.y));
    }
    float margin = 2.2f * length;
    float scale = nkw_min(box.width / (high.x - low.x + margin), box.height / (high.y - low.y + margin));
    svg_point centre = {box.x + 0.5f * box.width - 0.5f * scale * (low.x + high.x),
                        box.y + 0.5f * box.height - 0.5f * scale * (low.y + high.y)};
    return svg_orthographic(&view, centre, scale);
}

static void close_numbers(svg *out, const scene *s, const svg_camera *camera, size_t first)
{
    svg_font font = {14.0f, 0x1d1d22, 'm', 1, 0xffffff};
    char text[SVG_DIGITS];
    for (size_t k = 0; k < s->count; k++) {
        sprintf(text, "key %u", (unsigned)(first + k));
        svg_text(out, picture_outward(s, camera, k, 50.0f), &font, text);
    }
}

/* s: keys of a scene from `first` on. */
static int close_panel(svg *out, const scene *s, size_t first, svg_box box, nkw_orientation_method method)
{
    const float length = 0.42f;
    const int euler = method == NKW_ORIENTATION_EULER;
    svg_font name = {16.0f, euler ? euler_colour : slerp_colour, 's', 1, 0xffffff};
    svg_paint border = svg_stroke(0x9a9aa2, 1.0f, 1.0f);
    svg_camera camera = close_camera(s, box, length);
    svg_begin_clip(out, box);
    space_floor(out, &camera, box);
    frame_shadows(out, s, &camera, method, length);
    int ok = frame_objects(out, s, &camera, method, length);
    close_numbers(out, s, &camera, first);
    svg_end(out);
    svg_rect(out, box, 0.0f, &border);
    svg_text(out, svg_at(box.x + 12.0f, box.y + 24.0f), &name, euler ? "Euler angles" : "slerp");
    return ok;
}

static float most_different(const scene *s)
{
    float most = 0.0f;
    for (size_t i = 0; i < (s->count - 1) * SAMPLES; i++)
        most = nkw_max(most, difference(s, sample_time(s, i)));
    return nkw_degrees_from_radians(most);
}

/* The angle between the methods in a segment, with its largest value. */
static void close_arc(svg *out, const scene *s, const svg_plot *plot, size_t segment)
{
    svg_font label = {13.0f, 0x7b3fa0, 'm', 1, 0xffffff};
    svg_paint paint = svg_stroke(0x7b3fa0, 2.6f, 1.0f), dot = svg_fill(0x7b3fa0, 1.0f);
    svg_point line[SAMPLES + 1], top = {0.0f, 1e9f};
    char text[SVG_DIGITS], digits[SVG_DIGITS];
    float most = 0.0f;
    for (size_t i = 0; i <= SAMPLES; i++) {
        float t = scene_segment_time(s, segment, (float)i / (float)SAMPLES);
        float d = nkw_degrees_from_radians(difference(s, t));
        line[i] = svg_plot_at(plot, t, d);
        top = line[i].y < top.y ? line[i] : top;
        most = nkw_max(most, d);
    }
    svg_polyline(out, line, SAMPLES + 1, &paint);
    svg_circle(out, top, 4.0f, &dot);
    sprintf(text, "%.16s\302\260", svg_number(digits, most, 1));
    svg_text(out, svg_at(top.x, top.y + 22.0f), &label, text);
}

/* The names of the keys at their times. */
static void close_keys(svg *out, const scene *s, const svg_plot *plot, size_t first)
{
    char text[SVG_DIGITS];
    for (size_t k = 0; k < s->count; k++) {
        const char anchor = k == 0 ? 's' : k + 1 == s->count ? 'e' : 'm';
        svg_font font = {13.0f, 0x1d1d22, anchor, 1, 0xffffff};
        svg_point p = svg_plot_at(plot, s->keys[k].time, plot->y.to);
        const float aside = anchor == 's' ? 6.0f : anchor == 'e' ? -6.0f : 0.0f;
        sprintf(text, "key %u", (unsigned)(first + k));
        svg_text(out, svg_at(p.x + aside, p.y + 17.0f), &font, text);
    }
}

static void close_angles(svg *out, const scene *s, size_t first)
{
    const float span = scene_end(s) - scene_start(s), most = nkw_max(most_different(s), 1.0f);
    svg_plot plot = {{76.0f, 602.0f, 1000.0f, 130.0f},
                     {scene_start(s), scene_end(s),
                      span > 12.0f  ? 5.0f
                      : span > 2.5f ? 1.0f
                                    : 0.2f,
                      "time, s"},
                     {0.0f, 1.17f * most,
                      most > 60.0f  ? 30.0f
                      : most > 6.0f ? 5.0f
                                    : 1.0f,
                      "angle between the two, degrees"}};
    svg_plot_frame(out, &plot);
    for (size_t k = 0; k + 1 < s->count; k++)
        close_arc(out, s, &plot, k);
    close_keys(out, s, &plot, first);
}

int picture_frames_compare(const scene *s, const char *path)
{
    svg out;
    scene part = *s;
    char title[96];
    const svg_box left = {24.0f, 84.0f, 522.0f, 450.0f}, right = {554.0f, 84.0f, 522.0f, 450.0f};
    part.count = s->count < CLOSE_KEYS ? s->count : CLOSE_KEYS;
    size_t worst = worst_segment(s), last = s->count - part.count, first = worst < last ? worst : last;
    for (size_t k = 0; k < part.count; k++)
        part.keys[k] = s->keys[first + k];
    sprintf(title, "Euler angles against slerp, from key %u to key %u", (unsigned)first,
            (unsigned)(first + part.count - 1));
    if (!svg_sheet_open(&out, path, 1100.0f, 780.0f, title,
                      "The same keys, times and positions (Hermite), every 0.2 s. By Euler angles the objects between "
                      "two keys swing aside."))
        return 0;
    int ok = close_panel(&out, &part, first, left, NKW_ORIENTATION_EULER) &&
             close_panel(&out, &part, first, right, NKW_ORIENTATION_SLERP);
    picture_object_legend(&out, s, svg_at(36.0f, 556.0f));
    close_angles(&out, &part, first);
    return svg_close(&out) && ok;
}

/* ---- the path of the nose on the unit sphere ---- */

static void nose_path(svg *out, const svg_camera *camera, const scene *s, size_t segment, nkw_orientation_method method,
                      svg_colour colour)
{
    nkw_vec3 points[SAMPLES + 1];
    svg_paint dot = {colour, 0xffffff, 1.0f, 1.0f, NULL};
    for (size_t i = 0; i <= SAMPLES; i++)
        points[i] = nose(s, sample_time(s, segment * SAMPLES + i), method);
    sphere_line(out, camera, points, SAMPLES + 1, svg_stroke(colour, 3.2f, 1.0f));
    for (size_t i = 0; i <= SAMPLES; i += SAMPLES / 12)
        svg_circle(out, svg_project(camera, points[i]), 4.2f, &dot);
}

static void sphere_key(svg *out, const svg_camera *camera, const scene *s, size_t key)
{
    svg_font font = {13.0f, 0x1d1d22, 'm', 1, 0xffffff};
    svg_paint core = {0xffffff, 0x1d1d22, 2.0f, 1.0f, NULL};
    char text[SVG_DIGITS];
    svg_point p = svg_project(camera, nose(s, s->keys[key].time, NKW_ORIENTATION_STEP));
    svg_circle(out, p, 5.5f, &core);
    svg_text(out, svg_at(p.x, p.y + (p.y < camera->centre.y ? -14.0f : 24.0f)), &font, picture_key_name(s, key, text));
}

static void sphere(svg *out, const scene *s, size_t segment)
{
    svg_font heading = {14.0f, 0x1d1d22, 's', 1, SVG_NONE};
    nkw_mat4 view = upright_view(facing_yaw(s, segment, nose));
    svg_camera camera = svg_orthographic(&view, svg_at(260.0f, 682.0f), 190.0f);
    svg_text(out, svg_at(28.0f, 452.0f), &heading, "Where the nose points, from one key to the next");
    sphere_ball(out, &camera);
    nose_path(out, &camera, s, segment, NKW_ORIENTATION_EULER, euler_colour);
    nose_path(out, &camera, s, segment, NKW_ORIENTATION_SLERP, slerp_colour);
    sphere_key(out, &camera, s, segment);
    sphere_key(out, &camera, s, segment + 1);
}

/* ---- the speed of turning ---- */

/* Radians per second over the sample from i to i + 1; the end of a segment belongs to it. */
static float turning_speed(const scene *s, size_t i, nkw_orientation_method method)
{
    const float from = sample_time(s, i), to = sample_time(s, i + 1);
    nkw_mat4 a = turned(s, from, method), b = turned(s, to, method);
    const float angle = nkw_quat_angle(rotation_of(&a), rotation_of(&b));
    return to > from ? angle / (to - from) : 0.0f;
}

static float fastest(const scene *s)
{
    float most = 0.0f;
    for (size_t i = 0; i < (s->count - 1) * SAMPLES; i++)
        most = nkw_max(most,
                       nkw_max(turning_speed(s, i, NKW_ORIENTATION_EULER), turning_speed(s, i, NKW_ORIENTATION_SLERP)));
    return nkw_degrees_from_radians(most);
}

static void speed_line(svg *out, const scene *s, const svg_plot *plot, nkw_orientation_method method, svg_colour colour)
{
    svg_point line[SCENE_KEYS_MAX * SAMPLES];
    svg_paint paint = svg_stroke(colour, 2.4f, 1.0f);
    size_t count = (s->count - 1) * SAMPLES;
    for (size_t i = 0; i < count; i++)
        line[i] = svg_plot_at(plot, 0.5f * (sample_time(s, i) + sample_time(s, i + 1)),
                              nkw_degrees_from_radians(turning_speed(s, i, method)));
    svg_polyline(out, line, count, &paint);
}

static void speeds(svg *out, const scene *s)
{
    svg_font heading = {14.0f, 0x1d1d22, 's', 1, SVG_NONE};
    svg_plot plot = {{556.0f, 500.0f, 520.0f, 330.0f},
                     {scene_start(s), scene_end(s), 1.0f, "time, s"},
                     {0.0f, 0.0f, 30.0f, "degrees per second"}};
    plot.y.to = nkw_max(1.12f * fastest(s), 1.0f);
    while ((plot.x.to - plot.x.from) / plot.x.tick > 12.0f)
        plot.x.tick *= 2.0f;
    while (plot.y.to / plot.y.tick > 12.0f)
        plot.y.tick *= 2.0f;
    svg_text(out, svg_at(526.0f, 452.0f), &heading, "Angular speed, over all keys");
    svg_plot_frame(out, &plot);
    speed_line(out, s, &plot, NKW_ORIENTATION_EULER, euler_colour);
    speed_line(out, s, &plot, NKW_ORIENTATION_SLERP, slerp_colour);
}

static void method_legend(svg *out, svg_point at)
{
    svg_paint euler = svg_stroke(euler_colour, 3.2f, 1.0f), slerp = svg_stroke(slerp_colour, 3.2f, 1.0f);
    svg_line(out, at, svg_at(at.x + 30.0f, at.y), &euler);
    svg_text(out, svg_at(at.x + 38.0f, at.y + 4.5f), &svg_sheet_text, "Euler angles");
    svg_line(out, svg_at(at.x + 140.0f, at.y), svg_at(at.x + 170.0f, at.y), &slerp);
    svg_text(out, svg_at(at.x + 178.0f, at.y + 4.5f), &svg_sheet_text, "slerp");
}

int picture_orientation_compare(const scene *s, const char *path)
{
    svg out;
    size_t segment = worst_segment(s);
    char title[96];
    sprintf(title, "Where the two methods differ most: from key %u to key %u", (unsigned)segment, (unsigned)segment + 1);
    if (!svg_sheet_open(&out, path, 1100.0f, 884.0f, title,
                      "Same keys, same times. Slerp turns about one axis at constant speed. Euler angles take a longer "
                      "path at varying speed."))
        return 0;
    int ok = strip(&out, s, segment, facing_yaw(s, segment, top));
    sphere(&out, s, segment);
    speeds(&out, s);
    picture_object_legend(&out, s, svg_at(196.0f, 418.0f));
    method_legend(&out, svg_at(28.0f, 474.0f));
    method_legend(&out, svg_at(850.0f, 447.0f));
    return svg_close(&out) && ok;
}
