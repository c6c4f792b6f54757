// Warnings and advice about substeps.
#include "sim/stability_advice.h"

#include <fmt/format.h>

#include <limits>

namespace nuno {
namespace {

std::string_view method_name(Method method) { return choice_names(method)[static_cast<std::size_t>(method)]; }

// What to try where the limit of cloth that is hardly stretched was not enough.
std::string advice_when_stretched(const ClothModel& model, const SimParams& params)
{
    if (!is_explicit(params.method)) return "try more substeps, or less load";
    if (params.internal_model == InternalModel::continuum)
        return "try less load, or --set substeps=0, which follows its stretch";
    const int substeps = least_stable_substeps(model, params, std::numeric_limits<double>::infinity());
    if (substeps > params.substeps) return fmt::format("--set substeps={} holds however far it is stretched", substeps);
    return "try more substeps, less load, or --method xpbd";
}

}  // namespace

std::optional<std::string> stability_warning(const ClothModel& model, const SimParams& params)
{
    const double limit_s = largest_stable_substep(model, params);
    if (double(substep_s(params)) <= limit_s) return std::nullopt;
    const int substeps = least_stable_substeps(model, params);
    const std::string advice = substeps > 0 ? fmt::format("--set substeps={} holds", substeps)
                               : limit_s > 0
                                   ? "so many substeps a frame cannot be set; more damping or softer springs would hold"
                                   : "no number of substeps holds; more damping or softer springs would";
    return fmt::format("substep {:.4g} s is longer than the {:.4g} s up to which {} is stable; {}", substep_s(params),
                       limit_s, method_name(params.method), advice);
}

std::optional<std::string> present_warning(const ClothModel& model, const SimParams& params,
                                           const PresentStability& now)
{
    if (double(substep_s(params)) <= now.largest_stable_substep_s) return std::nullopt;
    return fmt::format(
        "substep {:.4g} s is longer than the {:.4g} s up to which {} is stable where the cloth is now, so what it did "
        "is not to be trusted; {}",
        substep_s(params), now.largest_stable_substep_s, method_name(params.method),
        stability_warning(model, params) ? "see the warning above" : advice_when_stretched(model, params));
}

std::string advice_after_blow_up(const ClothModel& model, const SimParams& params)
{
    return stability_warning(model, params).value_or(advice_when_stretched(model, params));
}

}  // namespace nuno
