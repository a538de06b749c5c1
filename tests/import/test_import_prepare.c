/* SPDX-License-Identifier: MIT */
/* Normals, tangents, facing and transforms that are made on request. */
#include <math.h>

#include <nakawari/export.h>
#include <nakawari/vec.h>

#include "moment.h"

#define PI 3.14159265f

static nkw_document *read_text(const char *text, const char *name)
{
    nkw_document *d;
    nkw_import_error error;
    const nkw_import_memory memory = {text, strlen(text), name, NULL, NULL, NULL, 0, 0};
    assert_int_equal(nkw_document_from_memory(&memory, &d, &error), NKW_IMPORT_OK);
    return d;
}

static void prepare(nkw_document *d, nkw_document_preparation wanted)
{
    nkw_import_error error;
    if (nkw_document_prepare(d, &wanted, &error) != NKW_IMPORT_OK)
        print_error("%s:%s: %s\n", error.file, error.place, error.reason);
    assert_int_equal(error.code, NKW_IMPORT_OK);
    assert_int_equal(nkw_document_validate(d, &error), NKW_IMPORT_OK);
}

static const nkw_document_preparation nothing = {0, 0, 0, 0, 0};

static nkw_document_preparation with_normals(float crease)
{
    nkw_document_preparation p = nothing;
    p.make_normals = 1;
    p.crease = crease;
    return p;
}

static const char cube[] = "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
                           "f 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\nf 1 3 4 2\nf 5 6 8 7\n";

static void missing_normals_split_vertices_at_hard_edges_only(void **state)
{
    (void)state;
    for (int smooth = 0; smooth < 2; smooth++) {
        nkw_document *d = read_text(cube, "cube.obj");
        const nkw_box box = {{-1, -1, -1}, {1, 1, 1}};
        expect_floats_bits(&d->meshes[0].primitives[0].box.low.x, &box.low.x, 6);
        assert_null(d->meshes[0].primitives[0].normals);
        prepare(d, with_normals(smooth ? PI : 0.5f));
        const nkw_document_primitive *p = &d->meshes[0].primitives[0];
        assert_int_equal(p->vertex_count, smooth ? 8 : 24);
        assert_int_equal(p->index_count, 36);
        for (size_t i = 0; i < 36; i++) {
            const nkw_vec3 at = p->positions[p->indices[i]], n = p->normals[p->indices[i]];
            const uint32_t *t = p->indices + i / 3 * 3;
            const nkw_vec3 face = nkw_vec3_cross(nkw_vec3_sub(p->positions[t[1]], p->positions[t[0]]),
                                                 nkw_vec3_sub(p->positions[t[2]], p->positions[t[0]]));
            expect_vec3_near(n, smooth ? nkw_vec3_normalize(at) : nkw_vec3_normalize(face), 1e-7);
        }
        assert_string_equal(d->warnings[0], smooth ? "normals made for 1 of 1 primitives, smooth up to 180 degrees"
                                                   : "normals made for 1 of 1 primitives, smooth up to 28.65 degrees");
        nkw_document_close(d);
    }
}

static void normals_of_the_file_stay(void **state)
{
    (void)state;
    nkw_document *d = read_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nf 1//1 2//1 3//1\n", "a.obj");
    const nkw_vec3 *before = d->meshes[0].primitives[0].normals;
    prepare(d, with_normals(1));
    assert_ptr_equal(d->meshes[0].primitives[0].normals, before);
    assert_string_equal(d->warnings[0], "normals made for 0 of 1 primitives, smooth up to 57.3 degrees");
    nkw_document_close(d);
}

/* OBJ has v upwards: where u grows along x and v along y, t is x, and the bitangent of glTF, with v upwards, y. */
static void missing_tangents_have_the_sign_of_gltf(void **state)
{
    (void)state;
    for (int mirrored = 0; mirrored < 2; mirrored++)
        for (int up = 0; up < 2; up++) {
            char text[256];
            snprintf(text, sizeof text,
                     "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvt %d 0\nvt %d 0\nvt %d 1\nvt %d 1\n"
                     "f 1/1/1 2/2/1 3/3/1 4/4/1\n",
                     mirrored, 1 - mirrored, 1 - mirrored, mirrored);
            const nkw_import_memory memory = {text, strlen(text), "a.obj", NULL, NULL, NULL, 0, up};
            nkw_document_preparation wanted = nothing;
            nkw_document *d;
            wanted.make_tangents = 1;
            assert_int_equal(nkw_document_from_memory(&memory, &d, NULL), NKW_IMPORT_OK);
            prepare(d, wanted);
            const nkw_document_primitive *p = &d->meshes[0].primitives[0];
            assert_int_equal(p->vertex_count, 4);
            const float want[] = {mirrored ? -1 : 1, 0, 0, mirrored ? -1 : 1};
            for (size_t i = 0; i < 4; i++)
                expect_floats_near(p->tangents + 4 * i, want, 4, 1e-7);
            nkw_document_close(d);
        }
}

