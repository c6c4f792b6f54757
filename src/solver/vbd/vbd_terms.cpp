// What vertex block descent makes of the parameters.
#include "solver/vbd/vbd_terms.h"

#include <algorithm>

#include "model/spring_weights.h"

namespace nuno {
namespace {

constexpr int kDefaultIterations = 2;
constexpr float kMostStiffness = 3;  // m / h^2, for each iteration

int iterations_of(const SimParams& params) { return params.iterations > 0 ? params.iterations : kDefaultIterations; }

// Stiffness [N/m] that a vertex of this area [m2] bears.
float most_stiffness(const SimParams& params, float area)
{
    const float h = substep_s(params);
    return kMostStiffness * static_cast<float>(iterations_of(params)) * params.areal_density * area / (h * h);
}

}  // namespace

VbdTerms vbd_terms(const ClothModel& model, const SimParams& params)
{
    const float h = substep_s(params);
    VbdTerms terms{.h = h,
                   .inverse_h = 1 / h,
                   .damper = params.stiffness_damping / h,
                   .longest = 1 + params.strain_limit,
                   .stiffer = 0,
                   .iterations = iterations_of(params)};
    if (params.strain_limit == 0) return terms;
    float stiffest = 0, area = 0;
    for (const SpringWeight& weight : vbd_spring_weights(model, params)) stiffest = std::max(stiffest, weight.axial);
    for (const float a : model.areas) area += a / static_cast<float>(model.areas.size());
    terms.stiffer = stiffest > 0 ? most_stiffness(params, area) / stiffest : 0.0f;
    return terms;
}

std::vector<SpringWeight> vbd_spring_weights(const ClothModel& model, const SimParams& params)
{
    std::vector<SpringWeight> weights = spring_weights(model, params);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Spring& spring = model.springs[i];
        const float area = std::max(model.areas[spring.a], model.areas[spring.b]);
        weights[i].axial = std::min(weights[i].axial, most_stiffness(params, area));
    }
    return weights;
}

bool vbd_spring_weights_differ(const SimParams& a, const SimParams& b)
{
    return spring_weights_differ(a, b) || most_stiffness(a, 1) != most_stiffness(b, 1);
}

}  // namespace nuno
