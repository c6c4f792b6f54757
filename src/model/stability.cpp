// Stability limits of the explicit methods.
#include "model/stability.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace nuno {
namespace {

// Largest eigenvalue of a symmetric, positive semi-definite 3x3 matrix, by its characteristic cubic in trigonometric
// form.
double largest_eigenvalue(const glm::dmat3& a)
{
    const double mean = (a[0][0] + a[1][1] + a[2][2]) / 3;
    const glm::dmat3 b = a - mean * glm::dmat3(1);
    double norm_sq = 0;
    for (int i = 0; i < 3; ++i) norm_sq += glm::dot(b[i], b[i]);
    const double scale = std::sqrt(norm_sq / 6);
    if (scale <= 1e-14 * std::abs(mean)) return mean;
    const double half_det = std::clamp(glm::determinant(b) / (2 * scale * scale * scale), -1.0, 1.0);
    return mean + 2 * scale * std::cos(std::acos(half_det) / 3);
}

}  // namespace

double omega_max_bound(const ClothModel& model, const SimParams& params)
{
    const double stiffness[kSpringKindCount] = {params.structural_stiffness, params.shear_stiffness,
                                                params.bend_stiffness};
    std::vector<glm::dmat3> blocks(model.vertex_count(), glm::dmat3(0));
    for (const Spring& spring : model.springs) {
        const glm::dvec3 n =
            glm::normalize(glm::dvec3(model.rest_positions[spring.b] - model.rest_positions[spring.a]));
        const glm::dmat3 block = stiffness[static_cast<int>(spring.kind)] * glm::outerProduct(n, n);
        blocks[spring.a] += block;
        blocks[spring.b] += block;
    }
    double omega_sq = 0;
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v) {
        if (model.pinned[v]) continue;
        const double mass = double(model.areas[v]) * double(params.areal_density);
        omega_sq = std::max(omega_sq, 2 * largest_eigenvalue(blocks[v]) / mass);
    }
    return std::sqrt(omega_sq);
}

double largest_stable_substep(const ClothModel& model, const SimParams& params)
{
    // A thread stretched to l pulls across its length, too: omega^2 grows by the factor 2 - l0 / l.
    const double omega = omega_max_bound(model, params) * std::sqrt(2 - 1 / (1 + kStretchAllowedFor));
    const double damping_rate = double(params.damping) / double(params.areal_density);  // c / m [1/s]
    if (omega <= 0) return damping_rate > 0 ? 2 / damping_rate : 1e9;
    const double zeta = damping_rate / (2 * omega);
    switch (params.method) {
    case Method::explicit_euler: return (zeta <= 1 ? 2 * zeta : 2 / (zeta + std::sqrt(zeta * zeta - 1))) / omega;
    case Method::symplectic_euler: return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / omega;
    }
    return 0;
}

int least_stable_substeps(const ClothModel& model, const SimParams& params)
{
    const double limit_s = largest_stable_substep(model, params);
    if (limit_s <= 0) return 0;
    const double count = std::ceil(1 / (double(params.frame_rate) * limit_s));
    const ParamInfo* info = find_param(sim_param_table(), "substeps");
    return count <= info->max ? std::max(1, static_cast<int>(count)) : 0;
}

}  // namespace nuno
