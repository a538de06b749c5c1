/* SPDX-License-Identifier: MIT */
#include "parcel.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/*
 * All members of all structures are known here. Where a size changes, a member was added: copy what it points to, then
 * correct the size. On other systems the sizes are not compared.
 */
#define KNOWN(type, bytes) typedef char known_##type[sizeof(void *) == 8 && sizeof(type) != (bytes) ? -1 : 1]
KNOWN(nkw_document, 240);
KNOWN(nkw_document_node, 88);
KNOWN(nkw_document_skin, 32);
KNOWN(nkw_document_primitive, 208);
KNOWN(nkw_document_target, 24);
KNOWN(nkw_document_mesh, 48);
KNOWN(nkw_document_image, 32);
KNOWN(nkw_document_material, 40);
KNOWN(nkw_document_animation, 48);
KNOWN(nkw_document_channel, 56);
KNOWN(nkw_document_unread, 16);
KNOWN(nkw_document_scene, 24);
KNOWN(nkw_clip_track, 56);

/* An array that is in the block. */
typedef struct copied {
    const void *from;
    size_t bytes, offset;
} copied;

typedef struct packer {
    parcel *to;
    size_t room, link_room;
    copied *table; /* open addressing, a power of two of entries, at most half of them used */
    size_t table_room, table_count;
    int known; /* whether the last array was in the block already, with its links */
    int failed; /* no memory */
} packer;

/* ---- memory ---- */

/* At least `needed` elements in an array of `room`, which doubles. */
static int reserve(void **data, size_t *room, size_t needed, size_t size)
{
    size_t more = *room ? *room : 1024;
    while (more < needed && more <= SIZE_MAX / 2 / size)
        more *= 2;
    if (more < needed)
        return 0;
    void *wider = more > *room ? realloc(*data, more * size) : *data;
    if (!wider)
        return 0;
    *data = wider;
    *room = more;
    return 1;
}

static size_t slot_of(const packer *p, const void *from, size_t bytes)
{
    size_t slot = ((size_t)(uintptr_t)from / 8 * 31 + bytes) & (p->table_room - 1);
    while (p->table[slot].from && (p->table[slot].from != from || p->table[slot].bytes != bytes))
        slot = (slot + 1) & (p->table_room - 1);
    return slot;
}

static int widen_table(packer *p)
{
    copied *old = p->table;
    const size_t count = p->table_room;
    p->table_room = count ? 2 * count : 1024;
    p->table = calloc(p->table_room, sizeof *p->table);
    for (size_t i = 0; p->table && i < count; i++)
        if (old[i].from)
            p->table[slot_of(p, old[i].from, old[i].bytes)] = old[i];
    free(old);
    return p->table != NULL;
}

/* The offset of an array in the block, where it is copied unless it is there. */
static size_t put(packer *p, const void *from, size_t bytes)
{
    parcel *to = p->to;
    const size_t offset = (to->bytes + PARCEL_ALIGNMENT - 1) / PARCEL_ALIGNMENT * PARCEL_ALIGNMENT;
    if (p->failed || (2 * p->table_count >= p->table_room && !widen_table(p)) || bytes > SIZE_MAX / 2 - offset) {
        p->failed = 1;
        return 0;
    }
    const size_t slot = slot_of(p, from, bytes);
    p->known = p->table[slot].from != NULL;
    if (p->known)
        return p->table[slot].offset;
    void *data = to->data;
    p->failed = !reserve(&data, &p->room, offset + bytes + 1, 1);
    to->data = data;
    if (p->failed)
        return 0;
    memset(to->data + to->bytes, 0, offset - to->bytes);
    memcpy(to->data + offset, from, bytes);
    to->bytes = offset + bytes;
    const copied entry = {from, bytes, offset};
    p->table[slot] = entry;
    p->table_count++;
    return offset;
}

/* ---- pointers ---- */

