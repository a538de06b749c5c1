/* SPDX-License-Identifier: MIT */
/* Wavefront .obj files. mesh.h says what of them is read. */
#include "mesh.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/vec.h>

#define NONE   ((size_t)-1)
#define BLANKS " \t\r"

/* A position of the file and the first vertex made of it; NONE: there is none. */
typedef struct place {
    nkw_vec3 at;
    size_t first;
} place;

/* Of a vertex: its normal's number, which for a face's own normal is NONE - line, and the next vertex of its place. */
typedef struct use {
    size_t normal, next;
} use;

typedef struct reader {
    mesh *out;
    const char *path;
    char *message;
    size_t line;
    place *places;
    nkw_vec3 *normals;
    use *uses;
    size_t place_count, place_room, normal_count, normal_room, use_room;
} reader;

/* Corners of one face, as numbers from 0; the normal may be NONE. */
enum { CORNERS_MAX = 256 };
typedef struct polygon {
    size_t place[CORNERS_MAX], normal[CORNERS_MAX];
    int corners;
} polygon;

static int fail(const reader *r, const char *what)
{
    sprintf(r->message, "%.300s:%lu: %.100s", r->path, (unsigned long)r->line, what);
    return 0;
}

static int no_memory(const reader *r)
{
    return fail(r, "not enough memory");
}

/* ---- v and vn ---- */

static int read_vector(const reader *r, const char *text, nkw_vec3 *out)
{
    float number[3];
    for (int i = 0; i < 3; i++) {
        char *end;
        number[i] = (float)strtod(text, &end);
        if (end == text)
            return fail(r, "three numbers were expected");
        text = end;
    }
    nkw_vec3 v = {number[0], number[1], number[2]};
    *out = v;
    return nkw_vec3_is_finite(v) || fail(r, "a number is too large");
}

static int add_place(reader *r, const char *text)
{
    place p = {{0.0f, 0.0f, 0.0f}, NONE}, *moved;
    if (!read_vector(r, text, &p.at))
        return 0;
    moved = mesh_grow(r->places, sizeof p, r->place_count, &r->place_room);
    if (!moved)
        return no_memory(r);
    r->places = moved;
    r->places[r->place_count++] = p;
    return 1;
}

static int add_normal(reader *r, const char *text)
{
    nkw_vec3 normal, *moved;
    if (!read_vector(r, text, &normal))
        return 0;
    moved = mesh_grow(r->normals, sizeof normal, r->normal_count, &r->normal_room);
    if (!moved)
        return no_memory(r);
    r->normals = moved;
    r->normals[r->normal_count++] = nkw_vec3_normalize(normal);
    return 1;
}

/* ---- f ---- */

/* A number of the file, from 1, or from -1 backwards, as one from 0. */
static int read_index(const reader *r, const char **text, size_t count, size_t *out)
{
    char *end;
    long n = strtol(*text, &end, 10);
    size_t index = n > 0 ? (size_t)n - 1 : count + (size_t)n;
    if (end == *text)
        return fail(r, "a corner's number was expected");
    if (index >= count)
        return fail(r, "no such vertex or normal so far");
    *out = index;
    *text = end;
    return 1;
}

/* v, v/vt, v//vn or v/vt/vn. */
static int read_corner(const reader *r, const char **text, size_t *place_index, size_t *normal)
{
    *normal = NONE;
    if (!read_index(r, text, r->place_count, place_index))
        return 0;
    if (**text == '/') {
        char *end;
        (void)strtol(*text + 1, &end, 10);
        *text = (*text)[1] == '/' ? *text + 1 : end;
        if (**text == '/') {
            (*text)++;
            if (!read_index(r, text, r->normal_count, normal))
                return 0;
        }
    }
    return !**text || strchr(BLANKS, **text) || fail(r, "a corner's number was expected");
}

static int read_polygon(const reader *r, const char *text, polygon *p)
{
    for (p->corners = 0;; p->corners++) {
        text += strspn(text, BLANKS);
        if (!*text)
            return p->corners >= 3 || fail(r, "a face has fewer than three corners");
        if (p->corners == CORNERS_MAX)
            return fail(r, "a face has too many corners");
        if (!read_corner(r, &text, &p->place[p->corners], &p->normal[p->corners]))
            return 0;
    }
}

