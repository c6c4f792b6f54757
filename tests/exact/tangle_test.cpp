// Intersections of a pose as nuno finds them, against those that CGAL's exact predicates find.
#include "collision/tangle.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include <glm/mat3x3.hpp>

#include "collision/orientation.h"
#include "collision/poses.h"
#include "model/mesh_writer.h"
#include "support/program_run.h"

namespace nuno {
namespace {

std::vector<Tangle> tangles_of(const Pose& pose, int threads = 1)
{
    ThreadPool pool(threads);
    return TangleSearch(pose.rest, pose.faces, {}).find(pose.positions, pool);
}

// The numbers that the checking program prints, one a pose; it takes no faces without area.
std::vector<std::size_t> counted_by_cgal(const std::vector<Pose>& poses)
{
    const TemporaryDirectory directory;
    std::vector<std::string> words{NUNO_MESH_INTERSECTIONS};
    for (const Pose& pose : poses) {
        const std::string name = fmt::format("{}.ply", words.size());
        const std::string text = ply_text({pose.positions, {}, pose.faces});
        words.push_back(directory.write(name, text).string());
    }
    const ProgramResult result = run_words(words);
    EXPECT_NE(result.exit_code, 2) << result.err;
    std::vector<std::size_t> counts;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) counts.push_back(std::stoul(line.substr(line.rfind(' '))));
    return counts;
}

// Fails unless both count the same in every pose; gives how many there are in all.
std::size_t expect_agreement(const std::vector<Pose>& poses)
{
    const std::vector<std::size_t> expected = counted_by_cgal(poses);
    EXPECT_EQ(expected.size(), poses.size());
    std::size_t all = 0;
    for (std::size_t i = 0; i < std::min(expected.size(), poses.size()); ++i) {
        EXPECT_EQ(tangles_of(poses[i]).size(), expected[i]) << "pose " << i;
        all += expected[i];
    }
    return all;
}

bool has_area(const Pose& pose, const glm::uvec3& face)
{
    const glm::vec3 a(pose.positions[face.x]), b(pose.positions[face.y]), c(pose.positions[face.z]);
    return area_sign(a, b, c, 0) != 0 || area_sign(a, b, c, 1) != 0 || area_sign(a, b, c, 2) != 0;
}

// Faces of random corners among vertices on a small lattice: nearly all that meet do so in some degenerate way.
Pose lattice_soup(std::uint32_t seed, std::uint32_t vertices, std::uint32_t side)
{
    std::mt19937 bits(seed);
    Pose pose;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const auto coordinate = [&] { return float(bits() % side); };
        const float x = coordinate(), y = coordinate(), z = coordinate();
        pose.positions.emplace_back(x, y, z, 1.0f);
        pose.rest.emplace_back(x, y, z);
    }
    for (int tries = 0; tries < 60; ++tries) {
        const glm::uvec3 face(bits() % vertices, bits() % vertices, bits() % vertices);
        if (has_area(pose, face)) pose.faces.push_back(face);
    }
    return pose;
}

void transform(Pose& pose, const glm::mat3& turn, glm::vec3 shift)
{
    for (glm::vec4& x : pose.positions) x = glm::vec4(turn * glm::vec3(x) + shift, x.w);
}

TEST(Tangle, agrees_with_cgal_on_crumples_folds_and_sheets)
{
    std::vector<Pose> poses{flat_sheet(9), folded_sheet(24, 0.01f), rolled_sheet(24, 0.01f), spiral_ramp(24, 0.05f)};
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        for (const float amplitude : {0.01f, 0.05f, 0.1f}) poses.push_back(crumpled_sheet(17, amplitude, seed));
        poses.push_back(stacked_sheets(12, 5, seed));
        Pose shaken_fold = folded_sheet(17, 0.002f);
        shaken_fold.positions = shaken(shaken_fold.positions, 0.003f, seed);
        poses.push_back(shaken_fold);
    }
    EXPECT_GT(expect_agreement(poses), 1000u);
}

TEST(Tangle, agrees_with_cgal_where_all_is_degenerate)
{
    std::vector<Pose> poses;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) poses.push_back(lattice_soup(seed, 10 + seed % 60, 2 + seed % 4));
    EXPECT_GT(expect_agreement(poses), 10000u);
}

// In one plane, each vertex on those of the other sheet, shifted by half a cell, or folded onto itself.
TEST(Tangle, agrees_with_cgal_on_sheets_in_one_plane)
{
    std::vector<Pose> poses;
    for (const glm::vec3 shift : {glm::vec3(0), glm::vec3(0.125f, 0.125f, 0), glm::vec3(0.06f, 0.03f, 0)}) {
        Pose pose = flat_sheet(5);
        const Pose other = flat_sheet(5);
        for (std::size_t v = 0; v < other.rest.size(); ++v) {
            pose.rest.push_back(other.rest[v] + glm::vec3(0, 0, 1));
            pose.positions.emplace_back(other.rest[v] + shift, 1.0f);
        }
        for (const glm::uvec3& face : other.faces) pose.faces.push_back(face + 25u);
        poses.push_back(pose);
    }
    Pose folded = flat_sheet(9);
    for (glm::vec4& x : folded.positions) x.x = std::abs(x.x - 0.5f);
    poses.push_back(folded);
    EXPECT_GT(expect_agreement(poses), 100u);
}

// Rounded to floats: planes are tilted, so that what was in one plane nearly is, on whichever side.
TEST(Tangle, agrees_with_cgal_where_rounding_decides)
{
    const glm::mat3 turn(0.36f, 0.48f, -0.8f, -0.8f, 0.6f, 0.0f, 0.48f, 0.64f, 0.6f);
    std::vector<Pose> poses;
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        poses.push_back(lattice_soup(seed, 12 + seed % 20, 4));
        transform(poses.back(), turn, glm::vec3(seed % 2 ? 0.1f : 1e4f));
        std::erase_if(poses.back().faces, [&](const glm::uvec3& face) { return !has_area(poses.back(), face); });
    }
    EXPECT_GT(expect_agreement(poses), 1000u);
}

TEST(Tangle, does_not_depend_on_the_number_of_threads)
{
    const Pose pose = crumpled_sheet(64, 0.1f, 1);
    const std::vector<Tangle> one = tangles_of(pose, 1);
    EXPECT_GT(one.size(), 100u);
    for (const int threads : {2, 3}) {
        const std::vector<Tangle> more = tangles_of(pose, threads);
        ASSERT_EQ(more.size(), one.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            EXPECT_EQ(more[i].faces, one[i].faces);
            EXPECT_EQ(more[i].meeting.kind, one[i].meeting.kind);
            EXPECT_EQ(more[i].place, one[i].place);
        }
    }
}

}  // namespace
}  // namespace nuno