static void tangents_are_written_and_read_back(void **state)
{
    (void)state;
    nkw_document *d = read_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                "f 1/1 2/2 3/3 4/4\n",
                                "a.obj"),
                 *again;
    nkw_document_preparation wanted = with_normals(PI);
    nkw_gltf_file file;
    wanted.make_tangents = 1;
    prepare(d, wanted);
    assert_int_equal(nkw_document_write(d, NKW_GLTF_BINARY, NULL, &file, NULL), NKW_IMPORT_OK);
    const nkw_import_memory memory = {file.data, file.bytes, "a.glb", NULL, NULL, NULL, 0, 0};
    assert_int_equal(nkw_document_from_memory(&memory, &again, NULL), NKW_IMPORT_OK);
    const nkw_document_primitive *p = &d->meshes[0].primitives[0], *q = &again->meshes[0].primitives[0];
    assert_int_equal(q->vertex_count, 4);
    expect_floats_bits(q->tangents, p->tangents, 16);
    expect_floats_bits(&q->normals[0].x, &p->normals[0].x, 12);
    expect_floats_bits(q->texcoords[0], p->texcoords[0], 8);
    nkw_gltf_file_free(&file);
    nkw_document_close(again);
    nkw_document_close(d);
}

/* Without texture coordinates, and without normals: none, and that is said. */
static void what_tangents_need_is_not_invented(void **state)
{
    (void)state;
    nkw_document_preparation wanted = with_normals(1);
    wanted.make_tangents = 1;
    nkw_document *d = read_text(cube, "cube.obj");
    prepare(d, wanted);
    assert_null(d->meshes[0].primitives[0].tangents);
    assert_string_equal(d->warnings[1],
                        "tangents made for 0 of 1 primitives; without texture coordinates or normals: 1");
    nkw_document_close(d);
}

/* One face of the cube inside out, with normals that point inwards with it. */
static void turned_triangles_take_their_normals_with_them(void **state)
{
    (void)state;
    char text[512];
    snprintf(text, sizeof text,
             "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
             "vn -1 0 0\nvn 1 0 0\nvn 0 -1 0\nvn 0 1 0\nvn 0 0 -1\nvn 0 0 1\n"
             "f 1//1 5//1 7//1 3//1\nf 2//2 4//2 8//2 6//2\nf 1//3 2//3 6//3 5//3\nf 3//4 7//4 8//4 4//4\n"
             "f 1//5 3//5 4//5 2//5\nf 7//5 8//5 6//5 5//5\n");
    nkw_document_preparation wanted = nothing;
    wanted.fix_facing = 1;
    nkw_document *d = read_text(text, "cube.obj");
    prepare(d, wanted);
    assert_string_equal(d->warnings[0],
                        "triangles turned: 2; edges whose triangles cannot agree: 0, of more than two: 0");
    const nkw_document_primitive *p = &d->meshes[0].primitives[0];
    assert_int_equal(p->vertex_count, 24);
    for (size_t i = 0; i < 36; i += 3) {
        const uint32_t *t = p->indices + i;
        const nkw_vec3 face = nkw_vec3_cross(nkw_vec3_sub(p->positions[t[1]], p->positions[t[0]]),
                                             nkw_vec3_sub(p->positions[t[2]], p->positions[t[0]]));
        for (size_t k = 0; k < 3; k++) {
            expect_vec3_near(p->normals[t[k]], nkw_vec3_normalize(face), 1e-7);
            assert_true(nkw_vec3_dot(face, p->positions[t[k]]) > 0.0f);
        }
    }
    nkw_document_close(d);
}

