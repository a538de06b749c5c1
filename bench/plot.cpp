/* SPDX-License-Identifier: MIT */
/*
 * Draws results:
 *
 *     nakawari-bench-plot RESULTS.csv FOLDER
 *
 * writes FOLDER/performance-joints.svg, -keys, -characters, -vertices (cost against size, both logarithmic) and
 * -ratios-<build>.svg (for each operation, how much faster than the best peer).
 */
#include <algorithm>
#include <cmath>
#include <cstdio>

extern "C" {
#include "figure.h"
}
#include "results.h"

using namespace bench;

static const char growth_build[] = "x86-64-v3";

static float real(double x)
{
    return static_cast<float>(x);
}

/* ---- cost against size ---- */

/* Rows of an operation, all (who = "") or one, with a name of their own. */
struct source {
    const char *stem, *operation, *who, *name;
};

struct panel {
    const char *title, *size, *element;
    std::vector<source> sources;
};

struct curve {
    std::string name;
    bool own;
    std::map<size_t, double> at;
};

/* A logarithmic axis over whole steps of 1, 2, 5, 10 ... */
struct axis {
    double from, to;
    float position(double value, float begin, float length) const
    {
        return begin + length * real(std::log(value / from) / std::log(to / from));
    }
};

static const double steps[] = {1, 2, 5};

template <class F> static void each_step(const axis &a, F f)
{
    for (int decade = -3; decade < 9; decade++)
        for (double s : steps) {
            double value = s * std::pow(10, decade);
            if (value >= a.from * 0.999 && value <= a.to * 1.001)
                f(value, s);
        }
}

static axis around(double least, double most)
{
    axis a = {1e-3, 1e8}, fit = {least, most};
    each_step(a, [&](double value, double) { fit.from = value <= least * 0.95 ? value : fit.from; });
    bool found = false;
    each_step(a, [&](double value, double) {
        if (!found && value >= most * 1.05)
            fit.to = value, found = true;
    });
    return fit;
}

static std::vector<curve> curves_of(const results &r, const panel &p)
{
    std::vector<curve> curves;
    for (const source &s : p.sources)
        for (const line &l : r.lines)
            if (l.build == growth_build && l.stem == s.stem && l.operation == s.operation &&
                (!*s.who || l.who == s.who) && !l.ns.empty())
                curves.push_back({*s.name ? s.name : l.who, l.own(), l.ns});
    return curves;
}

/* The place of a curve's colour: that of its name where it is one of `known`, else one behind these, in turn. */
static size_t place_of(const std::vector<curve> &curves, size_t k, const std::vector<std::string> &known)
{
    auto named = [&](const curve &c) { return std::find(known.begin(), known.end(), c.name) - known.begin(); };
    auto unknown = [&](const curve &c) {
        return c.own == curves[k].own && static_cast<size_t>(named(c)) == known.size();
    };
    auto place = static_cast<size_t>(named(curves[k]));
    if (place < known.size())
        return place;
    auto before = std::count_if(curves.begin(), curves.begin() + static_cast<std::ptrdiff_t>(k), unknown);
    return place + static_cast<size_t>(before);
}

/* The library's curves are full and cold, the peers' dashed and warm. */
static svg_paint paint_of(const std::vector<curve> &curves, size_t k)
{
    static const svg_colour own[] = {0x1f5fd0, 0x00897b, 0x5b4bb5, 0x4aa3df, 0x7d8a00},
                            others[] = {0xd55e00, 0xc2185b, 0xe0a000, 0x8d5524, 0x55555c};
    static const std::vector<std::string> peers = {"glm", "cglm", "Eigen"};
    svg_colour colour = curves[k].own ? own[place_of(curves, k, {}) % 5] : others[place_of(curves, k, peers) % 5];
    svg_paint paint = svg_stroke(colour, 2.2f, 1);
    paint.dash = curves[k].own ? nullptr : "6 3";
    return paint;
}

static void draw_frame(svg *s, const svg_box &b, const panel &p, const axis &x, const axis &y,
                       const std::vector<size_t> &sizes)
{
    svg_paint grid = svg_stroke(0xe6e6ea, 1, 1), border = svg_stroke(FIGURE_PALE, 1, 1);
    char text[32];
    each_step(y, [&](double value, double) {
        float at = b.y + b.height - y.position(value, 0, b.height);
        svg_line(s, svg_at(b.x, at), svg_at(b.x + b.width, at), &grid);
        std::snprintf(text, sizeof text, "%g", value);
        figure_text(s, b.x - 7, at + 4, 11, FIGURE_GREY, 'e', text);
    });
    for (size_t n : sizes) {
        float at = x.position(static_cast<double>(n), b.x, b.width);
        svg_line(s, svg_at(at, b.y), svg_at(at, b.y + b.height), &grid);
        std::snprintf(text, sizeof text, "%zu", n);
        figure_text(s, at, b.y + b.height + 16, 11, FIGURE_GREY, 'm', text);
    }
    svg_rect(s, b, 0, &border);
    std::string unit = std::string("ns for each ") + p.element;
    figure_bold(s, b.x, b.y - 26, 14, FIGURE_INK, 's', p.title);
    figure_text(s, b.x, b.y - 9, 12, FIGURE_GREY, 's', unit.c_str());
    figure_text(s, b.x + b.width / 2, b.y + b.height + 34, 12, FIGURE_GREY, 'm', p.size);
}

