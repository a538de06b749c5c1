/* SPDX-License-Identifier: MIT */
/*
 * Runs the shaders of docs/examples/shaders by OpenGL, without a window, and compares their vertices with those of
 * nkw_skin_linear and, for normals, of nkw_mat3_normal of each vertex's blended matrix.
 *     run_shader FOLDER        exit codes 0; 1 differs; 77 no OpenGL 4.5
 */
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/nakawari.h>

#include "random.h"

enum { VERTICES = 1000, JOINTS = 24, FRAMES = 3, FLOATS = 14 };

/* Of lengths: positions within 4 m, unit directions. */
#define BOUND 1e-6

typedef struct skeletal_vertex {
    nkw_vec3 position;
    float texcoord[2];
    nkw_vec3 normal;
    uint16_t joints[4], weights[4];
} skeletal_vertex;

typedef struct model {
    skeletal_vertex vertices[VERTICES];
    float source[VERTICES][FLOATS], weights[VERTICES][8];
    nkw_mat4 palette[FRAMES][JOINTS], transform;
} model;

/* What the library computes: positions over the sum of the weights, directions of length 1. */
typedef struct expected {
    float vertex[VERTICES][FLOATS];
} expected;

/* ---- the model ---- */

static nkw_mat4 random_matrix(random_source *r)
{
    nkw_trs trs = nkw_trs_identity();
    trs.translation = random_vec3(r, -1.0f, 1.0f);
    nkw_quat turn = nkw_quat_slerp(nkw_quat_identity(), random_rotation(r), 0.4f);
    trs.rotation = turn;
    trs.scale = random_vec3(r, 0.5f, 2.0f);
    return nkw_mat4_from_trs(&trs);
}

static void make_vertex(random_source *r, model *m, size_t i)
{
    skeletal_vertex *v = &m->vertices[i];
    float *s = m->source[i];
    v->position = random_vec3(r, -1.0f, 1.0f);
    v->normal = random_direction(r);
    v->texcoord[0] = random_unit(r);
    v->texcoord[1] = random_unit(r);
    nkw_vec3 tangent = random_direction(r), bitangent = nkw_vec3_cross(v->normal, tangent);
    memcpy(s, &v->position, sizeof v->position);
    memcpy(s + 3, &v->normal, sizeof v->normal);
    memcpy(s + 6, &tangent, sizeof tangent);
    memcpy(s + 9, &bitangent, sizeof bitangent);
    memcpy(s + 12, v->texcoord, sizeof v->texcoord);
    float weights[4];
    for (int k = 0; k < 4; k++) {
        v->joints[k] = (uint16_t)(random_bits(r) % JOINTS);
        weights[k] = random_unit(r);
        m->weights[i][k] = weights[k]; /* of any sum: the compute shader divides by it */
        m->weights[i][4 + k] = (float)v->joints[k];
    }
    nkw_skin_normalize_weights((nkw_skin_view){weights, 0, NKW_SKIN_F32}, 4, 1,
                               (nkw_skin_span){v->weights, 0, NKW_SKIN_U16});
}

static void make_model(model *m)
{
    random_source r = random_from(35);
    for (size_t i = 0; i < VERTICES; i++)
        make_vertex(&r, m, i);
    for (size_t f = 0; f < FRAMES; f++)
        for (size_t j = 0; j < JOINTS; j++)
            m->palette[f][j] = random_matrix(&r);
    m->transform = random_matrix(&r);
}

/* ---- the library ---- */

static float blend_of(const model *m, size_t i, int lesson, const nkw_mat4 *palette, nkw_mat4 *blend)
{
    double sum = 0.0, e[16] = {0.0};
    for (int k = 0; k < 4; k++) {
        double w = lesson ? m->vertices[i].weights[k] / 65535.0 : (double)m->weights[i][k];
        sum += w;
        for (int n = 0; n < 16; n++)
            e[n] += w * (double)palette[m->vertices[i].joints[k]].m[n];
    }
    for (int n = 0; n < 16; n++)
        blend->m[n] = (float)e[n];
    return (float)sum;
}

