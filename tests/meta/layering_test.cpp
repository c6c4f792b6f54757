// The floors of the architecture: every #include of the tree keeps to them, and the checker can fail.
#include <gtest/gtest.h>

#include "meta/include_rules.h"
#include "meta/tree.h"

namespace nuno::meta {
namespace {

std::vector<std::string> sources()
{
    std::vector<std::string> files = files_under("src", {".h", ".cpp", ".inc", ".def"});
    const std::vector<std::string> shaders =
        files_under("shaders", {".h", ".glsl", ".comp", ".vert", ".frag", ".geom", ".inc"});
    files.insert(files.end(), shaders.begin(), shaders.end());
    return files;
}

bool is_breach(std::string_view file, const std::string& line)
{
    const std::vector<Include> includes = read_includes(line);
    EXPECT_EQ(includes.size(), 1u) << line;
    return include_breach(file, includes.at(0)).has_value();
}

TEST(Layering, every_include_of_the_tree_keeps_to_the_floors)
{
    int count = 0;
    for (const std::string& file : sources()) {
        for (const Include& include : read_includes(read_file(file))) {
            ++count;
            const std::optional<std::string> breach = include_breach(file, include);
            EXPECT_FALSE(breach) << file << ":" << include.line << ": " << *breach;
        }
    }
    EXPECT_GT(count, 20) << "the sources were not found";
}

TEST(Layering, reads_includes_with_their_lines)
{
    const std::vector<Include> includes =
        read_includes("// top\n#include <vector>\n  #  include \"core/error.h\"  // why\nint include;\n");
    ASSERT_EQ(includes.size(), 2u);
    EXPECT_EQ(includes[0].path, "vector");
    EXPECT_TRUE(includes[0].angled);
    EXPECT_EQ(includes[1].path, "core/error.h");
    EXPECT_EQ(includes[1].line, 3);
    EXPECT_FALSE(includes[1].angled);
}

TEST(Layering, a_lower_floor_and_the_own_folder_are_allowed)
{
    EXPECT_FALSE(is_breach("src/app/main.cpp", "#include \"study/trade.h\""));
    EXPECT_FALSE(is_breach("src/solver/euler.cpp", "#include \"solver/euler.h\""));
    EXPECT_FALSE(is_breach("src/solver/euler.cpp", "#include \"euler.h\""));
    EXPECT_FALSE(is_breach("src/model/formulas.h", "#include \"shaders/shared/forces.h\""));
    EXPECT_FALSE(is_breach("shaders/sim/euler.comp", "#include \"shared/forces.h\""));
    EXPECT_FALSE(is_breach("shaders/sim/euler.comp", "#include \"shaders/shared/forces.h\""));
    EXPECT_FALSE(is_breach("src/core/text.cpp", "#include <vector>"));
}

TEST(Layering, a_higher_floor_is_a_breach)
{
    EXPECT_TRUE(is_breach("src/core/text.cpp", "#include \"model/mesh.h\""));
    EXPECT_TRUE(is_breach("src/sim/simulation.h", "#include \"app/view.h\""));
    EXPECT_TRUE(is_breach("shaders/shared/forces.h", "#include \"sim/euler.comp\""));
}

TEST(Layering, folders_of_one_floor_do_not_see_each_other)
{
    EXPECT_TRUE(is_breach("src/collision/bvh.cpp", "#include \"solver/solver.h\""));
    EXPECT_TRUE(is_breach("src/render/view.cpp", "#include \"scene/scene.h\""));
    EXPECT_TRUE(is_breach("src/model/mesh.h", "#include \"gl/buffer.h\""));
    EXPECT_TRUE(is_breach("shaders/render/cloth.frag", "#include \"sim/euler.comp\""));
}

TEST(Layering, methods_of_the_solver_see_what_they_share_but_not_each_other)
{
    EXPECT_FALSE(is_breach("src/solver/xpbd/cpu_xpbd.cpp", "#include \"solver/base/cpu_solver.h\""));
    EXPECT_FALSE(is_breach("src/solver/method_table.cpp", "#include \"solver/xpbd/cpu_xpbd.h\""));
    EXPECT_FALSE(is_breach("src/sim/simulation.cpp", "#include \"solver/base/cloth_solver.h\""));
    EXPECT_TRUE(is_breach("src/solver/xpbd/cpu_xpbd.cpp", "#include \"solver/vbd/cpu_vbd.h\""));
    EXPECT_TRUE(is_breach("src/solver/base/cpu_solver.cpp", "#include \"solver/xpbd/cpu_xpbd.h\""));
    EXPECT_TRUE(is_breach("src/solver/base/cpu_solver.cpp", "#include \"solver/method_table.h\""));
    EXPECT_TRUE(is_breach("src/solver/method_table.cpp", "#include \"scene/scene.h\""));
}

TEST(Layering, folders_of_collision_do_not_see_what_is_built_on_them_nor_each_other)
{
    EXPECT_FALSE(is_breach("src/collision/self_collision.cpp", "#include \"collision/ccd/impact.h\""));
    EXPECT_FALSE(is_breach("src/collision/ccd/filter.cpp", "#include \"model/wide.h\""));
    EXPECT_TRUE(is_breach("src/collision/ccd/impact.cpp", "#include \"collision/self_collision.h\""));
    EXPECT_TRUE(is_breach("src/collision/ccd/impact.cpp", "#include \"collision/tree/tree_node.h\""));
}

TEST(Layering, unknown_folders_are_breaches)
{
    EXPECT_TRUE(is_breach("src/utils/misc.cpp", "#include <vector>"));
    EXPECT_TRUE(is_breach("src/core/text.cpp", "#include \"utils/misc.h\""));
    EXPECT_TRUE(is_breach("src/core/text.cpp", "#include \"../model/mesh.h\""));
    EXPECT_TRUE(is_breach("src/core/text.cpp", "#include \"src/core/text.h\""));
}

TEST(Layering, libraries_stay_in_the_folders_meant_for_them)
{
    EXPECT_TRUE(is_breach("src/render/view.cpp", "#include <imgui.h>"));
    EXPECT_TRUE(is_breach("src/gl/context.cpp", "#include <GLFW/glfw3.h>"));
    EXPECT_TRUE(is_breach("src/solver/explicit/cpu_euler.cpp", "#include <glad/gl.h>"));
    EXPECT_TRUE(is_breach("src/solver/explicit/cpu_euler.cpp", "#include \"gl/buffer.h\""));
    EXPECT_TRUE(is_breach("src/collision/bvh.cpp", "#include <GL/gl.h>"));
    EXPECT_TRUE(is_breach("src/core/text.cpp", "#include <gtest/gtest.h>"));
    EXPECT_FALSE(is_breach("src/solver/explicit/gpu_euler.cpp", "#include <glad/gl.h>"));
    EXPECT_FALSE(is_breach("src/solver/explicit/gpu_euler.cpp", "#include \"gl/buffer.h\""));
    EXPECT_FALSE(is_breach("src/app/panel.cpp", "#include <imgui.h>"));
    EXPECT_FALSE(is_breach("src/gl/context.cpp", "#include <EGL/egl.h>"));
}

TEST(Layering, shaders_and_cpp_share_only_the_common_dialect)
{
    EXPECT_TRUE(is_breach("shaders/sim/euler.comp", "#include \"core/text.h\""));
    EXPECT_TRUE(is_breach("shaders/sim/euler.comp", "#include <vector>"));
    EXPECT_TRUE(is_breach("src/render/view.cpp", "#include \"shaders/render/cloth.frag\""));
    EXPECT_TRUE(is_breach("src/render/view.cpp", "#include \"generated/sim_params\""));
    EXPECT_FALSE(is_breach("shaders/sim/euler.comp", "#include \"model/sim_params.def\""));
    EXPECT_FALSE(is_breach("shaders/sim/euler.comp", "#include \"generated/sim_params\""));
}

}  // namespace
}  // namespace nuno::meta
