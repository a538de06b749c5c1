/* SPDX-License-Identifier: MIT */
/*
 * Poses of records, beside the same of component arrays and beside a plain loop over records. An element is a joint.
 * The poses are two frames of a character: a clip of 67 joints, 67 of whose 201 tracks keep one value.
 */
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench.h"
#include "scene.h"
#include "truth.h"

using namespace bench;

namespace
{

constexpr size_t joints = 67;
constexpr float weight = 0.3f;

struct frames {
    std::shared_ptr<scene> play;
    std::vector<nkw_trs> a, b, out;
    std::vector<float> arrays[3], mask, work;

    frames() : play(draw_scene(joints, 301, NKW_INTERPOLATION_LINEAR, 3)), a(joints), b(joints), out(joints)
    {
        for (auto &block : arrays)
            block.resize(NKW_POSE_FLOATS(joints));
        for (size_t k = 0; k < 2; k++) {
            const float time = play->times.back() * (k == 0 ? 0.321f : 0.4f);
            nkw_clip_sample(play->clip(0), time, nullptr, {arrays[k].data(), joints}, nullptr);
            nkw_trs_from_pose({arrays[k].data(), joints}, (k == 0 ? a : b).data());
        }
        mask.assign(t.at, t.at + NKW_POSE_STRIDE(joints));
        work.resize(NKW_CLIP_RECORDS_WORK(joints) / sizeof(float));
    }
    nkw_pose_view pose(size_t k) const
    {
        return {arrays[k].data(), joints};
    }
};

operation operation_of(const char *name, double bytes, double flops, reference truth)
{
    operation op = {"records", name, 10, bytes, flops, truth, 8, 4096, same::transform};
    op.sizes = {joints};
    op.elements = joints;
    return op;
}

template <class F> void of_records(const operation &op, const char *who, std::shared_ptr<frames> f, F run)
{
    whole(
        op, who, layout::structs, [=] { run(f->out.data()); },
        [=] { std::copy(f->out.begin(), f->out.end(), reinterpret_cast<nkw_trs *>(answer.at)); });
}

template <class F> void of_arrays(const operation &op, std::shared_ptr<frames> f, F run)
{
    whole(
        op, "nkw arrays", layout::components, [=] { run(f->arrays[2].data()); },
        [=] {
            for (size_t j = 0; j < joints; j++)
                for (size_t c = 0; c < 10; c++)
                    answer.part[c][j] = f->arrays[2][c * NKW_POSE_STRIDE(joints) + j];
        });
}

/* As many engines write it. */
nkw_trs loop_blend(const nkw_trs &a, const nkw_trs &b, float s)
{
    const nkw_quat p = a.rotation, q = b.rotation;
    const float u = p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w < 0 ? -s : s, r = 1 - s;
    const nkw_quat n = {r * p.x + u * q.x, r * p.y + u * q.y, r * p.z + u * q.z, r * p.w + u * q.w};
    const float by = 1 / sqrtf(n.x * n.x + n.y * n.y + n.z * n.z + n.w * n.w);
    const nkw_vec3 &c = a.translation, &d = b.translation, &e = a.scale, &f = b.scale;
    return {{r * c.x + s * d.x, r * c.y + s * d.y, r * c.z + s * d.z},
            {n.x * by, n.y * by, n.z * by, n.w * by},
            {r * e.x + s * f.x, r * e.y + s * f.y, r * e.z + s * f.z}};
}

void blends(std::shared_ptr<frames> f, bool masked)
{
    const float *mask = masked ? f->mask.data() : nullptr;
    auto at = [=](size_t j) { return mask ? weight * mask[j] : weight; };
    const operation op =
        operation_of(masked ? "two, masked" : "two", masked ? 124 : 120, 67, [=](size_t j, double *out) {
            const nkw_trs &a = f->a[j], &b = f->b[j];
            const double s = static_cast<double>(at(j));
            for (size_t c : {0u, 1u, 2u, 7u, 8u, 9u}) {
                const double x = static_cast<double>((&a.translation.x)[c]);
                out[c] = x + s * (static_cast<double>((&b.translation.x)[c]) - x);
            }
            truth::nlerp(truth::quat(a.rotation), truth::quat(b.rotation), s).put(out + 3);
        });
    of_records(op, "nkw", f, [=](nkw_trs *out) {
        nkw_records_blend({f->a.data(), joints}, {f->b.data(), joints}, weight, {mask, joints}, {out, joints});
    });
    of_arrays(op, f, [=](float *out) {
        nkw_pose_blend(f->pose(0), f->pose(1), weight, {mask, joints}, {out, joints});
    });
    of_records(op, "loop", f, [=](nkw_trs *out) {
        for (size_t j = 0; j < joints; j++)
            out[j] = loop_blend(f->a[j], f->b[j], at(j));
    });
}

/* The loop converts a pose of component arrays number by number. */
void samples(std::shared_ptr<frames> f)
{
    const float time = 0.321f * f->play->times.back();
    const operation op = operation_of("sample", 80, 67, [=](size_t j, double *out) {
        for (size_t c = 0; c < 10; c++)
            out[c] = static_cast<double>((&f->a[j].translation.x)[c]);
    });
    of_records(op, "nkw", f, [=](nkw_trs *out) {
        nkw_clip_sample_records(f->play->clip(0), time, f->play->cursors.data(), {out, joints}, nullptr,
                                {f->work.data(), f->work.size() * sizeof(float)});
    });
    of_arrays(op, f, [=](float *out) {
        nkw_clip_sample(f->play->clip(0), time, f->play->cursors.data(), {out, joints}, nullptr);
    });
    of_records(op, "loop", f, [=](nkw_trs *out) {
        nkw_clip_sample(f->play->clip(0), time, f->play->cursors.data(), {f->work.data(), joints}, nullptr);
        for (size_t j = 0; j < joints; j++)
            for (size_t c = 0; c < 10; c++)
                (&out[j].translation.x)[c] = f->work[c * NKW_POSE_STRIDE(joints) + j];
    });
}

const suite all([] {
    auto f = std::make_shared<frames>();
    blends(f, false);
    blends(f, true);
    samples(f);
});

} // namespace
