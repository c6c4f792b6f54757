// Reads the pages under docs/ as data: links, sections, the commands in their code blocks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nuno::meta {

// README.md, src/README.md and every .md file under docs/.
std::vector<std::string> pages();

// Targets of the links and pictures of a page, as written, without those to the web; code is not looked into.
std::vector<std::string> relative_links(std::string_view page);

struct Section
{
    std::string heading;  // without the #; empty before the first one
    std::string text;
};
std::vector<Section> sections(std::string_view page);

// The text of every code block that is opened with ```language.
std::vector<std::string> code_blocks(std::string_view page, std::string_view language);

// All pieces between `backticks` of a text.
std::vector<std::string> code_words(std::string_view text);

// Every --flag named in a text, sorted, once each.
std::vector<std::string> flags_in(std::string_view text);

struct Command
{
    std::vector<std::string> words;  // without `nuno` or ./run; split at spaces
    std::string line;
};
// The lines of the ```sh blocks of a page that start nuno, by that name or as ./run, with their continued lines.
std::vector<Command> commands(std::string_view page);

}  // namespace nuno::meta
