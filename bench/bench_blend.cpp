/* SPDX-License-Identifier: MIT */
/*
 * Poses blended: the shorter arc, unit rotations. An element is a joint. Peers have arrays of transforms, as those who
 * use them do.
 */
#include <cmath>
#include <memory>

#include "bench.h"
#include "from_trs.h"
#include "random.h"

#ifdef BENCH_IMPORT
#include <nakawari/import.h>
#endif

using namespace bench;

static const size_t most = 8;
static const float weight = 0.3f;

/*
 * apart        every number differs: the poses are within some 30 degrees of one another, half of the rotations with the
 *              other sign
 * even         the same, all of one weight
 * one_model    as two clips of one model: a third of the rotations is the same in all poses, a fifth the identity, only
 *              the root moves, and scales are 1. The mask is 0 below the waist and 1 above.
 */
enum class kind { apart, even, one_model };

struct poses {
    kind of;
    std::string suffix; /* of the names of operations */
    size_t joints;
    std::vector<nkw_trs> trs[most];
    std::vector<float> block[most], mask;
    nkw_pose_layer layers[most];
    float weights[most];
};

/* Blocks, layers and weights of the transforms. */
static void fill(poses &p)
{
    for (size_t k = 0; k < most; k++) {
        p.block[k].resize(NKW_POSE_FLOATS(p.joints));
        nkw_pose_from_trs(p.trs[k].data(), nkw_pose_span{p.block[k].data(), p.joints});
        p.weights[k] = p.of == kind::even ? 0.25f : 0.5f - 0.05f * static_cast<float>(k);
        p.layers[k] = {{p.block[k].data(), p.joints}, p.weights[k], {nullptr, 0}};
    }
}

static std::vector<float> half_mask(size_t joints)
{
    std::vector<float> mask(NKW_POSE_STRIDE(joints));
    std::fill(mask.begin() + static_cast<std::ptrdiff_t>(joints / 2), mask.end(), 1.0f);
    return mask;
}

/* What clips of one model share with its first pose. */
static void share(const poses &p, size_t k, size_t j, nkw_trs &trs)
{
    const nkw_quat still = {0, 0, 0, 1};
    const nkw_trs &first = k == 0 ? trs : p.trs[0][j];
    trs.scale = {1, 1, 1};
    trs.translation = j == 0 ? trs.translation : first.translation;
    trs.rotation = j % 5 == 1 ? still : j % 3 == 0 ? first.rotation : trs.rotation;
}

static std::shared_ptr<poses> draw(size_t joints, kind of)
{
    auto p = std::make_shared<poses>();
    p->of = of;
    p->suffix = of == kind::one_model ? ", one model" : of == kind::even ? " of one weight" : "";
    p->joints = joints;
    p->mask.assign(t.at, t.at + NKW_POSE_STRIDE(joints));
    if (of == kind::one_model)
        p->mask = half_mask(joints);
    for (size_t k = 0; k < most; k++) {
        random_source r = random_from(k);
        for (size_t j = 0; j < joints; j++) {
            nkw_quat q = random_near(&r, unit_a[j], random_between(&r, 0.01f, 0.25f));
            float sign = random_unit(&r) < 0.5f ? -1.0f : 1.0f;
            nkw_trs trs = {
                random_vec3(&r, -1, 1), {sign * q.x, sign * q.y, sign * q.z, sign * q.w}, random_vec3(&r, 0.9f, 1.1f)};
            if (of == kind::one_model)
                share(*p, k, j, trs);
            p->trs[k].push_back(trs);
        }
    }
    fill(*p);
    return p;
}

#ifdef BENCH_IMPORT
/* Poses of a file, from its first and its last animation in turn; empty where there is no such file. */
static std::shared_ptr<poses> read(const char *folder, const char *name)
{
    auto p = std::make_shared<poses>();
    nkw_document *d = nullptr;
    nkw_import_error error;
    if (nkw_document_open((std::string(folder) + "/" + name).c_str(), &d, &error) != NKW_IMPORT_OK)
        return nullptr;
    p->of = kind::one_model;
    p->suffix = std::string(", ") + name;
    p->joints = d->skeleton.joint_count;
    p->mask = half_mask(p->joints);
    for (size_t k = 0; k < most; k++) {
        nkw_clip *clip = nullptr;
        if (nkw_document_clip(d, k % 2 ? d->animation_count - 1 : 0, NKW_CLIP_FLOAT32, &clip, &error) != NKW_IMPORT_OK)
            std::abort();
        std::vector<float> block(NKW_POSE_FLOATS(p->joints)), floats(nkw_clip_describe(clip).float_count + 1);
        float start = nkw_clip_describe(clip).start, part = 0.1f + 0.11f * static_cast<float>(k);
        nkw_clip_sample(clip, start + part * (nkw_clip_describe(clip).end - start), nullptr, {block.data(), p->joints},
                        floats.data());
        p->trs[k].resize(p->joints);
        nkw_trs_from_pose({block.data(), p->joints}, p->trs[k].data());
        nkw_import_free(clip);
    }
    nkw_document_close(d);
    fill(*p);
    return p;
}
#endif

