// Comparing pictures, and the references kept beside the tests.
#include "render/picture_compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "render/png_file.h"
#include "render/texture_file.h"

namespace nuno {

PictureDifference compare_pictures(const Picture& a, const Picture& b)
{
    double sum = 0, changed = 0;
    for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
        int largest = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int difference = std::abs(a.rgba[pixel + channel] - b.rgba[pixel + channel]);
            sum += difference;
            largest = std::max(largest, difference);
        }
        if (largest > 24) ++changed;
    }
    const double pixels = static_cast<double>(a.rgba.size()) / 4;
    return {sum / (3 * pixels), changed / pixels};
}

glm::vec3 mean_colour(const Picture& picture, double x0, double y0, double x1, double y1)
{
    glm::dvec3 sum(0);
    double count = 0;
    for (int y = int(y0 * picture.height); y < int(y1 * picture.height); ++y)
        for (int x = int(x0 * picture.width); x < int(x1 * picture.width); ++x) {
            const std::uint8_t* p =
                picture.rgba.data() + 4 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x));
            sum += glm::dvec3(p[0], p[1], p[2]);
            ++count;
        }
    return glm::vec3(sum / count);
}

void expect_matches_reference(const Picture& picture, std::string_view name)
{
    const std::string file = std::string(name) + ".png";
    const std::filesystem::path path = std::filesystem::path(NUNO_ROOT_DIR) / "tests/render/reference" / file;
    if (std::getenv("NUNO_UPDATE_REFERENCES")) return write_png(path, picture);
    const Picture reference = load_picture(path, 8192);
    ASSERT_EQ(reference.width, picture.width);
    ASSERT_EQ(reference.height, picture.height);
    const PictureDifference difference = compare_pictures(picture, reference);
    if (difference.mean <= 1.5 && difference.changed_part <= 0.01) return;
    const std::filesystem::path drawn = std::filesystem::path(testing::TempDir()) / ("nuno-" + file);
    write_png(drawn, picture);
    ADD_FAILURE() << drawn << " is not " << path << ": mean difference " << difference.mean << " of 255, "
                  << 100 * difference.changed_part << " % of the pixels changed; if it should look so now, run with "
                  << "NUNO_UPDATE_REFERENCES=1";
}

}  // namespace nuno
