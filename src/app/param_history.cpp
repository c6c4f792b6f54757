// Entries done and undone, in one list.
#include "app/param_history.h"

#include <algorithm>
#include <utility>

namespace nuno {

std::vector<ParamChange> changes_between(ParamTable table, const void* before, const void* after)
{
    std::vector<ParamChange> changes;
    for (const ParamInfo& info : table)
        if (param_value(info, before) != param_value(info, after))
            changes.push_back({&info, param_value(info, before), param_value(info, after)});
    return changes;
}

void ParamHistory::clear()
{
    entries_.clear();
    done_ = 0;
    drags_ = false;
}

bool ParamHistory::continues_drag(std::span<const ParamChange> changes) const
{
    if (!drags_ || done_ == 0) return false;
    const std::vector<ParamChange>& last = entries_[done_ - 1].changes;
    return std::equal(changes.begin(), changes.end(), last.begin(), last.end(),
                      [](const ParamChange& a, const ParamChange& b) { return a.info == b.info; });
}

void ParamHistory::record(std::string name, std::vector<ParamChange> changes, bool drags)
{
    std::erase_if(changes, [](const ParamChange& change) { return change.before == change.after; });
    if (changes.empty()) return;
    entries_.resize(done_);
    if (drags && continues_drag(changes)) {
        std::vector<ParamChange>& last = entries_.back().changes;
        for (std::size_t i = 0; i < last.size(); ++i) last[i].after = changes[i].after;
        const auto is_back = [](const ParamChange& change) { return change.before == change.after; };
        if (!std::all_of(last.begin(), last.end(), is_back)) return;
        entries_.pop_back();
        done_ = entries_.size();
        drags_ = false;
        return;
    }
    entries_.push_back({std::move(name), std::move(changes)});
    if (entries_.size() > kMostEntries) entries_.erase(entries_.begin());
    done_ = entries_.size();
    drags_ = drags;
}

std::vector<ParamHistory::Value> ParamHistory::undo()
{
    std::vector<Value> values;
    drags_ = false;
    if (!can_undo()) return values;
    for (const ParamChange& change : entries_[--done_].changes) values.push_back({change.info, change.before});
    return values;
}

std::vector<ParamHistory::Value> ParamHistory::redo()
{
    std::vector<Value> values;
    drags_ = false;
    if (!can_redo()) return values;
    for (const ParamChange& change : entries_[done_++].changes) values.push_back({change.info, change.after});
    return values;
}

}  // namespace nuno
