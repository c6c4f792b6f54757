// The plain sum of all forces.
#include "model/force_model.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "model/wind_field.h"

namespace nuno {
namespace {

formulas_f64::FaceRest in_double(const formulas::FaceRest& r)
{
    return {double(r.warp_1), double(r.warp_2), double(r.weft_1),
            double(r.weft_2), double(r.area),   double(r.mass_area)};
}

formulas_f64::MembraneConstants membrane_in_double(const SimParams& params)
{
    const formulas::MembraneConstants c = membrane_constants(params);
    return {double(c.warp), double(c.weft), double(c.cross), double(c.shear), double(c.damping)};
}

// The damper's force is not bounded as the solvers bound it for their substep (shaders/shared/aero.h): h is 0.
formulas_f64::Air air_in_double(const SimParams& params)
{
    const formulas::Air air = air_of(params);
    return {double(air.density), double(air.pressure), double(air.skin), double(air.areal_density), 0};
}

}  // namespace

ForceModel::ForceModel(const ClothModel& model, const SimParams& params)
    : model_(model), params_(params), face_forces_(face_forces(params)), weights_(spring_weights(model, params))
{
    if (!face_forces_.any()) return;
    for (const formulas::FaceRest& rest : face_rests(model)) faces_.push_back(in_double(rest));
}

void ForceModel::forces(std::span<const glm::dvec3> x, std::span<const glm::dvec3> v, double time_s,
                        std::span<glm::dvec3> force) const
{
    const glm::dvec3 gravity(params_.gravity_x, params_.gravity_y, params_.gravity_z);
    double wind = 0;  // [N/m2] along z
    if (params_.wind_model == WindModel::sines)
        wind = double(params_.wind_mean) + formulas_f64::sines_wind(double(params_.wind_strength), time_s);
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i) {
        const double area = double(model_.areas[i]);
        force[i] = formulas_f64::gravity_force(mass(i), gravity) +
                   formulas_f64::damping_force(area * double(params_.damping), v[i]) + glm::dvec3(0, 0, area * wind);
    }
    add_springs(x, v, force);
    if (face_forces_.membrane) add_membrane(x, v, force);
    if (face_forces_.air) add_air(x, v, time_s, force);
}

void ForceModel::add_springs(std::span<const glm::dvec3> x, std::span<const glm::dvec3> v,
                             std::span<glm::dvec3> force) const
{
    const double beta = double(params_.stiffness_damping);
    for (std::size_t s = 0; s < weights_.size(); ++s) {
        const Spring& spring = model_.springs[s];
        const double axial = double(weights_[s].axial), plate = double(weights_[s].plate);
        if (axial == 0 && plate == 0) continue;
        const glm::dvec3 d = x[spring.b] - x[spring.a], u = v[spring.b] - v[spring.a];
        const glm::dvec3 f = formulas_f64::spring_force(d, axial + plate, axial * double(spring.rest_length)) +
                             formulas_f64::spring_damping_force(d, u, beta * axial);
        force[spring.a] += f;
        force[spring.b] -= f;
    }
}

void ForceModel::add_membrane(std::span<const glm::dvec3> x, std::span<const glm::dvec3> v,
                              std::span<glm::dvec3> force) const
{
    const formulas_f64::MembraneConstants constants = membrane_in_double(params_);
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        const glm::uvec3 c = model_.faces[face];
        const formulas_f64::CornerForces f = formulas_f64::membrane_forces(
            x[c[1]] - x[c[0]], x[c[2]] - x[c[0]], v[c[1]] - v[c[0]], v[c[2]] - v[c[0]], faces_[face], constants);
        force[c[1]] += f.on_1;
        force[c[2]] += f.on_2;
        force[c[0]] -= f.on_1 + f.on_2;
    }
}

void ForceModel::add_air(std::span<const glm::dvec3> x, std::span<const glm::dvec3> v, double time_s,
                         std::span<glm::dvec3> force) const
{
    const formulas_f64::Air air = air_in_double(params_);
    const AirField field = air_field(params_, time_s);
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        const glm::uvec3 c = model_.faces[face];
        const glm::dvec3 centre = (x[c[0]] + x[c[1]] + x[c[2]]) / 3.0, velocity = (v[c[0]] + v[c[1]] + v[c[2]]) / 3.0;
        const glm::dvec3 f = formulas_f64::face_air_force(
            x[c[1]] - x[c[0]], x[c[2]] - x[c[0]], air_velocity(field, centre) - velocity, faces_[face].mass_area, air);
        for (int k = 0; k < 3; ++k) force[c[k]] += f / 3.0;
    }
}

double ForceModel::elastic_energy(std::span<const glm::dvec3> x) const
{
    double energy = 0;
    for (std::size_t s = 0; s < weights_.size(); ++s) {
        const Spring& spring = model_.springs[s];
        const double length = glm::distance(x[spring.a], x[spring.b]), stretch = length - double(spring.rest_length);
        energy += (double(weights_[s].axial) * stretch * stretch + double(weights_[s].plate) * length * length) / 2;
    }
    if (!face_forces_.membrane) return energy;
    const formulas_f64::MembraneConstants m = membrane_in_double(params_);
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        const glm::uvec3 c = model_.faces[face];
        const formulas_f64::FaceRest& r = faces_[face];
        const glm::dvec3 e1 = x[c[1]] - x[c[0]], e2 = x[c[2]] - x[c[0]];
        const glm::dvec3 warp = r.warp_1 * e1 + r.warp_2 * e2, weft = r.weft_1 * e1 + r.weft_2 * e2;
        const double e11 = (glm::dot(warp, warp) - 1) / 2, e22 = (glm::dot(weft, weft) - 1) / 2;
        const double angle = glm::dot(warp, weft);
        energy += r.area *
                  (m.warp * e11 * e11 / 2 + m.weft * e22 * e22 / 2 + m.cross * e11 * e22 + m.shear * angle * angle / 2);
    }
    return energy;
}

double ForceModel::potential_energy(std::span<const glm::dvec3> x) const
{
    const glm::dvec3 gravity(params_.gravity_x, params_.gravity_y, params_.gravity_z);
    double energy = elastic_energy(x);
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i) energy -= mass(i) * glm::dot(gravity, x[i]);
    return energy;
}

double ForceModel::kinetic_energy(std::span<const glm::dvec3> v) const
{
    double energy = 0;
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i) energy += mass(i) * glm::dot(v[i], v[i]) / 2;
    return energy;
}

}  // namespace nuno