/* The pointer at `field` of the block points to `offset`. */
static void link_to(packer *p, size_t field, size_t offset)
{
    void *links = p->to->links;
    p->failed = p->failed || !reserve(&links, &p->link_room, p->to->link_count + 1, sizeof *p->to->links);
    p->to->links = links;
    if (p->failed)
        return;
    memcpy(p->to->data + field, &offset, sizeof offset);
    p->to->links[p->to->link_count++] = field;
}

/* Copies an array for the pointer at `field`, and returns where it is. NULL remains NULL. */
static size_t add(packer *p, size_t field, const void *from, size_t count, size_t size)
{
    if (!from || p->failed)
        return 0;
    p->failed = count > SIZE_MAX / 2 / size;
    const size_t offset = p->failed ? 0 : put(p, from, count * size);
    link_to(p, field, offset);
    return offset;
}

/* The same of an array whose elements have pointers: 0 if there are none to be copied. */
static size_t add_list(packer *p, size_t field, const void *from, size_t count, size_t size)
{
    p->known = 0;
    const size_t list = add(p, field, from, count, size);
    return p->failed || p->known ? 0 : list;
}

static void add_text(packer *p, size_t field, const char *text)
{
    if (text)
        add(p, field, text, strlen(text) + 1, 1);
}

static void add_texts(packer *p, size_t field, const char *const *texts, size_t count)
{
    const size_t list = add_list(p, field, texts, count, sizeof *texts);
    for (size_t i = 0; list && i < count; i++)
        add_text(p, list + i * sizeof *texts, texts[i]);
}

/* The place of a member of element i of the array at `list`. */
#define AT(list, i, type, member) ((list) + (i) * sizeof(type) + offsetof(type, member))
/* The place of a member of the document, which the block begins with. */
#define IN(member) offsetof(nkw_document, member)

/* ---- the parts of a document ---- */

static void add_nodes(packer *p, const nkw_document *d)
{
    const size_t n = d->skeleton.joint_count, list = add_list(p, IN(nodes), d->nodes, n, sizeof *d->nodes);
    for (size_t i = 0; list && i < n; i++) {
        add_text(p, AT(list, i, nkw_document_node, name), d->nodes[i].name);
        add(p, AT(list, i, nkw_document_node, matrix), d->nodes[i].matrix, 1, sizeof(nkw_mat4));
    }
    add(p, IN(skeleton) + offsetof(nkw_skeleton, parents), d->skeleton.parents, n, sizeof *d->skeleton.parents);
    add(p, IN(joint_of_node), d->joint_of_node, n, sizeof *d->joint_of_node);
    add(p, IN(rest) + offsetof(nkw_pose_view, data), d->rest.data, nkw_pose_floats(d->rest.joint_count), sizeof(float));
    add(p, IN(rest_floats), d->rest_floats, d->float_count, sizeof(float));
}

static void add_skins(packer *p, const nkw_document *d)
{
    const size_t list = add_list(p, IN(skins), d->skins, d->skin_count, sizeof *d->skins);
    for (size_t i = 0; list && i < d->skin_count; i++) {
        const nkw_document_skin *s = &d->skins[i];
        add_text(p, AT(list, i, nkw_document_skin, name), s->name);
        add(p, AT(list, i, nkw_document_skin, joints), s->joints, s->joint_count, sizeof *s->joints);
        add(p, AT(list, i, nkw_document_skin, inverse_bind), s->inverse_bind, s->joint_count, sizeof(nkw_mat4));
    }
}

static void add_view(packer *p, size_t field, const nkw_skin *skin, const nkw_skin_view *view)
{
    const size_t size = view->format == NKW_SKIN_U8 ? 1 : view->format == NKW_SKIN_U16 ? 2 : 4;
    const size_t stride = view->stride ? view->stride : skin->influence_count * size;
    add(p, field + offsetof(nkw_skin_view, data), view->data, skin->vertex_count, stride);
}

