/* SPDX-License-Identifier: MIT */
/*
 * Prints results as one table: a line for each way to do an operation, its sizes side by side.
 *
 *     nakawari-bench-table RESULTS.csv [BUILD]             as text
 *     nakawari-bench-table --markdown RESULTS.csv [BUILD]  as Markdown, a line for each operation
 *     nakawari-bench-table --losses RESULTS.csv            rows of the library that a peer beats by more than a tenth
 *
 * vs     the time of the best peer over this one, at 1024 elements: above 1 the library is faster. Structs are held
 *        against peers
 *        on structs, components against all.
 * limit  the least time that the machine could take, as a part of the time taken
 */
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

static const size_t sizes[] = {1, 16, 67, 1024, 65536};

/* A way to do an operation; times are 0 where there is none. */
struct line {
    std::string build, stem, operation, who, layout;
    std::map<size_t, double> ns;
    double chain = 0, error = 0, bytes = 0, flops = 0, limit = 0;

    bool own() const
    {
        return who.compare(0, 3, "nkw") == 0;
    }
    /* At 1024 elements, or at the largest size there is. */
    double time() const
    {
        return ns.count(1024) ? ns.at(1024) : ns.empty() ? 0 : ns.rbegin()->second;
    }
};

struct results {
    std::vector<line> lines, machine;
};

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

static bool read(const char *path, const char *build, results &r)
{
    /* An operation's lines stand together, wherever the list had them. */
    auto together = [](std::vector<line> &lines) {
        std::map<std::string, size_t> first;
        for (const line &l : lines)
            first.emplace(l.build + "/" + l.stem + "/" + l.operation, first.size());
        std::stable_sort(lines.begin(), lines.end(), [&](const line &a, const line &b) {
            return first[a.build + "/" + a.stem + "/" + a.operation] <
                   first[b.build + "/" + b.stem + "/" + b.operation];
        });
    };
    std::ifstream in(path);
    std::string text;
    if (!std::getline(in, text))
        return false;
    while (std::getline(in, text)) {
        std::vector<std::string> c = split(text);
        if (c.size() != 11 || (build && c[0] != build))
            continue;
        line &l = line_of(c[1] == "machine" ? r.machine : r.lines, c);
        size_t n = static_cast<size_t>(number(c[5]));
        (c[4] == "chain" ? l.chain : l.ns[n]) = number(c[6]);
        l.error = std::max(l.error, number(c[7]));
        l.bytes = number(c[8]), l.flops = number(c[9]);
        if (n == 1024 || l.limit == 0)
            l.limit = number(c[10]);
    }
    together(r.lines);
    return true;
}

/* The best peer's time over that of l; 0 without a peer. `chain` compares chains. */
static double versus(const results &r, const line &l, bool chain)
{
    double best = 0;
    for (const line &p : r.lines) {
        double time = chain ? p.chain : p.time();
        bool same = p.build == l.build && p.stem == l.stem && p.operation == l.operation;
        if (!same || p.own() || time == 0 || (l.layout == "structs" && p.layout != "structs"))
            continue;
        best = best == 0 ? time : std::min(best, time);
    }
    double time = chain ? l.chain : l.time();
    return l.own() && time > 0 ? best / time : 0;
}

static std::string three(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, value >= 99.95 ? "%.0f" : value >= 9.995 ? "%.1f" : "%.2f", value);
    return value == 0 ? "" : text;
}

static std::vector<std::string> cells(const results &r, const line &l)
{
    std::vector<std::string> c = {l.who, l.layout};
    for (size_t n : sizes)
        c.push_back(l.ns.count(n) ? three(l.ns.at(n)) : "");
    c.push_back(three(l.chain));
    c.push_back(l.error == 0 ? "0" : three(l.error));
    c.push_back(three(versus(r, l, false)));
    c.push_back(three(versus(r, l, true)));
    c.push_back(three(l.bytes));
    c.push_back(three(l.flops));
    c.push_back(l.time() > 0 ? three(100 * l.limit / l.time()) + " %" : "");
    return c;
}

static const std::vector<std::string> head = {"row",   "layout",  "n=1", "16",       "67",    "1024",  "65536",
                                              "chain", "error u", "vs",  "vs chain", "bytes", "flops", "limit"};

static void print(const std::vector<std::string> &c)
{
    std::printf("  %-17s%-11s", c[0].c_str(), c[1].c_str());
    for (size_t k = 2; k < c.size(); k++)
        std::printf("%9s", c[k].c_str());
    std::puts("");
}

