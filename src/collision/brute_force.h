// The reference for what the tree finds: every vertex against every face. Shares nothing with it but the formula.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/contact.h"
#include "collision/vertex_face.h"

namespace nuno {

// What ContactSearch::find finds, in the same order.
std::vector<Contact> brute_force_contacts(std::span<const glm::vec4> positions, std::span<const glm::uvec3> faces,
                                          const ContactRange& range);

// What find_pass_through finds, in the same order.
std::vector<VertexFace> brute_force_pass_through(std::span<const glm::vec4> positions_t0,
                                                 std::span<const glm::vec4> positions_t1,
                                                 std::span<const glm::uvec3> faces);

}  // namespace nuno