/* Where a vertex goes, in the vertex's order of 14 floats. */
static void expect_vertex(const model *m, size_t i, int lesson, const nkw_mat4 *palette, float out[FLOATS])
{
    nkw_mat4 blend;
    float sum = blend_of(m, i, lesson, palette, &blend);
    nkw_vec3 v[4];
    memcpy(v, m->source[i], sizeof v);
    if (lesson) {
        blend.m[15] = 1.0f;
        blend = nkw_mat4_mul_affine(&m->transform, &blend);
    }
    nkw_mat3 block = nkw_mat3_from_mat4(&blend), normal = nkw_mat3_normal(&block);
    v[0] = nkw_vec3_scale(nkw_mat4_transform_point(&blend, v[0]), lesson ? 1.0f : 1.0f / sum);
    v[1] = nkw_vec3_normalize(nkw_mat3_transform(&normal, v[1]));
    for (int k = 2; k < 4; k++)
        v[k] = nkw_vec3_normalize(nkw_mat3_transform(&block, v[k]));
    memcpy(out, v, sizeof v);
    memcpy(out + 12, m->source[i] + 12, 2 * sizeof(float));
}

/* The largest difference of `count` floats of each vertex from `first` on. */
static double farthest(const float *got, size_t stride, const expected *want, size_t first, size_t count)
{
    double most = 0.0;
    for (size_t i = 0; i < VERTICES; i++)
        for (size_t k = 0; k < count; k++) {
            double d = fabs((double)got[i * stride + k] - (double)want->vertex[i][first + k]);
            most = d > most || isnan(d) ? d : most;
        }
    return most;
}

static int report(const char *what, double difference)
{
    int ok = difference <= BOUND;
    printf("%s: %.2g%s\n", what, difference, ok ? "" : ", too far");
    return ok;
}

/* ---- OpenGL ---- */

static int open_gl(void)
{
    static const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API))
        return 0;
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

static char *read_text(const char *folder, const char *name)
{
    char path[1024], *text = NULL;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    if (!file || fseek(file, 0, SEEK_END)) {
        perror(path);
        exit(1);
    }
    long size = ftell(file);
    rewind(file);
    text = calloc((size_t)size + 1, 1);
    if (!text || fread(text, 1, (size_t)size, file) != (size_t)size)
        exit(1);
    fclose(file);
    return text;
}

static GLuint program_of(const char *folder, const char *name, GLenum stage)
{
    char log[4096] = "", *text = read_text(folder, name);
    GLuint shader = glCreateShader(stage), program = glCreateProgram();
    GLint ok = 0;
    glShaderSource(shader, 1, (const GLchar *const *)&text, NULL);
    free(text);
    glCompileShader(shader);
    glAttachShader(program, shader);
    if (stage == GL_VERTEX_SHADER) {
        static const char *const outputs[] = {"position_out", "texcoord_out", "normal_out"};
        glTransformFeedbackVaryings(program, 3, outputs, GL_INTERLEAVED_ATTRIBS);
    }
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (!ok) {
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        fprintf(stderr, "%s: %s\n", name, log);
        exit(1);
    }
    glUseProgram(program);
    return program;
}

static GLuint buffer_of(GLenum target, GLuint binding, const void *data, size_t bytes)
{
    GLuint buffer;
    glGenBuffers(1, &buffer);
    glBindBufferBase(target, binding, buffer);
    glBufferData(target, (GLsizeiptr)bytes, data, GL_STATIC_READ);
    return buffer;
}

/* Drawing needs a framebuffer, of any size, also where nothing is rasterised. */
static void set_framebuffer(void)
{
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
    glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
}

/* ---- the lesson's vertices ---- */

static void set_attributes(const model *m)
{
    const GLsizei stride = sizeof(skeletal_vertex);
    GLuint vertices, array;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &vertices);
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    glBufferData(GL_ARRAY_BUFFER, sizeof m->vertices, m->vertices, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 5; i++)
        glEnableVertexAttribArray(i);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, (void *)offsetof(skeletal_vertex, position));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, (void *)offsetof(skeletal_vertex, texcoord));
    glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, stride, (void *)offsetof(skeletal_vertex, normal));
    glVertexAttribIPointer(3, 4, GL_UNSIGNED_SHORT, stride, (void *)offsetof(skeletal_vertex, joints));
    glVertexAttribPointer(4, 4, GL_UNSIGNED_SHORT, GL_TRUE, stride, (void *)offsetof(skeletal_vertex, weights));
}

