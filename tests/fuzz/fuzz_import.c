/* SPDX-License-Identifier: MIT */
/* Files: the input as it is, and edits of files that have everything. What is read can be played. */
#include <stdlib.h>
#include <string.h>

#include <nakawari/export.h>

#include "fuzz.h"

enum { TEXT_MOST = 8192, EDITS_MOST = 12, DATA = 256 };

/* ' for ". The outer file has DATA bytes of any values. */
static const char whole[] =
    "{'asset':{'version':'2.0','generator':'g'},'scene':0,'scenes':[{'nodes':[0]}],'buffers':[{'uri':'d','byteLength':"
    "256},{'uri':'data:;base64,AAAAAAAAgD8AAABAAABAQAAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAAAA=','byteLength':44}],"
    "'bufferViews':[{'buffer':0,'byteLength':256},{'buffer':0,'byteLength':240,'byteStride':20,'byteOffset':16},"
    "{'buffer':1,'byteLength':44}],'accessors':[{'bufferView':2,'componentType':5126,'count':2,'type':'SCALAR'},"
    "{'bufferView':0,'componentType':5126,'count':6,'type':'VEC3'},{'bufferView':1,'componentType':5120,'normalized':"
    "true,'count':6,'type':'VEC4'},{'bufferView':1,'componentType':5121,'count':6,'type':'VEC4'},{'bufferView':0,"
    "'componentType':5126,'count':2,'type':'MAT4'},{'componentType':5126,'count':6,'type':'VEC3','sparse':{'count':1,"
    "'indices':{'bufferView':2,'componentType':5123},'values':{'bufferView':0,'byteOffset':8}}},{'bufferView':0,"
    "'componentType':5126,'count':4,'type':'SCALAR'},{'bufferView':2,'componentType':5121,'count':4,'type':'SCALAR'},"
    "{'bufferView':2,'byteOffset':16,'componentType':5126,'count':1,'type':'VEC4'},{'bufferView':2,'componentType':"
    "5126,'count':2,'type':'VEC3','byteOffset':8},{'bufferView':0,"
    "'componentType':5126,'count':6,'type':'VEC2'}],'materials':[{'name':'m','pbrMetallicRoughness':{'baseColorFactor':"
    "[1,1,1,1]}}],'meshes':[{'weights':[0.5,0],'extras':{'targetNames':['a']},'primitives':[{'attributes':{'POSITION':"
    "1,'NORMAL':5,'JOINTS_0':3,'WEIGHTS_0':2,'JOINTS_1':3,'WEIGHTS_1':2,'TEXCOORD_0':10,'TEXCOORD_1':10},'indices':7,'"
    "mode':5,'material':0,'targets':"
    "[{'POSITION':5},{'NORMAL':1}]}]}],'skins':[{'joints':[1,2],'inverseBindMatrices':4}],'nodes':[{'children':[1,3]},"
    "{'children':[2],'rotation':[0,0,1,0]},{'matrix':[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]},{'mesh':0,'skin':0,'weights':"
    "[1,2]}],'animations':[{'samplers':[{'input':0,'output':9},{'input':0,'output':6,'interpolation':'STEP'},{'input':"
    "6,'output':2,'interpolation':'LINEAR'}],'channels':[{'sampler':0,'target':{'node':1,'path':'translation'}},"
    "{'sampler':1,'target':{'node':3,'path':'weights'}}]}]}";

static const char keys[] = "index,name,time,clip,parent,interpolation,tx,ty,tz,qx,qy,qz,qw,sx,sy,sz\n"
                           "0,a,0,c,,,1,2,3,0,0,0,1,,,\n1,'b, b',0,c,a,STEP,,,,0,0,1,0,1,1,1\n# x\n"
                           "0,a,1,c,,,4,5,6,1,0,0,0,,,\n0,a,0,d,,,4,5,6,,,,,,,\n";

static const char curves[] = "name,time,interpolation,weight,in_weight,tx,ty,tz,out_tx,out_ty,out_tz\n"
                             "a,0,CUBICSPLINE,1,2,,,,,,\na,0,CUBICSPLINE,3,4,,,,,,\na,1,CUBICSPLINE,5,,1,2,3,4,5,6\n"
                             "a,1,CUBICSPLINE,6,,,,,,,\nb,0,,1,,,,,,,\n";

