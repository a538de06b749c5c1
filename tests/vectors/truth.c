/* SPDX-License-Identifier: CC0-1.0 */
/* vectors_truth FOLDER: writes every file of vectors into the folder. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <stdlib.h>
#include <string.h>

static FILE *file;
static random_source source;

void truth_open(const char *folder, const char *name, const char *const *about)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s.txt", folder, name);
    file = fopen(path, "w");
    if (!file) {
        perror(path);
        exit(2);
    }
    source = random_from((uint64_t)(name[0] * 256 + name[1]));
    fprintf(file, "vectors 1 %s\n# CC0-1.0: public domain. The format: docs/vectors.md.\n", name);
    for (; *about; about++)
        fprintf(file, "# %s\n", *about);
}

void truth_close(void)
{
    if (fclose(file)) {
        perror("vectors");
        exit(2);
    }
}

void truth_group(const char *name, const char *const *lines, double units, const char *reason)
{
    double tolerance = units * ULP1;
    fprintf(file, "\ngroup %s\n", name);
    for (; *lines; lines++)
        fprintf(file, "%s\n", *lines);
    fprintf(file, "tolerance %a ; %.3g: %s\n", tolerance, tolerance, reason);
}

void truth_case(const char *kind, const char *name, const char *check)
{
    fprintf(file, "case %s %s%s%s\n", kind, name, check ? " " : "", check ? check : "");
}

static const char *special(double x)
{
    return x != x ? "nan" : x > 0.0 ? "inf" : "-inf";
}

/* Hexadecimal, then the same decimal with enough digits to return to the bits. */
static void numbers(const char *name, const double *x, int n, int digits)
{
    fputs(name, file);
    for (int i = 0; i < n; i++)
        isfinite(x[i]) ? fprintf(file, " %a", x[i]) : fprintf(file, " %s", special(x[i]));
    fputs(" ;", file);
    for (int i = 0; i < n; i++)
        isfinite(x[i]) ? fprintf(file, " %.*g", digits, x[i]) : fprintf(file, " %s", special(x[i]));
    fputs("\n", file);
}

void truth_sizes(const double *sizes, int n)
{
    double v[8];
    for (int i = 0; i < n; i++)
        v[i] = (double)(float)sizes[i];
    numbers("size", v, n, 3);
}

void truth_scale(double scale)
{
    if (scale > 1.0)
        truth_sizes(&scale, 1);
}

void truth_in(const char *name, const float *x, int n)
{
    double v[64];
    for (int i = 0; i < n; i++)
        v[i] = (double)x[i];
    numbers(name, v, n, 9);
}

void truth_out(const char *name, const wide *x, int n)
{
    double v[64];
    for (int i = 0; i < n; i++)
        v[i] = (double)x[i];
    numbers(name, v, n, 17);
}

random_source *truth_random(void)
{
    return &source;
}

double truth_size(const float *x, int n)
{
    double size = 1.0;
    for (int i = 0; i < n; i++)
        size = fabs((double)x[i]) > size ? fabs((double)x[i]) : size;
    return size;
}

void truth_turn(float x, float y, float z, float degrees, float out[4])
{
    wide axis[3] = {x, y, z}, half = (wide)degrees * wide_pi() / 360;
    wide_normalize(axis, 3);
    for (int i = 0; i < 3; i++)
        out[i] = (float)(sinq(half) * axis[i]);
    out[3] = (float)cosq(half);
}

void truth_some_turn(float out[4])
{
    wide q[4];
    put_quat(out, random_rotation(&source));
    wide_from(out, q, 4);
    wide_normalize(q, 4);
    wide_round(q, out, 4);
}

void truth_append(wide q[4], const wide v[3], wide b)
{
    wide length = b * wide_length(v, 3), part = length != 0 ? b * sinq(length) / length : b;
    wide e[4] = {part * v[0], part * v[1], part * v[2], cosq(length)};
    wide_quat_mul(q, e, q);
}

void truth_inverse(const wide q[4], wide out[4])
{
    memmove(out, q, 4 * sizeof *q);
    wide_scale(out, -1, 3);
}

void truth_chord(const wide a[4], const wide b[4], wide v[3])
{
    wide turn[4];
    truth_inverse(a, turn);
    wide_quat_mul(turn, b, turn);
    wide_scale(turn, turn[3] < 0 ? -1 : 1, 4);
    wide_quat_log(turn, v);
}

void truth_align(const wide a[4], wide b[4], int path)
{
    int obtuse = wide_dot(a, b, 4) < 0;
    if (path == 1 ? !obtuse : path == 0 && obtuse)
        wide_scale(b, -1, 4);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fputs("usage: vectors_truth FOLDER\n", stderr);
        return 2;
    }
    truth_curves(argv[1]);
    truth_rotations(argv[1]);
    truth_paths(argv[1]);
    truth_splines(argv[1]);
    truth_euler(argv[1]);
    truth_time(argv[1]);
    truth_poses(argv[1]);
    truth_skinning(argv[1]);
    truth_motion(argv[1]);
    truth_tracks(argv[1]);
    truth_ease(argv[1]);
    return 0;
}

#else
WIDE_SKIPPED
#endif
