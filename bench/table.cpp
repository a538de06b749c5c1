/* SPDX-License-Identifier: MIT */
/*
 * Prints results as one table: a line for each way to do an operation, its sizes side by side.
 *
 *     nakawari-bench-table RESULTS.csv [BUILD]             as text
 *     nakawari-bench-table --markdown RESULTS.csv [BUILD]  as Markdown, a line for each operation
 *     nakawari-bench-table --growth RESULTS.csv [BUILD]    as Markdown, how the cost grows with the size
 *     nakawari-bench-table --losses RESULTS.csv [REASONS]  as Markdown, where a peer is more than a tenth faster, and why;
 *                                                          fails if REASONS has no sentence for one of them
 *
 * vs     the time of the best peer over this one, at the size that stands for all: above 1 the library is faster.
 *        Structs are held against peers on structs, components against all.
 * limit  the least time that the machine could take, as a part of the time taken
 */
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>

#include "results.h"

using namespace bench;

static std::vector<std::string> cells(const results &r, const line &l, const std::vector<size_t> &sizes)
{
    std::vector<std::string> c = {l.who, l.layout};
    for (size_t n : sizes)
        c.push_back(l.ns.count(n) ? three(l.ns.at(n)) : "");
    c.push_back(three(l.chain));
    c.push_back(l.error == 0 ? "0" : three(l.error));
    c.push_back(three(r.versus(l, false)));
    c.push_back(three(r.versus(l, true)));
    c.push_back(three(l.bytes));
    c.push_back(three(l.flops));
    c.push_back(l.time() > 0 ? three(100 * l.limit / l.time()) + " %" : "");
    return c;
}

static std::vector<std::string> head(const std::vector<size_t> &sizes)
{
    std::vector<std::string> c = {"row", "layout"};
    for (size_t n : sizes)
        c.push_back((n == sizes[0] ? "n=" : "") + std::to_string(n));
    for (const char *text : {"chain", "error u", "vs", "vs chain", "bytes", "flops", "limit"})
        c.push_back(text);
    return c;
}

static void print(const std::vector<std::string> &c)
{
    std::printf("  %-22s %-10s", c[0].c_str(), c[1].c_str());
    for (size_t k = 2; k < c.size(); k++)
        std::printf("%9s", c[k].c_str());
    std::puts("");
}

static void print_all(const results &r)
{
    for (const line &l : r.machine)
        std::printf("  %-10s %-18s %-8s %s\n", l.build.c_str(), l.operation.c_str(), l.who.c_str(),
                    three(l.ns.at(0)).c_str());
    const line *before = nullptr;
    for (const line &l : r.lines) {
        if (!before || before->build != l.build)
            std::printf("\nBuilt for %s. Nanoseconds for each element.\n", l.build.c_str());
        if (!before || !before->does(l)) {
            std::printf("\n%s: %s\n", l.stem.c_str(), l.operation.c_str());
            print(head(r.sizes(l)));
        }
        print(cells(r, l, r.sizes(l)));
        before = &l;
    }
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
    auto peer_structs = [](const line &l) { return l.compared() && l.layout == "structs"; };
    auto peer = [](const line &l) { return l.compared(); };
    const line *batch = r.fastest(of, false, components);
    std::printf("| %s ", of.operation.c_str());
    print_pair(r.fastest(of, false, structs), r.fastest(of, false, peer_structs), false);
    print_pair(r.fastest(of, true, structs), r.fastest(of, true, peer), true);
    print_pair(batch, r.fastest(of, false, peer), false);
    std::printf("| %s |\n", batch ? (three(100 * batch->limit / batch->time()) + " %").c_str() : "");
}

static void print_markdown(const results &r)
{
    std::puts("| limit | sse2 | avx2 | avx512 |\n|---|--:|--:|--:|");
    for (size_t k = 0; k < 5 && k < r.machine.size(); k++) {
        std::printf("| %s ", r.machine[k].operation.c_str());
        for (const char *isa : {"sse2", "avx2", "avx512"})
            for (const line &l : r.machine)
                if (l.operation == r.machine[k].operation && l.who == isa)
                    std::printf("| %s ", three(l.ns.at(0)).c_str());
        std::puts("|");
    }
    const line *before = nullptr;
    for (const line &l : r.lines) {
        if (!before || before->stem != l.stem)
            std::printf("\n### %s.h\n\n| operation | single | best peer | ratio | chain | best peer | ratio | arrays | "
                        "best peer | ratio | of the limit |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
                        l.stem.c_str());
        if (!before || !before->does(l))
            print_operation(r, l);
        before = &l;
    }
}