static void draw_panel(svg *s, const results &r, const panel &p, const svg_box &b)
{
    std::vector<curve> curves = curves_of(r, p);
    std::map<size_t, double> all;
    double least = 1e30, most = 0;
    for (const curve &c : curves)
        for (const auto &at : c.at) {
            all[at.first] = 0;
            least = std::min(least, at.second), most = std::max(most, at.second);
        }
    if (all.empty())
        return;
    std::vector<size_t> sizes;
    for (const auto &at : all)
        sizes.push_back(at.first);
    axis x = {static_cast<double>(sizes.front()) / 1.2, static_cast<double>(sizes.back()) * 1.2};
    axis y = around(least, most);
    draw_frame(s, b, p, x, y, sizes);
    for (size_t k = 0; k < curves.size(); k++) {
        svg_paint paint = paint_of(curves, k);
        std::vector<svg_point> points;
        for (const auto &at : curves[k].at)
            points.push_back(svg_at(x.position(static_cast<double>(at.first), b.x, b.width),
                                    b.y + b.height - y.position(at.second, 0, b.height)));
        svg_polyline(s, points.data(), points.size(), &paint);
        for (svg_point at : points)
            figure_dot(s, at, paint.stroke);
        float column = k % 2 == 0 ? 0 : b.width / 2, row = 20 * real(static_cast<double>(k / 2));
        figure_legend(s, b.x + column, b.y + b.height + 62 + row, &paint, curves[k].name.c_str());
    }
}

/* A page: its file is performance-<name>.svg. */
struct page {
    const char *name, *lesson;
    std::vector<panel> panels;
};

static const std::vector<page> pages = {
    {"joints",
     "Cost of a joint against the joints of the skeleton",
     {{"A pose from a clip, at random times", "joints", "joint", {{"clip", "pose by joints, random", "", ""}}},
      {"Local to model", "joints", "joint", {{"skeleton", "local to model", "", ""}}},
      {"Two poses blended", "joints", "joint", {{"blend", "two", "", ""}}},
      {"Joint matrices", "joints", "joint", {{"palette", "4x4", "", ""}}}}},
    {"keys",
     "Cost of a time against the keys",
     {{"Lookup: times at random", "keys", "lookup", {{"segment", "find by keys, random", "", ""}}},
      {"Lookup: times in order", "keys", "lookup", {{"segment", "find by keys, in order", "", ""}}},
      {"Rotation from a track",
       "keys",
       "sample",
       {{"track", "rotation linear by keys, random", "nkw _from", "random"},
        {"track", "rotation linear by keys, in order", "nkw _from", "in order"},
        {"track", "rotation linear by keys, backwards", "nkw _from", "backwards"},
        {"track", "rotation linear by keys, random", "upper_bound, glm", "glm: random"},
        {"track", "rotation linear by keys, in order", "upper_bound, glm", "glm: in order"}}},
      {"A pose of 16 joints from a clip",
       "keys",
       "joint",
       {{"clip", "pose by keys, random", "nkw", "random"},
        {"clip", "pose by keys, in order", "nkw", "in order"},
        {"clip", "pose by keys, backwards", "nkw", "backwards"},
        {"clip", "pose by keys, random", "upper_bound, glm", "glm: random"},
        {"clip", "pose by keys, in order", "upper_bound, glm", "glm: in order"}}}}},
    {"characters",
     "Cost of a character against the characters",
     {{"From a time to a palette, 67 joints",
       "characters",
       "character",
       {{"crowd", "time to palette", "", ""},
        {"crowd", "time to palette, 2 threads", "nkw sixteen", "sixteen, 2 threads"},
        {"crowd", "time to palette, 2 threads", "nkw one by one", "one by one, 2 threads"},
        {"crowd", "time to palette, 2 threads", "upper_bound, glm", "glm, 2 threads"}}},
      {"Local to model, 67 joints", "characters", "character", {{"crowd", "local to model", "", ""}}}}},
    {"vertices",
     "Cost of a vertex against the vertices",
     {{"Positions and normals, 4 influences", "vertices", "vertex", {{"skin", "4 influences", "", ""}}},
      {"Dual quaternions, 4 influences", "vertices", "vertex", {{"skin", "4, dual quaternions", "", ""}}}}},
};

static int draw_page(const results &r, const std::string &folder, const page &p)
{
    const float width = 480, height = 430;
    svg s;
    std::string path = folder + "/performance-" + p.name + ".svg";
    std::string reading =
        std::string("Both axes are logarithmic. Full lines: this library; dashed: its peers. Built for ") +
        growth_build + ".";
    float rows = real(static_cast<double>((p.panels.size() + 1) / 2));
    if (!figure_open(&s, path.c_str(), 2 * width, 90 + height * rows, p.lesson, reading.c_str()))
        return 0;
    for (size_t k = 0; k < p.panels.size(); k++) {
        float column = real(static_cast<double>(k % 2)), row = real(static_cast<double>(k / 2));
        draw_panel(&s, r, p.panels[k], {60 + width * column, 134 + height * row, 390, 230});
    }
    return svg_close(&s);
}

