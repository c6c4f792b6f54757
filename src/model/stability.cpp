// Frequencies of a cloth, and stability limits.
#include "model/stability.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/face_table.h"
#include "model/spring_weights.h"
#include "model/stiffness_product.h"

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

double vertex_mass(const ClothModel& model, const SimParams& params, std::uint32_t v)
{
    return double(model.areas[v]) * double(params.areal_density);
}

double springs_omega_sq(const ClothModel& model, const SimParams& params)
{
    const std::vector<SpringWeight> weights = spring_weights(model, params);
    std::vector<glm::dmat3> blocks(model.vertex_count(), glm::dmat3(0));
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Spring& spring = model.springs[i];
        const glm::dvec3 n =
            glm::normalize(glm::dvec3(model.rest_positions[spring.b] - model.rest_positions[spring.a]));
        const glm::dmat3 block =
            double(weights[i].axial) * glm::outerProduct(n, n) + std::abs(double(weights[i].plate)) * glm::dmat3(1);
        blocks[spring.a] += block;
        blocks[spring.b] += block;
    }
    double omega_sq = 0;
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v)
        if (!model.pinned[v])
            omega_sq = std::max(omega_sq, 2 * largest_eigenvalue(blocks[v]) / vertex_mass(model, params, v));
    return omega_sq;
}

// Lower triangular L with L L^T = C.
glm::dmat3 root_of_stiffness(const formulas::MembraneConstants& c)
{
    const double l11 = std::sqrt(double(c.warp)), l21 = l11 > 0 ? double(c.cross) / l11 : 0;
    const double l22 = std::sqrt(std::max(double(c.weft) - l21 * l21, 0.0));
    return {l11, l21, 0, 0, l22, 0, 0, 0, std::sqrt(double(c.shear))};
}

// E = B u for moves u in the plane, B M^-1 B^T summed over the corners, each with the mass of its share of this face.
double face_omega_sq(const formulas::FaceRest& r, const glm::dvec3& inverse_masses, const glm::dmat3& root)
{
    const double warp[] = {-double(r.warp_1) - double(r.warp_2), double(r.warp_1), double(r.warp_2)};
    const double weft[] = {-double(r.weft_1) - double(r.weft_2), double(r.weft_1), double(r.weft_2)};
    glm::dmat3 sum(0);
    for (int corner = 0; corner < 3; ++corner) {
        const double p = warp[corner], q = weft[corner], w = inverse_masses[corner];
        const glm::dvec3 along_warp(p, 0, q), along_weft(0, q, p);  // columns of B: E11, E22, 2 E12
        sum += w * (glm::outerProduct(along_warp, along_warp) + glm::outerProduct(along_weft, along_weft));
    }
    return double(r.area) * largest_eigenvalue(glm::transpose(root) * sum * root);
}

double membrane_omega_sq(const ClothModel& model, const SimParams& params)
{
    const std::vector<formulas::FaceRest> rests = face_rests(model);
    const glm::dmat3 root = root_of_stiffness(membrane_constants(params));
    std::vector<double> face_areas(model.vertex_count());
    for (std::size_t face = 0; face < rests.size(); ++face)
        for (int corner = 0; corner < 3; ++corner)
            face_areas[model.faces[face][corner]] += double(rests[face].area) / 3;
    double omega_sq = 0;
    for (std::size_t face = 0; face < rests.size(); ++face) {
        glm::dvec3 inverse_masses(0);
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t v = model.faces[face][corner];
            const double share = double(rests[face].area) / 3 / face_areas[v];
            if (!model.pinned[v]) inverse_masses[corner] = 1 / (share * vertex_mass(model, params, v));
        }
        omega_sq = std::max(omega_sq, face_omega_sq(rests[face], inverse_masses, root));
    }
    return omega_sq;
}

// Numbers in -1 .. 1 that are the same on every machine.
std::vector<glm::dvec3> noise(std::size_t count)
{
    std::vector<glm::dvec3> values(count);
    std::uint64_t bits = 1;
    for (glm::dvec3& value : values)
        for (int axis = 0; axis < 3; ++axis) {
            bits = bits * 6364136223846793005u + 1442695040888963407u;
            value[axis] = double(bits >> 33) / double(1u << 30) - 1;
        }
    return values;
}

int substeps_for(const SimParams& params, double limit_s)
{
    if (limit_s <= 0) return 0;
    const double count = std::ceil(1 / (double(params.frame_rate) * limit_s));
    const ParamInfo* info = find_param(sim_param_table(), "substeps");
    return count <= info->max ? std::max(1, static_cast<int>(count)) : 0;
}

}  // namespace

double omega_max_bound(const ClothModel& model, const SimParams& params)
{
    const double membrane = face_forces(params).membrane ? membrane_omega_sq(model, params) : 0;
    return std::sqrt(springs_omega_sq(model, params) + membrane);
}