static const char scenes[] = "{'s':[{'time':0,'pos':[1,2,3],'quat_xyzw':[0,1,0,0]},{'time':1,'pos':[1,2,3],"
                             "'euler_yxz_yaw_pitch_roll':[1,2,3]},{'time':2,'pos':[4,5,6],'ori_rows':[0,-1,0,1,0,0,0,"
                             "0,1]}],'t':[{'time':3,'pos':[1,2,3]}]}";

static const char rows[] = "{'columns':'tx,ty,tz,yaw,pitch,roll','rows':[{'name':'a','time':0,'clip':0,'values':[1,2,3,"
                           "10,20,30]},{'name':'b','time':0,'parent':'a','values':[1,2,3,null,null,null]},{'name':'b',"
                           "'interpolation':'STEP','clip':'d','time':0,'values':[null,null,null,1,2,3]}]}";

static const char shapes[] =
    "mtllib d\no a\nv 0 0 0 1 1 1\nv 1 0 0\nv 1 1 0\nv .2 .4 0\nv 0 1 0\nvt 0 1\nvn 0 0 1\nusemtl m\n"
    "f 1/1/1 2/1/1 3/1/1 4/1/1 -1/1/1\nf 1 2 3\ng b \\\nc # d\nl 1 2 \\\n 3\np -1 2\n";

static const char *const words[] = {
    "0",    "1", "-1",   "4294967295", "9007199254740992", "1e999", "null", "[", "{", "]", "}", "''", "65536", "0.5",
    "true", ",", "5126", "5121",       "'CUBICSPLINE'",    "7"};

/* Replaces `cut` bytes at a place by a word, a byte or another part of the text. */
static size_t edit(fuzz *f, char *text, size_t length)
{
    char piece[64];
    size_t at = fuzz_upto(f, length - 1), cut = fuzz_byte(f) % 8, more;
    unsigned char kind = fuzz_byte(f);
    cut = cut > length - at ? length - at : cut;
    if (kind % 4 == 0) {
        piece[0] = (char)fuzz_byte(f);
        more = 1;
    } else if (kind % 4 == 1) {
        size_t from = fuzz_upto(f, length - 1);
        more = fuzz_upto(f, sizeof piece - 1);
        more = more > length - from ? length - from : more;
        memcpy(piece, text + from, more);
    } else {
        const char *word = words[fuzz_upto(f, sizeof words / sizeof *words - 1)];
        more = strlen(word);
        memcpy(piece, word, more);
        while (kind % 4 == 3 && at + cut < length && strchr("0123456789.", text[at + cut]))
            cut++;
    }
    if (length - cut + more > TEXT_MOST)
        return length;
    memmove(text + at + more, text + at + cut, length - at - cut);
    memcpy(text + at, piece, more);
    return length - cut + more;
}

static size_t read_data(void *user, const char *path, void *out, size_t size)
{
    FUZZ_CHECK(path[0] != '/' && !strstr(path, ".."));
    if (size > DATA)
        return SIZE_MAX;
    if (out)
        memcpy(out, user, size);
    return DATA;
}

static void check_indices(const nkw_document *d)
{
    size_t joints = d->skeleton.joint_count;
    FUZZ_CHECK(joints > 0 && nkw_skeleton_validate(&d->skeleton, NULL) == NKW_OK);
    for (size_t j = 0; j < joints; j++) {
        const nkw_document_node *n = &d->nodes[j];
        FUZZ_CHECK(n->name && n->number < joints && (size_t)d->joint_of_node[n->number] == j);
        FUZZ_CHECK(n->mesh == NKW_NO_JOINT || (size_t)n->mesh < d->mesh_count);
        FUZZ_CHECK(n->skin == NKW_NO_JOINT || (size_t)n->skin < d->skin_count);
        FUZZ_CHECK(n->float_first + (size_t)n->float_count <= d->float_count);
    }
    for (size_t k = 0; k < d->skin_count; k++)
        for (size_t i = 0; i < d->skins[k].joint_count; i++)
            FUZZ_CHECK(d->skins[k].joints[i] >= 0 && (size_t)d->skins[k].joints[i] < joints);
    for (size_t m = 0; m < d->mesh_count; m++)
        for (size_t i = 0; i < d->meshes[m].primitive_count; i++) {
            const nkw_document_primitive *p = &d->meshes[m].primitives[i];
            FUZZ_CHECK(p->index_count % ((size_t)p->topology + 1) == 0);
            for (size_t v = 0; v < p->index_count; v++)
                FUZZ_CHECK(p->indices[v] < p->vertex_count);
            FUZZ_CHECK((p->texcoord_count == 0) == (p->texcoords == NULL));
        }
}

