// Reading Markdown, as far as the pages use it.
#include "meta/markdown.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include "meta/tree.h"

namespace nuno::meta {
namespace {

constexpr std::string_view kFence = "```";

std::vector<std::string> matches(const std::string& text, const std::regex& pattern)
{
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) found.push_back((*it)[1]);
    return found;
}

// The page without its code blocks.
std::string prose(std::string_view page)
{
    std::string text;
    bool in_code = false;
    for (const std::string& line : lines_of(page)) {
        if (line.starts_with(kFence))
            in_code = !in_code;
        else if (!in_code)
            text += line + "\n";
    }
    return text;
}

}  // namespace

std::vector<std::string> pages()
{
    std::vector<std::string> found = files_under("docs", {".md"});
    found.insert(found.end(), {"README.md", "src/README.md"});
    return found;
}

std::vector<std::string> relative_links(std::string_view page)
{
    static const std::regex inline_code("`[^`\n]*`");
    static const std::regex link(R"(\]\(([^)\s]+)\))");
    std::vector<std::string> found = matches(std::regex_replace(prose(page), inline_code, ""), link);
    std::erase_if(found, [](const std::string& target) { return target.find("://") != std::string::npos; });
    return found;
}

std::vector<Section> sections(std::string_view page)
{
    std::vector<Section> found{{}};
    bool in_code = false;
    for (const std::string& line : lines_of(page)) {
        if (line.starts_with(kFence)) in_code = !in_code;
        if (!in_code && line.starts_with("#"))
            found.push_back({line.substr(line.find_first_not_of("# ")), ""});
        else
            found.back().text += line + "\n";
    }
    return found;
}

std::vector<std::string> code_blocks(std::string_view page, std::string_view language)
{
    const std::string opening = std::string(kFence) + std::string(language);
    std::vector<std::string> blocks;
    bool in_code = false, wanted = false;
    for (const std::string& line : lines_of(page)) {
        if (line.starts_with(kFence)) {
            in_code = !in_code;
            wanted = in_code && line == opening;
            if (wanted) blocks.emplace_back();
        } else if (wanted) {
            blocks.back() += line + "\n";
        }
    }
    return blocks;
}

std::vector<std::string> code_words(std::string_view text)
{
    static const std::regex pattern("`([^`\n]+)`");
    return matches(std::string(text), pattern);
}

std::vector<std::string> flags_in(std::string_view text)
{
    static const std::regex pattern("(?:^|[^A-Za-z0-9-])(--[a-z][a-z0-9-]*)");
    std::vector<std::string> flags = matches(std::string(text), pattern);
    std::sort(flags.begin(), flags.end());
    flags.erase(std::unique(flags.begin(), flags.end()), flags.end());
    return flags;
}

std::vector<Command> commands(std::string_view page)
{
    std::vector<Command> found;
    for (const std::string& block : code_blocks(page, "sh")) {
        static const std::regex continued("\\\\\n\\s*");
        for (std::string line : lines_of(std::regex_replace(block, continued, " "))) {
            line = line.substr(0, line.find(" #"));
            std::istringstream stream(line);
            std::vector<std::string> words;
            for (std::string word; stream >> word;) words.push_back(word);
            if (words.size() < 2 || (words[0] != "nuno" && words[0] != "./run")) continue;
            words.erase(words.begin());
            found.push_back({words, line});
        }
    }
    return found;
}

}  // namespace nuno::meta
