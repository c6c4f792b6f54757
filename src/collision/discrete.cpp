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
#include <cstring>

#include "collision/pair_sieve.h"
#include "core/task_share.h"
#include "model/formulas.h"
#include "model/wide.h"

namespace nuno {
namespace {

constexpr float kRounding = 1e-5f;

float length_sq(const glm::vec3& a) { return a.x * a.x + a.y * a.y + a.z * a.z; }

// The shared formulas of a point and a face for kLanes pairs at once: a lane computes what formulas::face_foot does.
#define SHARED_FN static NUNO_WIDE_INLINE
#define PRECISE
struct Feet
{
    using Real = WideFloat;
    struct Vec3 : WideVec3
    {
        Vec3() = default;
        NUNO_WIDE_INLINE Vec3(const WideVec3& a) : WideVec3(a) {}
        NUNO_WIDE_INLINE Vec3(Real x_, Real y_, Real z_) : WideVec3(x_, y_, z_) {}
        NUNO_WIDE_INLINE explicit Vec3(Real a) : WideVec3(a, a, a) {}
    };
#include "shaders/shared/vector.h"
//
#include "shaders/shared/point_face.h"
};
#undef SHARED_FN
#undef PRECISE

NUNO_WIDE_INLINE Feet::Vec3 gathered(const ElementPair* const (&pairs)[kLanes], int corner,
                                     std::span<const glm::vec4> positions)
{
    float lanes[3][kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
        const glm::vec4& x = positions[pairs[lane]->vertices[corner]];
        for (int axis = 0; axis < 3; ++axis) lanes[axis][lane] = x[axis];
    }
    return Feet::Vec3(Feet::Real(lanes[0]), Feet::Real(lanes[1]), Feet::Real(lanes[2]));
}

// Lane by lane whether low <= a <= high; all bits are set where it is.
NUNO_WIDE_INLINE WideFloat::Bits within(WideFloat a, float low, float high)
{
    return WideFloat::Bits(a.lanes >= WideFloat(low).lanes) & WideFloat::Bits(a.lanes <= WideFloat(high).lanes);
}

// Appends the pairs that are contacts, in their order.
NUNO_SIMD_CLONES void append_contacts(std::span<const ElementPair> pairs, std::span<const glm::vec4> positions,
                                      const ContactRange& range, std::vector<Contact>& contacts)
{
    const float least = -range.edge_tolerance, most = 1.0f + range.edge_tolerance;
    for (std::size_t first = 0; first < pairs.size(); first += kLanes) {
        const std::size_t count = std::min<std::size_t>(kLanes, pairs.size() - first);
        const ElementPair* eight[kLanes];  // where fewer are left the last is repeated
        for (std::size_t lane = 0; lane < kLanes; ++lane) eight[lane] = &pairs[first + std::min(lane, count - 1)];
        const Feet::FaceFoot foot = Feet::face_foot(gathered(eight, 0, positions), gathered(eight, 1, positions),
                                                    gathered(eight, 2, positions), gathered(eight, 3, positions));
        const WideFloat::Bits found = within(foot.weights.x, least, most) & within(foot.weights.y, least, most) &
                                      within(foot.weights.z, least, most) &
                                      within(foot.distance, -range.thickness, range.thickness);
        std::uint32_t bits[kLanes];
        std::memcpy(bits, &found, sizeof bits);
        for (std::size_t lane = 0; lane < count; ++lane) {
            if (bits[lane] == 0) continue;
            const auto at = [lane](const Feet::Vec3& a) {
                return glm::vec3(a.x.lanes[lane], a.y.lanes[lane], a.z.lanes[lane]);
            };
            const float distance = foot.distance.lanes[lane];
            const glm::vec3 normal = at(foot.normal);
            contacts.push_back({eight[lane]->vertices.x, eight[lane]->face, at(foot.weights),
                                distance < 0 ? -normal : normal, std::abs(distance)});
        }
    }
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
    share_tasks(pool, task_count, [&](int number, int) {
        // On this thread's stack meanwhile, for the tasks of two threads may lie in one cache line.
        Task task = std::move(tasks_[static_cast<std::size_t>(number)]);
        task.contacts.clear();
        task.pairs_tested = 0;
        PairBatches batches([&](PairKind, std::span<const ElementPair> pairs) {
            task.pairs_tested += pairs.size();
            append_contacts(pairs, positions, range, task.contacts);
        });
        query.run(number, [&](const ElementPair& pair) { batches.add(pair); });
        batches.finish();
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
