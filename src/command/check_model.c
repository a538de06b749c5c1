/* SPDX-License-Identifier: MIT */
/* Nodes, skins and the influences of vertices. */
#include <math.h>
#include <string.h>

#include <nakawari/mat.h>

#include "check.h"

finding check_finding_at(severity level, const char *what, const char *object, const char *name, size_t number)
{
    finding f = finding_of(level, what);
    f.object = object;
    f.joint = name;
    f.number = (long)number;
    return f;
}

static void check_nodes(check *c)
{
    for (size_t n = 0; n < c->document->skeleton.joint_count; n++) {
        const nkw_document_node *node = &c->document->nodes[c->document->joint_of_node[n]];
        nkw_vec3 s = node->rest.scale;
        double least = fmin((double)s.x, fmin((double)s.y, (double)s.z));
        const severity level = least < 0.0 ? SEVERITY_WARNING : SEVERITY_NOTE;
        finding f = check_finding_at(level, "non-positive-scale", "node", node->name, node->number);
        f.amount = least;
        snprintf(f.detail, sizeof f.detail, "scale %.6g %.6g %.6g", (double)s.x, (double)s.y, (double)s.z);
        if (least <= 0.0)
            findings_add(&c->found, &f);
        double length = sqrt((double)node->rest.rotation.x * (double)node->rest.rotation.x +
                             (double)node->rest.rotation.y * (double)node->rest.rotation.y +
                             (double)node->rest.rotation.z * (double)node->rest.rotation.z +
                             (double)node->rest.rotation.w * (double)node->rest.rotation.w);
        f.level = SEVERITY_WARNING;
        f.what = "not-unit";
        f.amount = length;
        snprintf(f.detail, sizeof f.detail, "the length of its quaternion is %.6g", length);
        if (!(fabs(length - 1.0) <= 1e-3))
            findings_add(&c->found, &f);
    }
}

/* ---- skins ---- */

/* The fourth row of an inverse bind matrix, and its translation, in columns. */
static void check_affine(check *c, finding f, const nkw_mat4 *m)
{
    const double row = fmax(fabs((double)m->m[3]), fmax(fabs((double)m->m[7]), fabs((double)m->m[11])));
    const int moves = m->m[12] != 0.0f || m->m[13] != 0.0f || m->m[14] != 0.0f;
    const double corner = fabs((double)m->m[15] - 1.0);
    if (row <= 1e-5 && corner <= 1e-5)
        return;
    f.level = SEVERITY_ERROR;
    f.what = row > 1e-5 && !moves && corner <= 1e-5 ? "transposed-matrix" : "not-affine";
    f.amount = fmax(row, corner);
    const size_t used = strlen(f.detail);
    snprintf(f.detail + used, sizeof f.detail - used, ": its last row is %.6g %.6g %.6g %.6g, not 0 0 0 1",
             (double)m->m[3], (double)m->m[7], (double)m->m[11], (double)m->m[15]);
    findings_add(&c->found, &f);
}

static void check_skin(check *c, size_t index)
{
    const nkw_document_skin *skin = &c->document->skins[index];
    for (size_t i = 0; skin->inverse_bind && i < skin->joint_count; i++) {
        const nkw_mat4 *m = &skin->inverse_bind[i];
        finding f = check_finding_at(SEVERITY_ERROR, "not-finite", "skin", skin->name, index);
        int finite = 1;
        for (int e = 0; e < 16; e++)
            finite = finite && isfinite(m->m[e]);
        f.amount = (double)nkw_mat4_determinant(m);
        snprintf(f.detail, sizeof f.detail, "inverse bind matrix %zu of joint %s", i,
                 c->document->nodes[skin->joints[i]].name);
        if (!finite)
            findings_add(&c->found, &f);
        else
            check_affine(c, f, m);
        f.level = SEVERITY_WARNING;
        f.what = "singular-matrix";
        if (finite && f.amount == 0.0)
            findings_add(&c->found, &f);
    }
}

