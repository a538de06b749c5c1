/* SPDX-License-Identifier: MIT */
/* The inputs, and the check that stands before every measurement. */
#include "bench.h"

#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "random.h"
#include "report.h"

namespace bench
{

array<nkw_quat> unit_a, unit_b, unit_near;
array<nkw_vec3> point[4], angles;
array<nkw_trs> place, place_b;
array<nkw_mat4> rigid, affine, general;
array<nkw_mat3> turn;
array<float> t, signed_one, turns, positive;
array<nkw_mat4> answer;

nkw_vec3_view view(const array<nkw_vec3> &a, size_t i)
{
    return {a.part[0] + i, a.part[1] + i, a.part[2] + i};
}

nkw_quat_view view(const array<nkw_quat> &a, size_t i)
{
    return {a.part[0] + i, a.part[1] + i, a.part[2] + i, a.part[3] + i};
}

nkw_trs_view view(const array<nkw_trs> &a, size_t i)
{
    return {{a.part[0] + i, a.part[1] + i, a.part[2] + i},
            {a.part[3] + i, a.part[4] + i, a.part[5] + i, a.part[6] + i},
            {a.part[7] + i, a.part[8] + i, a.part[9] + i}};
}

nkw_mat4_view view(const array<nkw_mat4> &a, size_t i)
{
    nkw_mat4_view v;
    for (size_t k = 0; k < 16; k++)
        v.m[k] = a.part[k] + i;
    return v;
}

nkw_vec3_span vec3_out(size_t i)
{
    return {answer.part[0] + i, answer.part[1] + i, answer.part[2] + i};
}

nkw_quat_span quat_out(size_t i)
{
    return {answer.part[0] + i, answer.part[1] + i, answer.part[2] + i, answer.part[3] + i};
}

nkw_mat4_span mat4_out(size_t i)
{
    nkw_mat4_span s;
    for (size_t k = 0; k < 16; k++)
        s.m[k] = answer.part[k] + i;
    return s;
}

static nkw_trs any_place(random_source *r)
{
    return {random_vec3(r, -1, 1), random_rotation(r), random_vec3(r, 0.5f, 2)};
}

static nkw_mat4 any_matrix(random_source *r)
{
    nkw_mat4 m;
    for (size_t k = 0; k < 16; k++)
        m.m[k] = random_between(r, -1, 1) + (k % 5 == 0 ? 2.0f : 0.0f);
    return m;
}

void draw_inputs()
{
    random_source source = random_from(2024), *r = &source;
    for (size_t i = 0; i < pool; i++) {
        unit_a.set(i, random_rotation(r));
        unit_b.set(i, random_rotation(r));
        /* Half the turn stands between the quaternions. */
        unit_near.set(i, random_near(r, unit_a[i], random_between(r, 0.00436f, 0.1309f)));
        for (array<nkw_vec3> &p : point)
            p.set(i, random_vec3(r, -1, 1));
        angles.set(i, {random_between(r, -3, 3), random_between(r, -1.5f, 1.5f), random_between(r, -3, 3)});
        place.set(i, any_place(r));
        place_b.set(i, any_place(r));
        affine.set(i, nkw_mat4_from_trs(&place.at[i]));
        nkw_mat3 rotation = nkw_mat3_from_quat(unit_b[i]);
        turn.set(i, rotation);
        rigid.set(i, nkw_mat4_from_mat3(&rotation, point[0][i]));
        general.set(i, any_matrix(r));
        t.set(i, random_unit(r));
        signed_one.set(i, random_between(r, -1, 1));
        turns.set(i, random_between(r, -10, 10));
        positive.set(i, random_between(r, 0.01f, 100));
    }
}

static std::vector<void (*)()> &suites()
{
    static std::vector<void (*)()> all;
    return all;
}

suite::suite(void (*list)())
{
    suites().push_back(list);
}

void list_all()
{
    for (void (*list)() : suites())
        list();
}

static double part(layout where, size_t width, size_t i, size_t k)
{
    const float *flat = reinterpret_cast<const float *>(answer.at);
    return static_cast<double>(where == layout::components ? answer.part[k][i] : flat[i * width + k]);
}

/* In u of the larger of `least` and the result's largest component. Infinite for NaN. */
static double error_at(const operation &op, layout where, size_t i, const double *truth)
{
    size_t first = op.sort == same::transform ? 3 : 0;
    size_t last = op.sort == same::number ? 0 : first + 4;
    double dot = 0, scale = op.least, worst = 0;
    for (size_t k = first; k < last; k++)
        dot += truth[k] * part(where, op.width, i, k);
    for (size_t k = 0; k < op.width; k++) {
        double sign = dot < 0 && first <= k && k < last ? -1 : 1;
        double off = std::fabs(sign * part(where, op.width, i, k) - truth[k]);
        worst = off <= worst ? worst : std::isnan(off) ? std::numeric_limits<double>::infinity() : off;
        scale = std::fmax(scale, std::fabs(truth[k]));
    }
    return worst == 0 ? 0 : worst / (scale * 0x1p-24);
}

/* References are worked out once for each operation, as far as they are asked for, or for each of its sizes. */
static const double *truth_at(const operation &op, size_t size, size_t i)
{
    static std::map<std::string, std::vector<double>> known;
    std::vector<double> &truth = known[op.stem + "/" + op.name + "/" + std::to_string(op.elements ? size : 0)];
    for (size_t done = truth.size() / op.width; done <= i; done++) {
        truth.resize((done + 1) * op.width);
        op.truth(done, &truth[done * op.width]);
    }
    return &truth[i * op.width];
}

static double checked(const operation &op, layout where, size_t size, size_t n, const std::function<void(size_t)> &fill)
{
    double worst = 0;
    for (size_t i = 0; i < pool; i++)
        for (size_t k = 0; k < 16; k++)
            answer.at[i].m[k] = answer.part[k][i] = std::numeric_limits<float>::quiet_NaN();
    fill(n);
    for (size_t i = 0; i < n; i++)
        worst = std::fmax(worst, error_at(op, where, i, truth_at(op, size, i)));
    return worst;
}

void add(const operation &op, const std::string &who, layout where, size_t n, std::function<void(size_t)> fill,
         std::function<void(benchmark::State &)> time, passing clock)
{
    static const char *const layouts[] = {"structs", "components", "chain"};
    const bool own = who.compare(0, 3, "nkw") == 0;
    if (BENCH_ROWS != rows_all && own != (BENCH_ROWS == rows_own))
        return;
    row &r = new_row();
    size_t elements = op.elements ? op.elements : n;
    r = {op.stem,
         op.name,
         who,
         layouts[static_cast<int>(where)],
         n,
         elements,
         op.round ? op.round : elements,
         clock == passing::told,
         -1,
         op.bytes,
         op.flops,
         {}};
    double allowed = r.own() ? op.own : op.others;
    auto body = [=, &r](benchmark::State &state) {
        if (r.error < 0)
            r.error = checked(op, where, n, elements, fill);
        if (r.error > allowed) {
            state.SkipWithError(("wrong: off by " + std::to_string(r.error) + " u").c_str());
            return;
        }
        time(state);
        state.counters["error_u"] = r.error;
        state.counters["bytes"] = r.bytes;
        state.counters["flops"] = r.flops;
        state.counters["elements"] = static_cast<double>(elements);
    };
    auto *registered = benchmark::RegisterBenchmark(r.key().c_str(), body);
    if (r.told)
        registered->UseManualTime();
}

std::string named(const char *what, asking o)
{
    return std::string(what) + (o == asking::random ? ", random" : o == asking::onward ? ", in order" : ", backwards");
}

float time_at(asking o, size_t i, float end)
{
    if (o == asking::random)
        return end * t[i % pool];
    float on = std::fmod(static_cast<float>(i % pool) / 60, end);
    return o == asking::onward ? on : end - on;
}

} // namespace bench
