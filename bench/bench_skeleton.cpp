/* SPDX-License-Identifier: MIT */
/* Down and up the hierarchy. An element is a joint; the size is the number of joints of the one character. */
#include <memory>

#include "bench.h"
#include "from_trs.h"
#include "scene.h"
#include "views.h"
#include "../docs/examples/matrix_stack.h"

using namespace bench;

static const size_t most = 1000;

/* One character: parents, the tree of the same, local transforms in each form, and the model matrices in binary64. */
struct character {
    size_t joints;
    std::vector<int32_t> parents, first_child, next_sibling, stack;
    std::vector<nkw_trs> trs;
    std::vector<float> pose;
    array<nkw_mat4> locals, models;
    std::vector<double> truth;

    nkw_skeleton skeleton() const
    {
        return {parents.data(), joints};
    }
    size_t parent(size_t j) const
    {
        return static_cast<size_t>(parents[j]);
    }
};

static void draw_tree(character &c)
{
    c.first_child.assign(c.joints, NKW_NO_JOINT);
    c.next_sibling.assign(c.joints, NKW_NO_JOINT);
    c.stack.resize(c.joints);
    for (size_t j = c.joints; j-- > 1;) {
        int32_t &first = c.first_child[c.parent(j)];
        c.next_sibling[j] = first;
        first = static_cast<int32_t>(j);
    }
}

static std::shared_ptr<character> draw(size_t joints)
{
    auto c = std::make_shared<character>();
    c->joints = joints;
    c->parents = draw_parents(joints);
    c->pose.resize(NKW_POSE_FLOATS(joints));
    c->truth.resize(16 * joints);
    draw_tree(*c);
    for (size_t j = 0; j < joints; j++) {
        c->trs.push_back(local_at(j));
        c->locals.at[j] = nkw_mat4_from_trs(&c->trs[j]);
        double local[16], *model = &c->truth[16 * j];
        truth::matrix(c->trs[j], local);
        if (j == 0)
            std::copy_n(local, 16, model);
        else
            truth::product(&c->truth[16 * c->parent(j)], local, 4, model);
    }
    nkw_pose_from_trs(c->trs.data(), nkw_pose_span{c->pose.data(), joints});
    nkw_skeleton skeleton = c->skeleton();
    nkw_skeleton_models_from_pose(&skeleton, nkw_pose_view{c->pose.data(), skeleton.joint_count}, nullptr, nullptr,
                                  c->models.at);
    return c;
}

/* From `first` on: the reference of element i is the model matrix of joint first + i. */
static operation models_of(const char *name, std::shared_ptr<character> c, size_t first, double bytes, double flops)
{
    operation op = {"skeleton", name,
                    16,         bytes,
                    flops,      [=](size_t i, double *out) { std::copy_n(&c->truth[16 * (first + i)], 16, out); },
                    64};
    op.sizes = {c->joints};
    op.elements = c->joints - first;
    return op;
}

/* model[j] = model[parent] local(j) of the library M, for joints `from` on, into `out`; the root has no parent. */
template <class M, class Local, class Product>
static void down(const character &c, size_t from, nkw_mat4 *out, Local local, Product product)
{
    M *model = reinterpret_cast<M *>(out);
    for (size_t j = from; j < c.joints; j++)
        model[j] = c.parents[j] < 0 ? local(j) : product(model[c.parent(j)], local(j));
}

