/* SPDX-License-Identifier: MIT */
/*
 * MD5 files are checked before Assimp reads them: Assimp 5.2 reads out of bounds where a file is cut, or names a joint,
 * a weight, a vertex or a value that it does not have.
 */
#include <stdio.h>
#include <string.h>

#include "assimp.h"

enum { LINE_MOST = 1024 };

typedef enum section { GLOBAL, JOINTS, MESH, HIERARCHY, BASEFRAME, FRAME, OTHER } section;

typedef struct md5 {
    const char *at, *end;
    char line[LINE_MOST];
    size_t number; /* of the line */
    section in;
    unsigned long joints, base_frames; /* lines of these sections */
    unsigned long vertices, triangles, weights; /* of the mesh, as stated */
    unsigned long vertex_lines, triangle_lines, weight_lines;
    unsigned long first_most, vertex_most; /* 1 more than the largest weight and vertex that the mesh names */
    unsigned long values, values_most; /* of the frame, and 1 more than the largest of the hierarchy */
} md5;

/* The next line without its blanks; 0 at the end, -1 for one that is too long. */
static int next_line(md5 *m)
{
    size_t length = 0;
    while (m->at < m->end && (*m->at == ' ' || *m->at == '\t'))
        m->at++;
    if (m->at == m->end)
        return 0;
    for (; m->at < m->end && *m->at != '\n' && length < LINE_MOST - 1; m->at++)
        m->line[length++] = *m->at;
    if (m->at < m->end && *m->at != '\n')
        return -1;
    m->at += m->at < m->end;
    m->line[length] = 0;
    m->number++;
    return memchr(m->line, 0, length) ? -1 : 1;
}

static int is_word(const md5 *m, const char *word)
{
    size_t length = strlen(word);
    return strncmp(m->line, word, length) == 0 && (m->line[length] == 0 || strchr(" \t\r{", m->line[length]));
}

/* A name in quotes, then its parent: a line before. *rest is what follows. */
static int is_joint(const md5 *m, const char **rest)
{
    const char *close = m->line[0] == '"' ? strchr(m->line + 1, '"') : NULL;
    long parent;
    int used;
    if (!close || sscanf(close + 1, "%ld%n", &parent, &used) != 1)
        return 0;
    *rest = close + 1 + used;
    return parent >= -1 && parent < (long)m->joints;
}

/* Two vectors in brackets. */
static int are_vectors(const char *text)
{
    for (int i = 0; i < 2; i++) {
        const char *open = strchr(text, '('), *close = open ? strchr(open, ')') : NULL;
        if (!close)
            return 0;
        text = close + 1;
    }
    return 1;
}

static int joint_line(md5 *m)
{
    const char *rest;
    return is_joint(m, &rest) && are_vectors(rest) && ++m->joints;
}

/* Bits 0 to 5 of the flags: which of six values a frame has. */
static int hierarchy_line(md5 *m)
{
    const char *rest;
    unsigned long flags, first, count = 0;
    if (!is_joint(m, &rest) || sscanf(rest, "%lu %lu", &flags, &first) != 2 || flags > 63 || first > 1000000)
        return 0;
    for (unsigned long bits = flags; bits; bits /= 2)
        count += bits % 2;
    if (flags && first + count > m->values_most)
        m->values_most = first + count;
    m->joints++;
    return 1;
}

static unsigned long most_of(unsigned long a, unsigned long b)
{
    return a > b ? a : b;
}

static int mesh_line(md5 *m)
{
    unsigned long i, a, b, c;
    const char *close = strchr(m->line, ')');
    if (is_word(m, "shader")) {
        const char *open = strchr(m->line, '"');
        return open && strchr(open + 1, '"');
    }
    if (is_word(m, "vert")) {
        if (sscanf(m->line, "vert %lu (", &i) != 1 || !close || sscanf(close + 1, "%lu %lu", &a, &b) != 2 ||
            a > 100000000 || b > 100000000)
            return 0;
        m->first_most = most_of(m->first_most, a + b);
        return i == m->vertex_lines++;
    }
    if (is_word(m, "tri")) {
        if (sscanf(m->line, "tri %lu %lu %lu %lu", &i, &a, &b, &c) != 4)
            return 0;
        m->vertex_most = most_of(m->vertex_most, most_of(a, most_of(b, c)));
        return i == m->triangle_lines++;
    }
    if (is_word(m, "weight"))
        return sscanf(m->line, "weight %lu %lu", &i, &a) == 2 && strchr(m->line, '(') && close &&
               i == m->weight_lines++ && a < m->joints;
    return sscanf(m->line, "numverts %lu", &m->vertices) == 1 || sscanf(m->line, "numtris %lu", &m->triangles) == 1 ||
           sscanf(m->line, "numweights %lu", &m->weights) == 1 || m->line[0] == '/';
}

static int frame_line(md5 *m)
{
    for (const char *at = m->line; *at; m->values += *at != 0, at += strcspn(at, " \t\r"))
        at += strspn(at, " \t\r");
    return 1;
}

/* What a section states is there. */
static int end_section(md5 *m)
{
    if (m->in == MESH)
        return m->vertex_lines == m->vertices && m->triangle_lines == m->triangles && m->weight_lines == m->weights &&
               m->first_most <= m->weights && (m->triangles == 0 || m->vertex_most < m->vertices);
    return m->in != FRAME || m->values == 0 || m->values >= m->values_most;
}

static section section_of(const md5 *m)
{
    static const char *const words[] = {"", "joints", "mesh", "hierarchy", "baseframe", "frame"};
    int k = 1;
    while (k < OTHER && !is_word(m, words[k]))
        k++;
    return (section)k;
}

/* A line outside of sections, which may begin one. */
static int global_line(md5 *m)
{
    unsigned long count;
    if (sscanf(m->line, "num%*[A-Za-z] %lu", &count) == 1 && count > 1000000)
        return 0;
    if (is_word(m, "commandline") || !strchr(m->line, '{'))
        return m->line[0] != '}';
    m->in = section_of(m);
    m->vertex_lines = m->triangle_lines = m->weight_lines = 0;
    m->vertices = m->triangles = m->weights = m->first_most = m->vertex_most = m->values = 0;
    return 1;
}

static int section_line(md5 *m, size_t bytes)
{
    if (m->line[0] == '}') {
        int good = end_section(m);
        m->in = GLOBAL;
        return good;
    }
    if (m->line[0] == 0 || m->line[0] == '\r')
        return 1;
    switch (m->in) {
    case JOINTS:
        return joint_line(m);
    case MESH: /* a line has at least eight bytes */
        return mesh_line(m) && m->vertices < bytes / 8 && m->triangles < bytes / 8 && m->weights < bytes / 8;
    case HIERARCHY:
        return hierarchy_line(m);
    case BASEFRAME:
        m->base_frames++;
        return are_vectors(m->line);
    case FRAME:
        return frame_line(m);
    default:
        return 1;
    }
}

size_t nkwi_assimp_md5_fault(const void *data, size_t bytes)
{
    md5 m;
    int good = 1, more = 1;
    memset(&m, 0, sizeof m);
    m.at = (const char *)data;
    m.end = m.at + bytes;
    while (good && (more = next_line(&m)) == 1)
        good = m.in == GLOBAL ? global_line(&m) : section_line(&m, bytes);
    if (good && more == 0 && m.in == GLOBAL && (m.base_frames == 0 || m.base_frames == m.joints))
        return 0;
    return m.number + (more != 1);
}
