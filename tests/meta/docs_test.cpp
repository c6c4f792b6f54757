// What the pages say can be checked: links lead somewhere, tables and lists are those of the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>

#include "meta/markdown.h"
#include "meta/tree.h"
#include "model/sim_params.h"
#include "scene/end_check.h"
#include "scene/scene.h"
#include "support/program_run.h"

namespace nuno::meta {
namespace {

namespace fs = std::filesystem;

bool names(std::string_view page, std::string_view word)
{
    const std::vector<std::string> words = code_words(page);
    return std::find(words.begin(), words.end(), word) != words.end();
}

// Whether a page has a heading whose anchor is `anchor`: its letters, digits and underscores in lower case, a hyphen for each space.
bool has_heading(const std::string& page, std::string_view anchor)
{
    const std::vector<Section> parts = sections(page);
    return std::any_of(parts.begin(), parts.end(), [&](const Section& section) {
        std::string name;
        for (const unsigned char letter : section.heading)
            if (std::isalnum(letter) || letter == ' ' || letter == '-' || letter == '_')
                name += letter == ' ' ? '-' : std::tolower(letter);
        return name == anchor;
    });
}

TEST(Docs, every_link_leads_to_a_file_and_a_heading)
{
    int count = 0;
    for (const std::string& page : pages())
        for (const std::string& link : relative_links(read_file(page))) {
            ++count;
            const std::size_t mark = link.find('#');
            const fs::path target = fs::path(page).parent_path() / link.substr(0, mark);
            ASSERT_TRUE(fs::exists(fs::path(root()) / target)) << page << " links to " << link;
            if (mark == link.npos) continue;
            EXPECT_TRUE(has_heading(read_file(target.string()), link.substr(mark + 1))) << page << " links to " << link;
        }
    EXPECT_GT(count, 20);
}

TEST(Docs, links_are_found_and_code_is_not_taken_for_one)
{
    const std::vector<std::string> found =
        relative_links("[a](b.md) ![c](d/e.png) [w](https://x.y/z) `[n](o)`\n```sh\n[p](q)\n```\n[f](g.md#h)\n");
    EXPECT_EQ(found, (std::vector<std::string>{"b.md", "d/e.png", "g.md#h"}));
}

TEST(Docs, every_page_is_in_the_index)
{
    const std::vector<std::string> links = relative_links(read_file("docs/README.md"));
    for (const std::string& page : files_under("docs", {".md", ".json"})) {
        const std::string name = page.substr(std::string_view("docs/").size());
        if (name == "README.md") continue;
        EXPECT_NE(std::find(links.begin(), links.end(), name), links.end()) << name;
    }
}

TEST(Docs, the_page_of_parameters_is_what_the_program_prints)
{
    const ProgramResult printed = run_program({"params", "--markdown"});
    ASSERT_EQ(printed.exit_code, 0) << printed.err;
    EXPECT_TRUE(printed.out == read_file("docs/parameters.md"))
        << "docs/parameters.md is stale; `nuno params --markdown > docs/parameters.md` writes it anew";
}

// docs/gallery/refresh runs these blocks.
TEST(Docs, the_gallery_makes_every_picture_that_it_shows)
{
    const std::string gallery = read_file("docs/gallery/README.md");
    std::string code;
    for (const std::string& block : code_blocks(gallery, "sh")) code += block;
    int count = 0;
    for (const std::string& link : relative_links(gallery)) {
        if (fs::path(link).extension() != ".png") continue;
        ++count;
        const std::string of_level = std::regex_replace(link, std::regex("_(discrete|guaranteed)\\."), "_$level.");
        EXPECT_TRUE(code.find(".png " + link + "\n") != std::string::npos ||
                    code.find(".png " + of_level + "\n") != std::string::npos)
            << link;
    }
    EXPECT_GE(count, 16);
}

TEST(Docs, the_gallery_shows_every_scene)
{
    const std::string gallery = read_file("docs/gallery/README.md");
    for (const std::string& scene : scene_names()) {
        EXPECT_TRUE(names(gallery, scene)) << scene;
        const std::vector<std::string> links = relative_links(gallery);
        EXPECT_TRUE(
            std::any_of(links.begin(), links.end(), [&](const std::string& link) { return link.starts_with(scene); }))
            << "no picture of " << scene;
    }
}

TEST(Docs, pictures_are_small)
{
    for (const std::string& picture : files_under("docs", {".png", ".svg", ".jpg"}))
        EXPECT_LT(fs::file_size(fs::path(root()) / picture), 300'000u) << picture;
}

TEST(Docs, the_page_of_methods_names_every_one)
{
    const std::string page = read_file("docs/methods.md");
    for (const std::string_view method : choice_names(Method{})) EXPECT_TRUE(names(page, method)) << method;
}

TEST(Docs, the_page_of_scenes_names_every_metric_of_the_end_check)
{
    const std::string page = read_file("docs/scenes.md");
    for (const MetricInfo& metric : metric_table()) EXPECT_TRUE(names(page, metric.name)) << metric.name;
}

TEST(Docs, the_example_scene_runs)
{
    const TemporaryDirectory directory;
    int count = 0;
    for (const std::string& block : code_blocks(read_file("docs/scenes.md"), "toml")) {
        if (block.find("[[sheet]]") == std::string::npos) continue;
        ++count;
        const std::string path = directory.write("example.toml", block).string();
        const ProgramResult run =
            run_program({"render", path, "--frames", "120", "--no-images", "--backend", "cpu", "--quiet"});
        EXPECT_EQ(run.exit_code, 0) << block << run.err;
        EXPECT_EQ(run.err, "");
    }
    EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace nuno::meta
