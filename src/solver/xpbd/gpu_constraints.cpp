// Uploads coloured constraints, and runs them.
#include "solver/xpbd/gpu_constraints.h"

#include <algorithm>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"

namespace nuno {
namespace {

constexpr int kSmallGroup = 128;  // a group of more invocations than a colour of such a cloth has springs idles

// Calls visit(sheet, batch) for every batch, colour by colour, and notes where colours begin.
template <class Colours, class Visit>
std::vector<std::int32_t> walk(std::size_t sheet_count, const Colours& colours_of, const Visit& visit)
{
    int colour_count = 0;
    for (std::size_t sheet = 0; sheet < sheet_count; ++sheet)
        colour_count = std::max(colour_count, colours_of(sheet).colour_count());
    std::vector<std::int32_t> first{0};
    for (int colour = 0; colour < colour_count; ++colour) {
        std::int32_t count = 0;
        for (std::size_t sheet = 0; sheet < sheet_count; ++sheet) {
            const ConstraintColours& colours = colours_of(sheet);
            if (colour >= colours.colour_count()) continue;
            const Range batches = colours.batches(colour);
            for (int batch = batches.begin; batch < batches.end; ++batch) visit(sheet, colours, batch);
            count += (batches.end - batches.begin) * kColourBatch;
        }
        first.push_back(first.back() + count);
    }
    return first;
}

}  // namespace

GpuConstraints::GpuConstraints(const ClothModel& model)
    : model_(model), springs_(GL_RG32I), plates_(GL_RGBA32I), starts_(GL_R32I)
{
    for (const Sheet& sheet : model.sheets) {
        sheets_.push_back(std::make_unique<MeshConstraints>(model, sheet));
        std::vector<std::int32_t>& vertices = vertices_.emplace_back(sheet.vertex_count + kSparePlaces, -1);
        for (std::uint32_t v = 0; v < sheet.vertex_count; ++v)
            vertices[sheets_.back()->places()[v]] = static_cast<std::int32_t>(sheet.first_vertex + v);
    }
    plates_.program = compute_program("sim/xpbd_plates.comp");
}

void GpuConstraints::compile()
{
    const std::vector<Define> defines{{"LIMITED", limited_ ? "1" : "0"},
                                      {"SMALL_GROUP", std::to_string(kSmallGroup)},
                                      {"SMALL_VERTICES", std::to_string(kSmallVertices)}};
    springs_.program = compute_program("sim/xpbd_springs.comp", defines);
    small_ = compute_program("sim/xpbd_sweep_small.comp", defines);
    small_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(model_.vertex_count()));
}

void GpuConstraints::choose(std::span<const SpringWeight> weights, const Numbers& numbers,
                            std::span<const float> inverse_masses)
{
    const bool limited = numbers.limit > 0, compiles = springs_.program.id() == 0 || limited != limited_;
    limited_ = limited;
    if (compiles) compile();
    for (std::size_t n = 0; n < sheets_.size(); ++n)
        sheets_[n]->choose(weights, model_.sheets[n].vertex_count, limited);
    make_numbers(numbers, inverse_masses);
    upload_springs(true);
    upload_plates(true);
    starts_.upload(springs_.first);
}

void GpuConstraints::set_numbers(const Numbers& numbers, std::span<const float> inverse_masses)
{
    make_numbers(numbers, inverse_masses);
    upload_springs(false);
    upload_plates(false);
}

void GpuConstraints::make_numbers(const Numbers& numbers, std::span<const float> inverse_masses)
{
    for (std::size_t n = 0; n < sheets_.size(); ++n) {
        const Sheet& sheet = model_.sheets[n];
        std::vector<glm::vec4> by_place(sheet.vertex_count);
        for (std::uint32_t v = 0; v < sheet.vertex_count; ++v)
            by_place[sheets_[n]->places()[v]].w = inverse_masses[sheet.first_vertex + v];
        sheets_[n]->set_numbers(numbers.step, numbers.projections, numbers.limit, by_place);
    }
}

