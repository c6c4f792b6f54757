// Finds functions by their layout, which format_test keeps to one form.
#include "meta/size_rules.h"

#include <regex>

#include "meta/tree.h"

namespace nuno::meta {

namespace {

// Whether the declaration that ends just above line `brace` is a type or a namespace.
bool opens_type(const std::vector<std::string>& lines, std::size_t brace)
{
    std::size_t first = brace;
    while (first > 0) {
        const std::string& above = lines[first - 1];
        if (above.empty() || above.ends_with(";") || above.ends_with("}") || above.ends_with(":")) break;
        if (above.find("//") == above.find_first_not_of(' ')) break;
        --first;
    }
    std::string head;
    for (std::size_t i = first; i < brace; ++i) head += lines[i] + " ";
    static const std::regex type(R"(^\s*(template\s*<[^{]*>\s*)?(struct|class|union|enum|namespace|extern)\b)");
    return std::regex_search(head, type);
}

}  // namespace

std::vector<FunctionSize> function_sizes(std::string_view text)
{
    const std::vector<std::string> lines = lines_of(text);
    std::vector<FunctionSize> functions;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t indent = lines[i].find_first_not_of(' ');
        if (indent == std::string::npos || lines[i].substr(indent) != "{" || opens_type(lines, i)) continue;
        const std::string closing = std::string(indent, ' ') + "}";
        std::size_t end = i + 1;
        while (end < lines.size() && !lines[end].starts_with(closing)) ++end;
        functions.push_back({static_cast<int>(i + 1), static_cast<int>(end - i - 1)});
    }
    return functions;
}

}  // namespace nuno::meta
