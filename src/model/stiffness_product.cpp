// The stiffness matrix times a vector.
#include "model/stiffness_product.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace nuno {

StiffnessProduct::StiffnessProduct(const ClothModel& model, const SimParams& params)
    : model_(model), weights_(spring_weights(model, params))
{
    if (!face_forces(params).membrane) return;
    faces_ = face_rests(model);
    membrane_ = membrane_constants(params);
}

// A spring's force (k + b - k l0 / |d|) d changes by (k + b - k l0 / |d|) e + k l0 / |d| n (n . e) as d does by e.
void StiffnessProduct::multiply(std::span<const glm::vec4> x, std::span<const glm::dvec3> u,
                                std::span<glm::dvec3> product) const
{
    std::fill(product.begin(), product.end(), glm::dvec3(0));
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        const Spring& spring = model_.springs[i];
        const double axial = double(weights_[i].axial), plate = double(weights_[i].plate);
        if (axial == 0 && plate == 0) continue;
        const glm::dvec3 d = glm::dvec3(x[spring.b]) - glm::dvec3(x[spring.a]), e = u[spring.b] - u[spring.a];
        const double length = std::max(glm::length(d), 1e-12);
        const glm::dvec3 n = d / length;
        const double pull = axial * double(spring.rest_length) / length;
        const glm::dvec3 change = (axial + plate - pull) * e + pull * glm::dot(n, e) * n;
        product[spring.a] -= change;
        product[spring.b] += change;
    }
    if (!faces_.empty()) add_membrane(x, u, product);
}

// d(F S) = dF S + F C dE.
void StiffnessProduct::add_membrane(std::span<const glm::vec4> x, std::span<const glm::dvec3> u,
                                    std::span<glm::dvec3> product) const
{
    const double c11 = double(membrane_.warp), c22 = double(membrane_.weft);
    const double c12 = double(membrane_.cross), c33 = double(membrane_.shear);
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        const glm::uvec3 corners = model_.faces[face];
        const formulas::FaceRest& r = faces_[face];
        const auto warp_of = [&](const glm::dvec3& a, const glm::dvec3& b) {
            return double(r.warp_1) * a + double(r.warp_2) * b;
        };
        const auto weft_of = [&](const glm::dvec3& a, const glm::dvec3& b) {
            return double(r.weft_1) * a + double(r.weft_2) * b;
        };
        const glm::dvec3 e1 = glm::dvec3(x[corners[1]]) - glm::dvec3(x[corners[0]]), u1 = u[corners[1]] - u[corners[0]];
        const glm::dvec3 e2 = glm::dvec3(x[corners[2]]) - glm::dvec3(x[corners[0]]), u2 = u[corners[2]] - u[corners[0]];
        const glm::dvec3 f1 = warp_of(e1, e2), f2 = weft_of(e1, e2), g1 = warp_of(u1, u2), g2 = weft_of(u1, u2);
        const double e11 = (glm::dot(f1, f1) - 1) / 2, e22 = (glm::dot(f2, f2) - 1) / 2, angle = glm::dot(f1, f2);
        const double d11 = glm::dot(f1, g1), d22 = glm::dot(f2, g2), d_angle = glm::dot(f1, g2) + glm::dot(g1, f2);
        const double s11 = c11 * e11 + c12 * e22, s22 = c12 * e11 + c22 * e22, s12 = c33 * angle;
        const double t11 = c11 * d11 + c12 * d22, t22 = c12 * d11 + c22 * d22, t12 = c33 * d_angle;
        const glm::dvec3 p1 = double(r.area) * (s11 * g1 + s12 * g2 + t11 * f1 + t12 * f2);
        const glm::dvec3 p2 = double(r.area) * (s12 * g1 + s22 * g2 + t12 * f1 + t22 * f2);
        const glm::dvec3 on_1 = double(r.warp_1) * p1 + double(r.weft_1) * p2;
        const glm::dvec3 on_2 = double(r.warp_2) * p1 + double(r.weft_2) * p2;
        product[corners[1]] += on_1;
        product[corners[2]] += on_2;
        product[corners[0]] -= on_1 + on_2;
    }
}

}  // namespace nuno