static void print_growth_of(const results &r, const growth &g)
{
    const line *of = nullptr;
    for (const line &l : r.lines)
        of = !of && l.stem == g.stem && l.operation == g.operation ? &l : of;
    if (!of)
        return;
    std::vector<size_t> sizes = r.sizes(*of);
    std::printf("%s.h, %s: nanoseconds for each %s\n\n| %s |", g.stem, g.operation, g.element, g.size);
    for (size_t n : sizes)
        std::printf(" %zu |", n);
    std::printf("\n|---|");
    for (size_t k = 0; k < sizes.size(); k++)
        std::printf("--:|");
    std::puts("");
    for (const line &l : r.lines)
        if (l.does(*of)) {
            std::printf("| %s |", l.who.c_str());
            for (size_t n : sizes)
                std::printf(" %s |", l.ns.count(n) ? three(l.ns.at(n)).c_str() : "");
            std::puts("");
        }
    std::puts("");
}

/* How an operation is called: the rows of the library and of the peers that are compared. */
struct form {
    const char *name, *layout;
    bool chain, structs_only;
};
static const form forms[] = {
    {"single", "structs", false, true}, {"chain", "structs", true, false}, {"arrays", "components", false, false}};

/* The best peer's time over the library's in `build`; 0 where one of them is missing. Stores the name of the peer. */
static double ratio_of(const results &r, line of, const form &f, const std::string &build, std::string *who)
{
    of.build = build;
    const line *own = r.fastest(of, f.chain, [&](const line &l) { return l.own() && l.layout == f.layout; });
    const line *peer = r.fastest(
        of, f.chain, [&](const line &l) { return l.compared() && (!f.structs_only || l.layout == f.layout); });
    if (!own || !peer)
        return 0;
    *who = peer->who;
    return f.chain ? peer->chain / own->chain : peer->time() / own->time();
}

/* The sentences of a file: "stem, operation: sentence" or "stem: sentence" a line. */
static std::map<std::string, std::string> read_reasons(const char *path)
{
    std::map<std::string, std::string> reasons;
    std::ifstream in(path);
    std::string text;
    while (std::getline(in, text)) {
        size_t colon = text.find(": ");
        if (colon != std::string::npos)
            reasons[text.substr(0, colon)] = text.substr(colon + 2);
    }
    return reasons;
}

/* That of the operation, or of its stem, or "". */
static std::string reason_of(const std::map<std::string, std::string> &reasons, const line &l)
{
    for (const std::string &name : {l.stem + ", " + l.operation, l.stem})
        if (reasons.count(name))
            return reasons.at(name);
    return "";
}

/*
 * Prints a line for each form of an operation in which a peer is more than a tenth faster in some build, the reason last.
 * Returns how many have no reason in the file.
 */
static int print_losses(const results &r, const char *reasons_path)
{
    std::map<std::string, std::string> reasons;
    if (reasons_path)
        reasons = read_reasons(reasons_path);
    const std::vector<std::string> builds = r.builds();
    int missing = 0;
    std::string head = "| operation | form |", rule = "|---|---|";
    for (const std::string &b : builds)
        head += " " + b + " |", rule += "--:|";
    std::printf("%s why |\n%s---|\n", head.c_str(), rule.c_str());
    std::set<std::string> seen;
    for (const line &l : r.lines) {
        std::string name = l.stem + ", " + l.operation;
        if (!seen.insert(name).second)
            continue;
        for (const form &f : forms) {
            std::string cells, who;
            bool lost = false;
            for (const std::string &b : builds) {
                double ratio = ratio_of(r, l, f, b, &who);
                lost = lost || (ratio > 0 && ratio < 0.9);
                cells += ratio > 0 ? " " + three(ratio) + " " + who + " |" : " |";
            }
            if (!lost)
                continue;
            std::string reason = reason_of(reasons, l);
            if (reasons_path && reason.empty())
                std::fprintf(stderr, "%s: no line \"%s: ...\"\n", reasons_path, name.c_str()), missing++;
            std::printf("| %s | %s |%s %s |\n", name.c_str(), f.name, cells.c_str(), reason.c_str());
        }
    }
    return missing;
}

int main(int argc, char **argv)
{
    std::string how = argc > 1 && argv[1][0] == '-' ? argv[1] : "";
    int first = how.empty() ? 1 : 2;
    results r;
    bool losses = how == "--losses";
    const char *second = argc > first + 1 ? argv[first + 1] : nullptr;
    bool known = how.empty() || how == "--markdown" || how == "--growth" || losses;
    if (!known || argc <= first || !r.read(argv[first], losses ? nullptr : second)) {
        std::fprintf(stderr, "usage: %s [--markdown | --growth] RESULTS.csv [BUILD] | --losses RESULTS.csv [REASONS]\n",
                     argv[0]);
        return 2;
    }
    if (losses)
        return print_losses(r, second) > 0;
    if (how == "--markdown")
        print_markdown(r);
    else if (how == "--growth")
        for (const growth &g : growths)
            print_growth_of(r, g);
    else
        print_all(r);
    return 0;
}