/* The rows of the peers, each with its own local matrices. */
template <class F> static void peers_down(const operation &op, std::shared_ptr<character> c, bool trs, F row)
{
    (void)op, (void)c, (void)trs, (void)row;
#ifdef BENCH_CGLM
    const cg::mat *cglm = as<cg::mat>(c->locals);
    auto cglm_product = [](const cg::mat &a, const cg::mat &b) {
        cg::mat m = a, n = b, r;
        glm_mul(m.m, n.m, r.m);
        return r;
    };
    row("cglm", [=](size_t from, nkw_mat4 *out) {
        trs ? down<cg::mat>(
                  *c, from, out, [&](size_t j) { return cglm_matrix(c->trs[j]); }, cglm_product)
            : down<cg::mat>(
                  *c, from, out, [&](size_t j) { return cglm[j]; }, cglm_product);
    });
#endif
#ifdef BENCH_GLM
    const glm::mat4 *glm = as<glm::mat4>(c->locals);
    auto glm_product = [](const glm::mat4 &a, const glm::mat4 &b) { return a * b; };
    row("glm", [=](size_t from, nkw_mat4 *out) {
        trs ? down<glm::mat4>(
                  *c, from, out, [&](size_t j) { return glm_matrix(c->trs[j]); }, glm_product)
            : down<glm::mat4>(
                  *c, from, out, [&](size_t j) { return glm[j]; }, glm_product);
    });
#endif
#ifdef BENCH_EIGEN
    const Eigen::Affine3f *eigen = as<Eigen::Affine3f>(c->locals);
    auto eigen_product = [](const Eigen::Affine3f &a, const Eigen::Affine3f &b) { return a * b; };
    row("Eigen", [=](size_t from, nkw_mat4 *out) {
        trs ? down<Eigen::Affine3f>(
                  *c, from, out, [&](size_t j) { return eigen_matrix(c->trs[j]); }, eigen_product)
            : down<Eigen::Affine3f>(
                  *c, from, out, [&](size_t j) { return eigen[j]; }, eigen_product);
    });
#endif
}

static nkw_mat4 product(const nkw_mat4 &a, const nkw_mat4 &b)
{
    return nkw_mat4_mul_affine(&a, &b);
}

static void local_to_model(std::shared_ptr<character> c)
{
    operation op = models_of("local to model", c, 0, 104, 100);
    auto row = [&](const char *who, auto f) { whole(op, who, layout::structs, [=] { f(size_t{0}, answer.at); }); };
    row("nkw", [=](size_t, nkw_mat4 *out) {
        nkw_skeleton s = c->skeleton();
        nkw_skeleton_models_from_pose(&s, nkw_pose_view{c->pose.data(), s.joint_count}, nullptr, nullptr, out);
    });
    row("nkw singles", [=](size_t from, nkw_mat4 *out) {
        down<nkw_mat4>(
            *c, from, out, [&](size_t j) { return nkw_mat4_from_trs(&c->trs[j]); }, product);
    });
    peers_down(op, c, true, row);
}

static void of_matrices(std::shared_ptr<character> c)
{
    operation op = models_of("local matrices to model", c, 0, 128, 63);
    auto row = [&](const char *who, auto f) { whole(op, who, layout::structs, [=] { f(size_t{0}, answer.at); }); };
    row("nkw", [=](size_t, nkw_mat4 *out) {
        nkw_skeleton s = c->skeleton();
        nkw_skeleton_models_from_locals(&s, c->locals.at, nullptr, nullptr, out);
    });
    /* The method of the D3DX days: made to be read, and slower. */
    row("nkw stack", [=](size_t, nkw_mat4 *out) {
        nkw_tree tree = {c->first_child.data(), c->next_sibling.data(), c->joints};
        matrix_stack_walk(&tree, c->locals.at, nullptr, STACK_COLUMN_VECTORS, c->stack.data(), c->stack.size(), out,
                          nullptr);
    });
    row("nkw singles", [=](size_t from, nkw_mat4 *out) {
        down<nkw_mat4>(
            *c, from, out, [&](size_t j) { return c->locals.at[j]; }, product);
    });
    peers_down(op, c, false, row);
}

/* The second half of the joints, in models where the first half stands. */
static void update(std::shared_ptr<character> c)
{
    size_t first = c->joints / 2;
    operation op = models_of("update of half", c, first, 104, 100);
    auto row = [&](const char *who, auto f) {
        whole(
            op, who, layout::structs, [=] { f(first, c->models.at); },
            [=] { std::copy(&c->models.at[first], &c->models.at[c->joints], answer.at); });
    };
    row("nkw", [=](size_t from, nkw_mat4 *out) {
        nkw_skeleton s = c->skeleton();
        update_models_from_pose(&s, c->pose.data(), nullptr, from, c->joints, out);
    });
    peers_down(op, c, true, row);
}