/* The joints with a mesh, of all and of one joint: ascending, below it, as many as it says. */
static void list_frames(fuzz *f, const nkw_document *d)
{
    const size_t joints = d->skeleton.joint_count, capacity = fuzz_upto(f, joints);
    const int32_t root = (int32_t)fuzz_upto(f, joints + 1) - 1;
    int32_t *list = (int32_t *)fuzz_block(f, capacity * sizeof *list);
    size_t count, with_mesh = 0;
    const nkw_result result = nkw_document_mesh_joints(d, root, list, capacity, &count);
    FUZZ_CHECK(root < (int32_t)joints || (result == NKW_OUT_OF_RANGE && count == 0));
    FUZZ_CHECK(result == NKW_OUT_OF_RANGE || (result == NKW_OK) == (count <= capacity));
    for (size_t i = 0; i < count && i < capacity; i++)
        FUZZ_CHECK(list[i] >= root && d->nodes[list[i]].mesh != NKW_NO_JOINT && (i == 0 || list[i] > list[i - 1]));
    for (size_t j = 0; j < joints; j++)
        with_mesh += d->nodes[j].mesh != NKW_NO_JOINT;
    FUZZ_CHECK(root != NKW_NO_JOINT || count == with_mesh);
}

/* Samples every clip that can be built, and skins every mesh. */
static void play(fuzz *f, const nkw_document *d)
{
    size_t joints = d->skeleton.joint_count;
    const nkw_pose_span pose = {fuzz_room(f, nkw_pose_floats(joints)), joints};
    float *floats = fuzz_room(f, d->float_count);
    nkw_mat4 *models = (nkw_mat4 *)fuzz_block(f, joints * sizeof *models);
    for (size_t i = 0; i <= d->animation_count && i < 4; i++) {
        nkw_clip *clip;
        nkw_import_error error;
        if (nkw_document_clip(d, i, NKW_CLIP_FLOAT32, &clip, &error) != NKW_IMPORT_OK) {
            FUZZ_CHECK(error.code == NKW_IMPORT_REFUSED && error.result != NKW_OK && error.reason[0]);
            continue;
        }
        FUZZ_CHECK(nkw_clip_sample(clip, fuzz_float(f), NULL, pose, floats) == NKW_OK);
        FUZZ_CHECK(nkw_document_models(d, NKW_VIEW(nkw_pose, pose), NULL, models) == NKW_OK);
        nkw_import_free(clip);
    }
    for (size_t j = 0; j < joints && j < 16; j++) {
        const nkw_document_node *n = &d->nodes[j];
        if (n->mesh == NKW_NO_JOINT || d->meshes[n->mesh].primitive_count == 0)
            continue;
        nkw_mat4 *palette = NULL;
        if (n->skin != NKW_NO_JOINT) {
            palette = (nkw_mat4 *)fuzz_block(f, d->skins[n->skin].joint_count * sizeof *palette);
            FUZZ_CHECK(nkw_document_palette(d, (size_t)n->skin, models, palette) == NKW_OK);
        }
        size_t bytes = d->meshes[n->mesh].primitives[0].vertex_count * sizeof(nkw_vec3);
        const nkw_document_vertices_span out = {(nkw_vec3 *)fuzz_block(f, bytes), (nkw_vec3 *)fuzz_block(f, bytes)};
        const nkw_document_moment moment = {models, floats, palette};
        FUZZ_CHECK(nkw_document_vertices(d, j, 0, &moment, out) == NKW_OK);
    }
}

