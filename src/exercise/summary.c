/* SPDX-License-Identifier: MIT */
#include "summary.h"

#include <nakawari/euler.h>
#include <nakawari/mat.h>
#include <nakawari/quat.h>

#define DEGREES 57.29577951308232

static const nkw_position_method positions[] = {NKW_POSITION_LINEAR, NKW_POSITION_HERMITE, NKW_POSITION_BEZIER,
                                                NKW_POSITION_BSPLINE};
enum { POSITIONS = sizeof positions / sizeof *positions };

/* With a star at the time of a key. */
static void print_time(FILE *f, const scene *s, float time)
{
    size_t key = 0;
    while (key < s->count && s->keys[key].time != time)
        key++;
    fprintf(f, "%4.1f%c", (double)time, key < s->count ? '*' : ' ');
}

/* 0 in place of -0.00. */
static double rounded(double value)
{
    return value > -0.005 && value < 0.005 ? 0.0 : value;
}

static void print_vector(FILE *f, double x, double y, double z, int width)
{
    fprintf(f, " %*.2f%*.2f%*.2f", width, rounded(x), width, rounded(y), width, rounded(z));
}

static nkw_mat3 rotation_at(const scene *s, float time, nkw_orientation_method method)
{
    nkw_mat4 m = scene_sample(s, time, NKW_POSITION_LINEAR, method);
    return nkw_mat3_from_mat4(&m);
}

/* Yaw, pitch and roll. */
static void print_angles(FILE *f, const nkw_mat3 *r)
{
    nkw_vec3 angles = nkw_euler_from_mat3(r, NKW_EULER_YXZ);
    print_vector(f, (double)angles.y * DEGREES, (double)angles.x * DEGREES, (double)angles.z * DEGREES, 8);
}

static void print_positions(FILE *f, const scene *s, float time)
{
    print_time(f, s, time);
    for (int i = 0; i < POSITIONS; i++) {
        nkw_mat4 m = scene_sample(s, time, positions[i], NKW_ORIENTATION_STEP);
        nkw_vec3 p = nkw_mat4_translation(&m);
        print_vector(f, (double)p.x, (double)p.y, (double)p.z, 6);
    }
    fputc('\n', f);
}

static void print_orientations(FILE *f, const scene *s, float time)
{
    nkw_mat3 euler = rotation_at(s, time, NKW_ORIENTATION_EULER), slerp = rotation_at(s, time, NKW_ORIENTATION_SLERP);
    double between = (double)nkw_quat_angle(nkw_quat_from_mat3(&euler), nkw_quat_from_mat3(&slerp)) * DEGREES;
    print_time(f, s, time);
    print_angles(f, &euler);
    print_angles(f, &slerp);
    fprintf(f, "%10.2f\n", rounded(between));
}

void summary_print(FILE *f, const scene *s)
{
    const float start = s->keys[0].time;
    const int rows = (int)((scene_end(s) - start) * 2.0f) + 1;
    fprintf(f, "Position x y z at some seconds (* a key):\n%11s%21s%18s%20s\n", "linear", "Hermite", "Bezier",
            "B-spline");
    for (int k = 0; k < rows; k++)
        print_positions(f, s, start + 0.5f * (float)k);
    fprintf(f, "\nOrientation in degrees, yaw pitch roll, and the angle between the two:\n%17s%18s%27s\n",
            "Euler angles", "slerp", "between");
    for (int k = 0; k < rows; k++)
        print_orientations(f, s, start + 0.5f * (float)k);
}