/* local[j] = inverse(model[parent]) model[j]; the reference is what the models were made of. */
template <class M, class Inverse> static void up(const character &c, Inverse inverse)
{
    const M *model = as<M>(c.models);
    M *out = reinterpret_cast<M *>(answer.at);
    for (size_t j = 0; j < c.joints; j++)
        out[j] = c.parents[j] < 0 ? model[j] : M(inverse(model[c.parent(j)]) * model[j]);
}

static void model_to_local(std::shared_ptr<character> c)
{
    operation op = {
        "skeleton", "model to local", 16, 192, 145, [=](size_t i, double *out) { truth::matrix(c->trs[i], out); }, 128};
    op.sizes = {c->joints};
    whole(op, "nkw", layout::structs, [=] {
        nkw_skeleton s = c->skeleton();
        nkw_skeleton_locals_from_models(&s, c->models.at, nullptr, answer.at);
    });
#ifdef BENCH_GLM
    whole(op, "glm", layout::structs,
          [=] { up<glm::mat4>(*c, [](const glm::mat4 &m) { return glm::affineInverse(m); }); });
#endif
#ifdef BENCH_EIGEN
    whole(op, "Eigen", layout::structs,
          [=] { up<Eigen::Affine3f>(*c, [](const Eigen::Affine3f &m) { return m.inverse(); }); });
#endif
}

#ifdef BENCH_GLM
/* Of a matrix without shear: the lengths of its columns, and the rotation of what remains. */
static nkw_trs decomposed(const glm::mat4 &m)
{
    glm::vec3 x(m[0]), y(m[1]), z(m[2]), s(glm::length(x), glm::length(y), glm::length(z));
    glm::quat q = glm::quat_cast(glm::mat3(x / s.x, y / s.y, z / s.z));
    return {{m[3].x, m[3].y, m[3].z}, {q.x, q.y, q.z, q.w}, {s.x, s.y, s.z}};
}
#endif

/* The local transforms of all model matrices, without residuals. */
static void model_to_pose(std::shared_ptr<character> c)
{
    size_t joints = c->joints, n = NKW_POSE_STRIDE(joints);
    reference truth = [=](size_t j, double *out) {
        for (size_t k = 0; k < 10; k++)
            out[k] = static_cast<double>((&c->trs[j].translation.x)[k]);
    };
    operation op = {"skeleton", "model to pose", 10, 168, 255, truth, 256, 4096, same::transform};
    op.sizes = {joints};
    auto pose = std::make_shared<std::vector<float>>(NKW_POSE_FLOATS(joints));
    auto run = [=] {
        nkw_skeleton s = c->skeleton();
        nkw_skeleton_pose_from_models(&s, c->models.at, nullptr, nkw_pose_span{pose->data(), joints}, nullptr);
    };
    whole(op, "nkw", layout::components, run, [=] {
        for (size_t k = 0; k < 10; k++)
            std::copy_n(pose->data() + k * n, joints, answer.part[k]);
    });
#ifdef BENCH_GLM
    whole(op, "glm", layout::structs, [=] {
        const glm::mat4 *model = as<glm::mat4>(c->models);
        nkw_trs *out = reinterpret_cast<nkw_trs *>(answer.at);
        for (size_t j = 0; j < joints; j++)
            out[j] = decomposed(c->parents[j] < 0 ? model[j] : glm::affineInverse(model[c->parent(j)]) * model[j]);
    });
#endif
}

static const suite all([] {
    for (size_t joints : {size_t{10}, size_t{67}, size_t{256}, most}) {
        auto c = draw(joints);
        local_to_model(c);
        of_matrices(c);
        update(c);
        model_to_local(c);
        model_to_pose(c);
    }
});