static void print_all(const results &r)
{
    for (const line &l : r.machine)
        std::printf("  %-10s %-18s %-8s %s\n", l.build.c_str(), l.operation.c_str(), l.who.c_str(),
                    three(l.ns.at(0)).c_str());
    std::string build, operation;
    for (const line &l : r.lines) {
        if (l.build != build) {
            std::printf("\nBuilt for %s. Nanoseconds for each element.\n", l.build.c_str());
            build = l.build;
            operation.clear();
        }
        if (l.stem + l.operation != operation) {
            std::printf("\n%s: %s\n", l.stem.c_str(), l.operation.c_str());
            print(head);
            operation = l.stem + l.operation;
        }
        print(cells(r, l));
    }
}

/* The fastest of the lines that `wanted` picks, or NULL. */
template <class F> static const line *fastest(const results &r, const line &of, bool chain, F wanted)
{
    const line *best = nullptr;
    for (const line &l : r.lines) {
        double time = chain ? l.chain : l.time();
        bool same = l.build == of.build && l.stem == of.stem && l.operation == of.operation;
        if (same && time > 0 && wanted(l) && (!best || time < (chain ? best->chain : best->time())))
            best = &l;
    }
    return best;
}

/* Three cells: the library's row, the best peer, the ratio. */
static void print_pair(const line *own, const line *peer, bool chain)
{
    double a = own ? chain ? own->chain : own->time() : 0, b = peer ? chain ? peer->chain : peer->time() : 0;
    std::string who = peer && b > 0 ? three(b) + " " + peer->who : "";
    std::printf("| %s | %s | %s ", three(a).c_str(), a > 0 ? who.c_str() : "",
                a > 0 && b > 0 ? three(b / a).c_str() : "");
}

static void print_operation(const results &r, const line &of)
{
    auto structs = [](const line &l) { return l.own() && l.layout == "structs"; };
    auto components = [](const line &l) { return l.own() && l.layout == "components"; };
    auto peer_structs = [](const line &l) { return !l.own() && l.layout == "structs"; };
    auto peer = [](const line &l) { return !l.own(); };
    const line *batch = fastest(r, of, false, components);
    std::printf("| %s ", of.operation.c_str());
    print_pair(fastest(r, of, false, structs), fastest(r, of, false, peer_structs), false);
    print_pair(fastest(r, of, true, structs), fastest(r, of, true, peer), true);
    print_pair(batch, fastest(r, of, false, peer), false);
    std::printf("| %s |\n", batch ? (three(100 * batch->limit / batch->time()) + " %").c_str() : "");
}

static void print_markdown(const results &r)
{
    std::string stem, operation;
    std::puts("| limit | sse2 | avx2 | avx512 |\n|---|--:|--:|--:|");
    for (size_t k = 0; k < 5 && k < r.machine.size(); k++) {
        std::printf("| %s ", r.machine[k].operation.c_str());
        for (const char *isa : {"sse2", "avx2", "avx512"})
            for (const line &l : r.machine)
                if (l.operation == r.machine[k].operation && l.who == isa)
                    std::printf("| %s ", three(l.ns.at(0)).c_str());
        std::puts("|");
    }
    for (const line &l : r.lines) {
        if (l.stem != stem)
            std::printf("\n### %s.h\n\n| operation | single | best peer | ratio | chain | best peer | ratio | arrays | "
                        "best peer | ratio "
                        "| of the limit |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
                        l.stem.c_str());
        if (l.stem + l.operation != operation)
            print_operation(r, l);
        stem = l.stem;
        operation = l.stem + l.operation;
    }
}

static void print_losses(const results &r)
{
    for (const line &l : r.lines)
        for (bool chain : {false, true}) {
            double ratio = versus(r, l, chain);
            if (ratio > 0 && ratio < 0.9)
                std::printf("%-10s %-10s %-22s %-10s %-11s %-6s %5.2f\n", l.build.c_str(), l.stem.c_str(),
                            l.operation.c_str(), l.who.c_str(), l.layout.c_str(), chain ? "chain" : "", ratio);
        }
}

int main(int argc, char **argv)
{
    bool markdown = argc > 1 && !std::strcmp(argv[1], "--markdown"),
         losses = argc > 1 && !std::strcmp(argv[1], "--losses");
    int first = markdown || losses ? 2 : 1;
    results r;
    if (argc <= first || !read(argv[first], argc > first + 1 ? argv[first + 1] : nullptr, r)) {
        std::fprintf(stderr, "usage: %s [--markdown | --losses] RESULTS.csv [BUILD]\n", argv[0]);
        return 2;
    }
    if (losses) {
        print_losses(r);
        return 0;
    }
    markdown ? print_markdown(r) : print_all(r);
    return 0;
}