void GpuConstraints::upload_springs(bool with_ends)
{
    std::vector<glm::ivec2> ends;
    std::vector<glm::vec4> numbers;
    const auto of = [&](std::size_t sheet) -> const ConstraintColours& { return sheets_[sheet]->springs(); };
    springs_.first = walk(sheets_.size(), of, [&](std::size_t sheet, const ConstraintColours& colours, int batch) {
        const std::uint32_t* const places = colours.ends(batch);
        const float* const number = colours.numbers(batch);
        for (int lane = 0; lane < kColourBatch; ++lane) {
            ends.emplace_back(vertices_[sheet][places[lane] / 4], vertices_[sheet][places[lane + kColourBatch] / 4]);
            glm::vec4& to = numbers.emplace_back(0);
            for (int n = 0; n < (limited_ ? kLimitedSpringNumberCount : kSpringNumberCount); ++n)
                to[n] = number[n * kColourBatch + lane];
        }
    });
    if (with_ends) springs_.ends.upload(ends);
    springs_.numbers.upload(numbers);
}

void GpuConstraints::upload_plates(bool with_ends)
{
    std::vector<glm::ivec4> ends;
    std::vector<glm::vec4> coefficients;
    std::vector<float> shares;
    const auto of = [&](std::size_t sheet) -> const ConstraintColours& { return sheets_[sheet]->plates(); };
    plates_.first = walk(sheets_.size(), of, [&](std::size_t sheet, const ConstraintColours& colours, int batch) {
        for (int lane = 0; lane < kColourBatch; ++lane) {
            glm::ivec4& end = ends.emplace_back();
            glm::vec4& coefficient = coefficients.emplace_back();
            for (int k = 0; k < 4; ++k) {
                end[k] = vertices_[sheet][colours.ends(batch)[k * kColourBatch + lane] / 4];
                coefficient[k] = colours.numbers(batch)[k * kColourBatch + lane];
            }
            shares.push_back(colours.numbers(batch)[kPlateShare * kColourBatch + lane]);
        }
    });
    if (with_ends) plates_.ends.upload(ends);
    plates_.numbers.upload(coefficients);
    plates_.shares.upload(shares);
}

void GpuConstraints::project(const Kind& kind, std::size_t colour) const
{
    const std::int32_t first = kind.first[colour], end = kind.first[colour + 1];
    kind.program.set(LOCATION_FIRST_PLACE, first);
    kind.program.set(LOCATION_END_PLACE, end);
    glDispatchCompute(static_cast<GLuint>((end - first + GROUP_SIZE - 1) / GROUP_SIZE), 1, 1);
    barrier_compute_to_compute();
}

bool GpuConstraints::is_small() const { return model_.vertex_count() <= kSmallVertices && plates_.first.size() == 1; }

void GpuConstraints::sweep(int pairs) const
{
    if (is_small()) return sweep_small(pairs);
    for (int pair = 0; pair < pairs; ++pair) sweep_pair();
}

void GpuConstraints::sweep_small(int pairs) const
{
    small_.use();
    small_.set(LOCATION_COLOUR_COUNT, static_cast<std::int32_t>(springs_.first.size() - 1));
    small_.set(LOCATION_PAIR_COUNT, pairs);
    springs_.ends.bind(UNIT_ENDS);
    springs_.numbers.bind(UNIT_NUMBERS);
    starts_.bind(UNIT_COLOUR_STARTS);
    glDispatchCompute(1, 1, 1);
    barrier_compute_to_compute();
}

void GpuConstraints::sweep_pair() const
{
    const auto begin = [](const Kind& kind) {
        kind.program.use();
        kind.ends.bind(UNIT_ENDS);
        kind.numbers.bind(UNIT_NUMBERS);
        kind.shares.bind(UNIT_SHARES);
    };
    const std::size_t springs = springs_.first.size() - 1, plates = plates_.first.size() - 1;
    begin(springs_);
    for (std::size_t colour = 0; colour < springs; ++colour) project(springs_, colour);
    if (plates > 0) {
        begin(plates_);
        for (std::size_t colour = 0; colour < plates; ++colour) project(plates_, colour);
        for (std::size_t colour = plates; colour-- > 0;) project(plates_, colour);
        begin(springs_);
    }
    for (std::size_t colour = springs; colour-- > 0;) project(springs_, colour);
}

}  // namespace nuno
