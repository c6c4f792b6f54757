// The file of a saved state.
#include "sim/saved_state.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <bit>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

#include "core/archive.h"
#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
#include "core/version.h"

namespace nuno {
namespace {

static_assert(std::endian::native == std::endian::little, "the file holds little-endian numbers");

constexpr std::string_view kMagic = "nuno state\n";
constexpr std::uint32_t kFormat = 2;  // 1: without shifts; a higher one says what this program does not know

std::uint64_t hash_of(std::span<const std::byte> bytes)
{
    Fnv1a hash;
    hash.add(bytes.data(), bytes.size());
    return hash.value();
}

void carry(Archive& archive, SavedState& saved, std::uint32_t format)
{
    archive.value(saved.frame);
    archive.value(saved.time_s);
    archive.list(saved.cloth.positions);
    archive.list(saved.cloth.velocities);
    std::vector<char> kind(saved.past_kind.begin(), saved.past_kind.end());
    archive.list(kind);
    saved.past_kind.assign(kind.begin(), kind.end());
    archive.list(saved.past);
    if (format > 1) archive.list(saved.shifts);
    archive.finish();
}

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what)
{
    throw Error(
        fmt::format("{}: {}; save the state anew, or take the line `state` out of the scene", path.string(), what));
}

struct Body
{
    std::uint32_t format;
    std::vector<std::byte> bytes;
};

// What follows the magic, the format and the hash, which must be right.
Body checked_body(const std::filesystem::path& path, std::string_view text)
{
    if (text.substr(0, kMagic.size()) != kMagic) fail(path, "is no state that nuno saved");
    text.remove_prefix(kMagic.size());
    std::uint32_t format = 0;
    std::uint64_t hash = 0;
    if (text.size() < sizeof format + sizeof hash) fail(path, "is cut short");
    std::memcpy(&format, text.data(), sizeof format);
    if (format > kFormat)
        throw Error(
            fmt::format("{}: the state has format {}, from a newer nuno; this one ({}) knows format {}: run it "
                        "with a newer nuno",
                        path.string(), format, kVersion, kFormat));
    std::memcpy(&hash, text.data() + sizeof format, sizeof hash);
    text.remove_prefix(sizeof format + sizeof hash);
    const std::span<const std::byte> body = std::as_bytes(std::span(text));
    if (hash_of(body) != hash) fail(path, "is cut short, or was changed");
    return {format, {body.begin(), body.end()}};
}

void check_numbers(const std::filesystem::path& path, const SavedState& saved, std::uint32_t vertex_count)
{
    const std::size_t count = saved.cloth.positions.size();
    if (count != vertex_count || saved.cloth.velocities.size() != count)
        throw Error(
            fmt::format("{}: holds a cloth of {} vertices, but that of the scene has {}; leave sheets and "
                        "resolution as they were, or take the line `state` out of the scene",
                        path.string(), count, vertex_count));
    for (const auto* values : {&saved.cloth.positions, &saved.cloth.velocities})
        if (const auto lost = first_lost(*values))
            fail(path, fmt::format("vertex {} is not finite, or beyond 1e6 m or m/s", *lost));
    for (std::size_t v = 0; v < count; ++v)
        if (!(saved.cloth.positions[v].w >= 0) || is_lost(static_cast<float>(saved.time_s)) || saved.frame < 0)
            fail(path, "holds a mass or a time that is none");
    const auto is_way = [](const glm::dvec3& way) { return !is_lost(static_cast<float>(glm::length(way))); };
    for (const BodyShift& shift : saved.shifts)
        if (!is_way(shift.from) || !is_way(shift.to) || !std::isfinite(shift.from_s) || !std::isfinite(shift.to_s))
            fail(path, "holds a place of a body that is not finite, or beyond 1e6 m");
}

}  // namespace

std::size_t SavedState::size_bytes() const
{
    return sizeof(SavedState) + past.size() + shifts.size() * sizeof(BodyShift) +
           (cloth.positions.size() + cloth.velocities.size()) * sizeof(glm::vec4);
}

std::string past_kind(std::string_view solver_name, const SimParams& p)
{
    const std::array<int, 7> made_for{
        static_cast<int>(p.sweep), static_cast<int>(p.tethers), static_cast<int>(p.internal_model),
        p.strain_limit > 0,        p.stiffness_damping > 0,     bends(p),
        p.count_pass_through};
    return fmt::format("{} {} {} {}", kVersion, kCommit, solver_name, fmt::join(made_for, " "));
}

void write_state(const std::filesystem::path& path, const SavedState& saved)
{
    SavedState copy = saved;
    Archive body;
    carry(body, copy, kFormat);
    const std::uint64_t hash = hash_of(body.bytes());
    std::string file(kMagic);
    const auto append = [&](const void* bytes, std::size_t count) {
        file.append(static_cast<const char*>(bytes), count);
    };
    append(&kFormat, sizeof kFormat);
    append(&hash, sizeof hash);
    append(body.bytes().data(), body.bytes().size());
    write_whole(path, file);
}

SavedState read_state(const std::filesystem::path& path, const SimParams& asked, std::uint32_t vertex_count)
{
    SavedState saved;
    saved.asked = asked;
    Body body = checked_body(path, read_text(path));
    Archive archive(std::move(body.bytes));
    carry(archive, saved, body.format);
    check_numbers(path, saved, vertex_count);
    return saved;
}

}  // namespace nuno
