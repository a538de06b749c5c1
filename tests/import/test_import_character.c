/* SPDX-License-Identifier: MIT */
/*
 * The character of a document: its numbers are those of the document, its clips, matrices and vertices those of the
 * functions that take a document. The foreign files are not in the repository: without NKW_DATA_DIR they are skipped.
 */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* glob */
#endif
#include <math.h>
#include <stdlib.h>

#include <nakawari/import.h>

#include "support/expect.h"
#include "support/samples.h"
#include "support/views.h"

/* A document, its character, and the memory of a frame. */
typedef struct player {
    nkw_document *document;
    void *block;
    nkw_character c;
    float *pose, *floats;
    nkw_mat4 *models, *palette;
    nkw_vec3 *positions[2], *normals[2];
} player;

static void *room(size_t count, size_t size)
{
    void *memory = calloc(count + 1, size);
    assert_non_null(memory);
    return memory;
}

static void open_player(player *p, const char *path)
{
    nkw_import_error error;
    size_t bytes = 0, again = 0;
    memset(p, 0, sizeof *p);
    assert_int_equal(nkw_document_open(path, &p->document, &error), NKW_IMPORT_OK);
    assert_int_equal(nkw_document_character(p->document, NKW_CLIP_FLOAT32, bytes_span(NULL, 0), &bytes, NULL, &error),
                     NKW_IMPORT_OK);
    p->block = room(bytes, 1);
    assert_int_equal(
        nkw_document_character(p->document, NKW_CLIP_FLOAT32, bytes_span(p->block, bytes), &again, &p->c, &error),
        NKW_IMPORT_OK);
    assert_int_equal(bytes, again);
    const size_t joints = p->c.skeleton.joint_count;
    p->pose = (float *)room(NKW_POSE_FLOATS(joints), sizeof(float));
    p->floats = (float *)room(p->c.set.float_count, sizeof(float));
    p->models = (nkw_mat4 *)room(joints, sizeof(nkw_mat4));
    p->palette = (nkw_mat4 *)room(p->c.palette.joint_count, sizeof(nkw_mat4));
    for (int k = 0; k < 2; k++) {
        p->positions[k] = (nkw_vec3 *)room(p->c.most_vertices, sizeof(nkw_vec3));
        p->normals[k] = (nkw_vec3 *)room(p->c.most_vertices, sizeof(nkw_vec3));
    }
}

static void close_player(player *p)
{
    for (int k = 0; k < 2; k++)
        free(p->positions[k]), free(p->normals[k]);
    free(p->pose), free(p->floats), free(p->models), free(p->palette), free(p->block);
    nkw_document_close(p->document);
}

static void expect_numbers_of_the_document(const player *p)
{
    const nkw_document *d = p->document;
    assert_int_equal(p->c.skeleton.joint_count, d->skeleton.joint_count);
    assert_int_equal(p->c.set.clip_count, d->animation_count);
    assert_int_equal(p->c.set.float_count, d->float_count);
    for (size_t j = 0; j < d->skeleton.joint_count; j++) {
        assert_int_equal(p->c.joint_of_node[j], j);
        assert_int_equal(p->c.skeleton.parents[j], d->skeleton.parents[j]);
        assert_string_equal(p->c.names[j], d->nodes[j].name);
    }
    assert_int_equal(nkw_mixer_set_validate(&p->c.set, NULL), NKW_OK);
}

static int has_matrices(const nkw_document *d)
{
    int has = 0;
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        has |= d->nodes[j].matrix != NULL;
    return has;
}

/* Part `index` against nkw_document_vertices, which has another text for rigid parts and for normals. */
static void expect_vertices(const player *p, size_t index, size_t primitive, double size)
{
    const nkw_character_part *part = &p->c.parts[index];
    const nkw_document_moment moment = {p->models, p->floats, p->palette + part->matrix_first};
    const nkw_document_vertices_span want = {p->positions[0], p->normals[0]};
    nkw_vertices_span got;
    memset(&got, 0, sizeof got);
    got.positions.data = p->positions[1];
    got.normals.data = p->normals[1];
    assert_int_equal(nkw_document_vertices(p->document, (size_t)part->joint, primitive, &moment, want), NKW_OK);
    assert_int_equal(nkw_character_vertices(&p->c, index, p->floats, p->palette, got), NKW_OK);
    for (size_t v = 0; v < part->skin.vertex_count; v++)
        expect_vec3_near(p->positions[1][v], p->positions[0][v], 2e-6 * size);
    /* Normals of joints of different scales differ: a blend of inverse transposes, or the inverse transpose of a blend. */
    for (size_t v = 0; part->vertices.normals.data && part->skin_index < 0 && v < part->skin.vertex_count; v++)
        expect_vec3_near(p->normals[1][v], p->normals[0][v], 1e-5);
}

static double size_of(const player *p)
{
    double size = 1.0;
    for (size_t j = 0; j < p->c.skeleton.joint_count; j++)
        for (int k = 0; k < 16; k++)
            size = fmax(size, fabs((double)p->models[j].m[k]));
    for (size_t i = 0; i < p->c.part_count; i++) {
        const nkw_vec3 *positions = (const nkw_vec3 *)p->c.parts[i].vertices.positions.data;
        for (size_t v = 0; v < p->c.parts[i].skin.vertex_count; v++)
            size = fmax(size, (double)nkw_vec3_length(positions[v]));
    }
    return size;
}

