// Random queries held to the exact oracle, as many as asked for, or printed as ccd_queries reads them:
// ccd_fuzz [QUERIES a family] [first SEED] [FAMILY to print].
#include <cstdio>
#include <cstdlib>
#include <string>

#include "collision/ccd/oracle_check.h"
#include "collision/ccd/random_query.h"

namespace {

struct Seeds
{
    long first, count;
};

void print_query(nuno::QueryFamily family, long seed)
{
    const nuno::Query query = nuno::random_query(family, static_cast<std::uint64_t>(seed));
    std::printf("%s-%ld %s\n", nuno::name_of(family).c_str(), seed, nuno::text_of(query).c_str());
}

long wrong_count(nuno::QueryFamily family, Seeds seeds)
{
    long impacts = 0, wrong = 0;
    for (long seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
        const nuno::OracleCheck check =
            nuno::check_against_oracle(nuno::random_query(family, static_cast<std::uint64_t>(seed)));
        impacts += check.is_impact;
        if (check.fault.empty()) continue;
        ++wrong;
        std::printf("# %s\n", check.fault.c_str());
        print_query(family, seed);
    }
    std::printf("# %s: %ld impacts, %ld wrong\n", nuno::name_of(family).c_str(), impacts, wrong);
    std::fflush(stdout);
    return wrong;
}

}  // namespace

int main(int argument_count, char** arguments)
{
    const Seeds seeds{argument_count > 2 ? std::atol(arguments[2]) : 1,
                      argument_count > 1 ? std::atol(arguments[1]) : 1000};
    const std::string printed = argument_count > 3 ? arguments[3] : "";
    long wrong = 0;
    if (printed.empty()) std::printf("# %ld queries a family from seed %ld\n", seeds.count, seeds.first);
    for (int i = 0; i < static_cast<int>(nuno::QueryFamily::count); ++i) {
        const auto family = static_cast<nuno::QueryFamily>(i);
        if (printed.empty())
            wrong += wrong_count(family, seeds);
        else if (printed == nuno::name_of(family))
            for (long seed = seeds.first; seed < seeds.first + seeds.count; ++seed) print_query(family, seed);
    }
    return wrong == 0 ? 0 : 1;
}
