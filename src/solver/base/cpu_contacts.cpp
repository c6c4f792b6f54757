// Contacts between layers of cloth on the CPU; shaders/sim/contacts.comp does the same in the same order.
#include "solver/base/cpu_contacts.h"

#include "model/formulas.h"
#include "model/stability.h"

namespace nuno {
namespace {

// Contacts that are worth another thread, which takes them in such portions.
constexpr int kContactsPerThread = 4096, kGrain = 64;

}  // namespace

void CpuContacts::set(std::span<const LayerContact> contacts, std::span<const glm::vec4> positions, ContactOrder order)
{
    colours_ = colour_contacts(contacts, static_cast<std::uint32_t>(positions.size()), order);
    start_.assign(positions.begin(), positions.end());
    active_.resize(contacts.size());
    moved_.assign(positions.size(), 0);
}

std::span<const VertexMove> CpuContacts::answer(std::span<const glm::vec4> positions, const SimParams& params,
                                                ThreadPool& pool)
{
    now_.assign(positions.begin(), positions.end());
    find_active(pool);
    for (std::size_t i = 0; i < colours_.contacts.size(); ++i)
        if (active_[i]) answer_one(colours_.contacts[i], params);

    moves_.clear();
    for (const std::uint32_t v : moved_vertices_) {
        const glm::vec3 now(now_[v]);
        moves_.push_back({v, now, (now - glm::vec3(positions[v])) / substep_s(params)});
        moved_[v] = 0;
    }
    moved_vertices_.clear();
    start_.swap(now_);
    return moves_;
}

// Where the plane across the normal still keeps the sides apart, there is nothing to do; so it is for most.
void CpuContacts::find_active(ThreadPool& pool)
{
    const auto find = [&](Range range) {
        for (int i = range.begin; i < range.end; ++i) {
            const LayerContact& c = colours_.contacts[i];
            const auto x = [&](int corner) { return glm::vec3(now_[c.vertices[corner]]); };
            active_[i] = formulas::layer_gap(c.kind, c.normal, x(0), x(1), x(2), x(3)) < c.thickness;
        }
    };
    const int count = static_cast<int>(colours_.contacts.size());
    if (count < kContactsPerThread || pool.thread_count() == 1) return find({0, count});
    pool.run([&](int thread) { find(part_of(count, kGrain, thread, pool.thread_count())); });
}

void CpuContacts::answer_one(LayerContact& contact, const SimParams& params)
{
    const glm::uvec4& v = contact.vertices;
    const auto x = [&](int corner) { return glm::vec3(now_[v[corner]]); };
    const auto way = [&](int corner) { return x(corner) - glm::vec3(start_[v[corner]]); };
    const auto inverse_mass = [&](int corner) { return now_[v[corner]].w; };

    const formulas::ClosestPoints c = formulas::closest_of_layers(contact.kind, x(0), x(1), x(2), x(3));
    contact.normal = formulas::contact_normal(contact.normal, c.separation);
    const float mobility =
        formulas::contact_mobility(c, inverse_mass(0), inverse_mass(1), inverse_mass(2), inverse_mass(3));
    const formulas::ContactTerms terms{contact.thickness, substep_s(params), {params.friction, params.static_friction}};
    const glm::vec3 push =
        formulas::contact_push(contact.normal, formulas::dot_product(contact.normal, c.separation),
                               formulas::contact_way(c, way(0), way(1), way(2), way(3)), terms, mobility);
    if (push == glm::vec3(0)) return;
    const float weights[] = {c.w0, c.w1, c.w2, c.w3};
    for (int corner = 0; corner < 4; ++corner) {
        if (inverse_mass(corner) * weights[corner] == 0) continue;
        glm::vec4& to = now_[v[corner]];
        to = glm::vec4(formulas::contact_position(glm::vec3(to), push, weights[corner], to.w), to.w);
        if (moved_[v[corner]]) continue;
        moved_[v[corner]] = 1;
        moved_vertices_.push_back(v[corner]);
    }
}

}  // namespace nuno