static operation blend_of(const std::string &name, size_t joints, double bytes, double flops, reference truth)
{
    operation op = {"blend", name, 10, bytes, flops, truth, 8, 4096, same::transform};
    op.sizes = {joints};
    op.elements = joints; /* masks differ between sizes */
    return op;
}

/* A pose block to the answer. */
static void spread(const std::vector<float> &block, size_t joints)
{
    for (size_t j = 0; j < joints; j++)
        for (size_t c = 0; c < 10; c++)
            answer.part[c][j] = block[c * NKW_POSE_STRIDE(joints) + j];
}

template <class F> static void own(const operation &op, const char *who, F f)
{
    size_t joints = op.sizes[0];
    auto out = std::make_shared<std::vector<float>>(NKW_POSE_FLOATS(joints));
    whole(
        op, who, layout::components, [=] { f(out->data()); }, [=] { spread(*out, joints); });
}

/* f(j) gives the transform of joint j. */
template <class F> static void peer(const operation &op, const char *who, F f)
{
    size_t joints = op.sizes[0];
    whole(op, who, layout::structs, [=] {
        nkw_trs *out = reinterpret_cast<nkw_trs *>(answer.at);
        for (size_t j = 0; j < joints; j++)
            out[j] = f(j);
    });
}

/* ---- two ---- */

static void lerps(const nkw_trs &a, const nkw_trs &b, double s, double *out)
{
    for (size_t c : {0u, 1u, 2u, 7u, 8u, 9u}) {
        double x = static_cast<double>((&a.translation.x)[c]), y = static_cast<double>((&b.translation.x)[c]);
        out[c] = x + s * (y - x);
    }
}

#ifdef BENCH_GLM
static glm::vec3 glm_vec(nkw_vec3 v)
{
    return {v.x, v.y, v.z};
}

static glm::quat glm_quaternion(nkw_quat q)
{
    return {q.w, q.x, q.y, q.z};
}

static nkw_trs glm_trs(const glm::vec3 &p, const glm::quat &q, const glm::vec3 &s)
{
    return {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}, {s.x, s.y, s.z}};
}

static glm::quat glm_nlerp(const glm::quat &a, const glm::quat &b, float s)
{
    return glm::normalize(a * (1 - s) + b * (glm::dot(a, b) < 0 ? -s : s));
}

static nkw_trs glm_blend(const nkw_trs &a, const nkw_trs &b, float s)
{
    return glm_trs(glm::mix(glm_vec(a.translation), glm_vec(b.translation), s),
                   glm_nlerp(glm_quaternion(a.rotation), glm_quaternion(b.rotation), s),
                   glm::mix(glm_vec(a.scale), glm_vec(b.scale), s));
}

static nkw_trs glm_blend_slerp(const nkw_trs &a, const nkw_trs &b, float s)
{
    return glm_trs(glm::mix(glm_vec(a.translation), glm_vec(b.translation), s),
                   glm::slerp(glm_quaternion(a.rotation), glm_quaternion(b.rotation), s),
                   glm::mix(glm_vec(a.scale), glm_vec(b.scale), s));
}
#endif

#ifdef BENCH_CGLM
static nkw_trs cglm_blend(nkw_trs a, nkw_trs b, float s)
{
    nkw_trs out;
    cg::quat p, q, r;
    glm_vec3_lerp(&a.translation.x, &b.translation.x, s, &out.translation.x);
    memcpy(p.v, &a.rotation, sizeof p.v);
    memcpy(q.v, &b.rotation, sizeof q.v);
    glm_quat_nlerp(p.v, q.v, s, r.v);
    memcpy(&out.rotation, r.v, sizeof out.rotation);
    glm_vec3_lerp(&a.scale.x, &b.scale.x, s, &out.scale.x);
    return out;
}
#endif

#ifdef BENCH_EIGEN
static nkw_trs eigen_blend(const nkw_trs &a, const nkw_trs &b, float s)
{
    using vec = Eigen::Map<const Eigen::Vector3f>;
    using quat = Eigen::Map<const Eigen::Vector4f>;
    nkw_trs out;
    quat p(&a.rotation.x), q(&b.rotation.x);
    Eigen::Map<Eigen::Vector3f>(&out.translation.x) = (1 - s) * vec(&a.translation.x) + s * vec(&b.translation.x);
    Eigen::Map<Eigen::Vector4f>(&out.rotation.x) = ((1 - s) * p + (p.dot(q) < 0 ? -s : s) * q).normalized();
    Eigen::Map<Eigen::Vector3f>(&out.scale.x) = (1 - s) * vec(&a.scale.x) + s * vec(&b.scale.x);
    return out;
}
#endif