/* Twice the area, along the normal: the sum over the triangles of the fan. */
static nkw_vec3 polygon_area(const reader *r, const polygon *p)
{
    nkw_vec3 first = r->places[p->place[0]].at, sum = NKW_VEC3_ZERO;
    for (int i = 1; i + 1 < p->corners; i++) {
        nkw_vec3 a = nkw_vec3_sub(r->places[p->place[i]].at, first);
        nkw_vec3 b = nkw_vec3_sub(r->places[p->place[i + 1]].at, first);
        sum = nkw_vec3_add(sum, nkw_vec3_cross(a, b));
    }
    return sum;
}

/* The vertex of a place and a normal, made when it is first met. */
static int vertex_of(reader *r, place *p, size_t number, nkw_vec3 normal, size_t *out)
{
    use made = {number, p->first}, *moved;
    for (*out = p->first; *out != NONE; *out = r->uses[*out].next) {
        if (r->uses[*out].normal == number)
            return 1;
    }
    moved = mesh_grow(r->uses, sizeof made, r->out->vertex_count, &r->use_room);
    if (!moved)
        return no_memory(r);
    r->uses = moved;
    *out = p->first = r->out->vertex_count;
    r->uses[*out] = made;
    return mesh_add_vertex(r->out, p->at, normal) || no_memory(r);
}

static int corner_vertex(reader *r, const polygon *p, int k, size_t *out)
{
    place *at = &r->places[p->place[k]];
    if (p->normal[k] != NONE)
        return vertex_of(r, at, p->normal[k], r->normals[p->normal[k]], out);
    return vertex_of(r, at, NONE - r->line, nkw_vec3_normalize(polygon_area(r, p)), out);
}

/* One face of three or four corners, or a fan of triangles about the first corner. */
static int add_polygon(reader *r, const char *text)
{
    polygon p;
    size_t corner[4];
    if (!read_polygon(r, text, &p))
        return 0;
    int size = p.corners == 4 ? 4 : 3;
    for (int first = 1; first + size - 2 < p.corners; first++) {
        for (int i = 0; i < size; i++) {
            if (!corner_vertex(r, &p, i ? first + i - 1 : 0, &corner[i]))
                return 0;
        }
        if (!mesh_add_face(r->out, corner, size))
            return no_memory(r);
    }
    return 1;
}

/* ---- the file ---- */

static int read_line(reader *r, const char *text)
{
    text += strspn(text, BLANKS);
    size_t word = strcspn(text, BLANKS);
    const char *rest = text + word;
    if (word == 1 && *text == 'v')
        return add_place(r, rest);
    if (word == 2 && text[0] == 'v' && text[1] == 'n')
        return add_normal(r, rest);
    return !(word == 1 && *text == 'f') || add_polygon(r, rest);
}

static int read_lines(reader *r, char *text)
{
    while (text) {
        char *end = strchr(text, '\n');
        if (end)
            *end++ = '\0';
        r->line++;
        if (!read_line(r, text))
            return 0;
        text = end;
    }
    return 1;
}

/* All that is left of a file, ended by a zero; NULL, errno set, if it cannot be read. The caller frees it. */
static char *read_rest(FILE *f)
{
    enum { BLOCK = 4096 };
    char *text = NULL, *moved;
    size_t count = 0, blocks = 0, got;
    do {
        moved = mesh_grow(text, BLOCK, (count + 1) / BLOCK, &blocks);
        if (!moved)
            errno = ENOMEM;
        else
            text = moved;
        got = moved ? fread(text + count, 1, blocks * BLOCK - count - 1, f) : 0;
        count += got;
    } while (got);
    if (moved && !ferror(f)) {
        text[count] = '\0';
        return text;
    }
    int error = errno;
    free(text);
    errno = error;
    return NULL;
}

int mesh_read_obj(mesh *m, const char *path, char message[MESH_MESSAGE])
{
    reader r = {m, path, message, 0, NULL, NULL, NULL, 0, 0, 0, 0, 0};
    FILE *f = fopen(path, "rb");
    char *text = f ? read_rest(f) : NULL;
    if (!text)
        sprintf(message, "cannot read %.300s: %.100s", path, strerror(errno));
    if (f)
        fclose(f);
    if (!text)
        return 0;
    int ok = read_lines(&r, text);
    if (ok && m->face_count == 0) {
        sprintf(message, "%.300s: there are no faces", path);
        ok = 0;
    }
    free(text);
    free(r.places);
    free(r.normals);
    free(r.uses);
    return ok;
}
