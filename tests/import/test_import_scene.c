/* SPDX-License-Identifier: MIT */
/*
 * Real glTF files: the numbers read are those of their plain texts, bit for bit; sampled, they are those of independent
 * implementations (three.js, SciPy). The files are not in the repository: without the folder NKW_DATA_DIR every test is
 * skipped.
 */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* glob */
#endif
#include <glob.h>
#include <math.h>
#include <stdlib.h>

#include <nakawari/import.h>

#include "scene.h"
#include "support/expect.h"
#include "support/views.h"

/* The file of the folder gltf with this name, without its ending. */
static nkw_document *open_model(const char *name)
{
    static const char *const ends[] = {"gltf", "glb", "vrm"};
    nkw_document *document = NULL;
    nkw_import_error error;
    for (int i = 0; i < 3 && !document; i++) {
        char path[512];
        snprintf(path, sizeof path, "%s/gltf/%s.%s", NKW_DATA_DIR, name, ends[i]);
        nkw_import_result result = nkw_document_open(path, &document, &error);
        if (result != NKW_IMPORT_OK && result != NKW_IMPORT_UNREADABLE)
            print_error("%s:%s: %s\n", error.file, error.place, error.reason);
        assert_true(result == NKW_IMPORT_OK || result == NKW_IMPORT_UNREADABLE);
    }
    if (!document)
        print_error("%s:%s: %s\n", error.file, error.place, error.reason);
    assert_non_null(document);
    assert_int_equal(nkw_document_validate(document, &error), NKW_IMPORT_OK);
    return document;
}

/* ---- The plain texts, which have no sign of zeros ---- */

static void expect_numbers(const float *got, const float *want, size_t n)
{
    expect_floats_near(got, want, n, 0.0);
}

static void expect_nodes(const nkw_document *d, const scene *s)
{
    assert_int_equal(d->skeleton.joint_count, s->nodes);
    for (int i = 0; i < s->nodes; i++) {
        const scene_node *want = &s->node[i];
        const nkw_document_node *got = &d->nodes[d->joint_of_node[i]];
        assert_int_equal(d->joint_of_node[i], s->joint_of_node[i]);
        assert_int_equal(d->skeleton.parents[s->joint_of_node[i]], s->parents[s->joint_of_node[i]]);
        assert_int_equal(got->number, i);
        if (want->is_matrix)
            expect_numbers(got->matrix->m, want->matrix.m, 16);
        else
            expect_numbers(&got->rest.translation.x, &want->rest.translation.x, 10);
    }
}

static void expect_channel(const nkw_document *d, const scene_channel *want, size_t k)
{
    const nkw_document_animation *a = &d->animations[want->anim];
    assert_in_range(k, 0, a->track_count - 1);
    const nkw_track *got = &a->tracks[k].track, *track = &want->track.track;
    assert_int_equal(a->tracks[k].target, want->track.target);
    if (want->track.target != NKW_CLIP_FLOATS)
        assert_int_equal(a->tracks[k].index, d->joint_of_node[want->track.index]);
    assert_int_equal(got->count, track->count);
    assert_int_equal(got->width, track->width);
    assert_int_equal(got->interpolation, track->interpolation);
    expect_numbers(got->times, track->times, track->count);
    expect_numbers(got->values, track->values, nkw_track_value_count(track));
}

static void expect_skin(const nkw_document *d, const scene *s, int k)
{
    const scene_skin *want = &s->skin[k];
    assert_int_equal(d->skins[k].joint_count, want->count);
    for (size_t j = 0; j < want->count; j++) {
        assert_int_equal(d->skins[k].joints[j], want->joints[j]);
        if (d->skins[k].inverse_bind)
            expect_numbers(d->skins[k].inverse_bind[j].m, want->inverse_bind[j].m, 16);
    }
}

/* The text lists the influences whose weight is not 0. */
static void expect_vertices(const nkw_document *d, const scene_mesh *want)
{
    const nkw_document_node *node = &d->nodes[d->joint_of_node[want->node]];
    const nkw_document_primitive *p = &d->meshes[node->mesh].primitives[0];
    for (size_t v = 0; v < want->count; v++) {
        size_t index = (size_t)want->index[v], used = 0;
        expect_numbers(&p->positions[index].x, &want->positions[v].x, 3);
        for (size_t i = 0; i < p->influence_count; i++)
            if (p->weights[index * p->influence_count + i] != 0.0f) {
                assert_int_equal(p->joints[index * p->influence_count + i], want->joints[v][used]);
                expect_near(p->weights[index * p->influence_count + i], want->weights[v][used], 0.0);
                used++;
            }
    }
}

