// Uploads contacts and runs their kernel.
#include "solver/base/gpu_contacts.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gl/barriers.h"
#include "model/stability.h"
#include "shaders/shared/bindings.h"

namespace nuno {
namespace {

// As sim/contacts.comp lays it out.
struct ContactRecord
{
    glm::uvec4 vertices;
    glm::vec3 normal;
    float kind;
    float thickness, acts = 0, unused[2] = {};
};
static_assert(sizeof(ContactRecord) == 48);

Buffer vertex_buffer(std::uint32_t vertex_count)
{
    return Buffer(vertex_count * sizeof(glm::vec4), nullptr, GL_DYNAMIC_COPY);
}

// Software renderers end the loops of an invocation after 65535 turns in all, and a colour takes some three.
constexpr int kMostColours = 16000;

void check_fits(std::size_t bytes, int colour_count)
{
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    if (static_cast<GLint64>(bytes) > most || colour_count > kMostColours)
        throw Error(
            fmt::format("{} contacts between layers in {} colours are more than this device takes ({} bytes, {} "
                        "colours); lower `thickness`, or set backend to cpu",
                        bytes / sizeof(ContactRecord), colour_count, most, kMostColours));
}

}  // namespace

GpuContacts::GpuContacts(std::uint32_t vertex_count)
    : program_(compute_program("sim/contacts.comp")),
      vertex_count_(vertex_count),
      start_(vertex_buffer(vertex_count)),
      end_(vertex_buffer(vertex_count)),
      colour_starts_(GL_R32UI)
{
    program_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count));
}

void GpuContacts::set(std::span<const LayerContact> contacts, const Buffer& positions, ContactOrder order)
{
    const ContactColours colours = colour_contacts(contacts, vertex_count_, order);
    colour_count_ = static_cast<int>(colours.starts.size()) - 1;
    if (empty()) return;
    std::vector<ContactRecord> records;
    records.reserve(contacts.size());
    for (const LayerContact& c : colours.contacts) records.push_back({c.vertices, c.normal, c.kind, c.thickness});
    const std::size_t bytes = records.size() * sizeof(ContactRecord);
    check_fits(bytes, colour_count_);
    if (contacts_.size_bytes() < bytes) contacts_ = Buffer(bytes + bytes / 2, nullptr, GL_DYNAMIC_DRAW);
    contacts_.update(0, records);
    colour_starts_.upload(colours.starts);
    positions.copy_to(0, start_, 0, positions.size_bytes());
}

void GpuContacts::answer(const Buffer& positions, const Buffer& velocities, const Buffer& new_velocities,
                         const SimParams& params)
{
    program_.use();
    program_.set(LOCATION_SUBSTEP, substep_s(params));
    program_.set(LOCATION_COLOURS, colour_count_);
    program_.set(LOCATION_FRICTION, glm::vec2(params.friction, params.static_friction));
    positions.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_POSITIONS);
    velocities.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_VELOCITIES);
    new_velocities.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_CONTACT_VELOCITIES);
    start_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_START_POSITIONS);
    end_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_END_POSITIONS);
    contacts_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_CONTACTS);
    colour_starts_.bind(UNIT_COLOURS);
    glDispatchCompute(1, 1, 1);
    barrier_compute_to_compute();
}

}  // namespace nuno