/* The same arrays as the library's, in a loop of the user's own. */
static void loop_blend(const poses &p, bool masked, float part, float *out)
{
    size_t n = NKW_POSE_STRIDE(p.joints);
    const float *a = p.block[0].data(), *b = p.block[1].data();
    for (size_t j = 0; j < p.joints; j++) {
        float s = masked ? part * p.mask[j] : part, c = 0, length = 0;
        for (size_t k = 3; k < 7; k++)
            c += a[k * n + j] * b[k * n + j];
        for (size_t k = 0; k < 10; k++) {
            float y = 3 <= k && k < 7 && c < 0 ? -b[k * n + j] : b[k * n + j];
            float v = (1 - s) * a[k * n + j] + s * y;
            length += 3 <= k && k < 7 ? v * v : 0;
            out[k * n + j] = v;
        }
        for (size_t k = 3; k < 7; k++)
            out[k * n + j] /= sqrtf(length);
    }
}

static void two(std::shared_ptr<poses> p, bool masked)
{
    const float part = masked && p->of == kind::one_model ? 1.0f : weight;
    auto at = [=](size_t j) { return masked ? part * p->mask[j] : part; };
    const nkw_trs *a = p->trs[0].data(), *b = p->trs[1].data();
    operation op = blend_of((masked ? "two, masked" : "two") + p->suffix, p->joints, masked ? 124 : 120, 67,
                            [=](size_t j, double *out) {
                                double s = static_cast<double>(at(j));
                                lerps(a[j], b[j], s, out);
                                truth::nlerp(truth::quat(a[j].rotation), truth::quat(b[j].rotation), s).put(out + 3);
                            });
    const float *mask = masked ? p->mask.data() : nullptr;
    own(op, "nkw", [=](float *out) {
        nkw_pose_blend(nkw_pose_view{p->block[0].data(), p->joints}, nkw_pose_view{p->block[1].data(), p->joints}, part,
                       nkw_mask_view{mask, p->joints}, nkw_pose_span{out, p->joints});
    });
    size_t joints = p->joints;
    auto out = std::make_shared<std::vector<float>>(NKW_POSE_FLOATS(joints));
    whole(
        op, "loop", layout::components, [=] { loop_blend(*p, masked, part, out->data()); },
        [=] { spread(*out, joints); });
#ifdef BENCH_CGLM
    peer(op, "cglm", [=](size_t j) { return cglm_blend(a[j], b[j], at(j)); });
#endif
#ifdef BENCH_GLM
    peer(op, "glm", [=](size_t j) { return glm_blend(a[j], b[j], at(j)); });
#endif
#ifdef BENCH_EIGEN
    peer(op, "Eigen", [=](size_t j) { return eigen_blend(a[j], b[j], at(j)); });
#endif
}

static void two_by_slerp(std::shared_ptr<poses> p)
{
    const nkw_trs *a = p->trs[0].data(), *b = p->trs[1].data();
    operation op = blend_of("two by slerp" + p->suffix, p->joints, 120, 108, [=](size_t j, double *out) {
        double s = static_cast<double>(weight);
        lerps(a[j], b[j], s, out);
        truth::slerp(truth::unit(truth::quat(a[j].rotation)), truth::unit(truth::quat(b[j].rotation)), s).put(out + 3);
    });
    own(op, "nkw", [=](float *out) {
        nkw_pose_blend_slerp(nkw_pose_view{p->block[0].data(), p->joints}, nkw_pose_view{p->block[1].data(), p->joints},
                             weight, nkw_mask_view{nullptr, p->joints}, nkw_pose_span{out, p->joints});
    });
#ifdef BENCH_GLM
    peer(op, "glm", [=](size_t j) { return glm_blend_slerp(a[j], b[j], weight); });
#endif
}

/* ---- many ---- */

static void truth_of_many(const poses &p, size_t count, size_t j, double *out)
{
    double total = 0, sum[10] = {0};
    truth::quat first(p.trs[0][j].rotation);
    for (size_t k = 0; k < count; k++) {
        const nkw_trs &trs = p.trs[k][j];
        double w = static_cast<double>(p.weights[k]), sign = truth::dot(first, truth::quat(trs.rotation)) < 0 ? -1 : 1;
        total += w;
        for (size_t c = 0; c < 10; c++)
            sum[c] += (3 <= c && c < 7 ? sign : 1) * w * static_cast<double>((&trs.translation.x)[c]);
    }
    truth::unit(truth::quat(sum[3], sum[4], sum[5], sum[6])).put(out + 3);
    for (size_t c : {0u, 1u, 2u, 7u, 8u, 9u})
        out[c] = sum[c] / total;
}

