/* SPDX-License-Identifier: MIT */
/*
 * Runs the shaders of docs/examples/shaders by OpenGL, without a window, on frames of baked clips, and compares their
 * vertices with those of nkw_skin_linear.
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

enum { VERTICES = 1000, JOINTS = 24, FLOATS = 14, CLIPS = 2, KEYS = 5 };

/* Of lengths: positions within 4 m, unit directions. */
#define BOUND 1e-6

typedef struct skeletal_vertex {
    nkw_vec3 position;
    float texcoord[2];
    nkw_vec3 normal;
    uint16_t joints[4], weights[4];
} skeletal_vertex;

/* 4 weights, 4 joints of each vertex: floats, as the compute shader reads them. */
typedef struct influence_floats {
    float weights[4], joints[4];
} influence_floats;

typedef struct model {
    skeletal_vertex vertices[VERTICES];
    float source[VERTICES][FLOATS];
    influence_floats influences[VERTICES];
    int32_t parents[JOINTS];
    nkw_trs rest[JOINTS];
    nkw_palette_chunk clips[CLIPS]; /* where the frames of each clip are in `palettes` */
    nkw_mat4 *palettes; /* all frames of all clips; owned */
    size_t matrix_count;
    nkw_mat4 transform;
} model;

/* What the library computes of the vertices. */
typedef struct expected {
    float vertex[VERTICES][FLOATS];
} expected;

static void *allocate(size_t bytes)
{
    void *p = calloc(1, bytes);
    if (!p)
        exit(1);
    return p;
}

static void require(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "run_shader: %s\n", what);
        exit(1);
    }
}

/* ---- the model ---- */

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
    influence_floats *f = &m->influences[i];
    for (int k = 0; k < 4; k++) {
        v->joints[k] = (uint16_t)(random_bits(r) % JOINTS);
        f->weights[k] = random_unit(r); /* of any sum: the compute shader divides by it */
        f->joints[k] = (float)v->joints[k];
    }
    nkw_skin_normalize_weights((nkw_skin_view){f->weights, 0, NKW_SKIN_F32}, 4, 1,
                               (nkw_skin_span){v->weights, 0, NKW_SKIN_U16});
}

/* A tree of joints with uneven scales, so that joint matrices have shear. */
static void make_joints(random_source *r, model *m)
{
    for (int32_t j = 0; j < JOINTS; j++) {
        m->parents[j] = (j + 1) / 2 - 1;
        m->rest[j].translation = random_vec3(r, -0.3f, 0.3f);
        m->rest[j].rotation = random_near(r, nkw_quat_identity(), 0.2f);
        m->rest[j].scale = random_vec3(r, 0.8f, 1.2f);
    }
}

/* Rotations of every joint at 0 s, 0.5 s, ... 2 s, about 0.3 rad from the rest. */
static nkw_clip *make_clip(random_source *r, const model *m)
{
    static float times[KEYS], rest[NKW_POSE_FLOATS(JOINTS)], values[JOINTS][KEYS][4];
    static nkw_clip_track tracks[JOINTS];
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(JOINTS));
    size_t bytes;
    for (int k = 0; k < KEYS; k++)
        times[k] = 0.5f * (float)k;
    for (uint32_t j = 0; j < JOINTS; j++) {
        for (int k = 0; k < KEYS; k++) {
            const nkw_quat q = random_near(r, m->rest[j].rotation, 0.15f);
            memcpy(values[j][k], &q, sizeof q);
        }
        tracks[j].target = NKW_CLIP_ROTATION;
        tracks[j].index = j;
        tracks[j].track = (nkw_track){times, values[j][0], KEYS, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL};
    }
    nkw_pose_from_trs(m->rest, (nkw_pose_span){rest, JOINTS});
    nkw_clip_source source = {tracks, JOINTS, JOINTS, 0, {rest, JOINTS}, NULL, NKW_CLIP_FLOAT32, NULL};
    require(nkw_clip_build(&source, (nkw_bytes_span){NULL, 0}, &bytes, NULL, work) == NKW_TOO_SMALL, "size of a clip");
    nkw_clip *clip = allocate(bytes);
    require(nkw_clip_build(&source, (nkw_bytes_span){clip, bytes}, &bytes, NULL, work) == NKW_OK, "clip");
    return clip;
}