/* One triangle: positions, normals and tangents; three nodes have it. */
static const float triangle[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1,
                                 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
#define TRIANGLE(nodes)                                                                                                \
    "{'asset':{'version':'2.0'},'nodes':[" nodes "],'buffers':[{'uri':'data.bin','byteLength':120}],"                  \
    "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,'TANGENT':2}}]}],"                                \
    "'bufferViews':[{'buffer':0,'byteLength':120}],'accessors':["                                                      \
    "{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'},"                                                   \
    "{'bufferView':0,'byteOffset':36,'componentType':5126,'count':3,'type':'VEC3'},"                                   \
    "{'bufferView':0,'byteOffset':72,'componentType':5126,'count':3,'type':'VEC4'}]"

static void vertices_move_with_their_nodes(void **state)
{
    (void)state;
    nkw_document_preparation wanted = nothing;
    wanted.apply_transforms = 1;
    nkw_document *d = opened(TRIANGLE("{'translation':[1,2,3],'children':[1],'mesh':0},"
                                      "{'rotation':[0,0,0.70710678,0.70710678],'scale':[2,1,1],'mesh':0},"
                                      "{'scale':[-1,1,1],'mesh':0}") "}",
                             triangle, sizeof triangle);
    prepare(d, wanted);
    assert_int_equal(d->mesh_count, 3);
    const nkw_vec3 want[3][3] = {{{1, 2, 3}, {2, 2, 3}, {1, 3, 3}}, /* moved */
                                 {{1, 2, 3}, {1, 4, 3}, {0, 2, 3}}, /* scaled along x, turned to y, moved */
                                 {{0, 0, 0}, {-1, 0, 0}, {0, 1, 0}}}; /* mirrored */
    const float tangents[3][4] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {-1, 0, 0, -1}};
    for (size_t j = 0; j < 3; j++) {
        const nkw_document_node *node = &d->nodes[d->joint_of_node[j]];
        const nkw_document_primitive *p = &d->meshes[node->mesh].primitives[0];
        const nkw_trs identity = nkw_trs_identity();
        const nkw_vec3 up = {0, 0, 1};
        expect_floats_bits(&node->rest.translation.x, &identity.translation.x, 10);
        for (size_t v = 0; v < 3; v++) {
            expect_vec3_near(p->positions[v], want[j][v], 1e-6);
            expect_vec3_near(p->normals[v], up, 1e-6);
            expect_floats_near(p->tangents + 4 * v, tangents[j], 4, 1e-6);
        }
        assert_int_equal(p->indices[1], j == 2 ? 2 : 1);
        const nkw_box box = nkw_box_from_points(want[j], 3);
        expect_floats_near(&p->box.low.x, &box.low.x, 6, 1e-6);
    }
    assert_string_equal(d->warnings[0], "nodes whose vertices were multiplied by their transforms: 3; nodes that keep "
                                        "theirs (animated, joints, cameras, above such): 0");
    nkw_document_close(d);
}

/* A camera keeps its node, and the node above it; the mesh beside it moves by its own transform only. */
static void nodes_that_something_needs_keep_their_transforms(void **state)
{
    (void)state;
    nkw_document_preparation wanted = nothing;
    wanted.apply_transforms = 1;
    nkw_document *d = opened(TRIANGLE("{'translation':[1,2,3],'children':[1,2]},{'translation':[0,0,5],'camera':0},"
                                      "{'translation':[0,1,0],'mesh':0}") ",'cameras':[{'type':'perspective','"
                                                                          "perspective':{'yfov':1,'znear':1}}]}",
                             triangle, sizeof triangle);
    prepare(d, wanted);
    const nkw_vec3 first = {0, 1, 0}, kept = {1, 2, 3};
    expect_vec3_near(d->meshes[0].primitives[0].positions[0], first, 0);
    expect_vec3_near(d->nodes[d->joint_of_node[0]].rest.translation, kept, 0);
    expect_near(d->nodes[d->joint_of_node[1]].rest.translation.z, 5, 0);
    expect_near(d->nodes[d->joint_of_node[2]].rest.translation.y, 0, 0);
    nkw_document_close(d);
}

/* The vertices of a node at rest, in the space of the model. */
static void pose_vertices(const nkw_document *d, size_t joint, size_t primitive, nkw_vec3 *positions, nkw_vec3 *normals)
{
    static nkw_mat4 models[JOINTS], palette[JOINTS];
    const nkw_document_node *node = &d->nodes[joint];
    assert_int_equal(nkw_document_models(d, d->rest, NULL, models), NKW_OK);
    if (node->skin != NKW_NO_JOINT)
        assert_int_equal(nkw_document_palette(d, (size_t)node->skin, models, palette), NKW_OK);
    const nkw_document_moment now = {models, NULL, palette};
    const nkw_document_vertices_span out = {positions, normals};
    assert_int_equal(nkw_document_vertices(d, joint, primitive, &now, out), NKW_OK);
}

