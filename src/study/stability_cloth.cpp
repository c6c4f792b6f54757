// Rest states, and exact substeps.
#include "study/stability_cloth.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/stability.h"
#include "model/stiffness_product.h"
#include "solver/method_table.h"

namespace nuno {
namespace {

SimParams params_of(SimParams p, const RestCase& rest)
{
    scale_stiffness(p, rest.stiffness);
    p.backend = Backend::cpu;
    p.tethers = Tethers::none;
    p.strain_limit = 0;
    p.damping = static_cast<float>(rest.damping);
    p.wind_model = WindModel::sines;
    p.wind_strength = 0;
    p.wind_mean = static_cast<float>(rest.pressure);
    if (!rest.loaded) p.gravity_x = p.gravity_y = p.gravity_z = 0;
    p.seed = 0;
    return p;
}

// And its mode, at most 1.
double highest_frequency(const ClothModel& model, const SimParams& params, const ClothState& state,
                         std::vector<glm::dvec3>& mode)
{
    mode.clear();
    double omega = omega_max(model, params, state, mode), before = 0;
    for (int i = 0; i < 100 && omega - before > 1e-6 * omega; ++i) {
        before = omega;
        omega = omega_max(model, params, state, mode);
    }
    return omega;
}

// Cosines with half a wave along each side of the sheet's box, moving along that side.
std::vector<glm::dvec3> slow_motion(const ClothModel& model, const ClothState& rest)
{
    glm::vec3 low = model.rest_positions.front(), high = low;
    for (const glm::vec3& p : model.rest_positions) low = glm::min(low, p), high = glm::max(high, p);
    std::vector<glm::dvec3> motion(rest.positions.size(), glm::dvec3(0));
    for (std::size_t v = 0; v < motion.size(); ++v)
        for (int axis = 0; axis < 3; ++axis) {
            const double side = double(high[axis]) - double(low[axis]);
            if (rest.positions[v].w <= 0 || side <= 0) continue;
            motion[v][axis] = std::cos(M_PI * (double(model.rest_positions[v][axis]) - double(low[axis])) / side);
        }
    return motion;
}

// Rayleigh's quotient of the slow motion.
double frequency_of(const ClothModel& model, const SimParams& params, const ClothState& state,
                    const std::vector<glm::dvec3>& motion)
{
    std::vector<glm::dvec3> forces(motion.size());
    StiffnessProduct(model, params).multiply(state.positions, motion, forces);
    double work = 0, mass = 0;
    for (std::size_t v = 0; v < motion.size(); ++v) {
        if (state.positions[v].w <= 0) continue;
        work += glm::dot(motion[v], forces[v]);
        mass += glm::dot(motion[v], motion[v]) / double(state.positions[v].w);
    }
    return std::sqrt(std::max(work / mass, 0.0));
}

double mean_length(const ClothModel& model, const ClothState& state)
{
    double sum = 0;
    for (const Spring& spring : model.springs)
        sum += double(glm::distance(glm::vec3(state.positions[spring.a]), glm::vec3(state.positions[spring.b])));
    return sum / double(model.springs.size());
}

// Brings a loaded cloth to rest: seconds with a damper that is right for slow modes, in substeps short enough for any
// stretch.
void settle(RestCloth& cloth)
{
    constexpr double rate = 8, seconds = 16;  // [1/s], [s]
    RestCloth damped = cloth;
    damped.params.damping = static_cast<float>(rate * double(cloth.params.areal_density));
    const double h = 0.5 / damped.omega_bound;
    ExactSubsteps run(damped, Method::symplectic_euler, h);
    run.upload(cloth.rest);
    run.step(static_cast<int>(seconds / h));
    cloth.rest = run.state();
    for (glm::vec4& v : cloth.rest.velocities) {
        cloth.residual_speed = std::max(cloth.residual_speed, double(glm::length(glm::vec3(v))));
        v = {0, 0, 0, v.w};
    }
}

}  // namespace

void make_every_other_lighter(ClothModel& model, double ratio)
{
    for (const Sheet& sheet : model.sheets)
        for (std::uint32_t i = 0; i < sheet.vertex_count; ++i) {
            const auto columns = static_cast<std::uint32_t>(std::max(sheet.columns, 1));
            if ((i % columns + i / columns) % 2 == 0) continue;
            const std::uint32_t v =
                sheet.is_grid() ? sheet.grid_vertex(int(i % columns), int(i / columns)) : sheet.first_vertex + i;
            model.areas[v] = static_cast<float>(double(model.areas[v]) / ratio);
        }
}

void scale_stiffness(SimParams& p, double factor)
{
    for (float* k :
         {&p.structural_stiffness, &p.shear_stiffness, &p.bend_stiffness, &p.warp_stiffness, &p.weft_stiffness,
          &p.cross_stiffness, &p.shear_modulus, &p.bending_warp, &p.bending_weft, &p.bending_bias})
        *k = static_cast<float>(double(*k) * factor);
}

RestCloth rest_cloth(const ClothModel& sheets, const SimParams& params, const RestCase& rest)
{
    RestCloth cloth;
    cloth.model = sheets;
    cloth.model.start_positions = cloth.model.rest_positions;
    cloth.model.handle_pins.clear();
    if (rest.mass_ratio != 1) make_every_other_lighter(cloth.model, rest.mass_ratio);
    cloth.params = params_of(params, rest);
    cloth.rest = start_state(cloth.model, cloth.params);
    cloth.omega_bound = omega_max_bound(cloth.model, cloth.params);
    if (rest.loaded) {
        settle(cloth);
        cloth.omega_bound *= std::sqrt(2.0);  // however far springs are stretched
    }
    cloth.omega = highest_frequency(cloth.model, cloth.params, cloth.rest, cloth.fast_motion);
    cloth.slow_motion = slow_motion(cloth.model, cloth.rest);
    cloth.slow_omega = frequency_of(cloth.model, cloth.params, cloth.rest, cloth.slow_motion);
    cloth.spring_m = mean_length(cloth.model, cloth.rest);
    return cloth;
}

double predicted_limit_s(const RestCloth& cloth, Method method)
{
    SimParams params = cloth.params;
    params.method = method;
    return largest_stable_substep(params, cloth.omega);
}

ClothState shaken(const RestCloth& cloth, const Shake& shake)
{
    std::mt19937 random(static_cast<std::uint32_t>(shake.seed));
    const auto share = [&] { return double(random() >> 8) * (2.0 / 16777215.0) - 1; };
    const double speed = shake.share * cloth.spring_m * cloth.slow_omega;
    ClothState state = cloth.rest;
    for (std::size_t v = 0; v < state.velocities.size(); ++v)
        for (int axis = 0; axis < 3; ++axis) {
            const double of_all_modes = shake.noise * share();
            if (state.positions[v].w <= 0) continue;
            const double of_the_fast = shake.fast * cloth.fast_motion[v][axis];
            state.velocities[v][axis] =
                static_cast<float>(speed * (cloth.slow_motion[v][axis] + of_all_modes + of_the_fast));
        }
    return state;
}

ExactSubsteps::ExactSubsteps(const RestCloth& cloth, Method method, double substep_s) : params_(cloth.params)
{
    params_.method = method;
    params_.frame_rate = 1;
    params_.substeps = std::max(1, static_cast<int>(std::ceil(1 / substep_s)));
    unit_s_ = substep_s * params_.substeps;
    params_.areal_density = static_cast<float>(double(params_.areal_density) / (unit_s_ * unit_s_));
    params_.damping = static_cast<float>(double(params_.damping) / unit_s_);
    params_.stiffness_damping = static_cast<float>(double(params_.stiffness_damping) / unit_s_);
    for (float* g : {&params_.gravity_x, &params_.gravity_y, &params_.gravity_z})
        *g = static_cast<float>(double(*g) * unit_s_ * unit_s_);
    solver_ = make_solver(cloth.model, no_bodies_, params_, pool_);
}

void ExactSubsteps::upload(const ClothState& state)
{
    state_ = state;
    for (glm::vec4& p : state_.positions) p.w = static_cast<float>(double(p.w) * unit_s_ * unit_s_);
    for (glm::vec4& v : state_.velocities) v = glm::vec4(glm::vec3(v) * static_cast<float>(unit_s_), v.w);
    solver_->upload(state_);
    done_ = 0;
}

void ExactSubsteps::step(int count)
{
    solver_->step({params_, done_ / double(params_.substeps), count});
    done_ += count;
}

const ClothState& ExactSubsteps::state()
{
    solver_->finish();
    solver_->download_positions(state_.positions);
    solver_->download_velocities(state_.velocities);
    const double per_unit = 1 / unit_s_;
    for (glm::vec4& p : state_.positions) p.w = static_cast<float>(double(p.w) * per_unit * per_unit);
    for (glm::vec4& v : state_.velocities) v = glm::vec4(glm::vec3(v) * static_cast<float>(per_unit), v.w);
    return state_;
}

namespace {

// The root of the mean of `square_of` a vertex, by mass.
template <class SquareOf>
double mean_root(const ClothState& rest, SquareOf square_of)
{
    double sum = 0, mass = 0;
    for (std::size_t v = 0; v < rest.positions.size(); ++v) {
        const double w = double(rest.positions[v].w);
        if (w <= 0) continue;
        sum += square_of(v) / w;
        mass += 1 / w;
    }
    return std::sqrt(sum / mass);
}

double square(const glm::dvec3& a) { return glm::dot(a, a); }

}  // namespace

double mean_speed(const RestCloth& cloth, const ClothState& state)
{
    return mean_root(cloth.rest, [&](std::size_t v) { return square(glm::dvec3(state.velocities[v])); });
}

double difference(const RestCloth& cloth, const ClothState& a, const ClothState& b)
{
    return mean_root(cloth.rest, [&](std::size_t v) {
        return square(glm::dvec3(a.velocities[v]) - glm::dvec3(b.velocities[v])) +
               square(cloth.slow_omega * (glm::dvec3(a.positions[v]) - glm::dvec3(b.positions[v])));
    });
}

}  // namespace nuno
