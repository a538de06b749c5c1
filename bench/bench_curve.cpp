/* SPDX-License-Identifier: MIT */
/*
 * Cubic curves on vectors. The plain loop and cglm take the polynomial as given; the library goes from the
 * nearer end.
 */
#include "bench.h"
#include "peers.h"

using namespace bench;

/* The four control points of element i, and its t. */
template <class W> static reference of()
{
    return [](size_t i, double *out) {
        double w[4];
        W::at(static_cast<double>(t[i]), w);
        for (size_t k = 0; k < 3; k++) {
            out[k] = 0;
            for (size_t j = 0; j < 4; j++)
                out[k] += w[j] * static_cast<double>(point[j].part[k][i]);
        }
    };
}

struct hermite_weights {
    template <class T> static void at(T s, T *w)
    {
        T u = 1 - s;
        w[0] = (1 + 2 * s) * u * u, w[1] = s * u * u, w[2] = s * s * (3 - 2 * s), w[3] = -s * s * u;
    }
};

struct bezier_weights {
    template <class T> static void at(T s, T *w)
    {
        T u = 1 - s;
        w[0] = u * u * u, w[1] = 3 * s * u * u, w[2] = 3 * s * s * u, w[3] = s * s * s;
    }
};

struct bspline_weights {
    template <class T> static void at(T s, T *w)
    {
        T u = 1 - s;
        w[0] = u * u * u / 6, w[1] = (3 * s * s * s - 6 * s * s + 4) / 6, w[2] = (3 * u * u * u - 6 * u * u + 4) / 6,
        w[3] = s * s * s / 6;
    }
};

struct catmull_weights {
    template <class T> static void at(T s, T *w)
    {
        T u = 1 - s;
        w[0] = -s * u * u / 2, w[1] = (2 - 5 * s * s + 3 * s * s * s) / 2, w[2] = (2 - 5 * u * u + 3 * u * u * u) / 2,
        w[3] = -u * s * s / 2;
    }
};

using curve = nkw_vec3 (*)(nkw_vec3, nkw_vec3, nkw_vec3, nkw_vec3, float);
using curve_n = void (*)(nkw_vec3_view, nkw_vec3_view, nkw_vec3_view, nkw_vec3_view, const float *, nkw_vec3_span,
                         size_t);

/* The weights, then the weighted sum: how a user writes any of them. */
template <class W> static nkw_vec3 loop(size_t i)
{
    float w[4];
    W::at(t[i], w);
    const nkw_vec3 &p = point[0][i], &q = point[1][i], &r = point[2][i], &s = point[3][i];
    return {w[0] * p.x + w[1] * q.x + w[2] * r.x + w[3] * s.x, w[0] * p.y + w[1] * q.y + w[2] * r.y + w[3] * s.y,
            w[0] * p.z + w[1] * q.z + w[2] * r.z + w[3] * s.z};
}

template <curve F, curve_n N, class W> static operation rows(const char *name, double flops)
{
    operation op = {"curve", name, 3, 64, flops, of<W>(), 8};
    single(op, "nkw", [](size_t i) { return F(point[0][i], point[1][i], point[2][i], point[3][i], t[i]); });
    batch(op, "nkw _n", [](size_t from, size_t n) {
        N(view(point[0], from), view(point[1], from), view(point[2], from), view(point[3], from), t.at + from,
          vec3_out(from), n);
    });
    single(op, "loop", [](size_t i) { return loop<W>(i); });
    return op;
}

static const suite all([] {
    operation hermite = rows<nkw_vec3_hermite, nkw_vec3_hermite_n, hermite_weights>("hermite", 45);
    operation bezier = rows<nkw_vec3_bezier, nkw_vec3_bezier_n, bezier_weights>("bezier", 45);
    rows<nkw_vec3_bspline, nkw_vec3_bspline_n, bspline_weights>("bspline", 50);
    operation catmull = rows<nkw_vec3_catmull_rom, nkw_vec3_catmull_rom_n, catmull_weights>("catmull rom", 50);
#ifdef BENCH_CGLM
    single(hermite, "cglm", [](size_t i) {
        const nkw_vec3 &p = point[0][i], &v = point[1][i], &q = point[2][i], &w = point[3][i];
        return nkw_vec3{glm_hermite(t[i], p.x, v.x, w.x, q.x), glm_hermite(t[i], p.y, v.y, w.y, q.y),
                        glm_hermite(t[i], p.z, v.z, w.z, q.z)};
    });
    single(bezier, "cglm", [](size_t i) {
        const nkw_vec3 &p = point[0][i], &q = point[1][i], &r = point[2][i], &s = point[3][i];
        return nkw_vec3{glm_bezier(t[i], p.x, q.x, r.x, s.x), glm_bezier(t[i], p.y, q.y, r.y, s.y),
                        glm_bezier(t[i], p.z, q.z, r.z, s.z)};
    });
#endif
#ifdef BENCH_GLM
    const glm::vec3 *p = as<glm::vec3>(point[0]), *q = as<glm::vec3>(point[1]), *r = as<glm::vec3>(point[2]),
                    *s = as<glm::vec3>(point[3]);
    single(hermite, "glm", [=](size_t i) { return glm::hermite(p[i], q[i], r[i], s[i], t[i]); });
    single(catmull, "glm", [=](size_t i) { return glm::catmullRom(p[i], q[i], r[i], s[i], t[i]); });
#endif
});