static void files_have_the_numbers_of_their_texts(void **state)
{
    (void)state;
    static scene s;
    glob_t found;
    assert_int_equal(glob(NKW_DATA_DIR "/scenes/*.scene.txt", 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        char name[64];
        assert_int_equal(sscanf(found.gl_pathv[i] + strlen(NKW_DATA_DIR "/scenes/"), "%63[^.]", name), 1);
        scene_read(found.gl_pathv[i], &s);
        nkw_document *d = open_model(name);
        expect_nodes(d, &s);
        assert_int_equal(d->animation_count, s.anims);
        assert_int_equal(d->float_count, s.floats);
        for (int c = 0, k = 0; c < s.channels; c++) {
            k = c > 0 && s.channel[c].anim == s.channel[c - 1].anim ? k + 1 : 0;
            expect_channel(d, &s.channel[c], (size_t)k);
        }
        assert_int_equal(d->skin_count, s.skins);
        for (int k = 0; k < s.skins; k++)
            expect_skin(d, &s, k);
        for (int k = 0; k < s.meshes; k++)
            expect_vertices(d, &s.mesh[k]);
        nkw_document_close(d);
        scene_free(&s);
    }
    assert_true(found.gl_pathc > 0);
    globfree(&found);
}

/* ---- The tables ---- */

/* A document at a time of an animation. */
typedef struct moment {
    const nkw_document *document;
    nkw_clip **clips; /* of all animations, then of none */
    float *pose, *floats;
    nkw_mat4 *models, **palettes;
    nkw_vec3 **vertices; /* of the first primitive of each joint's mesh */
} moment;

static void *take(size_t count, size_t size)
{
    void *block = calloc(count + 1, size);
    assert_non_null(block);
    return block;
}

/* normalized: rotation keys are normalised before use. */
static nkw_clip *clip_of(const nkw_document *d, size_t animation, int normalized)
{
    nkw_clip_source source = nkw_document_clip_source(d, animation, NKW_CLIP_FLOAT32);
    nkw_clip_track *tracks = (nkw_clip_track *)take(source.track_count, sizeof *tracks);
    const size_t work_bytes = NKW_CLIP_BUILD_WORK(source.track_count);
    const nkw_work work = {take(work_bytes, 1), work_bytes};
    size_t bytes, bad;
    if (source.track_count > 0)
        memcpy(tracks, source.tracks, source.track_count * sizeof *tracks);
    for (size_t i = 0; i < source.track_count; i++)
        if (normalized && tracks[i].target == NKW_CLIP_ROTATION)
            tracks[i].track.kind = NKW_TRACK_ROTATION_NORMALIZED;
    source.tracks = tracks;
    assert_int_equal(nkw_clip_build(&source, bytes_span(NULL, 0), &bytes, &bad, work), NKW_TOO_SMALL);
    nkw_clip *clip = (nkw_clip *)take(bytes, 1);
    assert_int_equal(nkw_clip_build(&source, bytes_span(clip, bytes), &bytes, &bad, work), NKW_OK);
    free(work.data);
    free(tracks);
    return clip;
}

static moment begin(const nkw_document *d, int normalized)
{
    size_t joints = d->skeleton.joint_count;
    moment m = {d, NULL, NULL, NULL, NULL, NULL, NULL};
    m.clips = (nkw_clip **)take(d->animation_count + 1, sizeof *m.clips);
    m.pose = (float *)take(nkw_pose_floats(joints), sizeof *m.pose);
    m.floats = (float *)take(d->float_count, sizeof *m.floats);
    m.models = (nkw_mat4 *)take(joints, sizeof *m.models);
    m.palettes = (nkw_mat4 **)take(d->skin_count, sizeof *m.palettes);
    m.vertices = (nkw_vec3 **)take(joints, sizeof *m.vertices);
    for (size_t i = 0; i <= d->animation_count; i++) {
        nkw_import_error error;
        m.clips[i] = clip_of(d, i, normalized);
        if (!normalized) {
            nkw_clip *same = NULL;
            assert_int_equal(nkw_document_clip(d, i, NKW_CLIP_FLOAT32, &same, &error), NKW_IMPORT_OK);
            assert_int_equal(nkw_clip_describe(same).bytes, nkw_clip_describe(m.clips[i]).bytes);
            assert_memory_equal(same, m.clips[i], nkw_clip_describe(same).bytes);
            nkw_import_free(same);
        }
    }
    for (size_t k = 0; k < d->skin_count; k++)
        m.palettes[k] = (nkw_mat4 *)take(d->skins[k].joint_count, sizeof **m.palettes);
    for (size_t j = 0; j < joints; j++)
        if (d->nodes[j].mesh != NKW_NO_JOINT)
            m.vertices[j] =
                (nkw_vec3 *)take(d->meshes[d->nodes[j].mesh].primitives[0].vertex_count, sizeof **m.vertices);
    return m;
}

static void end(moment *m)
{
    for (size_t i = 0; i <= m->document->animation_count; i++)
        free(m->clips[i]);
    for (size_t k = 0; k < m->document->skin_count; k++)
        free(m->palettes[k]);
    for (size_t j = 0; j < m->document->skeleton.joint_count; j++)
        free(m->vertices[j]);
    free(m->clips);
    free(m->pose);
    free(m->floats);
    free(m->models);
    free(m->palettes);
    free(m->vertices);
}

/* From keys to skinned vertices, as a user does. */
static void play_to(moment *m, int animation, float time)
{
    const nkw_document *d = m->document;
    size_t joints = d->skeleton.joint_count;
    const nkw_clip *clip = m->clips[animation < 0 ? d->animation_count : (size_t)animation];
    assert_int_equal(nkw_clip_sample(clip, time, NULL, pose_span(m->pose, joints), m->floats), NKW_OK);
    assert_int_equal(nkw_document_models(d, pose_view(m->pose, joints), NULL, m->models), NKW_OK);
    for (size_t k = 0; k < d->skin_count; k++)
        assert_int_equal(nkw_document_palette(d, k, m->models, m->palettes[k]), NKW_OK);
    for (size_t j = 0; j < joints; j++) {
        const nkw_document_vertices_span out = {m->vertices[j], NULL};
        const nkw_mat4 *palette = d->nodes[j].skin == NKW_NO_JOINT ? NULL : m->palettes[d->nodes[j].skin];
        const nkw_document_moment now = {m->models, m->floats, palette};
        if (d->nodes[j].mesh != NKW_NO_JOINT)
            assert_int_equal(nkw_document_vertices(d, j, 0, &now, out), NKW_OK);
    }
}

/* Compares a row of the table; returns whether it is compared. */
static int compare_row(const moment *m, const table_row *r, double bound)
{
    const nkw_document *d = m->document;
    size_t joint = r->tag[0] == 'J' || r->tag[0] == '#' ? 0 : (size_t)d->joint_of_node[r->a];
    const nkw_document_node *node = &d->nodes[joint];
    nkw_trs got = nkw_pose_get(pose_view(m->pose, d->skeleton.joint_count), joint);
    nkw_quat rotation = {r->values[3], r->values[4], r->values[5], r->values[6]};
    switch (r->tag[0]) {
    case 'L':
        expect_floats_near(&got.translation.x, r->values, 3, bound);
        expect_rotation_near(got.rotation, rotation, bound);
        expect_floats_near(&got.scale.x, r->values + 7, 3, bound);
        return 1;
    case 'W':
        expect_floats_near(m->models[joint].m, r->values, 16, bound);
        return 1;
    case 'M':
        assert_int_equal(r->count, node->float_count);
        expect_floats_near(m->floats + node->float_first, r->values, node->float_count, bound);
        return 1;
    case 'J':
        expect_floats_near(m->palettes[r->a][r->b].m, r->values, 16, bound);
        return 1;
    case 'V':
        expect_floats_near(&m->vertices[joint][r->b].x, r->values, 3, bound);
        return 1;
    default:
        return 0;
    }
}

/* All rows: local values, morph weights, world and skinning matrices, skinned vertices. Returns the count. */
static int compare_table(const char *name, const char *table, int normalized, double bound)
{
    table_row r;
    int rows = 0, compared = 0, animation = -2;
    float time = 0.0f;
    nkw_document *d = open_model(name);
    moment m = begin(d, normalized);
    FILE *file = table_open(table);
    for (; table_read(file, &r); rows++) {
        if (r.tag[0] != '#' && (r.anim != animation || r.time != time))
            play_to(&m, animation = r.anim, time = r.time);
        compared += compare_row(&m, &r, bound);
    }
    table_close(file);
    end(&m);
    nkw_document_close(d);
    assert_int_equal(rows, compared + 1); /* the header */
    return compared;
}

/* Tables of keys as stored, and, for files whose keys are off unit, of normalised ones. */
static void samples_are_those_of_independent_implementations(void **state)
{
    (void)state;
    const char *const folder = NKW_DATA_DIR "/expected/", *const last = ".expected.csv";
    glob_t found;
    int compared = 0;
    assert_int_equal(glob(NKW_DATA_DIR "/expected/*.expected.csv*", 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        char name[64], table[512], other[512];
        assert_int_equal(sscanf(found.gl_pathv[i] + strlen(folder), "%63[^.]", name), 1);
        const char *rest = found.gl_pathv[i] + strlen(folder) + strlen(name);
        int normalized = strncmp(rest, ".keynorm.", 9) == 0;
        if (!normalized && strncmp(rest, last, strlen(last)) != 0)
            continue; /* a table of another kind */
        snprintf(table, sizeof table, "%s%s%s%s", folder, name, normalized ? ".keynorm" : "", last);
        snprintf(other, sizeof other, "%s%s.keynorm%s", folder, name, last);
        FILE *there = normalized ? NULL : fopen(other, "r");
        if (there)
            fclose(there);
        int rows = compare_table(name, table, normalized, table_bound(table, there != NULL));
        printf("%s%s: %d rows\n", name, normalized ? ", keys normalised" : "", rows);
        compared += rows;
    }
    globfree(&found);
    assert_true(compared > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_have_the_numbers_of_their_texts),
        cmocka_unit_test(samples_are_those_of_independent_implementations),
    };
    if (!scene_folder_is_there())
        return 77;
    return cmocka_run_group_tests_name("import_scene", tests, NULL, NULL);
}