/* The frames of all clips in one buffer, at 30 and at 25 frames per second. */
static void bake(random_source *r, model *m)
{
    static const float rates[CLIPS] = {30.0f, 25.0f};
    nkw_mat4 models[JOINTS], inverse_bind[JOINTS];
    float pose[NKW_POSE_FLOATS(JOINTS)];
    const nkw_skeleton skeleton = {m->parents, JOINTS};
    const nkw_palette_source bind = {models, JOINTS, NULL, NULL, NULL, JOINTS};
    const size_t bytes = NKW_CROWD_BAKE_WORK(JOINTS, JOINTS);
    const nkw_work work = {allocate(bytes), bytes};
    nkw_pose_from_trs(m->rest, (nkw_pose_span){pose, JOINTS});
    nkw_skeleton_models_from_pose(&skeleton, (nkw_pose_view){pose, JOINTS}, NULL, NULL, models);
    nkw_palette_inverse_bind(&bind, inverse_bind);
    for (size_t c = 0; c < CLIPS; c++)
        m->clips[c] = (nkw_palette_chunk){(size_t)(2.0f * rates[c]) + 1, JOINTS, 0};
    require(nkw_palette_chunks_place(m->clips, CLIPS, 4, &m->matrix_count, NULL) == NKW_OK, "chunks");
    m->palettes = allocate(m->matrix_count * sizeof *m->palettes);
    for (size_t c = 0; c < CLIPS; c++) {
        nkw_clip *clip = make_clip(r, m);
        const nkw_crowd_source source = {clip, &skeleton, NULL, NULL, inverse_bind, JOINTS, 0.0f, rates[c]};
        require(nkw_crowd_bake(&source, &m->clips[c], NULL, m->palettes, NULL, work) == NKW_OK, "bake");
        free(clip);
    }
    free(work.data);
}

static void make_model(model *m)
{
    random_source r = random_from(35);
    for (size_t i = 0; i < VERTICES; i++)
        make_vertex(&r, m, i);
    make_joints(&r, m);
    bake(&r, m);
    nkw_trs mirror = {random_vec3(&r, -1.0f, 1.0f), random_rotation(&r), {-0.8f, 1.0f, 1.25f}};
    m->transform = nkw_mat4_from_trs(&mirror);
}

static size_t frame_at(const model *m, size_t clip, size_t frame)
{
    return m->clips[clip].first + frame * m->clips[clip].joint_count;
}

/* ---- the library ---- */