/* The character of a document, in a block of its very size; every part is skinned in bounds. */
static void play_character(fuzz *f, const nkw_document *d)
{
    nkw_bytes_span block = {NULL, 0};
    nkw_import_error error;
    nkw_character c;
    size_t bytes;
    const nkw_clip_format format = fuzz_byte(f) % 2 ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32;
    if (nkw_document_character(d, format, block, &block.bytes, NULL, &error) != NKW_IMPORT_OK) {
        FUZZ_CHECK(block.bytes == 0 && error.result != NKW_OK);
        return;
    }
    block.data = fuzz_block(f, block.bytes);
    FUZZ_CHECK(nkw_document_character(d, format, block, &bytes, &c, &error) == NKW_IMPORT_OK && bytes == block.bytes);
    nkw_mat4 *models = (nkw_mat4 *)fuzz_block(f, d->skeleton.joint_count * sizeof *models);
    nkw_mat4 *palette = (nkw_mat4 *)fuzz_block(f, c.palette.joint_count * sizeof *palette);
    FUZZ_CHECK(nkw_character_palette(&c, c.set.rest, NULL, models, palette) == NKW_OK);
    for (size_t p = 0; p < c.part_count; p++) {
        nkw_vertices_span out;
        memset(&out, 0, sizeof out);
        out.positions.data = fuzz_block(f, c.parts[p].skin.vertex_count * sizeof(nkw_vec3));
        FUZZ_CHECK(c.parts[p].matrix_first + c.parts[p].matrix_count <= c.palette.joint_count);
        FUZZ_CHECK(nkw_character_vertices(&c, p, NULL, palette, out) == NKW_OK);
    }
}

static void read_again(nkw_gltf_file *file, nkw_import_result result, const nkw_document *d, void *outer)
{
    nkw_document *again = NULL;
    nkw_import_error error;
    const nkw_import_memory memory = {file->data, file->bytes, "written", NULL, read_data, outer, 0, 0};
    if (result == NKW_IMPORT_OK) {
        nkw_document_from_memory(&memory, &again, &error);
        FUZZ_CHECK(again && again->skeleton.joint_count == d->skeleton.joint_count);
        FUZZ_CHECK(again->mesh_count == d->mesh_count && again->skin_count == d->skin_count);
    }
    nkw_document_close(again);
    nkw_gltf_file_free(file);
}

/*
 * OBJ has the triangles, lines and points of all nodes, in which numbers are finite. Refused is a document without
 * vertices, and a skin that nkw_skin_linear refuses.
 */
static void write_obj(const nkw_document *d)
{
    const nkw_obj_writing writing = {NULL, NULL, "d", NULL, 0};
    nkw_obj_file file;
    nkw_import_error error;
    nkw_document *again;
    const nkw_import_result result = nkw_document_write_obj(d, &writing, &file, &error);
    FUZZ_CHECK(result == NKW_IMPORT_OK || (result == NKW_IMPORT_UNSUPPORTED && error.reason[0] && !file.data));
    const nkw_import_memory memory = {file.data, file.bytes, "written.obj", NULL, NULL, NULL, 0, 0};
    if (result == NKW_IMPORT_OK) {
        const nkw_import_result read = nkw_document_from_memory(&memory, &again, &error);
        FUZZ_CHECK(read == NKW_IMPORT_OK || strstr(error.reason, "finite"));
        nkw_document_close(again);
    }
    nkw_obj_file_free(&file);
}

/* The arrays of OBJ: as many triangles as the document has, numbers in range; scaled, they are finite or infinite. */
static void read_arrays(fuzz *f, const nkw_import_memory *memory, const nkw_document *d)
{
    nkw_obj *obj;
    nkw_import_error error;
    const nkw_import_result result = nkw_obj_from_memory(memory, &obj, &error);
    size_t corners = 0;
    FUZZ_CHECK((result == NKW_IMPORT_OK) == (strcmp(d->format, "OBJ") == 0) &&
               (result == NKW_IMPORT_OK) == (obj != NULL));
    if (!obj)
        return;
    for (size_t m = 0; m < d->mesh_count; m++)
        for (size_t k = 0; k < d->meshes[m].primitive_count; k++)
            if (d->meshes[m].primitives[k].topology == NKW_DOCUMENT_TRIANGLES)
                corners += d->meshes[m].primitives[k].index_count;
    FUZZ_CHECK(corners == 3 * obj->triangle_count);
    for (size_t i = 0; i < corners; i++) {
        FUZZ_CHECK(obj->position_indices[i] < obj->position_count);
        FUZZ_CHECK(obj->texcoord_indices[i] == NKW_OBJ_NONE || obj->texcoord_indices[i] < obj->texcoord_count);
        FUZZ_CHECK(obj->normal_indices[i] == NKW_OBJ_NONE || obj->normal_indices[i] < obj->normal_count);
        FUZZ_CHECK(obj->materials[i / 3] < (int32_t)d->material_count);
    }
    const nkw_vec3 size = nkw_obj_scale(obj, fuzz_float(f));
    FUZZ_CHECK(!(size.x < 0.0f || size.y < 0.0f || size.z < 0.0f));
    nkw_obj_close(obj);
}