static void many(std::shared_ptr<poses> p, size_t count, const std::string &name)
{
    double n = static_cast<double>(count);
    operation op = blend_of(name + p->suffix, p->joints, 40 + 40 * n, 30 * n + 20,
                            [=](size_t j, double *out) { truth_of_many(*p, count, j, out); });
    own(op, "nkw", [=](float *out) {
        nkw_pose_layers_blend(p->layers, count, nkw_pose_view{p->block[0].data(), p->joints}, 0.1f,
                              nkw_pose_span{out, p->joints});
    });
#ifdef BENCH_GLM
    peer(op, "glm", [=](size_t j) {
        glm::vec3 at(0.0f), scale(0.0f);
        glm::quat first = glm_quaternion(p->trs[0][j].rotation), sum(0.0f, 0.0f, 0.0f, 0.0f);
        float total = 0;
        for (size_t k = 0; k < count; k++) {
            const nkw_trs &trs = p->trs[k][j];
            glm::quat q = glm_quaternion(trs.rotation);
            float w = p->weights[k];
            at += w * glm_vec(trs.translation);
            scale += w * glm_vec(trs.scale);
            sum = sum + q * (glm::dot(first, q) < 0 ? -w : w);
            total += w;
        }
        return glm_trs(at / total, glm::normalize(sum), scale / total);
    });
#endif
}

/* ---- on top ---- */

static void additive(std::shared_ptr<poses> p)
{
    const nkw_trs *base = p->trs[0].data();
    auto delta = std::make_shared<std::vector<float>>(NKW_POSE_FLOATS(p->joints));
    auto d = std::make_shared<std::vector<nkw_trs>>(p->joints);
    nkw_pose_additive_build(nkw_pose_view{p->block[1].data(), p->joints}, nkw_pose_view{p->block[2].data(), p->joints},
                            NKW_ADDITIVE_LOCAL, nkw_pose_span{delta->data(), p->joints});
    nkw_trs_from_pose(nkw_pose_view{delta->data(), p->joints}, d->data());
    operation op = blend_of("additive apply" + p->suffix, p->joints, 120, 80, [=](size_t j, double *out) {
        double s = static_cast<double>(weight);
        const nkw_trs &a = base[j], &b = (*d)[j];
        truth::quat part = truth::nlerp(truth::quat(0, 0, 0, 1), truth::quat(b.rotation), s);
        for (size_t c = 0; c < 3; c++) {
            double at = static_cast<double>((&a.translation.x)[c]), scale = static_cast<double>((&a.scale.x)[c]);
            out[c] = at + s * static_cast<double>((&b.translation.x)[c]);
            out[7 + c] = scale * (1 + s * (static_cast<double>((&b.scale.x)[c]) - 1));
        }
        truth::mul(truth::quat(a.rotation), part).put(out + 3);
    });
    own(op, "nkw", [=](float *out) {
        nkw_pose_additive_apply(nkw_pose_view{p->block[0].data(), p->joints}, nkw_pose_view{delta->data(), p->joints},
                                weight, nkw_mask_view{nullptr, p->joints}, NKW_ADDITIVE_LOCAL,
                                nkw_pose_span{out, p->joints});
    });
#ifdef BENCH_GLM
    peer(op, "glm", [=](size_t j) {
        const nkw_trs &a = base[j], &b = (*d)[j];
        glm::quat part = glm_nlerp(glm::quat(1, 0, 0, 0), glm_quaternion(b.rotation), weight);
        return glm_trs(glm_vec(a.translation) + weight * glm_vec(b.translation), glm_quaternion(a.rotation) * part,
                       glm_vec(a.scale) * glm::mix(glm::vec3(1.0f), glm_vec(b.scale), weight));
    });
#endif
}

static void rows(std::shared_ptr<poses> p)
{
    two(p, false);
    two(p, true);
    two_by_slerp(p);
    many(p, 4, "four");
    many(p, 8, "eight");
    additive(p);
}

static const suite all([] {
    for (size_t joints : {10u, 67u, 256u, 1000u}) {
        rows(draw(joints, kind::apart));
        many(draw(joints, kind::even), 4, "four");
        rows(draw(joints, kind::one_model));
    }
#ifdef BENCH_IMPORT
    for (auto p : {read(BENCH_EXAMPLES, "character.glb"), read(BENCH_DATA, "Fox.glb")})
        if (p)
            rows(p);
#endif
});