double omega_max(const ClothModel& model, const SimParams& params, const ClothState& state,
                 std::vector<glm::dvec3>& mode)
{
    constexpr int warm_products = 10, cold_products = 80;
    const bool warm = mode.size() == state.positions.size();
    if (!warm) mode = noise(state.positions.size());
    const StiffnessProduct stiffness(model, params);
    std::vector<glm::dvec3> forces(mode.size());
    double omega_sq = 0;
    for (int i = 0; i < (warm ? warm_products : cold_products); ++i) {
        double mass = 0, work = 0, size = 0;
        for (std::size_t v = 0; v < mode.size(); ++v)
            if (state.positions[v].w <= 0) mode[v] = glm::dvec3(0);
        stiffness.multiply(state.positions, mode, forces);
        for (std::size_t v = 0; v < mode.size(); ++v) {
            const double w = double(state.positions[v].w);
            if (w <= 0) continue;
            mass += glm::dot(mode[v], mode[v]) / w;
            work += glm::dot(mode[v], forces[v]);
            forces[v] *= w;
            size = std::max(size, glm::length(forces[v]));
        }
        if (!(size > 0) || !std::isfinite(size)) break;
        omega_sq = work / mass;
        for (std::size_t v = 0; v < mode.size(); ++v) mode[v] = forces[v] / size;
    }
    return std::sqrt(std::max(omega_sq, 0.0));
}

namespace {

// The same with the rate [1/s] of a damper of the air.
double largest_stable_substep(const SimParams& params, double omega, double air)
{
    if (!is_explicit(params.method)) return kAnySubstep;
    constexpr int modes = 16;
    double limit = kAnySubstep;
    for (int i = 0; i <= modes; ++i) {
        const double w = omega * i / modes, rate = air + double(params.stiffness_damping) * w * w;
        if (w > 0 || rate > 0) limit = std::min(limit, stable_until(params.method, {w, rate}));
    }
    return limit;
}

// The quadratic drag rho C |u| / 2 changes by twice that with u; held down by the shared formula where h is long.
double air_rate(const SimParams& params)
{
    const double damper = double(params.damping) / double(params.areal_density);
    if (params.wind_model != WindModel::aero) return damper;
    const double speed =
        glm::length(glm::dvec3(params.wind_x, params.wind_y, params.wind_z)) + double(params.gust_speed);
    const double coefficient = std::max(double(params.pressure_coefficient), double(params.skin_coefficient));
    return damper + double(params.air_density) * coefficient * speed / double(params.areal_density);
}

// The larger eigenvalue of F^T F: the square of the largest principal stretch of a face with the edges e1, e2.
double stretch_sq(const formulas::FaceRest& r, const glm::dvec3& e1, const glm::dvec3& e2)
{
    const glm::dvec3 warp = double(r.warp_1) * e1 + double(r.warp_2) * e2;
    const glm::dvec3 weft = double(r.weft_1) * e1 + double(r.weft_2) * e2;
    const double a = glm::dot(warp, warp), b = glm::dot(weft, weft);
    return (a + b) / 2 + std::hypot((a - b) / 2, glm::dot(warp, weft));
}

// What a stretch e makes of omega^2.
double stiffening(const SimParams& params, double e)
{
    return face_forces(params).membrane ? (1 + e) * (1 + e) + e + e * e / 2 : 2 - 1 / (1 + e);
}

}  // namespace

double largest_stable_substep(const SimParams& params, double omega)
{
    return largest_stable_substep(params, omega, double(params.damping) / double(params.areal_density));
}

double largest_stable_substep(const ClothModel& model, const SimParams& params, double stretch)
{
    if (!is_explicit(params.method)) return kAnySubstep;
    const double omega = omega_max_bound(model, params) * std::sqrt(stiffening(params, stretch));
    return largest_stable_substep(params, omega, air_rate(params));
}

int least_stable_substeps(const ClothModel& model, const SimParams& params, double stretch)
{
    return substeps_for(params, largest_stable_substep(model, params, stretch));
}

double largest_face_stretch(const ClothModel& model, const ClothState& state, double ahead_s)
{
    const std::vector<formulas::FaceRest> rests = face_rests(model);
    double largest_sq = 1;
    for (std::size_t face = 0; face < rests.size(); ++face)
        for (const double t : {0.0, ahead_s}) {
            const auto corner = [&](int i) {
                const std::uint32_t v = model.faces[face][i];
                return glm::dvec3(state.positions[v]) + t * glm::dvec3(state.velocities[v]);
            };
            const glm::dvec3 origin = corner(0);
            largest_sq = std::max(largest_sq, stretch_sq(rests[face], corner(1) - origin, corner(2) - origin));
        }
    return std::sqrt(largest_sq) - 1;
}

PresentStability present_stability(const ClothModel& model, const SimParams& params, const ClothState& state,
                                   std::vector<glm::dvec3>& mode)
{
    PresentStability present{};
    present.omega_max = omega_max(model, params, state, mode);
    present.omega_bound = omega_max_bound(model, params);
    SimParams with = params;
    for (std::size_t i = 0; i < kExplicitMethods.size(); ++i) {
        with.method = kExplicitMethods[i];
        present.stable_substep_s[i] = largest_stable_substep(with, present.omega_max, air_rate(params));
    }
    present.largest_stable_substep_s = largest_stable_substep(params, present.omega_max, air_rate(params));
    present.least_substeps = substeps_for(params, present.largest_stable_substep_s / 1.05);
    return present;
}

}  // namespace nuno
