// Which sheet a vertex belongs to.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/cloth_model.h"

namespace nuno {

// Of every vertex, its sheet; 0 of all where there are no sheets.
inline std::vector<std::uint32_t> sheet_numbers(std::span<const Sheet> sheets, std::size_t vertex_count)
{
    std::vector<std::uint32_t> numbers(vertex_count);
    for (std::uint32_t sheet = 0; sheet < sheets.size(); ++sheet)
        std::fill_n(numbers.begin() + sheets[sheet].first_vertex, sheets[sheet].vertex_count, sheet);
    return numbers;
}

}  // namespace nuno