/* ---- vertices ---- */

/* Findings of one kind among the vertices of a primitive: the first vertex, the worst amount. */
typedef struct vertex_fault {
    size_t count, first;
    double worst, badness;
} vertex_fault;

static void note_fault(vertex_fault *fault, size_t vertex, double amount, double badness)
{
    if (!fault->count++)
        fault->first = vertex;
    if (fault->count == 1 || badness > fault->badness) {
        fault->worst = amount;
        fault->badness = badness;
    }
}

static void check_sums(const nkw_document_primitive *p, vertex_fault *sums, vertex_fault *negatives)
{
    for (size_t v = 0; v < p->vertex_count; v++) {
        const float *w = p->weights + v * p->influence_count;
        double sum = 0.0, least = 0.0;
        float bad = 0.0f;
        for (size_t i = 0; i < p->influence_count; i++) {
            const double weight = isfinite(w[i]) ? (double)w[i] : -INFINITY;
            sum += (double)w[i];
            bad = weight < least ? w[i] : bad;
            least = fmin(least, weight);
        }
        if (least < 0.0)
            note_fault(negatives, v, (double)bad, -least);
        else if (fabs(sum - 1.0) > 1e-3)
            note_fault(sums, v, sum, fabs(sum - 1.0));
    }
}

static void check_ranges(const nkw_document_primitive *p, size_t joint_count, vertex_fault *used, vertex_fault *unused)
{
    for (size_t i = 0; i < p->vertex_count * p->influence_count; i++)
        if (p->joints[i] >= joint_count)
            note_fault(p->weights[i] != 0.0f ? used : unused, i / p->influence_count, (double)p->joints[i],
                       (double)p->joints[i]);
}

static void add_fault(check *c, finding f, const vertex_fault *fault, size_t primitive, const char *text)
{
    if (!fault->count)
        return;
    f.vertex = (long)fault->first;
    f.amount = fault->worst;
    snprintf(f.detail, sizeof f.detail, "primitive %zu, %zu %s: %s, the worst %.6g", primitive,
             COUNT(fault->count, "vertex", "vertices"), text, fault->worst);
    findings_add(&c->found, &f);
}

static void check_primitive(check *c, const nkw_document_node *node, size_t index)
{
    const nkw_document_mesh *mesh = &c->document->meshes[node->mesh];
    const nkw_document_primitive *p = &mesh->primitives[index];
    vertex_fault sums = {0, 0, 0.0, 0.0}, negatives = sums, used = sums, unused = sums;
    if (node->skin < 0 || !p->influence_count)
        return;
    check_sums(p, &sums, &negatives);
    check_ranges(p, c->document->skins[node->skin].joint_count, &used, &unused);
    finding f = check_finding_at(SEVERITY_WARNING, "weights-sum", "mesh", mesh->name, (size_t)node->mesh);
    add_fault(c, f, &sums, index, "weights do not sum to 1");
    f.what = "unused-joint-out-of-range";
    add_fault(c, f, &unused, index, "a joint of weight 0 is not in the skin");
    f.level = SEVERITY_ERROR;
    f.what = "bad-weight";
    add_fault(c, f, &negatives, index, "a weight is negative or not finite");
    f.what = "joint-out-of-range";
    add_fault(c, f, &used, index, "a joint is not in the skin");
}

void check_model(check *c)
{
    const nkw_document *d = c->document;
    check_nodes(c);
    for (size_t s = 0; s < d->skin_count; s++)
        check_skin(c, s);
    for (size_t n = 0; n < d->skeleton.joint_count; n++) {
        const nkw_document_node *node = &d->nodes[d->joint_of_node[n]];
        for (size_t p = 0; node->mesh >= 0 && p < d->meshes[node->mesh].primitive_count; p++)
            check_primitive(c, node, p);
    }
}
