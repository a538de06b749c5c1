/* SPDX-License-Identifier: MIT */
/*
 * Runs the benchmarks and appends their results to FOLDER/<processor>.csv:
 *
 *     nakawari-bench-<build> FOLDER [options of Google Benchmark]
 *
 * A row is the median of its repetitions. Gives 1 where a row's answer was wrong.
 */
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <deque>
#include <fstream>
#include <iostream>
#include <map>

#include <benchmark/benchmark.h>

#include "probe.h"
#include "report.h"

namespace bench
{

static std::deque<row> &rows()
{
    static std::deque<row> all;
    return all;
}

row &new_row()
{
    rows().emplace_back();
    return rows().back();
}

/* "AMD EPYC 9654 96-Core" becomes amd-epyc-9654-96-core. */
static std::string processor()
{
    std::ifstream info("/proc/cpuinfo");
    std::string line, name;
    while (std::getline(info, line) && line.compare(0, 10, "model name") != 0)
        line.clear();
    size_t colon = line.find(':');
    for (char c : colon == std::string::npos ? std::string() : line.substr(colon + 1))
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '-')
            name += '-';
    while (!name.empty() && name.back() == '-')
        name.pop_back();
    return name.empty() ? "unknown" : name;
}

static double median(std::vector<double> v)
{
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
}

class collector : public benchmark::BenchmarkReporter
{
  public:
    int wrong = 0;

    collector()
    {
        for (row &r : rows())
            at[r.key()] = &r;
    }
    bool ReportContext(const Context &) override
    {
        return true;
    }
    void ReportRuns(const std::vector<Run> &runs) override
    {
        for (const Run &run : runs) {
            row &r = *at.at(run.run_name.function_name);
            if (run.error_occurred) {
                std::cerr << r.key() << ": " << run.error_message << "\n";
                wrong++;
            } else if (run.run_type == Run::RT_Iteration) {
                double time = r.told ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
                r.ns.push_back(time / static_cast<double>(r.elements));
            }
        }
    }

  private:
    std::map<std::string, row *> at;
};

static void write_limits(std::ostream &out)
{
    for (const limits &l : machine_limits()) {
        const double values[] = {l.flops, l.near_copy, l.second_copy, l.third_copy, l.far_copy};
        const char *names[] = {"peak Gflop/s", "copy L1 GB/s", "copy L2 GB/s", "copy L3 GB/s", "copy memory GB/s"};
        for (size_t k = 0; k < 5; k++)
            out << BENCH_BUILD << ",machine," << names[k] << "," << l.isa << ",,0," << values[k] << ",,,,\n";
    }
}

static void write(const std::string &path)
{
    bool begins = !std::ifstream(path).good();
    std::ofstream out(path, std::ios::app);
    if (begins)
        out << "build,stem,operation,row,layout,n,value,error_u,bytes,flops,limit_ns\n";
    out.precision(5);
    if (BENCH_ROWS != rows_peers)
        write_limits(out);
    for (const row &r : rows())
        if (!r.ns.empty())
            out << BENCH_BUILD << "," << r.stem << ",\"" << r.operation << "\",\"" << r.who << "\"," << r.layout << ","
                << r.n << "," << median(r.ns) << "," << r.error << "," << r.bytes << "," << r.flops << ","
                << limit_ns(r) << "\n";
}

} // namespace bench

int main(int argc, char **argv)
{
    if (argc < 2 || argv[1][0] == '-') {
        std::fprintf(stderr, "usage: %s FOLDER [options of Google Benchmark]\n", argv[0]);
        return 2;
    }
    std::string path = std::string(argv[1]) + "/" + bench::processor() + ".csv";
    argv[1] = argv[0];
    argc--;
    argv++;
    bench::draw_inputs();
    bench::list_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    bench::collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    bench::write(path);
    return collector.wrong != 0;
}
