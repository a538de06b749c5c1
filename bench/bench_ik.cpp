/* SPDX-License-Identifier: MIT */
/*
 * Limbs and aims. The loops are those of many programs: the law of cosines with the C library's arc cosine, and the
 * shortest rotation between two directions. They have no pole, no limits, no weight, and no answer for straight limbs
 * or opposite directions.
 */
#include <cmath>

#include "bench.h"
#include "textbook.h"

using namespace bench;
using textbook::quat;
using textbook::vec;

static std::vector<nkw_ik_two_bone> limbs;
static std::vector<nkw_ik_aim> aims;

/* From direction a to b, of any lengths. */
template <class T> static quat<T> between(vec<T> a, vec<T> b)
{
    vec<T> c = cross(a, b);
    return unit(quat<T>(c.x, c.y, c.z, dot(a, b) + std::sqrt(dot(a, a) * dot(b, b))));
}

template <class T> static T angle_of(T a, T b, T opposite)
{
    T c = (a * a + b * b - opposite * opposite) / (2 * a * b);
    return std::acos(c < -1 ? -1 : c > 1 ? 1 : c);
}

/* Source Holden, Simple Two Joint IK, 2017. The end of the limb by its two rotations, as a check. */
static nkw_vec3 loop_end(const nkw_ik_two_bone &l)
{
    vec<float> root(l.root), a = vec<float>(l.mid) - root, b = vec<float>(l.end) - vec<float>(l.mid);
    vec<float> reach = a + b, to_target = vec<float>(l.target) - root, axis = cross(a, b);
    float la = length(a), lb = length(b), d = length(to_target);
    axis = (1 / length(axis)) * axis;
    float bend = angle_of(la, lb, length(reach)) - angle_of(la, lb, d);
    quat<float> mid = textbook::exp(0.5f * bend * axis);
    vec<float> bent = rotate(mid, b);
    quat<float> turn = between(a + bent, to_target);
    return to(root + rotate(turn, a) + rotate(turn * mid, b));
}

/* Targets between 0.4 and 0.9 of the length, limbs of 90 to 150 degrees. */
static void draw()
{
    for (size_t i = 0; i < pool; i++) {
        quat<float> q(unit_a[i]);
        float s = sinf(0.5f + 0.5f * t[i]), c = cosf(0.5f + 0.5f * t[i]);
        vec<float> root(point[0][i]), mid = root + rotate(q, vec<float>(0.5f * s, 0.5f * c, 0));
        vec<float> end = mid + rotate(q, vec<float>(-0.4f * s, 0.4f * c, 0));
        float reach = 0.65f + 0.2f * signed_one[i];
        vec<float> target = root + rotate(quat<float>(unit_near[i]), vec<float>(0.1f, 0.9f * reach, 0.1f));
        nkw_ik_two_bone limb = {to(root), to(mid), to(end), to(target), {0, 0, 0}, {0, 0, 0}, 0, 1};
        limbs.push_back(limb);
        nkw_ik_aim aim = {};
        aim.position = point[0][i], aim.forward = to(rotate(q, vec<float>(0, 0, 1)));
        aim.target = to(root + rotate(quat<float>(unit_near[i]), vec<float>(0.3f, 0.4f, 2))), aim.weight = 1;
        aims.push_back(aim);
    }
}

template <class T> static quat<T> textbook_aim(const nkw_ik_aim &a)
{
    return between(vec<T>(a.forward), vec<T>(a.target) - vec<T>(a.position));
}

static const suite all([] {
    draw();
    reference reached = [](size_t i, double *out) { put(vec<double>(limbs[i].target), out); };
    reference aimed = [](size_t i, double *out) { put(textbook_aim<double>(aims[i]), out); };
    operation limb = {"ik", "two bones", 3, 116, 250, reached};
    single(limb, "nkw", [](size_t i) { return nkw_ik_two_bone_solve(&limbs[i]).end_position; });
    single(limb, "loop", [](size_t i) { return loop_end(limbs[i]); });
    operation aim = {"ik", "aim", 4, 116, 40, aimed, 4, 4096, same::rotation};
    single(aim, "nkw", [](size_t i) { return nkw_ik_aim_solve(&aims[i]).rotation; });
    single(aim, "loop", [](size_t i) { return to(textbook_aim<float>(aims[i])); });
});