/* ---- ratios ---- */

struct ratio {
    std::string name;
    bool stem; /* a heading */
    double single, arrays;
};

static std::vector<ratio> ratios_of(const results &r, const char *build)
{
    std::vector<ratio> all;
    const line *before = nullptr;
    for (const line &l : r.lines) {
        if (l.build != build || (before && before->does(l)))
            continue;
        auto best = [&](const char *layout) {
            double most = 0;
            for (const line &o : r.lines)
                most = o.does(l) && o.layout == layout ? std::max(most, r.versus(o, false)) : most;
            return most;
        };
        if (!before || before->stem != l.stem)
            all.push_back({l.stem + ".h", true, 0, 0});
        before = &l;
        ratio one = {l.operation, false, best("structs"), best("components")};
        if (one.single > 0 || one.arrays > 0)
            all.push_back(one);
    }
    return all;
}

/* From 1 to the ratio, cut off at the ends of the axis; in `lost` where the peer is faster. */
static void draw_bar(svg *s, const axis &x, float left, float width, float y, double value, svg_colour won,
                     svg_colour lost)
{
    if (value == 0)
        return;
    svg_colour colour = value < 1 ? lost : won;
    double shown = std::min(std::max(value, x.from), x.to);
    float one = x.position(1, left, width), end = x.position(shown, left, width);
    svg_box box = {std::min(one, end), y, std::max(std::fabs(end - one), 1.0f), 6};
    svg_paint paint = svg_fill(colour, 1.0f);
    svg_rect(s, box, 0, &paint);
    std::string text = three(value);
    figure_text(s, std::max(one, end) + 4, y + 6, 8, FIGURE_GREY, 's', text.c_str());
}

static void draw_scale(svg *s, const axis &x, float left, float width, float top, float bottom)
{
    char text[32];
    each_step(x, [&](double value, double) {
        svg_paint grid = svg_stroke(value == 1 ? FIGURE_INK : 0xe6e6ea, 1, 1);
        float at = x.position(value, left, width);
        svg_line(s, svg_at(at, top), svg_at(at, bottom), &grid);
        std::snprintf(text, sizeof text, "%g", value);
        figure_text(s, at, top - 5, 10, FIGURE_GREY, 'm', text);
    });
}

static int draw_ratios(const results &r, const std::string &folder, const char *build)
{
    const float row = 20, top = 130, label = 190, bars = 260, column = 500;
    const svg_colour single = 0x1f5fd0, arrays = 0x00897b, lost_single = 0xd55e00, lost_arrays = 0xc2185b;
    std::vector<ratio> all = ratios_of(r, build);
    size_t half = (all.size() + 1) / 2;
    while (half < all.size() && !all[half].stem)
        half++;
    float bottom = top + row * real(static_cast<double>(half));
    axis x = {0.05, 50};
    svg s;
    std::string path = folder + "/performance-ratios-" + build + ".svg";
    std::string lesson = std::string("Time of the best peer over the library's: built for ") + build;
    if (!figure_open(&s, path.c_str(), 2 * column, bottom + 30, lesson.c_str(),
                     "To the right of the line at 1 the library is faster; to the left, red, the peer. Logarithmic; "
                     "bars end at 0.05 and at 50."))
        return 0;
    svg_paint one = svg_stroke(single, 6, 1), many = svg_stroke(arrays, 6, 1);
    figure_legend(&s, 24, 90, &one, "structs: single calls, and arrays of structs");
    figure_legend(&s, 24 + column, 90, &many, "component arrays, against the best peer of any layout");
    for (size_t k = 0; k < all.size(); k++) {
        float left = k < half ? 20 : 20 + column, y = top + row * real(static_cast<double>(k < half ? k : k - half));
        if (k == 0 || k == half)
            draw_scale(&s, x, left + label, bars, top, bottom);
        if (all[k].stem) {
            figure_bold(&s, left, y + 12, 12, FIGURE_INK, 's', all[k].name.c_str());
            continue;
        }
        figure_text(&s, left + label - 6, y + 13, 11, FIGURE_GREY, 'e', all[k].name.c_str());
        draw_bar(&s, x, left + label, bars, y + 1, all[k].single, single, lost_single);
        draw_bar(&s, x, left + label, bars, y + 10, all[k].arrays, arrays, lost_arrays);
    }
    return svg_close(&s);
}

int main(int argc, char **argv)
{
    results r;
    if (argc != 3 || !r.read(argv[1], nullptr)) {
        std::fprintf(stderr, "usage: %s RESULTS.csv FOLDER\n", argv[0]);
        return 2;
    }
    int drawn = 1;
    for (const std::string &build : r.builds())
        drawn = drawn && draw_ratios(r, argv[2], build.c_str());
    for (const page &p : pages)
        drawn = drawn && draw_page(r, argv[2], p);
    if (!drawn) {
        std::perror(argv[2]);
        return 1;
    }
    return 0;
}