static void add_targets(packer *p, size_t field, const nkw_document_primitive *from)
{
    const size_t n = from->vertex_count;
    const size_t list = add_list(p, field, from->targets, from->target_count, sizeof *from->targets);
    for (size_t i = 0; list && i < from->target_count; i++) {
        const nkw_document_target *t = &from->targets[i];
        add(p, AT(list, i, nkw_document_target, positions), t->positions, n, sizeof(nkw_vec3));
        add(p, AT(list, i, nkw_document_target, normals), t->normals, n, sizeof(nkw_vec3));
        add(p, AT(list, i, nkw_document_target, tangents), t->tangents, n, sizeof(nkw_vec3));
    }
}

static void add_primitive(packer *p, size_t at, const nkw_document_primitive *from)
{
#define FIELD(member) (at + offsetof(nkw_document_primitive, member))
    const size_t n = from->vertex_count, influences = n * from->influence_count;
    add(p, FIELD(positions), from->positions, n, sizeof(nkw_vec3));
    add(p, FIELD(normals), from->normals, n, sizeof(nkw_vec3));
    add(p, FIELD(tangents), from->tangents, n, 4 * sizeof(float));
    const size_t sets = add_list(p, FIELD(texcoords), from->texcoords, from->texcoord_count, sizeof *from->texcoords);
    for (size_t set = 0; sets && set < from->texcoord_count; set++)
        add(p, sets + set * sizeof *from->texcoords, from->texcoords[set], n, 2 * sizeof(float));
    add(p, FIELD(colors), from->colors, n, 4 * sizeof(float));
    add(p, FIELD(indices), from->indices, from->index_count, sizeof *from->indices);
    add(p, FIELD(joints), from->joints, influences, sizeof *from->joints);
    add(p, FIELD(weights), from->weights, influences, sizeof *from->weights);
    add_view(p, FIELD(skin.joints), &from->skin, &from->skin.joints);
    add_view(p, FIELD(skin.weights), &from->skin, &from->skin.weights);
    add_targets(p, FIELD(targets), from);
#undef FIELD
}

static void add_meshes(packer *p, const nkw_document *d)
{
    const size_t list = add_list(p, IN(meshes), d->meshes, d->mesh_count, sizeof *d->meshes);
    for (size_t i = 0; list && i < d->mesh_count; i++) {
        const nkw_document_mesh *m = &d->meshes[i];
        const size_t primitives = add_list(p, AT(list, i, nkw_document_mesh, primitives), m->primitives,
                                           m->primitive_count, sizeof *m->primitives);
        for (size_t k = 0; primitives && k < m->primitive_count; k++)
            add_primitive(p, primitives + k * sizeof *m->primitives, &m->primitives[k]);
        add_text(p, AT(list, i, nkw_document_mesh, name), m->name);
        add(p, AT(list, i, nkw_document_mesh, weights), m->weights, m->target_count, sizeof *m->weights);
        add_texts(p, AT(list, i, nkw_document_mesh, target_names), m->target_names, m->target_count);
    }
}

static void add_materials(packer *p, const nkw_document *d)
{
    const size_t images = add_list(p, IN(images), d->images, d->image_count, sizeof *d->images);
    for (size_t i = 0; images && i < d->image_count; i++) {
        add_text(p, AT(images, i, nkw_document_image, name), d->images[i].name);
        add(p, AT(images, i, nkw_document_image, data), d->images[i].data, d->images[i].bytes, 1);
        add_text(p, AT(images, i, nkw_document_image, path), d->images[i].path);
    }
    const size_t list = add_list(p, IN(materials), d->materials, d->material_count, sizeof *d->materials);
    for (size_t i = 0; list && i < d->material_count; i++) {
        const nkw_document_material *m = &d->materials[i];
        add_text(p, AT(list, i, nkw_document_material, name), m->name);
        if (m->image)
            link_to(p, AT(list, i, nkw_document_material, image),
                    images + (size_t)(m->image - d->images) * sizeof *m->image);
    }
}