/* Whatever the file: the model at rest is where it was. */
static void models_at_rest_stay_where_they_are(void **state)
{
    (void)state;
    enum { MOST = 4000 };
    static nkw_vec3 p[MOST], n[MOST], q[MOST], m[MOST];
    static const char *const files[] = {NKW_CHARACTER, NKW_TEST_DATA "/import/arm.dae", NKW_TEST_DATA "/import/arm.x",
                                        NKW_TEST_DATA "/import/bar.obj", NKW_TEST_DATA "/import/clips.dae"};
    nkw_document_preparation wanted = nothing;
    wanted.apply_transforms = 1;
    size_t read = 0;
    for (size_t f = 0; f < sizeof files / sizeof *files; f++) {
        nkw_document *a, *b;
        if (nkw_document_open(files[f], &a, NULL) != NKW_IMPORT_OK) /* built without Assimp */
            continue;
        assert_int_equal(nkw_document_open(files[f], &b, NULL), NKW_IMPORT_OK);
        prepare(b, wanted);
        read++;
        for (size_t j = 0; j < a->skeleton.joint_count; j++)
            for (size_t k = 0; a->nodes[j].mesh >= 0 && k < a->meshes[a->nodes[j].mesh].primitive_count; k++) {
                const size_t count = a->meshes[a->nodes[j].mesh].primitives[k].vertex_count;
                assert_in_range(count, 1, MOST);
                pose_vertices(a, j, k, p, n);
                pose_vertices(b, j, k, q, m);
                for (size_t v = 0; v < count; v++) {
                    expect_vec3_near(q[v], p[v], 1e-5 * (1 + (double)nkw_vec3_length(p[v])));
                    expect_vec3_near(m[v], n[v], 1e-5);
                }
            }
        nkw_document_close(a);
        nkw_document_close(b);
    }
    assert_in_range(read, 2, 5);
}

/* A skinned mesh keeps its influences through the split of its vertices, and moves as before. */
static void split_vertices_keep_their_influences(void **state)
{
    (void)state;
    nkw_document *d;
    nkw_document_preparation wanted = with_normals(0.3f);
    assert_int_equal(nkw_document_open(NKW_CHARACTER, &d, NULL), NKW_IMPORT_OK);
    nkw_document_primitive *p = (nkw_document_primitive *)&d->meshes[0].primitives[0], before = *p;
    p->normals = NULL;
    assert_true(before.influence_count > 0);
    prepare(d, wanted);
    const nkw_document_primitive *q = &d->meshes[0].primitives[0];
    assert_int_equal(q->index_count, before.index_count);
    assert_int_equal(q->skin.vertex_count, q->vertex_count);
    for (size_t i = 0; i < q->index_count; i++) {
        const size_t v = q->indices[i], w = before.indices[i], k = before.influence_count;
        expect_vec3_bits(q->positions[v], before.positions[w]);
        assert_memory_equal(q->joints + k * v, before.joints + k * w, k * sizeof *q->joints);
        assert_memory_equal(q->weights + k * v, before.weights + k * w, k * sizeof *q->weights);
        const size_t s = before.skin.influence_count;
        assert_memory_equal((const float *)q->skin.weights.data + s * v,
                            (const float *)before.skin.weights.data + s * w, s * sizeof(float));
    }
    nkw_document_close(d);
}

static void faults_have_their_place_and_leave_the_document(void **state)
{
    (void)state;
    nkw_document *d = read_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
    nkw_document_preparation wanted = with_normals(1);
    nkw_import_error error;
    ((nkw_vec3 *)d->meshes[0].primitives[0].positions)[2].y = INFINITY;
    assert_int_equal(nkw_document_prepare(d, &wanted, &error), NKW_IMPORT_REFUSED);
    assert_int_equal(error.result, NKW_NOT_FINITE);
    assert_string_equal(error.place, "/meshes/0/primitives/0");
    assert_null(d->meshes[0].primitives[0].normals);
    wanted.crease = -0.1f;
    assert_int_equal(nkw_document_prepare(d, &wanted, &error), NKW_IMPORT_REFUSED);
    assert_int_equal(error.result, NKW_OUT_OF_RANGE);
    nkw_document_close(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(missing_normals_split_vertices_at_hard_edges_only),
        cmocka_unit_test(normals_of_the_file_stay),
        cmocka_unit_test(missing_tangents_have_the_sign_of_gltf),
        cmocka_unit_test(tangents_are_written_and_read_back),
        cmocka_unit_test(what_tangents_need_is_not_invented),
        cmocka_unit_test(turned_triangles_take_their_normals_with_them),
        cmocka_unit_test(vertices_move_with_their_nodes),
        cmocka_unit_test(nodes_that_something_needs_keep_their_transforms),
        cmocka_unit_test(models_at_rest_stay_where_they_are),
        cmocka_unit_test(split_vertices_keep_their_influences),
        cmocka_unit_test(faults_have_their_place_and_leave_the_document),
    };
    return cmocka_run_group_tests_name("import_prepare", tests, NULL, NULL);
}
