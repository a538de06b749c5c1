/* SPDX-License-Identifier: MIT */
/*
 * Transitions of poses, evaluated 0.1 s after they began. An element is a joint. The loops are the formulas joint by
 * joint, over structs, with the C library.
 */
#include <cmath>
#include <memory>

#include "bench.h"
#include "random.h"
#include "textbook.h"

using namespace bench;
using textbook::quat;
using textbook::vec;

static const float when = 0.1f, duration = 0.4f, half_life = 0.15f;

/* The last pose of the old motion, its velocities, and the new pose: rotations up to 60 degrees apart. */
struct motions {
    size_t joints;
    std::vector<nkw_trs> old, now;
    std::vector<nkw_vec3> velocity[3], offset[3]; /* of translation, rotation and scale */
    std::vector<float> to, inertia, dead;
    nkw_pose_dead_blend blend()
    {
        return {dead.data(), joints, half_life, duration};
    }
};

/* The same for every count of joints. */
static void draw_joint(motions *m, random_source *r, size_t j)
{
    nkw_quat near = random_near(r, unit_a[j], random_between(r, 0.01f, 0.5f));
    nkw_trs a = {point[0][j], unit_a[j], random_vec3(r, 0.9f, 1.1f)}, b = {point[1][j], near, {1, 1, 1}};
    m->old.push_back(a), m->now.push_back(b);
    for (std::vector<nkw_vec3> &v : m->velocity)
        v.push_back(random_vec3(r, -1, 1));
    m->offset[0].push_back(to(vec<float>(a.translation) - vec<float>(b.translation)));
    m->offset[1].push_back(to(textbook::log(quat<float>(a.rotation) * conjugate(quat<float>(b.rotation)))));
    m->offset[2].push_back(to(vec<float>(a.scale) - vec<float>(b.scale)));
}

static std::shared_ptr<motions> draw(size_t joints)
{
    auto m = std::make_shared<motions>();
    random_source r = random_from(2);
    size_t n = NKW_POSE_STRIDE(joints);
    std::vector<float> from(10 * n), velocity(9 * n);
    m->joints = joints, m->to.resize(10 * n), m->inertia.resize(30 * n), m->dead.resize(23 * n);
    for (size_t j = 0; j < joints; j++) {
        draw_joint(m.get(), &r, j);
        for (size_t k = 0; k < 9; k++)
            velocity[k * n + j] = (&m->velocity[k / 3][j].x)[k % 3];
    }
    nkw_pose_from_trs(m->old.data(), nkw_pose_span{from.data(), joints});
    nkw_pose_from_trs(m->now.data(), nkw_pose_span{m->to.data(), joints});
    nkw_pose_state moving = {{from.data(), joints}, {velocity.data(), joints}}, still = moving;
    nkw_pose_state target = {{m->to.data(), joints}, {nullptr, joints}};
    still.velocity.data = nullptr;
    nkw_pose_inertia_begin(nkw_pose_inertia{m->inertia.data(), joints}, &still, &target, duration);
    auto blend = m->blend();
    nkw_pose_dead_blend_begin(&blend, &moving);
    return m;
}

template <class T> struct joint {
    vec<T> at;
    quat<T> rotation;
    vec<T> scale;
};

/* Both motions at rest at the beginning: offset(u) = x (1 - u)^3 (1 + 3 u + 6 u^2). */
template <class T> static joint<T> inertia_at(const motions &m, size_t j)
{
    T u = static_cast<T>(when) / static_cast<T>(duration), r = 1 - u, f = r * r * r * (1 + u * (3 + 6 * u));
    const nkw_trs &b = m.now[j];
    return {vec<T>(b.translation) + f * vec<T>(m.offset[0][j]),
            textbook::exp(f * vec<T>(m.offset[1][j])) * quat<T>(b.rotation),
            vec<T>(b.scale) + f * vec<T>(m.offset[2][j])};
}

template <class T> static joint<T> dead_at(const motions &m, size_t j)
{
    T u = static_cast<T>(when) / static_cast<T>(duration), s = u * u * (3 - 2 * u), h = static_cast<T>(half_life);
    T k = h / std::log(static_cast<T>(2)) * (1 - std::exp2(-static_cast<T>(when) / h));
    const nkw_trs &a = m.old[j], &b = m.now[j];
    auto mixed = [=](vec<T> x, vec<T> v, vec<T> y) { return (1 - s) * (x + k * v) + s * y; };
    quat<T> old = textbook::exp(k / 2 * vec<T>(m.velocity[1][j])) * quat<T>(a.rotation), now(b.rotation);
    vec<T> half = textbook::log(old * conjugate(now));
    return {mixed(vec<T>(a.translation), vec<T>(m.velocity[0][j]), vec<T>(b.translation)),
            textbook::exp((1 - s) * half) * now, mixed(vec<T>(a.scale), vec<T>(m.velocity[2][j]), vec<T>(b.scale))};
}

template <class F, class G, class H>
static void rows(const char *name, std::shared_ptr<motions> m, double bytes, double flops, F own, G loop, H exact)
{
    size_t joints = m->joints, n = NKW_POSE_STRIDE(joints);
    reference truth = [=](size_t j, double *out) {
        joint<double> x = exact(*m, j);
        put(x.at, out), put(unit(x.rotation), out + 3), put(x.scale, out + 7);
    };
    operation op = {"transition", name, 10, bytes, flops, truth, 8, 4096, same::transform};
    op.sizes = {joints};
    auto out = std::make_shared<std::vector<float>>(NKW_POSE_FLOATS(joints));
    auto run = [=] { own(*m, nkw_pose_view{m->to.data(), joints}, nkw_pose_span{out->data(), joints}); };
    whole(op, "nkw", layout::components, run, [=] {
        for (size_t k = 0; k < 10; k++)
            std::copy_n(out->data() + k * n, joints, answer.part[k]);
    });
    whole(op, "loop", layout::structs, [=] {
        nkw_trs *to_trs = reinterpret_cast<nkw_trs *>(answer.at);
        for (size_t j = 0; j < joints; j++) {
            joint<float> x = loop(*m, j);
            to_trs[j] = {to(x.at), to(x.rotation), to(x.scale)};
        }
    });
}

static void own_inertia(motions &m, nkw_pose_view to, nkw_pose_span out)
{
    nkw_pose_inertia_evaluate(nkw_pose_inertia{m.inertia.data(), m.joints}, to, when, out);
}

static void own_dead(motions &m, nkw_pose_view to, nkw_pose_span out)
{
    const auto blend = m.blend();
    nkw_pose_dead_blend_evaluate(&blend, to, when, out);
}

static const suite all([] {
    for (size_t joints : {10u, 67u, 256u, 1000u}) {
        auto m = draw(joints);
        rows("inertialisation", m, 200, 90, own_inertia, inertia_at<float>, inertia_at<double>);
        rows("dead blending", m, 188, 210, own_dead, dead_at<float>, dead_at<double>);
    }
});
