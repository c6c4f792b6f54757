// Ladders of substeps.
#include "study/trade_settings.h"

#include "model/stability.h"
#include "solver/method_choice.h"

namespace nuno {
namespace {

constexpr int kMostSubsteps = 10000;

SimParams with_method(SimParams params, Method method)
{
    params.method = method;
    return params;
}

// What does not resolve the motion is of use only where the scene is slow: the first of these is about it.
std::vector<int> substeps_of(const MethodInfo& info, const ClothModel& model, const SimParams& params)
{
    if (!is_explicit(info.method))
        return info.takes_tethers ? std::vector{1, 2, 4, 8, 16, 32, 64} : std::vector{1, 2, 4, 8, 16, 32};
    const int least = least_stable_substeps(model, with_method(params, info.method));
    if (least == 0) return {};
    std::vector<int> ladder;
    for (int n = least; n <= kMostSubsteps && ladder.size() < 4; n *= 2) ladder.push_back(n);
    return ladder;
}

// 0: the method's own.
std::vector<int> iterations_of(Method method)
{
    if (method == Method::xpbd) return {0, 4};
    if (method == Method::vbd) return {0, 20};
    return {0};
}

}  // namespace

bool can_run(const MethodInfo& info, const SimParams& params)
{
    return info.method != Method::reference && info.on(Backend::cpu) &&
           (params.internal_model != InternalModel::continuum || info.takes_continuum) &&
           (params.stiffness_damping <= 0 || info.takes_dampers);
}

Setting of_method(const MethodInfo& info, const SimParams& params)
{
    Setting setting{{"method", std::string(info.name)}};
    if (info.takes_tethers) return setting;
    if (params.tethers != Tethers::automatic && params.tethers != Tethers::none)
        setting.emplace_back("tethers", "none");
    if (params.strain_limit > 0) setting.emplace_back("strain_limit", "0");
    return setting;
}

std::vector<Setting> settings_in_time(const ClothModel& model, const Bodies& bodies, const SimParams& params)
{
    std::vector<Setting> settings;
    for (const MethodInfo& info : method_table()) {
        if (!can_run(info, params)) continue;
        const bool tethered = info.takes_tethers &&
                              resolve_params(model, bodies, with_method(params, info.method)).tethers != Tethers::none;
        for (const bool untied : {false, true}) {
            if (untied && !tethered) continue;
            for (const int iterations : iterations_of(info.method))
                for (const int substeps : substeps_of(info, model, params)) {
                    Setting setting = of_method(info, params);
                    if (untied) setting.emplace_back("tethers", "none");
                    if (iterations > 0) setting.emplace_back("iterations", std::to_string(iterations));
                    setting.emplace_back("substeps", std::to_string(substeps));
                    settings.push_back(std::move(setting));
                }
        }
    }
    return settings;
}

std::vector<Setting> settings_by_method(const ClothModel& model, const Bodies& bodies, const SimParams& params)
{
    std::vector<Setting> settings;
    for (const MethodInfo& info : method_table()) {
        if (!can_run(info, params)) continue;
        SimParams own = with_method(params, info.method);
        own.substeps = 0;
        own = resolve_params(model, bodies, own);
        const int least = least_stable_substeps(model, own);
        if (is_explicit(info.method) && (least == 0 || own.substeps < least)) continue;
        settings.push_back(of_method(info, params));
        settings.back().emplace_back("substeps", "0");
    }
    return settings;
}

}  // namespace nuno
