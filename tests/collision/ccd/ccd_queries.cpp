// Answers a file of continuous queries: a line `id,hit,toi` each, and how long a query took. With a separation, the time
// until which that is kept.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "collision/ccd/impact.h"
#include "collision/ccd/query_file.h"
#include "core/error.h"
#include "core/stopwatch.h"
#include "core/text.h"

namespace {

using Times = std::vector<std::optional<double>>;

double answer_all(const std::vector<nuno::FileQuery>& queries, double separation, Times& times)
{
    const nuno::Stopwatch watch;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const nuno::FileQuery& query = queries[i];
        times[i] = query.kind == nuno::PairKind::vertex_face ? nuno::vertex_face_impact(query.t0, query.t1, separation)
                                                             : nuno::edge_edge_impact(query.t0, query.t1, separation);
    }
    return watch.elapsed_ms();
}

// The fastest of ten passes over all queries, or of as many as half a second has room for.
double mean_microseconds(const std::vector<nuno::FileQuery>& queries, double separation, Times& times)
{
    const nuno::Stopwatch watch;
    double least_ms = answer_all(queries, separation, times);
    for (int pass = 1; pass < 10 && watch.elapsed_ms() < 500; ++pass)
        least_ms = std::min(least_ms, answer_all(queries, separation, times));
    return queries.empty() ? 0 : 1000 * least_ms / static_cast<double>(queries.size());
}

double separation_of(const char* text)
{
    const std::optional<double> separation = nuno::parse_number(text);
    if (!separation || !(*separation >= 0))
        throw nuno::Error(std::string("separation '") + text + "' is no length, a number that is not negative");
    return *separation;
}

void print(const std::vector<nuno::FileQuery>& queries, const Times& times)
{
    for (std::size_t i = 0; i < queries.size(); ++i) {
        if (times[i])
            std::printf("%s,1,%.17g\n", queries[i].id.c_str(), *times[i]);
        else
            std::printf("%s,0,\n", queries[i].id.c_str());
    }
}

}  // namespace

int main(int argument_count, char** arguments)
{
    if (argument_count != 2 && argument_count != 3) {
        std::fprintf(stderr, "usage: ccd_queries FILE [SEPARATION], with lines `id vf|ee x0 .. x23` in FILE\n");
        return 2;
    }
    try {
        const double separation = argument_count == 3 ? separation_of(arguments[2]) : 0;
        const std::vector<nuno::FileQuery> queries = nuno::read_query_file(arguments[1]);
        Times times(queries.size());
        const double mean_us = mean_microseconds(queries, separation, times);
        print(queries, times);
        if (std::fflush(stdout) != 0) throw nuno::Error("the answers cannot be written");
        std::fprintf(stderr, "mean microseconds a query: %.4f\n", mean_us);
    } catch (const nuno::Error& error) {
        std::fprintf(stderr, "ccd_queries: %s\n", error.what());
        return 2;
    }
    return 0;
}
