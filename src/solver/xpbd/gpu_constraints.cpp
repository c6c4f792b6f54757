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
    : model_(model),
      springs_(model.vertex_count()),
      plate_ends_(GL_RGBA32I),
      plate_coefficients_(GL_RGBA32F),
      plate_shares_(GL_R32F),
      plates_(compute_program("sim/xpbd_plates.comp"))
{
    for (const Sheet& sheet : model.sheets) {
        sheets_.push_back(std::make_unique<MeshConstraints>(model, sheet));
        std::vector<std::int32_t>& vertices = vertices_.emplace_back(sheet.vertex_count + kSparePlaces, -1);
        for (std::uint32_t v = 0; v < sheet.vertex_count; ++v)
            vertices[sheets_.back()->places()[v]] = static_cast<std::int32_t>(sheet.first_vertex + v);
    }
}

void GpuConstraints::choose(std::span<const SpringWeight> weights, const Numbers& numbers,
                            std::span<const float> inverse_masses)
{
    limited_ = numbers.limit > 0;
    using Layout = MeshConstraints::Layout;
    const Layout layout = limited_ ? Layout::limited_springs : Layout::springs;
    for (std::size_t n = 0; n < sheets_.size(); ++n) sheets_[n]->choose(weights, model_.sheets[n].vertex_count, layout);
    make_numbers(numbers, inverse_masses);
    upload_plates(true);
    springs_.choose(coloured_springs(), limited_, fit_one_group());
    upload_spring_numbers();
}

void GpuConstraints::set_numbers(const Numbers& numbers, std::span<const float> inverse_masses)
{
    make_numbers(numbers, inverse_masses);
    upload_plates(false);
    upload_spring_numbers();
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

ColouredSprings GpuConstraints::coloured_springs() const
{
    ColouredSprings springs;
    const auto of = [&](std::size_t sheet) -> const ConstraintColours& { return sheets_[sheet]->springs(); };
    springs.first = walk(sheets_.size(), of, [&](std::size_t sheet, const ConstraintColours& colours, int batch) {
        const std::uint32_t* const places = colours.ends(batch);
        for (int lane = 0; lane < kColourBatch; ++lane)
            springs.ends.emplace_back(vertices_[sheet][places[lane] / 4],
                                      vertices_[sheet][places[lane + kColourBatch] / 4]);
    });
    return springs;
}

void GpuConstraints::upload_spring_numbers()
{
    std::vector<glm::vec4> numbers;
    const auto of = [&](std::size_t sheet) -> const ConstraintColours& { return sheets_[sheet]->springs(); };
    walk(sheets_.size(), of, [&](std::size_t, const ConstraintColours& colours, int batch) {
        const float* const number = colours.numbers(batch);
        for (int lane = 0; lane < kColourBatch; ++lane) {
            glm::vec4& to = numbers.emplace_back(0);
            for (int n = 0; n < (limited_ ? kLimitedSpringNumberCount : kSpringNumberCount); ++n)
                to[n] = number[n * kColourBatch + lane];
        }
    });
    springs_.set_numbers(numbers);
}

void GpuConstraints::upload_plates(bool with_ends)
{
    std::vector<glm::ivec4> ends;
    std::vector<glm::vec4> coefficients;
    std::vector<float> shares;
    const auto of = [&](std::size_t sheet) -> const ConstraintColours& { return sheets_[sheet]->plates(); };
    first_plate_ = walk(sheets_.size(), of, [&](std::size_t sheet, const ConstraintColours& colours, int batch) {
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
    if (with_ends) plate_ends_.upload(ends);
    plate_coefficients_.upload(coefficients);
    plate_shares_.upload(shares);
}

bool GpuConstraints::fit_one_group() const
{
    return model_.vertex_count() <= GpuSprings::kSmallVertices && first_plate_.size() == 1;
}

void GpuConstraints::sweep(int pairs) const
{
    for (int pair = 0; pair < pairs; ++pair) {
        if (first_plate_.size() == 1) {
            springs_.sweep_forth_and_back();
        } else {
            springs_.sweep_forth();
            sweep_plates();
            springs_.sweep_back();
        }
    }
}

void GpuConstraints::sweep_plates() const
{
    plates_.use();
    plate_ends_.bind(UNIT_ENDS);
    plate_coefficients_.bind(UNIT_NUMBERS);
    plate_shares_.bind(UNIT_SHARES);
    const std::size_t colours = first_plate_.size() - 1;
    for (std::size_t colour = 0; colour < colours; ++colour) project_plates(colour);
    for (std::size_t colour = colours; colour-- > 0;) project_plates(colour);
}

void GpuConstraints::project_plates(std::size_t colour) const
{
    const std::int32_t first = first_plate_[colour], end = first_plate_[colour + 1];
    plates_.set(LOCATION_FIRST_PLACE, first);
    plates_.set(LOCATION_END_PLACE, end);
    glDispatchCompute(static_cast<GLuint>((end - first + GROUP_SIZE - 1) / GROUP_SIZE), 1, 1);
    barrier_compute_to_compute();
}

}  // namespace nuno
