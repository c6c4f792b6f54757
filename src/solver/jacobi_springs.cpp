// Shares of springs that are projected all at once.
#include "solver/jacobi_springs.h"

#include <algorithm>

#include "core/error.h"
#include "solver/spring_share.h"
#include "solver/xpbd_part.h"

namespace nuno {
namespace {

// As many as make a sheet about as stiff as one sweep in colours and back (`hang`: docs/methods.md).
constexpr int kPassesPerIteration = 8;

// What one spring takes in a pass, for one unit of inverse mass.
struct Share
{
    double all = 0, limit = 0;
};

}  // namespace

int jacobi_passes(const SimParams& params) { return kPassesPerIteration * std::max(params.iterations, 1); }

JacobiSprings make_jacobi_springs(const ClothModel& model, const SimParams& params,
                                  std::span<const float> inverse_masses)
{
    const std::vector<SpringWeight> weights = spring_weights(model, params);
    const bool limited = params.strain_limit > 0;
    const double step = double(SubstepTimes(params).step);
    std::vector<Share> shares(weights.size());
    std::vector<double> taken(model.vertex_count());
    for (std::size_t n = 0; n < weights.size(); ++n) {
        if (weights[n].plate != 0)
            throw Error("sweep: jacobi has no bending_warp, bending_weft and bending_bias; choose coloured, or 0 for them");
        const Spring& spring = model.springs[n];
        const double both = double(inverse_masses[spring.a]) + double(inverse_masses[spring.b]);
        shares[n].all = spring_share(both, double(weights[n].axial), step, jacobi_passes(params));
        if (limited && shares[n].all > 0) shares[n].limit = 1 / both;
        for (const std::uint32_t v : {spring.a, spring.b})
            taken[v] += both * std::max(shares[n].all, shares[n].limit);
    }
    const SpringEntries entries = spring_entries(model, weights);
    JacobiSprings result{entries.vertex_count, entries.slot_count, entries.neighbours, {}, {}, {}, {}};
    const SpringTable& table = model.spring_table;
    int slot = 0;
    for (int from = 0; from < table.slot_count() && slot < entries.slot_count; ++from) {
        const std::size_t begin = std::size_t(from) * table.vertex_count;
        const std::size_t to = std::size_t(slot) * table.vertex_count;
        // spring_entries leaves groups without a force out, in which no entry has one.
        const bool kept = std::equal(table.neighbours.begin() + std::ptrdiff_t(begin),
                                     table.neighbours.begin() + std::ptrdiff_t(begin + table.vertex_count),
                                     entries.neighbours.begin() + std::ptrdiff_t(to));
        if (!kept) continue;
        ++slot;
        for (std::uint32_t v = 0; v < table.vertex_count; ++v) {
            const std::uint32_t n = table.springs[begin + v];
            const Share share = n == SpringTable::kNoSpring ? Share{} : shares[n];
            const double most = n == SpringTable::kNoSpring
                                    ? 1
                                    : std::max({1.0, taken[model.springs[n].a], taken[model.springs[n].b]});
            const double length = n == SpringTable::kNoSpring ? 0 : double(model.springs[n].rest_length);
            result.share.push_back(static_cast<float>(share.all / most));
            result.share_length.push_back(static_cast<float>(share.all / most * length));
            if (!limited) continue;
            result.limit.push_back(static_cast<float>(share.limit / most));
            result.limit_length.push_back(
                static_cast<float>(share.limit / most * length * (1 + double(params.strain_limit))));
        }
    }
    return result;
}

}  // namespace nuno
