// Text, tables and pictures of a page.
#include "study/html.h"

#include <fmt/format.h>

#include "core/files.h"

namespace nuno {
namespace {

constexpr std::string_view kStyle =
    "body{font:16px/1.5 system-ui,sans-serif;max-width:66rem;margin:2rem auto;padding:0 1rem;color:#222}"
    "h1,h2,h3{line-height:1.2}table{border-collapse:collapse;margin:1rem 0;font-size:14px}"
    "th,td{border-bottom:1px solid #ddd;padding:.25rem .7rem;text-align:left}td.n{text-align:right;"
    "font-variant-numeric:tabular-nums}th{background:#f4f4f4}code{background:#f4f4f4;padding:0 .2rem}"
    "figure{margin:1rem 0}figure svg{max-width:100%;height:auto}figcaption{color:#555;font-size:14px}"
    ".scroll{overflow-x:auto}";

bool is_number(std::string_view cell)
{
    return !cell.empty() && cell.find_first_not_of("0123456789.,-+e %") == cell.npos;
}

}  // namespace

std::string html_text(std::string_view text)
{
    std::string spelt;
    for (const char c : text) switch (c)
        {
        case '<': spelt += "&lt;"; break;
        case '>': spelt += "&gt;"; break;
        case '&': spelt += "&amp;"; break;
        case '"': spelt += "&quot;"; break;
        default: spelt += c;
        }
    return spelt;
}

std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows)
{
    std::string table = "<div class=\"scroll\"><table><tr>";
    for (const std::string& cell : head) table += "<th>" + cell + "</th>";
    table += "</tr>\n";
    for (const std::vector<std::string>& row : rows) {
        table += "<tr>";
        for (const std::string& cell : row) table += (is_number(cell) ? "<td class=\"n\">" : "<td>") + cell + "</td>";
        table += "</tr>\n";
    }
    return table + "</table></div>\n";
}

std::string html_picture(const std::filesystem::path& svg, std::string_view caption)
{
    std::error_code status;
    if (!std::filesystem::exists(svg, status)) return "<p>(No picture: gnuplot was missing or failed.)</p>\n";
    const std::string text = read_text(svg);
    const std::size_t begin = text.find("<svg");
    return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                       begin == text.npos ? text : text.substr(begin), caption);
}

std::string html_missing(const std::vector<std::string>& ids, std::size_t of_all)
{
    if (ids.empty()) return "";
    std::string list;
    for (const std::string& id : ids) list += html_text(id) + "\n";
    return fmt::format(
        "<p><b>Not the whole sweep: {} of {} points are missing.</b></p><details><summary>Which</summary>"
        "<pre>{}</pre></details>\n",
        ids.size(), of_all, list);
}

std::string html_page(std::string_view title, std::string_view body)
{
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\"><title>{0}</title><style>{1}</style></head>\n<body><h1>{0}</h1>\n{2}</body></html>\n",
        html_text(title), kStyle, body);
}

}  // namespace nuno
