// Shares of springs that are projected all at once.
#include "solver/xpbd/jacobi_springs.h"

#include <algorithm>

#include "solver/xpbd/spring_share.h"
#include "solver/xpbd/xpbd_terms.h"

namespace nuno {
namespace {

// As many as make a sheet about as stiff as one sweep in colours and back (`hang`: docs/methods.md).
constexpr int kPassesPerIteration = 8;

// What one spring takes in a pass, for one unit of inverse mass.
struct Share
{
    double all = 0, limit = 0;
};

// Slots of a group without a force are left out.
bool has_share(const ClothModel& model, std::span<const Share> shares, int group)
{
    for (std::size_t n = 0; n < shares.size(); ++n)
        if (spring_group(model.springs[n].kind) == group && shares[n].all > 0) return true;
    return false;
}

}  // namespace

int jacobi_passes(const SimParams& params) { return kPassesPerIteration * sweep_pairs(params); }

JacobiSprings make_jacobi_springs(const ClothModel& model, const SimParams& params,
                                  std::span<const float> inverse_masses)
{
    const std::vector<SpringWeight> weights = spring_weights(model, params);
    const bool limited = params.strain_limit > 0;
    const double step = double(SubstepTimes(params).step);
    std::vector<Share> shares(weights.size());
    std::vector<double> taken(model.vertex_count());
    for (std::size_t n = 0; n < weights.size(); ++n) {
        const Spring& spring = model.springs[n];
        const double both = double(inverse_masses[spring.a]) + double(inverse_masses[spring.b]);
        shares[n].all = spring_share(both, double(weights[n].axial), step, jacobi_passes(params));
        if (limited && shares[n].all > 0) shares[n].limit = 1 / both;
        for (const std::uint32_t v : {spring.a, spring.b}) taken[v] += both * std::max(shares[n].all, shares[n].limit);
    }
    const SpringTable& table = model.spring_table;
    JacobiSprings result;
    result.vertex_count = table.vertex_count;
    for (int group = 0; group < kSpringGroupCount; ++group) {
        if (!has_share(model, shares, group)) continue;
        const std::size_t begin = std::size_t(table.first_slot[group]) * table.vertex_count;
        const std::size_t end = std::size_t(table.first_slot[group + 1]) * table.vertex_count;
        result.slot_count += table.first_slot[group + 1] - table.first_slot[group];
        for (std::size_t i = begin; i < end; ++i) {
            const bool present = table.springs[i] != SpringTable::kNoSpring;
            const Share share = present ? shares[table.springs[i]] : Share{};
            const Spring spring = present ? model.springs[table.springs[i]] : Spring{};
            const double most = present ? std::max({1.0, taken[spring.a], taken[spring.b]}) : 1;
            const double all = share.all / most, length = double(spring.rest_length);
            const double limit = static_cast<float>(all) > 0 ? share.limit / most : 0;  // none without the other
            result.neighbours.push_back(table.neighbours[i]);
            result.share.push_back(static_cast<float>(all));
            result.share_length.push_back(static_cast<float>(all * length));
            if (!limited) continue;
            result.limit.push_back(static_cast<float>(limit));
            result.limit_length.push_back(static_cast<float>(limit * length * (1 + double(params.strain_limit))));
        }
    }
    return result;
}

}  // namespace nuno