/* The vertices by the matrices of a frame, in the order of 14 floats. */
static void expect_vertices(const model *m, const nkw_skin *skin, const nkw_mat4 *frame, int divide, expected *out)
{
    const size_t s = sizeof m->source[0];
    const float *v = m->source[0];
    float *to = out->vertex[0];
    const nkw_skin_palette palette = {
        {frame, JOINTS, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, {0, 1, divide}};
    const nkw_vertices_view in = {{v, s}, {v + 3, s}, {v + 6, s}, {v + 9, s}};
    const nkw_vertices_span span = {{to, s}, {to + 3, s}, {to + 6, s}, {to + 9, s}};
    memcpy(out->vertex, m->source, sizeof m->source);
    require(nkw_skin_linear(skin, &palette, in, span) == NKW_OK, "skin");
}

/* The larger one, or NaN. */
static double larger(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

/* The largest difference of `count` floats of each vertex from `first` on. */
static double farthest(const float *got, size_t stride, const expected *want, size_t first, size_t count)
{
    double most = 0.0;
    for (size_t i = 0; i < VERTICES; i++)
        for (size_t k = 0; k < count; k++) {
            double d = fabs((double)got[i * stride + k] - (double)want->vertex[i][first + k]);
            most = larger(most, d);
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
    const nkw_mat4 object[2] = {m->transform, nkw_mat4_identity()}, *frame = m->palettes + frame_at(m, 1, 17);
    const nkw_skin skin = {VERTICES,
                           4,
                           {m->vertices[0].joints, sizeof m->vertices[0], NKW_SKIN_U16},
                           {m->vertices[0].weights, sizeof m->vertices[0], NKW_SKIN_U16}};
    nkw_mat4 moved[JOINTS];
    program_of(folder, "skin_vertex.glsl", GL_VERTEX_SHADER);
    set_framebuffer();
    set_attributes(m);
    buffer_of(GL_SHADER_STORAGE_BUFFER, 0, frame, JOINTS * sizeof *frame);
    buffer_of(GL_UNIFORM_BUFFER, 0, object, sizeof object);
    buffer_of(GL_TRANSFORM_FEEDBACK_BUFFER, 0, NULL, sizeof got);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, VERTICES);
    glEndTransformFeedback();
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof got, got);
    for (size_t j = 0; j < JOINTS; j++)
        moved[j] = nkw_mat4_mul_affine(&m->transform, &frame[j]);
    expect_vertices(m, &skin, moved, 0, &want);
    int ok = report("skin_vertex.glsl, positions", farthest(got[0], 8, &want, 0, 3));
    ok &= report("skin_vertex.glsl, texture coordinates", farthest(got[0] + 3, 8, &want, 12, 2));
    return ok & report("skin_vertex.glsl, normals", farthest(got[0] + 5, 8, &want, 3, 3));
}

/* ---- the book's buffers: frames of the palettes of all clips, the mesh behind others ---- */

enum { BEFORE = 5, DRAWS = 6 }; /* vertices of other meshes; characters */

/* Every character has the mesh, and a range of the destination of its own. */
static void draw_characters(const size_t *first_matrix)
{
    GLuint draw[8] = {BEFORE * FLOATS, VERTICES, BEFORE * 8, 0, 0};
    for (size_t i = 0; i < DRAWS; i++) {
        draw[3] = (GLuint)first_matrix[i];
        draw[4] = (GLuint)(i * VERTICES * FLOATS);
        buffer_of(GL_UNIFORM_BUFFER, 0, draw, sizeof draw);
        glDispatchCompute((VERTICES + 63) / 64, 1, 1);
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
}

static int run_compute_shader(const char *folder, const model *m)
{
    static float source[BEFORE + VERTICES][FLOATS], got[DRAWS][VERTICES][FLOATS];
    static influence_floats influences[BEFORE + VERTICES];
    static expected want;
    const size_t first_matrix[DRAWS] = {frame_at(m, 0, 0), frame_at(m, 0, 1),  frame_at(m, 0, 60),
                                        frame_at(m, 1, 0), frame_at(m, 1, 23), frame_at(m, 1, 50)};
    const nkw_skin skin = {VERTICES,
                           4,
                           {m->influences[0].joints, sizeof *influences, NKW_SKIN_F32},
                           {m->influences[0].weights, sizeof *influences, NKW_SKIN_F32}};
    double most[4] = {0.0};
    memcpy(source[BEFORE], m->source, sizeof m->source);
    memcpy(&influences[BEFORE], m->influences, sizeof m->influences);
    program_of(folder, "skin_compute.glsl", GL_COMPUTE_SHADER);
    buffer_of(GL_SHADER_STORAGE_BUFFER, 0, source, sizeof source);
    buffer_of(GL_SHADER_STORAGE_BUFFER, 1, influences, sizeof influences);
    buffer_of(GL_SHADER_STORAGE_BUFFER, 2, m->palettes, m->matrix_count * sizeof *m->palettes);
    GLuint destination = buffer_of(GL_SHADER_STORAGE_BUFFER, 3, NULL, sizeof got);
    draw_characters(first_matrix);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, destination);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof got, got);
    for (size_t i = 0; i < DRAWS; i++) {
        expect_vertices(m, &skin, m->palettes + first_matrix[i], 1, &want);
        most[0] = larger(most[0], farthest(got[i][0], FLOATS, &want, 0, 3));
        most[1] = larger(most[1], farthest(got[i][0] + 3, FLOATS, &want, 3, 3));
        most[2] = larger(most[2], farthest(got[i][0] + 6, FLOATS, &want, 6, 6));
        most[3] = larger(most[3], farthest(got[i][0] + 12, FLOATS, &want, 12, 2));
    }
    int ok = report("skin_compute.glsl, positions", most[0]);
    ok &= report("skin_compute.glsl, normals", most[1]);
    ok &= report("skin_compute.glsl, tangents and bitangents", most[2]);
    return ok & report("skin_compute.glsl, texture coordinates", most[3]);
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
    free(m.palettes);
    return glGetError() != GL_NO_ERROR || !ok;
}
