// A table of a TOML file that knows which of its keys were asked for, so that a misspelt one is an error with its line.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <toml++/toml.h>

#include "core/params.h"

namespace nuno {

class TomlTable
{
  public:
    TomlTable(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

    bool has(std::string_view key) const { return table_.contains(key); }
    // "file:line" of a key, or of the table itself.
    std::string where(std::string_view key = {}) const;

    std::string text(std::string_view key, std::string_view fallback);
    double number(std::string_view key, double fallback);
    int whole(std::string_view key, int fallback);
    glm::vec3 vector(std::string_view key, glm::vec3 fallback);
    bool flag(std::string_view key, bool fallback);
    const toml::table* table(std::string_view key);
    const toml::array* array(std::string_view key);
    // Calls read(table) for each [[key]].
    void for_each_table(std::string_view key, const std::function<void(TomlTable)>& read);

    // Every key must be a parameter of `table`; stores them in `block`.
    void read_params(ParamTable table, void* block);
    // All keys as text, for a parameter table that is not known here.
    struct Entry
    {
        std::string name, text, where;
        bool quoted;
    };
    std::vector<Entry> entries();

    // Error for the first key that none of the calls above asked for; names the nearest one that was.
    void finish() const;

    [[noreturn]] void fail(std::string_view key, std::string_view expected) const;

  private:
    const toml::node* find(std::string_view key);

    const toml::table& table_;
    std::string file_;
    std::vector<std::string_view> known_;
};

}  // namespace nuno
