// The parameters of a simulation: a struct made from the rows of sim_params.def, and the table of those rows.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/params.h"

namespace nuno {

enum class Fabric : std::int32_t
{
    custom,
    cotton,
    silk,
    wool,
    denim
};
enum class InternalModel : std::int32_t
{
    springs,
    fabric_springs,
    continuum
};
enum class Tethers : std::int32_t
{
    automatic,
    none,
    pins,
    contacts
};
enum class WindModel : std::int32_t
{
    sines,
    aero
};
enum class Method : std::int32_t
{
    automatic,
    explicit_euler,
    symplectic_euler,
    verlet,
    rk4,
    xpbd,
    vbd,
    implicit_euler,
    sdirk2,
    reference
};
enum class Sweep : std::int32_t
{
    automatic,
    rows,
    coloured,
    jacobi
};
enum class Backend : std::int32_t
{
    cpu,
    gpu
};
enum class CollisionLevel : std::int32_t
{
    none,
    spheres,
    discrete,
    speculative,
    continuous,
    guaranteed
};
enum class Culling : std::int32_t
{
    none,
    seed,
    sound
};
enum class MassLumping : std::int32_t
{
    area,
    equal
};

std::span<const std::string_view> choice_names(Fabric);
std::span<const std::string_view> choice_names(InternalModel);
std::span<const std::string_view> choice_names(Tethers);
std::span<const std::string_view> choice_names(WindModel);
std::span<const std::string_view> choice_names(Method);
std::span<const std::string_view> choice_names(Sweep);
std::span<const std::string_view> choice_names(Backend);
std::span<const std::string_view> choice_names(CollisionLevel);
std::span<const std::string_view> choice_names(Culling);
std::span<const std::string_view> choice_names(MassLumping);

// Laid out as the std140 block SimParams of the kernels: 4-byte scalars in table order.
struct SimParams
{
#include "core/param_fields.inc"
//
#include "model/sim_params.def"
//
#include "core/param_rows_end.inc"
};

ParamTable sim_param_table();

// True where a change of `name` rebuilds the cloth, so that the simulation starts again.
bool needs_restart(std::string_view name);

// True where all fields are equal.
bool same_params(const SimParams& a, const SimParams& b);

// True where the fabric resists bending by its stiffness D.
inline bool bends(const SimParams& p) { return p.bending_warp != 0 || p.bending_weft != 0 || p.bending_bias != 0; }

// Length of a substep [s]: 1 / (frame_rate substeps), rounded to float once, for both backends.
inline float substep_s(const SimParams& p) { return static_cast<float>(1.0 / (double(p.frame_rate) * p.substeps)); }

}  // namespace nuno
