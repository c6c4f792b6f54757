// The interface of a solver: one method of time integration on one backend.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <glm/vec4.hpp>

#include "core/archive.h"
#include "model/body.h"
#include "model/cloth_state.h"
#include "model/layer_contact.h"
#include "model/sim_params.h"
#include "solver/base/contact_colours.h"

namespace nuno {

// A run of substeps of equal length.
struct StepInput
{
    const SimParams& params;
    double start_time_s;  // simulated time at the start of the first substep
    int substep_count;
};

// Where a vertex goes because of contacts.
struct VertexMove
{
    std::uint32_t vertex;
    glm::vec3 position;       // [m]
    glm::vec3 velocity_gain;  // [m/s]
};

class ClothSolver
{
  public:
    virtual ~ClothSolver() = default;
    virtual std::string_view name() const = 0;  // "symplectic_euler on cpu"

    // Takes over a whole state; sizes are those of the model that the solver was made for.
    virtual void upload(const ClothState& state) = 0;
    // Positions alone, xyz [m]; what moves should get a new velocity right after, so that it has no past.
    virtual void upload_positions(std::span<const glm::vec4> positions) = 0;
    virtual void upload_velocities(std::span<const glm::vec4> velocities) = 0;
    // Places one vertex at rest: xyz [m], w inverse mass (0 holds it there).
    virtual void set_vertex(std::uint32_t vertex, glm::vec4 position) = 0;

    virtual void step(const StepInput& input) = 0;
    // The contacts between layers that keep_contacts keeps from here on, instead of those before.
    virtual void set_contacts(std::span<const LayerContact> contacts, std::uint32_t vertex_count,
                              ContactOrder order) = 0;
    // To call after every substep while there are contacts: moves the vertices that went too far in it.
    virtual void keep_contacts(const SimParams& params) = 0;
    // Waits until what step began is done.
    virtual void finish() = 0;

    virtual void download_positions(std::span<glm::vec4> positions) = 0;
    virtual void download_velocities(std::span<glm::vec4> velocities) = 0;
    // The first vertex whose position or velocity is lost (model/cloth_state.h).
    virtual std::optional<std::uint32_t> first_lost() = 0;

    // Writes what the method keeps beyond the state, or reads it: right after the upload of that state into a solver
    // made for the same parameters, whose next step then has the bits that it would have had.
    virtual void carry(Archive&, const SimParams&) {}

    // OpenGL name of the buffer that holds the positions now (vec4 each); 0 where they are not on the device.
    virtual std::uint32_t position_buffer() const = 0;
};

// The seed's wind plus its steady part [N/m2] at a simulated time.
float wind_pressure(const SimParams& params, double time_s);

}  // namespace nuno
