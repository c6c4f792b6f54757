// Search for contacts among the pairs that the tree of faces gives.
//
// No contact is lost (Culling::none and Culling::sound). Let vertex v be in contact with face F, with foot x4 = w0 x0 +
// w1 x1 + w2 x2, and let L be the longest edge of any face now.
// 1. x4 is within delta L of F. All weights are in -delta .. 1 + delta and their sum is 1, so either one is positive,
//    the others are -a and -b with a + b <= delta, and x4 = x2 + a (x2 - x0) + b (x2 - x1), say, is within (a + b) L of
//    x2; or one is -a, a <= delta, the others sum to 1 + a, and with p = (w0 x0 + w1 x1) / (1 + a) of the edge,
//    x4 = p + a (p - x2) is within a L of p.
// 2. |v - x4| <= epsilon, since face_foot measures the distance to x4 itself. So v is within D = delta L + epsilon of
//    F.
// 3. The query finds every pair of a vertex and a face that come within D: the boxes of both grow by D / 2. Where it
//    culls soundly, it leaves out only what is proven to be further than D apart.
// Rounding moves x4 by less than 1e-6 L, for which D has 1e-5 L.
#include "collision/discrete.h"

#include <algorithm>
#include <cmath>

#include "collision/task_loop.h"
#include "model/formulas.h"

namespace nuno {
namespace {

constexpr float kRounding = 1e-5f;

float length_sq(const glm::vec3& a) { return a.x * a.x + a.y * a.y + a.z * a.z; }

// The pair as a contact, if it is one. One comparison takes the three weights and the distance, without a branch on
// each.
void append_contact(const ElementPair& pair, std::span<const glm::vec4> positions, const ContactRange& range,
                    std::vector<Contact>& contacts)
{
    const float least = -range.edge_tolerance, most = 1.0f + range.edge_tolerance;
    const Float4 lowest = {least, least, least, 0}, highest = {most, most, most, range.thickness};
    const auto x = [&](int i) { return positions[pair.vertices[i]]; };
    const formulas::FaceFoot foot = formulas::face_foot(x(0), x(1), x(2), x(3));
    const float distance = std::abs(foot.distance);
    const Float4 found = {foot.weights.x, foot.weights.y, foot.weights.z, distance};
    if (lane_bits((found >= lowest) & (found <= highest)) != 0xf) return;
    contacts.push_back(
        {pair.vertices.x, pair.face, foot.weights, foot.distance < 0 ? -foot.normal : foot.normal, distance});
}

}  // namespace

float longest_edge(std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions)
{
    float longest = 0;
    for (const glm::uvec3& face : faces) {
        const glm::vec3 a = positions[face.x], b = positions[face.y], c = positions[face.z];
        longest = std::max({longest, length_sq(b - a), length_sq(c - b), length_sq(a - c)});
    }
    return std::sqrt(longest);
}

float contact_reach(const ContactRange& range, std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions)
{
    return range.thickness * (1.0f + kRounding) + (range.edge_tolerance + kRounding) * longest_edge(faces, positions);
}

std::span<const Contact> ContactSearch::find(const ElementQuery& query, int task_count,
                                             std::span<const glm::vec4> positions, const ContactRange& range,
                                             ThreadPool& pool)
{
    tasks_.resize(std::max(tasks_.size(), static_cast<std::size_t>(task_count)));
    run_tasks(pool, task_count, [&](int number) {
        // On this thread's stack meanwhile, for the tasks of two threads may lie in one cache line.
        Task task = std::move(tasks_[static_cast<std::size_t>(number)]);
        task.contacts.clear();
        task.pairs_tested = 0;
        query.run(number, [&](const ElementPair& pair) {
            ++task.pairs_tested;
            append_contact(pair, positions, range, task.contacts);
        });
        tasks_[static_cast<std::size_t>(number)] = std::move(task);
    });

    contacts_.clear();
    pairs_tested_ = 0;
    for (std::size_t t = 0; t < static_cast<std::size_t>(task_count); ++t) {
        contacts_.insert(contacts_.end(), tasks_[t].contacts.begin(), tasks_[t].contacts.end());
        pairs_tested_ += tasks_[t].pairs_tested;
    }
    std::sort(contacts_.begin(), contacts_.end(), comes_before);
    return contacts_;
}

}  // namespace nuno
