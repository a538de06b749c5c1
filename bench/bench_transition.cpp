/* SPDX-License-Identifier: MIT */
/*
 * Transitions of poses that begin, and evaluated 0.1 s after they began. An element is a joint. The loops are the formulas joint by
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
    std::vector<nkw_vec3> velocity[3], next[3], offset[3]; /* of translation, rotation and scale */
    std::vector<float> from, moving, to, moving_to, inertia, begun, dead;
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
    for (std::vector<nkw_vec3> &v : m->next)
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
    m->joints = joints, m->from.resize(10 * n), m->moving.resize(9 * n), m->to.resize(10 * n);
    m->moving_to.resize(9 * n), m->inertia.resize(30 * n), m->begun.resize(30 * n), m->dead.resize(23 * n);
    for (size_t j = 0; j < joints; j++) {
        draw_joint(m.get(), &r, j);
        for (size_t k = 0; k < 9; k++) {
            m->moving[k * n + j] = (&m->velocity[k / 3][j].x)[k % 3];
            m->moving_to[k * n + j] = (&m->next[k / 3][j].x)[k % 3];
        }
    }
    nkw_pose_from_trs(m->old.data(), nkw_pose_span{m->from.data(), joints});
    nkw_pose_from_trs(m->now.data(), nkw_pose_span{m->to.data(), joints});
    nkw_pose_state moving = {{m->from.data(), joints}, {m->moving.data(), joints}}, still = moving;
    nkw_pose_state target = {{m->to.data(), joints}, {nullptr, joints}};
    still.velocity.data = nullptr;
    nkw_pose_inertia_begin(nkw_pose_inertia{m->inertia.data(), joints}, &still, &target, duration);
    auto blend = m->blend();
    nkw_pose_dead_blend_begin(&blend, &moving);
    return m;
}

/* The offset that begins with x of the rate v: its coefficients, and its end. */
template <class T> struct begun {
    vec<T> c0, c1, c2;
    T end;
};

template <class T> static begun<T> begun_of(vec<T> x, vec<T> v)
{
    T xx = dot(x, x), growth = xx > 0 ? dot(x, v) / xx : 0, end = static_cast<T>(duration);
    end = growth * end < -5 ? -5 / growth : end;
    T a = -8 * growth * end - 20, more = a > 0 ? a / 2 : 0;
    vec<T> all = end * v;
    return {x, all + static_cast<T>(3) * x, static_cast<T>(3) * all + (6 + more) * x, end};
}

template <class T> static begun<T> begun_turning(const motions &m, size_t j)
{
    quat<T> d = unit(quat<T>(m.old[j].rotation) * conjugate(quat<T>(m.now[j].rotation)));
    vec<T> half = textbook::log(d), w = vec<T>(m.velocity[1][j]) - rotate(d, vec<T>(m.next[1][j]));
    return begun_of(half, static_cast<T>(0.5) * textbook::rate_of(static_cast<T>(2) * half, w));
}

/* All three offsets of a joint, as a user keeps them. */
struct kept {
    begun<float> translation, rotation, scale;
};

static kept begun_at(const motions &m, size_t j)
{
    const nkw_trs &a = m.old[j], &b = m.now[j];
    vec<float> x = vec<float>(a.translation) - vec<float>(b.translation), v = vec<float>(m.velocity[0][j]);
    vec<float> y = vec<float>(a.scale) - vec<float>(b.scale), w = vec<float>(m.velocity[2][j]);
    return {begun_of(x, v - vec<float>(m.next[0][j])), begun_turning<float>(m, j),
            begun_of(y, w - vec<float>(m.next[2][j]))};
}

/* Of the results, the coefficients of the rotations are compared. */
static void begins(std::shared_ptr<motions> m)
{
    size_t joints = m->joints, n = NKW_POSE_STRIDE(joints);
    reference truth = [=](size_t j, double *out) {
        begun<double> b = begun_turning<double>(*m, j);
        put(b.c0, out), put(b.c1, out + 3), put(b.c2, out + 6);
    };
    operation op = {"transition", "begin", 9, 272, 300, truth, 32, 4096};
    op.sizes = {joints};
    nkw_pose_state from = {{m->from.data(), joints}, {m->moving.data(), joints}};
    nkw_pose_state to_pose = {{m->to.data(), joints}, {m->moving_to.data(), joints}};
    auto run = [=] { nkw_pose_inertia_begin(nkw_pose_inertia{m->begun.data(), joints}, &from, &to_pose, duration); };
    whole(op, "nkw", layout::components, run, [=] {
        for (size_t k = 0; k < 9; k++)
            std::copy_n(m->begun.data() + (9 + k) * n, joints, answer.part[k]);
    });
    auto results = std::make_shared<std::vector<kept>>(joints, begun_at(*m, 0));
    auto loop = [=] {
        for (size_t j = 0; j < joints; j++)
            (*results)[j] = begun_at(*m, j);
    };
    whole(op, "loop", layout::structs, loop, [=] {
        float *out = reinterpret_cast<float *>(answer.at);
        for (size_t j = 0; j < joints; j++)
            std::memcpy(out + 9 * j, &(*results)[j].rotation, 9 * sizeof *out);
    });
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
        begins(m);
        rows("inertialisation", m, 200, 90, own_inertia, inertia_at<float>, inertia_at<double>);
        rows("dead blending", m, 188, 210, own_dead, dead_at<float>, dead_at<double>);
    }
});
