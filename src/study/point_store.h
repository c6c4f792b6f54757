// Results of a sweep on disk, one JSON object a line: an interrupted sweep goes on where it was, and parts of one that
// ran elsewhere are joined.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace nuno {

// What points.jsonl holds.
struct StoredPoints
{
    nlohmann::ordered_json header;  // what was measured, by which version and, where that matters, on which machine
    std::map<std::string, nlohmann::ordered_json> results;  // by the id of a point
    std::size_t whole_bytes = 0;                            // of the file; what follows is half a line
    bool ends_in_half_a_line = false;
};

// Error where the file cannot be read, or has a line that is no point (naming it) before the last.
StoredPoints read_points(const std::filesystem::path& directory);

// What becomes of points that are there already. Those of another header are not to be compared.
enum class FormerPoints
{
    keep,      // Error where they have another header, or cannot be read
    keep_own,  // dropped where they have another header, or cannot be read
    drop
};

class PointStore
{
  public:
    // Opens or begins directory/points.jsonl, and locks it against other processes. Error where one has it.
    PointStore(const std::filesystem::path& directory, const nlohmann::ordered_json& header,
               FormerPoints former = FormerPoints::keep);
    ~PointStore();
    PointStore(const PointStore&) = delete;
    PointStore& operator=(const PointStore&) = delete;

    bool holds(const std::string& id) const { return stored_.results.count(id) > 0; }
    const std::map<std::string, nlohmann::ordered_json>& results() const { return stored_.results; }
    std::size_t resumed() const { return resumed_; }                          // points that were there at the start
    bool dropped_others() const { return dropped_others_; }                   // of another header, or unreadable
    bool dropped_half_a_line() const { return stored_.ends_in_half_a_line; }  // of an interrupted write

    // Writes the point at once. Error where the disk refuses; what was written before stays whole.
    void add(const std::string& id, const nlohmann::ordered_json& result);
    // Adds those that it lacks. Error, and nothing added, where one has another result here.
    void add_missing(const std::map<std::string, nlohmann::ordered_json>& results);

  private:
    void take_former(const std::filesystem::path& directory, const nlohmann::ordered_json& header, FormerPoints former);
    void write_line(const nlohmann::ordered_json& object);

    std::filesystem::path path_;
    StoredPoints stored_;
    std::size_t resumed_ = 0;
    bool dropped_others_ = false;
    int file_ = -1;
};

// All points of these directories, which must have one header. Error where they differ, or two have another result for
// one point.
StoredPoints joined_points(const std::vector<std::filesystem::path>& directories);

}  // namespace nuno
