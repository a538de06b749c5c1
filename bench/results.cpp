/* SPDX-License-Identifier: MIT */
#include "results.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>

namespace bench
{

const std::vector<growth> growths = {
    {"clip", "pose by joints, random", "joint", "joints"},
    {"clip", "pose by joints, in order", "joint", "joints"},
    {"skeleton", "local to model", "joint", "joints"},
    {"blend", "two", "joint", "joints"},
    {"blend", "eight", "joint", "joints"},
    {"palette", "4x4", "joint", "joints"},
    {"segment", "find by keys, random", "lookup", "keys"},
    {"segment", "find by keys, in order", "lookup", "keys"},
    {"segment", "find by keys, backwards", "lookup", "keys"},
    {"track", "rotation linear by keys, random", "sample", "keys"},
    {"track", "rotation linear by keys, in order", "sample", "keys"},
    {"track", "rotation linear by keys, backwards", "sample", "keys"},
    {"clip", "pose by keys, random", "joint of 16", "keys"},
    {"clip", "pose by keys, in order", "joint of 16", "keys"},
    {"clip", "pose by keys, backwards", "joint of 16", "keys"},
    {"skin", "4 influences", "vertex", "vertices"},
    {"crowd", "local to model", "character", "characters"},
    {"crowd", "time to palette", "character", "characters"},
    {"crowd", "time to palette, 2 threads", "character", "characters"},
};

double line::time() const
{
    for (size_t n : {1024u, 67u, 301u, 1000u})
        if (ns.count(n))
            return ns.at(n);
    return ns.empty() ? 0 : ns.rbegin()->second;
}

static std::vector<std::string> split(const std::string &text)
{
    std::vector<std::string> cells;
    std::string cell;
    bool quoted = false;
    for (char c : text)
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells.push_back(cell), cell.clear();
        else
            cell += c;
    cells.push_back(cell);
    return cells;
}

static line &line_of(std::vector<line> &lines, const std::vector<std::string> &c)
{
    std::string layout = c[4] == "chain" ? "structs" : c[4];
    for (line &l : lines)
        if (l.build == c[0] && l.stem == c[1] && l.operation == c[2] && l.who == c[3] && l.layout == layout)
            return l;
    lines.emplace_back();
    line &l = lines.back();
    l.build = c[0], l.stem = c[1], l.operation = c[2], l.who = c[3], l.layout = layout;
    return l;
}

static double number(const std::string &text)
{
    return std::strtod(text.c_str(), nullptr);
}

/* Stems and operations in the order in which they first came. */
static void together(std::vector<line> &lines)
{
    std::map<std::string, size_t> stem, operation;
    auto key = [](const line &l) { return l.build + "/" + l.stem; };
    for (const line &l : lines) {
        stem.emplace(key(l), stem.size());
        operation.emplace(key(l) + "/" + l.operation, operation.size());
    }
    std::stable_sort(lines.begin(), lines.end(), [&](const line &a, const line &b) {
        size_t i = stem[key(a)], j = stem[key(b)];
        return i != j ? i < j : operation[key(a) + "/" + a.operation] < operation[key(b) + "/" + b.operation];
    });
}

bool results::read(const char *path, const char *build)
{
    std::ifstream in(path);
    std::string text;
    if (!std::getline(in, text))
        return false;
    while (std::getline(in, text)) {
        std::vector<std::string> c = split(text);
        if (c.size() != 11 || (build && c[0] != build))
            continue;
        line &l = line_of(c[1] == "machine" ? machine : lines, c);
        size_t n = static_cast<size_t>(number(c[5]));
        (c[4] == "chain" ? l.chain : l.ns[n]) = number(c[6]);
        l.error = std::max(l.error, number(c[7]));
        l.bytes = number(c[8]), l.flops = number(c[9]);
        if (c[4] != "chain" && (l.limit == 0 || l.ns[n] == l.time()))
            l.limit = number(c[10]);
    }
    together(lines);
    return true;
}

std::vector<std::string> results::builds() const
{
    std::vector<std::string> all;
    for (const line &l : lines)
        if (all.empty() || all.back() != l.build)
            all.push_back(l.build);
    return all;
}

double results::versus(const line &l, bool chain) const
{
    const line *best = fastest(
        l, chain, [&](const line &p) { return p.compared() && (l.layout != "structs" || p.layout == "structs"); });
    double time = chain ? l.chain : l.time();
    return l.own() && time > 0 && best ? (chain ? best->chain : best->time()) / time : 0;
}

std::vector<size_t> results::sizes(const line &of) const
{
    std::set<size_t> all;
    for (const line &l : lines)
        if (l.does(of))
            for (const auto &at : l.ns)
                all.insert(at.first);
    return std::vector<size_t>(all.begin(), all.end());
}

std::string three(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, value >= 99.95 ? "%.0f" : value >= 9.995 ? "%.1f" : "%.2f", value);
    return value == 0 ? "" : text;
}

} // namespace bench
