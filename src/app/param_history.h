// Changes of parameters that can be taken back.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/params.h"

namespace nuno {

struct ParamChange
{
    const ParamInfo* info;
    double before, after;  // of a choice: its index
};

// The fields of `table` that differ between two blocks, in its order: with what a fabric sets beside itself.
std::vector<ParamChange> changes_between(ParamTable table, const void* before, const void* after);

class ParamHistory
{
  public:
    // So many entries are kept.
    static constexpr std::size_t kMostEntries = 200;

    // Adds one entry of changes made together, and forgets what was undone. While a drag lasts, changes of the
    // parameters of the entry before go into that; where it comes back to its start, the entry goes. Where nothing changed, nothing is added.
    void record(std::string name, std::vector<ParamChange> changes, bool drags = false);
    // The slider was let go: the next change is an entry of its own.
    void end_drag() { drags_ = false; }
    // For another scene.
    void clear();

    bool can_undo() const { return done_ > 0; }
    bool can_redo() const { return done_ < entries_.size(); }
    // What undo or redo would be about.
    const std::string& undo_name() const { return entries_[done_ - 1].name; }
    const std::string& redo_name() const { return entries_[done_].name; }
    // Values to set one after another, which record nothing; empty where there is nothing to undo or redo.
    struct Value
    {
        const ParamInfo* info;
        double value;
    };
    std::vector<Value> undo();
    std::vector<Value> redo();

  private:
    struct Entry
    {
        std::string name;
        std::vector<ParamChange> changes;
    };
    bool continues_drag(std::span<const ParamChange> changes) const;

    std::vector<Entry> entries_;
    std::size_t done_ = 0;  // entries that are not undone
    bool drags_ = false;
};

}  // namespace nuno
