/* SPDX-License-Identifier: MIT */
/* Dense morph targets of positions, all with a weight. An element is a vertex. */
#include <memory>

#include "bench.h"
#include "random.h"

using namespace bench;

struct morphs {
    std::vector<std::vector<nkw_vec3>> deltas;
    std::vector<nkw_morph_target> targets;
    std::vector<float> weights;
};

static std::shared_ptr<morphs> draw(size_t count)
{
    auto m = std::make_shared<morphs>();
    random_source r = random_from(count);
    m->deltas.resize(count);
    for (std::vector<nkw_vec3> &d : m->deltas) {
        for (size_t i = 0; i < pool; i++)
            d.push_back(random_vec3(&r, -0.1f, 0.1f));
        nkw_morph_target target = {};
        target.deltas.positions = {d.data(), 0};
        m->targets.push_back(target);
        m->weights.push_back(random_between(&r, 0.1f, 1));
    }
    return m;
}

/* Target by target, as the vertices are stored. */
static void loop_morph(const morphs &m, size_t n, float *out)
{
    const float *from = &point[0].at[0].x;
    for (size_t i = 0; i < 3 * n; i++)
        out[i] = from[i];
    for (size_t k = 0; k < m.deltas.size(); k++) {
        const float *d = &m.deltas[k][0].x, w = m.weights[k];
        for (size_t i = 0; i < 3 * n; i++)
            out[i] += w * d[i];
    }
}

static void dense(const char *name, size_t count)
{
    auto m = draw(count);
    double k = static_cast<double>(count);
    reference truth = [=](size_t i, double *out) {
        for (size_t c = 0; c < 3; c++) {
            out[c] = static_cast<double>(point[0].part[c][i]);
            for (size_t j = 0; j < m->weights.size(); j++)
                out[c] += static_cast<double>(m->weights[j]) * static_cast<double>((&m->deltas[j][i].x)[c]);
        }
    };
    operation all = {"morph", name, 3, 24 + 12 * k, 6 * k, truth, 16};
    for (size_t n : {size_t{64}, size_t{1024}, pool}) {
        operation op = all;
        op.sizes = {n};
        whole(op, "nkw", layout::structs, [=] {
            nkw_morph morph = {m->targets.data(), m->targets.size(), n};
            nkw_vertices_view in = {};
            nkw_vertices_span out = {};
            in.positions = {point[0].at, 0};
            out.positions = {reinterpret_cast<nkw_vec3 *>(answer.at), 0};
            nkw_morph_apply(&morph, m->weights.data(), in, out);
        });
        whole(op, "loop", layout::structs, [=] { loop_morph(*m, n, reinterpret_cast<float *>(answer.at)); });
    }
}

static const suite all([] {
    dense("4 targets", 4);
    dense("16 targets", 16);
});