static void add_tracks(packer *p, size_t field, const nkw_document_animation *a)
{
    const size_t list = add_list(p, field, a->tracks, a->track_count, sizeof *a->tracks);
    for (size_t i = 0; list && i < a->track_count; i++) {
        const nkw_track *t = &a->tracks[i].track;
        const size_t at = AT(list, i, nkw_clip_track, track);
        add(p, at + offsetof(nkw_track, times), t->times, t->count, sizeof *t->times);
        add(p, at + offsetof(nkw_track, values), t->values, nkw_track_value_count(t), sizeof *t->values);
        add(p, at + offsetof(nkw_track, key_interpolation), t->key_interpolation, t->count, 1);
    }
}

static void add_animations(packer *p, const nkw_document *d)
{
    const size_t list = add_list(p, IN(animations), d->animations, d->animation_count, sizeof *d->animations);
    const size_t names = add_list(p, IN(clip_names), d->clip_names, d->animation_count, sizeof *d->clip_names);
    for (size_t i = 0; list && i < d->animation_count; i++) {
        const nkw_document_animation *a = &d->animations[i];
        add_text(p, AT(list, i, nkw_document_animation, name), a->name);
        add_tracks(p, AT(list, i, nkw_document_animation, tracks), a);
        add(p, AT(list, i, nkw_document_animation, channels), a->channels, a->track_count, sizeof *a->channels);
        const size_t unread =
            add_list(p, AT(list, i, nkw_document_animation, unread), a->unread, a->unread_count, sizeof *a->unread);
        for (size_t k = 0; unread && k < a->unread_count; k++)
            add_text(p, AT(unread, k, nkw_document_unread, reason), a->unread[k].reason);
        if (!names)
            continue;
        add_text(p, AT(names, i, nkw_clip_names, clip), d->clip_names[i].clip);
        add_texts(p, AT(names, i, nkw_clip_names, joints), d->clip_names[i].joints, d->skeleton.joint_count);
        add_texts(p, AT(names, i, nkw_clip_names, floats), d->clip_names[i].floats, d->float_count);
    }
}

static void add_scenes(packer *p, const nkw_document *d)
{
    const size_t list = add_list(p, IN(scenes), d->scenes, d->scene_count, sizeof *d->scenes);
    for (size_t i = 0; list && i < d->scene_count; i++) {
        add_text(p, AT(list, i, nkw_document_scene, name), d->scenes[i].name);
        add(p, AT(list, i, nkw_document_scene, roots), d->scenes[i].roots, d->scenes[i].root_count,
            sizeof *d->scenes[i].roots);
    }
}

int parcel_pack(parcel *to, const nkw_document *d)
{
    packer p = {to, 0, 0, NULL, 0, 0, 0, 0};
    memset(to, 0, sizeof *to);
    put(&p, d, sizeof *d);
    add_text(&p, IN(file), d->file);
    add_text(&p, IN(format), d->format);
    add_text(&p, IN(generator), d->generator);
    add_texts(&p, IN(warnings), d->warnings, d->warning_count);
    add_nodes(&p, d);
    add_skins(&p, d);
    add_meshes(&p, d);
    add_materials(&p, d);
    add_animations(&p, d);
    add_scenes(&p, d);
    free(p.table);
    return !p.failed;
}

void parcel_free(parcel *p)
{
    free(p->data);
    free(p->links);
    memset(p, 0, sizeof *p);
}

nkw_document *parcel_open(const parcel *p)
{
    if (p->bytes < sizeof(nkw_document))
        return NULL;
    for (size_t i = 0; i < p->link_count; i++) {
        size_t offset;
        if (p->links[i] > p->bytes - sizeof offset)
            return NULL;
        memcpy(&offset, p->data + p->links[i], sizeof offset);
        if (offset > p->bytes)
            return NULL;
        const void *to = p->data + offset;
        memcpy(p->data + p->links[i], &to, sizeof to);
    }
    return (nkw_document *)(void *)p->data;
}