static int run_vertex_shader(const char *folder, const model *m)
{
    static float got[VERTICES][8];
    static expected want;
    const nkw_mat4 object[2] = {m->transform, nkw_mat4_identity()};
    program_of(folder, "skin_vertex.glsl", GL_VERTEX_SHADER);
    set_framebuffer();
    set_attributes(m);
    buffer_of(GL_SHADER_STORAGE_BUFFER, 0, m->palette[1], sizeof m->palette[1]);
    buffer_of(GL_UNIFORM_BUFFER, 0, object, sizeof object);
    buffer_of(GL_TRANSFORM_FEEDBACK_BUFFER, 0, NULL, sizeof got);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, VERTICES);
    glEndTransformFeedback();
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof got, got);
    for (size_t i = 0; i < VERTICES; i++)
        expect_vertex(m, i, 1, m->palette[1], want.vertex[i]);
    int ok = report("skin_vertex.glsl, positions", farthest(got[0], 8, &want, 0, 3));
    ok &= report("skin_vertex.glsl, texture coordinates", farthest(got[0] + 3, 8, &want, 12, 2));
    return ok & report("skin_vertex.glsl, normals", farthest(got[0] + 5, 8, &want, 3, 3));
}

/* ---- the book's buffers: frame 2 of a palette of all frames, the mesh behind others ---- */

static int run_compute_shader(const char *folder, const model *m)
{
    enum { BEFORE = 5 }; /* vertices of other meshes */
    static float source[BEFORE + VERTICES][FLOATS], weights[BEFORE + VERTICES][8], got[VERTICES][FLOATS];
    static expected want;
    const GLuint draw[8] = {BEFORE * FLOATS, VERTICES, BEFORE * 8, 2 * JOINTS, 0};
    memcpy(source[BEFORE], m->source, sizeof m->source);
    memcpy(weights[BEFORE], m->weights, sizeof m->weights);
    program_of(folder, "skin_compute.glsl", GL_COMPUTE_SHADER);
    buffer_of(GL_SHADER_STORAGE_BUFFER, 0, source, sizeof source);
    buffer_of(GL_SHADER_STORAGE_BUFFER, 1, weights, sizeof weights);
    buffer_of(GL_SHADER_STORAGE_BUFFER, 2, m->palette, sizeof m->palette);
    buffer_of(GL_UNIFORM_BUFFER, 0, draw, sizeof draw);
    GLuint destination = buffer_of(GL_SHADER_STORAGE_BUFFER, 3, NULL, sizeof got);
    glDispatchCompute((VERTICES + 63) / 64, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, destination);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof got, got);
    for (size_t i = 0; i < VERTICES; i++)
        expect_vertex(m, i, 0, m->palette[2], want.vertex[i]);
    int ok = report("skin_compute.glsl, positions", farthest(got[0], FLOATS, &want, 0, 3));
    ok &= report("skin_compute.glsl, normals", farthest(got[0] + 3, FLOATS, &want, 3, 3));
    ok &= report("skin_compute.glsl, tangents and bitangents", farthest(got[0] + 6, FLOATS, &want, 6, 6));
    return ok & report("skin_compute.glsl, texture coordinates", farthest(got[0] + 12, FLOATS, &want, 12, 2));
}

int main(int count, char **arguments)
{
    static model m;
    if (count != 2)
        return fprintf(stderr, "usage: run_shader FOLDER\n"), 2;
    if (!open_gl()) {
        printf("skipped: no OpenGL 4.5 without a window\n");
        return 77;
    }
    printf("%s, %s\n", (const char *)glGetString(GL_VERSION), (const char *)glGetString(GL_RENDERER));
    make_model(&m);
    int ok = run_vertex_shader(arguments[1], &m);
    ok &= run_compute_shader(arguments[1], &m);
    return glGetError() != GL_NO_ERROR || !ok;
}