/* What is written can be read; so can a file whose first track ends after its first key, without its last channel. */
static void write_again(const nkw_import_memory *memory, const nkw_document *d, void *outer)
{
    nkw_import_error error;
    nkw_gltf_file file;
    read_again(&file, nkw_document_write(d, NKW_GLTF_TEXT, NULL, &file, &error), d, outer);
    if (strcmp(d->format, "glTF 2.0") != 0 || d->animation_count == 0 || d->animations[0].track_count == 0)
        return;
    nkw_document to = *d;
    nkw_document_animation *list = (nkw_document_animation *)malloc(d->animation_count * sizeof *list);
    nkw_clip_track *tracks = (nkw_clip_track *)malloc(d->animations[0].track_count * sizeof *tracks);
    FUZZ_CHECK(list && tracks);
    memcpy(list, d->animations, d->animation_count * sizeof *list);
    memcpy(tracks, d->animations[0].tracks, d->animations[0].track_count * sizeof *tracks);
    tracks[0].track.count = tracks[0].track.count > 0;
    list[0].tracks = tracks;
    list[0].track_count -= list[0].track_count > 1;
    to.animations = list;
    const nkw_gltf_rewriting rewriting = {memory, d, &to, 1};
    read_again(&file, nkw_gltf_rewrite(&rewriting, NKW_GLTF_BINARY, NULL, &file, &error), d, outer);
    free(list);
    free(tracks);
}

/* Whatever is made or refused, the document is one that can be used. */
static void prepare(fuzz *f, nkw_document *d)
{
    const unsigned parts = fuzz_byte(f);
    const nkw_document_preparation wanted = {(int)(parts & 1), (int)(parts & 2), (int)(parts & 4), (int)(parts & 8),
                                             parts & 16 ? fuzz_float(f) : 0.7f};
    nkw_import_error error;
    const nkw_import_result result = nkw_document_prepare(d, &wanted, &error);
    FUZZ_CHECK(result == error.code && (result == NKW_IMPORT_OK || result == NKW_IMPORT_REFUSED));
    check_indices(d);
    play(f, d);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    char *text = (char *)fuzz_block(&f, TEXT_MOST);
    static const char *const texts[10] = {whole, whole, whole, whole, curves, scenes, keys, rows, shapes, shapes};
    const char *from = texts[fuzz_byte(&f) % 10];
    size_t length = strlen(from), edits = fuzz_upto(&f, EDITS_MOST);
    for (size_t i = 0; i < length; i++)
        text[i] = (char)(from[i] == '\'' ? '"' : from[i]);
    void *outer = fuzz_byte(&f) % 2 ? fuzz_bytes(&f, DATA) : (void *)fuzz_floats(&f, DATA / 4, 0);
    for (size_t i = 0; i < edits && length > 0; i++)
        length = edit(&f, text, length);
    nkw_import_memory memory = {text, length, "fuzz", NULL, read_data, outer, 0, (int)(edits % 2)};
    for (int raw = 0; raw < 2; raw++) {
        nkw_document *d;
        nkw_import_error error;
        nkw_import_result result = nkw_document_from_memory(&memory, &d, &error);
        FUZZ_CHECK(result == error.code && (result == NKW_IMPORT_OK) == (d != NULL));
        FUZZ_CHECK(result == NKW_IMPORT_OK || error.reason[0]);
        FUZZ_CHECK(edits > 0 || raw || result == NKW_IMPORT_OK);
        if (d) {
            check_indices(d);
            nkw_document_validate(d, &error);
            play(&f, d);
            list_frames(&f, d);
            play_character(&f, d);
            write_again(&memory, d, outer);
            write_obj(d);
            read_arrays(&f, &memory, d);
            prepare(&f, d);
            write_again(&memory, d, outer);
            write_obj(d);
            read_arrays(&f, &memory, d);
        }
        nkw_document_close(d);
        memory.data = data;
        memory.bytes = size;
    }
    return fuzz_end(&f);
}
