// A run as it is between two frames: what another one needs to go on from there, and its file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/body_motion.h"
#include "model/cloth_state.h"
#include "model/sim_params.h"

namespace nuno {

struct SavedState
{
    int frame = 0;
    double time_s = 0;  // simulated
    SimParams asked;    // the parameters of then (Simulation::asked_params)
    ClothState cloth;
    std::vector<BodyShift> shifts;  // of all bodies; empty: no hand moved any
    // What solver and collision keep beyond the cloth, and by whom it can be read: solvers of the same past_kind.
    std::string past_kind;
    std::vector<std::byte> past;

    std::size_t size_bytes() const;
};

// What a solver is made for, and the program's version: where these differ, a past cannot be read.
std::string past_kind(std::string_view solver_name, const SimParams& params);

// Writes all but the parameters to a file, whole or not at all: little-endian, every bit of every number, and a hash of
// it all. Error naming the path where that fails.
void write_state(const std::filesystem::path& path, const SavedState& saved);

// Reads it, of a cloth of so many vertices, saved with parameters `asked`. Error naming the path where the file is
// missing, no such file, from a newer nuno, cut short or changed, holds what is no number, or is of another cloth.
SavedState read_state(const std::filesystem::path& path, const SimParams& asked, std::uint32_t vertex_count);

}  // namespace nuno