static void expect_frame(player *p, size_t animation, float part_of_clip)
{
    const nkw_document *d = p->document;
    const nkw_clip *mine = p->c.set.clips[animation].clip;
    const nkw_clip_description about = nkw_clip_describe(mine);
    const nkw_pose_span pose = pose_span(p->pose, p->c.skeleton.joint_count);
    assert_string_equal(about.name, d->animations[animation].name);
    assert_int_equal(nkw_clip_sample(mine, nkw_lerp(about.start, about.end, part_of_clip), NULL, pose, p->floats),
                     NKW_OK);
    assert_int_equal(nkw_character_palette(&p->c, NKW_VIEW(nkw_pose, pose), NULL, p->models, p->palette), NKW_OK);
    if (has_matrices(d))
        return; /* the document keeps their shear */
    const double size = size_of(p);
    size_t index = 0;
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        for (size_t k = 0; d->nodes[j].mesh != NKW_NO_JOINT && k < d->meshes[d->nodes[j].mesh].primitive_count; k++) {
            assert_int_equal(p->c.parts[index].joint, j);
            expect_vertices(p, index++, k, size);
        }
    assert_int_equal(index, p->c.part_count);
}

/* Both clips sample alike: the fingerprints of their poses. */
static void expect_clip_of_the_document(player *p, size_t animation)
{
    nkw_clip *theirs;
    const nkw_pose_span pose = pose_span(p->pose, p->c.skeleton.joint_count);
    assert_int_equal(nkw_document_clip(p->document, animation, NKW_CLIP_FLOAT32, &theirs, NULL), NKW_IMPORT_OK);
    const nkw_clip_description about = nkw_clip_describe(theirs);
    for (int i = 0; i <= 8; i++) {
        uint64_t prints[2];
        const float time = nkw_lerp(about.start, about.end, (float)i / 8.0f);
        for (int k = 0; k < 2; k++) {
            nkw_clip_sample(k ? theirs : p->c.set.clips[animation].clip, time, NULL, pose, p->floats);
            prints[k] = nkw_pose_fingerprint(NKW_VIEW(nkw_pose, pose), 0);
            prints[k] = nkw_fingerprint_floats(p->floats, about.float_count, prints[k]);
        }
        assert_true(prints[0] == prints[1]);
    }
    nkw_import_free(theirs);
}

static void expect_file(const char *path)
{
    player p;
    open_player(&p, path);
    expect_numbers_of_the_document(&p);
    for (size_t i = 0; i < p.document->animation_count; i++) {
        expect_clip_of_the_document(&p, i);
        expect_frame(&p, i, 0.0f);
        expect_frame(&p, i, 0.375f);
    }
    close_player(&p);
}

static void the_example_has_the_numbers_of_its_document(void **state)
{
    (void)state;
    expect_file(NKW_CHARACTER);
}

static void real_files_have_the_numbers_of_their_documents(void **state)
{
    (void)state;
    each_sample(expect_file);
}

static void a_document_that_is_refused_names_the_place(void **state)
{
    (void)state;
    static const char text[] = "name,time,tx,ty,tz\na,1,1,0,0\na,0,2,0,0\n";
    const nkw_import_memory memory = {text, sizeof text - 1, "keys.csv", NULL, NULL, NULL, 0, 0};
    nkw_document *document;
    nkw_import_error error;
    size_t bytes = 99;
    assert_int_equal(nkw_document_from_memory(&memory, &document, &error), NKW_IMPORT_OK);
    assert_int_equal(nkw_document_character(document, NKW_CLIP_FLOAT32, bytes_span(NULL, 0), &bytes, NULL, &error),
                     NKW_IMPORT_REFUSED);
    assert_int_equal(error.result, NKW_NOT_ASCENDING);
    assert_string_equal(error.place, "/animations/0/channels/0");
    assert_int_equal(bytes, 0);
    nkw_document_close(document);
}

static void a_block_that_is_too_small_is_an_error(void **state)
{
    (void)state;
    nkw_document *document;
    nkw_import_error error;
    nkw_character c;
    double block[8];
    size_t bytes = 0;
    assert_int_equal(nkw_document_open(NKW_CHARACTER, &document, &error), NKW_IMPORT_OK);
    assert_int_equal(
        nkw_document_character(document, NKW_CLIP_FLOAT32, bytes_span(block, sizeof block), &bytes, &c, &error),
        NKW_IMPORT_REFUSED);
    assert_int_equal(error.result, NKW_TOO_SMALL);
    assert_true(bytes > sizeof block);
    nkw_document_close(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_example_has_the_numbers_of_its_document),
        cmocka_unit_test(real_files_have_the_numbers_of_their_documents),
        cmocka_unit_test(a_document_that_is_refused_names_the_place),
        cmocka_unit_test(a_block_that_is_too_small_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
