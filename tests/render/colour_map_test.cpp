// The colours of numbers.
#include "render/colour_map.h"

#include <gtest/gtest.h>

#include <array>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

// Every eighth of the table that matplotlib publishes.
constexpr std::array<std::array<int, 3>, 9> kViridis{{{68, 1, 84},
                                                      {71, 44, 122},
                                                      {59, 81, 139},
                                                      {44, 113, 142},
                                                      {33, 144, 141},
                                                      {39, 173, 129},
                                                      {92, 200, 99},
                                                      {170, 220, 50},
                                                      {253, 231, 37}}};

TEST(ColourMap, viridis_is_the_published_table_within_4_of_255)
{
    for (std::size_t i = 0; i < kViridis.size(); ++i) {
        const glm::vec3 colour = 255.0f * viridis(float(i) / 8);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c], kViridis[i][std::size_t(c)], 4) << "eighth " << i;
    }
}

TEST(ColourMap, viridis_is_brighter_for_larger_numbers_and_keeps_its_ends_outside)
{
    const auto brightness = [](float t) { return glm::dot(viridis(t), glm::vec3(0.2126f, 0.7152f, 0.0722f)); };
    for (int i = 0; i < 64; ++i) EXPECT_GT(brightness(float(i + 1) / 64), brightness(float(i) / 64)) << i;
    EXPECT_EQ(viridis(-3), viridis(0));
    EXPECT_EQ(viridis(7), viridis(1));
}

}  // namespace
}  // namespace nuno
