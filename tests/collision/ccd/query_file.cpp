// Reads continuous queries line by line.
#include "collision/ccd/query_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string_view>

#include "core/error.h"

namespace nuno {
namespace {

// from_chars reads no sign of plus and no 0x, and does not round to 0 or a subnormal where strtod does.
std::optional<double> number(std::string_view text)
{
    std::string_view digits = text;
    const bool is_negative = digits.starts_with('-');
    if (is_negative || digits.starts_with('+')) digits.remove_prefix(1);
    auto format = std::chars_format::general;
    if (digits.starts_with("0x") || digits.starts_with("0X")) {
        format = std::chars_format::hex;
        digits.remove_prefix(2);
    }
    if (digits.starts_with('-')) return std::nullopt;
    double value = 0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value, format);
    if (status == std::errc::invalid_argument || end != digits.data() + digits.size()) return std::nullopt;
    if (status == std::errc::result_out_of_range) value = std::fabs(std::strtod(std::string(text).c_str(), nullptr));
    if (!std::isfinite(value)) return std::nullopt;
    return is_negative ? -value : value;
}

class Words
{
  public:
    explicit Words(std::string_view line) : rest_(line) {}
    // Empty at the end of the line.
    std::string_view next()
    {
        constexpr std::string_view kBlank = " \t\r";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
        const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlank));
        rest_.remove_prefix(word.size());
        return word;
    }

  private:
    std::string_view rest_;
};

FileQuery query_of(std::string_view line, const std::string& where)
{
    Words words(line);
    FileQuery query;
    query.id = words.next();
    const std::string_view kind = words.next();
    if (kind != "vf" && kind != "ee")
        throw Error(where + "the second word is '" + std::string(kind) + "', not vf or ee");
    query.kind = kind == "vf" ? PairKind::vertex_face : PairKind::edge_edge;
    for (int i = 0; i < 24; ++i) {
        const std::string_view word = words.next();
        if (word.empty()) throw Error(where + std::to_string(i) + " numbers after the kind, where there must be 24");
        const std::optional<double> value = number(word);
        if (!value) throw Error(where + "'" + std::string(word) + "' is no finite number of double precision");
        (i < 12 ? query.t0 : query.t1)[i % 12 / 3][i % 3] = *value;
    }
    if (!words.next().empty()) throw Error(where + "more than 24 numbers after the kind");
    return query;
}

}  // namespace

std::vector<FileQuery> read_query_file(const std::filesystem::path& path)
{
    std::ifstream file(path);
    if (!file || std::filesystem::is_directory(path)) throw Error(path.string() + ": cannot be read");
    std::vector<FileQuery> queries;
    std::string line;
    for (std::int64_t number = 1; std::getline(file, line); ++number) {
        if (line.starts_with('#') || line.find_first_not_of(" \t\r") == line.npos) continue;
        queries.push_back(query_of(line, path.string() + ":" + std::to_string(number) + ": "));
    }
    if (file.bad()) throw Error(path.string() + ": cannot be read to its end");
    return queries;
}

}  // namespace nuno
