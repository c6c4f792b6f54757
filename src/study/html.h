// Reports as one page of HTML that needs nothing beside it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace nuno {

std::string html_text(std::string_view text);  // with < > & " spelt out

// Rows of cells that are HTML already; numbers are set flush right.
std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);

// An SVG picture written into the page, with a line under it; a word where there is no such file.
std::string html_picture(const std::filesystem::path& svg, std::string_view caption);

// That a page is of a part of a sweep, and which points it lacks; empty where it lacks none.
std::string html_missing(const std::vector<std::string>& ids, std::size_t of_all);

// A whole page; `body` is HTML.
std::string html_page(std::string_view title, std::string_view body);

}  // namespace nuno
