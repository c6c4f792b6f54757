// Where a cloth comes to rest.
#include "support/equilibrium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/force_model.h"
#include "model/stiffness_product.h"

namespace nuno {
namespace {

using Field = std::vector<glm::dvec3>;

double dot(const Field& a, const Field& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
    return sum;
}

class Descent
{
  public:
    Descent(const ClothModel& model, const SimParams& params)
        : model_(model),
          forces_(model, params),
          stiffness_(model, params),
          still_(model.vertex_count()),
          inverse_diagonal_(diagonal(model, params))
    {
    }

    double energy(const Field& x) const { return forces_.potential_energy(x); }

    Field force(const Field& x) const
    {
        Field f(x.size());
        forces_.forces(x, still_, 0, f);
        hold_pins(f);
        return f;
    }

    // The step p with |p| <= radius in the metric of the diagonal that goes furthest down the quadratic model
    // (Steihaug 1983), and how far down that is.
    Field step(const Field& x, const Field& f, double radius, double& promised) const
    {
        std::vector<glm::vec4> places(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) places[i] = glm::vec4(glm::vec3(x[i]), 1);
        Field p(x.size(), glm::dvec3(0)), r = f, z = preconditioned(r), d = z, kd(x.size()), kp = p;
        double rz = dot(r, z);
        const double enough = 1e-4 * rz;
        for (int i = 0; i < 4000 && rz > enough; ++i) {
            stiffness_.multiply(places, d, kd);
            hold_pins(kd);
            const double curvature = dot(d, kd), dd = metric(d, d), pd = metric(p, d), pp = metric(p, p);
            const double to_edge = (-pd + std::sqrt(pd * pd + dd * (radius * radius - pp))) / dd;
            const double length = curvature > 0 ? rz / curvature : to_edge;
            const double taken = std::min(length, to_edge);
            for (std::size_t v = 0; v < p.size(); ++v)
                p[v] += taken * d[v], kp[v] += taken * kd[v], r[v] -= taken * kd[v];
            if (length >= to_edge) break;
            z = preconditioned(r);
            const double next = dot(r, z);
            for (std::size_t v = 0; v < p.size(); ++v) d[v] = z[v] + next / rz * d[v];
            rz = next;
        }
        promised = dot(f, p) - dot(p, kp) / 2;
        return p;
    }

    double size(const Field& p) const { return std::sqrt(metric(p, p)); }

    double weight(double g) const
    {
        double mass = 0;
        for (std::uint32_t v = 0; v < model_.vertex_count(); ++v) mass += forces_.mass(v);
        return mass * g;
    }

  private:
    static std::vector<double> diagonal(const ClothModel& model, const SimParams& params)
    {
        std::vector<double> sums(model.vertex_count(), 1e-9);
        const std::vector<SpringWeight> weights = spring_weights(model, params);
        for (std::size_t i = 0; i < weights.size(); ++i)
            for (const std::uint32_t v : {model.springs[i].a, model.springs[i].b})
                sums[v] += double(weights[i].axial) + std::abs(double(weights[i].plate));
        if (face_forces(params).membrane)
            for (const glm::uvec3& face : model.faces)
                for (int k = 0; k < 3; ++k) sums[face[k]] += double(params.warp_stiffness + params.weft_stiffness) / 2;
        for (double& sum : sums) sum = 1 / sum;
        return sums;
    }

    Field preconditioned(const Field& r) const
    {
        Field z(r.size());
        for (std::size_t v = 0; v < r.size(); ++v) z[v] = inverse_diagonal_[v] * r[v];
        return z;
    }

    double metric(const Field& a, const Field& b) const
    {
        double sum = 0;
        for (std::size_t v = 0; v < a.size(); ++v) sum += glm::dot(a[v], b[v]) / inverse_diagonal_[v];
        return sum;
    }

    void hold_pins(Field& a) const
    {
        for (std::size_t v = 0; v < a.size(); ++v)
            if (model_.pinned[v]) a[v] = glm::dvec3(0);
    }

    const ClothModel& model_;
    const ForceModel forces_;
    const StiffnessProduct stiffness_;
    const Field still_;
    const std::vector<double> inverse_diagonal_;
};

}  // namespace

std::vector<glm::dvec3> equilibrium(const ClothModel& model, const SimParams& params, std::vector<glm::dvec3> x,
                                    double tolerance)
{
    const Descent descent(model, params);
    const double g = glm::length(glm::dvec3(params.gravity_x, params.gravity_y, params.gravity_z));
    const double small = tolerance * descent.weight(g);
    double energy = descent.energy(x), radius = 1e9, largest = 0;
    for (int i = 0; i < 400; ++i) {
        const Field f = descent.force(x);
        largest = 0;
        for (const glm::dvec3& a : f) largest = std::max(largest, glm::length(a));
        if (largest <= small) return x;
        double promised = 0;
        const Field p = descent.step(x, f, radius, promised);
        Field next = x;
        for (std::size_t v = 0; v < x.size(); ++v) next[v] += p[v];
        const double there = descent.energy(next), kept = (energy - there) / promised;
        const bool rounding = promised < 1e-13 * std::abs(energy);
        if (kept > 0.1 || rounding) x = next, energy = there;
        if (!rounding && kept < 0.25) radius = descent.size(p) / 4;
        if (kept > 0.75) radius = std::max(radius, 3 * descent.size(p));
    }
    ADD_FAILURE() << "no rest: a force of " << largest << " N is left, where " << small << " N would do";
    return x;
}

std::vector<glm::dvec3> equilibrium(const ClothModel& model, const SimParams& params)
{
    return equilibrium(model, params, {model.start_positions.begin(), model.start_positions.end()});
}

}  // namespace nuno
