/* SPDX-License-Identifier: MIT */
/**
 * @file
 * nakawari-joints: the lesson on joint animation, finished: a capsule, or a mesh from a file, is bent by four joints,
 * from key frames to skinned vertices, and drawn; or the matrices of one moment are printed. See docs/joints.md.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>

#include "film.h"
#include "options.h"

/* Exit codes. */
enum { DONE, FAILED, MISUSED };
enum { PATH_SIZE = 4096, FRAMES_MAX = 1000 };

static const char usage[] = "usage: nakawari-joints [options]\n"
                            "Bends a capsule with four joints, from key frames to skinned vertices, and draws it.\n"
                            "\n"
                            "  --obj FILE         bend the faces of a Wavefront .obj file instead, upright along y\n"
                            "  --frames N         how many pictures of the 4 seconds, 1 to 1000 (default 8)\n"
                            "  --dual             skin by dual quaternions instead of blended matrices\n"
                            "  --out DIR          an existing folder for the pictures (default .)\n"
                            "  --trace TIME       write no file; print the matrices of all joints at TIME\n"
                            "  -h, --help         print this\n";

typedef struct options {
    const char *obj, *out;
    long frames;
    int dual, trace, help;
    double time;
} options;

static const char program[] = "nakawari-joints";

static int read_options(int argc, char **argv, options *o)
{
    const option known[] = {{"--obj", OPTION_TEXT, &o->obj, 0, 0, NULL},
                            {"--frames", OPTION_WHOLE, &o->frames, 1, FRAMES_MAX, NULL},
                            {"--dual", OPTION_FLAG, &o->dual, 0, 0, NULL},
                            {"--out", OPTION_TEXT, &o->out, 0, 0, NULL},
                            {"--trace", OPTION_NUMBER, &o->time, -1e6, 1e6, &o->trace}};
    if (!options_read(program, known, sizeof known / sizeof *known, argc, argv, &o->help))
        return 0;
    return strlen(o->out) + 64 < PATH_SIZE || options_complain(program, "path too long", o->out);
}

/* ---- one moment in numbers ---- */

/* What rounds to zero is printed as zero, not as -0. */
static void print_row(const nkw_mat4 *m, int row)
{
    for (int c = 0; c < 4; c++) {
        float x = m->m[c * 4 + row];
        printf(" %9.6f", x > -5e-7f && x < 5e-7f ? 0.0 : (double)x);
    }
}

static void print_pair(const char *a_name, const nkw_mat4 *a, const char *b_name, const nkw_mat4 *b)
{
    printf("  %-40s    %s\n", a_name, b_name);
    for (int row = 0; row < 4; row++) {
        printf(" ");
        print_row(a, row);
        printf("    ");
        print_row(b, row);
        printf("\n");
    }
}

/* The first vertex nearest to the height of joint 2. */
static size_t bend_vertex(const rig *r, const mesh *m)
{
    size_t best = 0;
    float height = r->foot + 2.0f * r->spacing, nearest = -1.0f;
    for (size_t i = 0; i < m->vertex_count; i++) {
        float d = m->vertices[i].position.y - height;
        if (nearest < 0.0f || d * d < nearest) {
            nearest = d * d;
            best = i;
        }
    }
    return best;
}

static void print_point(const char *before, nkw_vec3 p, const char *after)
{
    printf("%s(%.6f, %.6f, %.6f)%s", before, (double)p.x, (double)p.y, (double)p.z, after);
}

/* Where one vertex goes: a mesh of its own. */
static void print_vertex(mesh_vertex v, const rig_state *state)
{
    const mesh one = {&v, NULL, 1, 0, 1, 0};
    nkw_vec3 position, normal;
    print_point("a vertex at ", v.position, "\n  weights");
    for (int i = 0; i < MESH_INFLUENCES; i++)
        printf(" %u", v.weights[i]);
    printf(" of 65535 on joints 0 1 2 3\n");
    rig_skin(state, &one, 0, &position, &normal);
    print_point("  by blended matrices it goes to ", position, "\n");
    rig_skin(state, &one, 1, &position, &normal);
    print_point("  by dual quaternions it goes to ", position, "\n");
}

static void print_trace(const rig *r, const mesh *m, float time)
{
    rig_state state = rig_at(r, time);
    printf("time = %.9g s\n", (double)time);
    for (size_t j = 0; j < RIG_JOINTS; j++) {
        char model[64] = "model = local";
        if (j)
            sprintf(model, "model = model of joint %d * local", (int)r->skeleton.parents[j]);
        printf("\njoint %u\n", (unsigned)j);
        print_pair("local", &state.local[j], model, &state.model[j]);
        print_pair("inverse bind", &r->inverse_bind[j], "joint matrix = model * inverse bind", &state.palette[j]);
    }
    printf("\n");
    print_vertex(m->vertices[bend_vertex(r, m)], &state);
}

/* ---- the pictures ---- */

/* Reports a file that could not be written. */
static int report(int ok, const char *path)
{
    if (!ok)
        fprintf(stderr, "nakawari-joints: cannot write %s: %s\n", path, strerror(errno));
    return ok;
}

static int write_frames(film *f, const char *folder)
{
    char path[PATH_SIZE];
    int ok = 1;
    for (int i = 0; ok && i < f->frames; i++) {
        sprintf(path, "%s/joints-frame-%03d.svg", folder, i);
        ok = report(film_frame(f, i, path), path);
    }
    return ok;
}

static int write_files(film *f, const char *folder)
{
    char path[PATH_SIZE];
    if (!write_frames(f, folder))
        return 0;
    sprintf(path, "%s/joints-sheet.svg", folder);
    if (!report(film_sheet(f, path), path))
        return 0;
    sprintf(path, "%s/joints-compare.svg", folder);
    if (!report(film_compare(f, path), path))
        return 0;
    printf("wrote %d frames, %s/joints-sheet.svg and %s\n", f->frames, folder, path);
    return 1;
}

static int draw(const rig *r, const mesh *m, const options *o)
{
    film f;
    int ok = film_open(&f, r, m, o->dual, (int)o->frames);
    if (ok)
        ok = write_files(&f, o->out);
    else
        fprintf(stderr, "nakawari-joints: not enough memory\n");
    film_free(&f);
    return ok;
}

/* ---- */

static int bend(mesh *m, const options *o)
{
    rig r;
    const char *wrong = rig_build(&r, m);
    int ok = !wrong;
    if (wrong)
        fprintf(stderr, "nakawari-joints: %s\n", wrong);
    else if (o->trace)
        print_trace(&r, m, (float)o->time);
    else
        ok = draw(&r, m, o);
    rig_free(&r);
    return ok;
}

static int run(const options *o)
{
    mesh m = {NULL, NULL, 0, 0, 0, 0};
    char message[MESH_MESSAGE] = "not enough memory";
    int ok = o->obj ? mesh_read_obj(&m, o->obj, message) : mesh_capsule(&m);
    if (!ok)
        fprintf(stderr, "nakawari-joints: %s\n", message);
    ok = ok && bend(&m, o);
    mesh_free(&m);
    return ok ? DONE : FAILED;
}

int main(int argc, char **argv)
{
    options o = {NULL, ".", 8, 0, 0, 0, 0.0};
    int code = DONE;
    if (!read_options(argc, argv, &o))
        return MISUSED;
    if (o.help)
        fputs(usage, stdout);
    else
        code = run(&o);
    if (code == DONE && fflush(stdout) != 0)
        code = FAILED;
    return code;
}
