// A file of points.
#include "study/point_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/error.h"
#include "core/files.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path points_path(const fs::path& directory) { return directory / "points.jsonl"; }

Json parsed(const std::string& line, const fs::path& path, int number)
{
    Json object = Json::parse(line, nullptr, false);
    if (object.is_discarded() || !object.is_object())
        throw Error(
            fmt::format("{}:{}: is no point; remove the line, or the directory to start anew", path.string(), number));
    return object;
}

// Names of the entries that differ.
std::string difference(const Json& a, const Json& b)
{
    std::string names;
    for (const auto& [key, value] : a.items())
        if (!b.contains(key) || b[key] != value) names += (names.empty() ? "" : ", ") + key;
    return names.empty() ? "more than here" : names;
}

void require_same(const Json& found, const Json& wanted, const fs::path& directory)
{
    if (found == wanted) return;
    throw Error(
        fmt::format("{}: its points are of another sweep ({} differ), not to be compared with these; give another "
                    "directory, or remove it",
                    directory.string(), difference(wanted, found)));
}

void require_equal(const std::string& id, const Json& known, const Json& result, const fs::path& directory)
{
    if (known == result) return;
    throw Error(
        fmt::format("{}: has another result for {} than the other directories; leave one out", directory.string(), id));
}

}  // namespace

StoredPoints read_points(const fs::path& directory)
{
    const fs::path path = points_path(directory);
    const std::string text = read_text(path);
    StoredPoints stored;
    int number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        ++number;
        if (end == text.npos) {
            stored.ends_in_half_a_line = true;
            break;
        }
        Json object = parsed(text.substr(at, end - at), path, number);
        if (number == 1)
            stored.header = std::move(object);
        else if (object.contains("id") && object.contains("result"))
            stored.results[object["id"].get<std::string>()] = object["result"];
        else
            throw Error(fmt::format("{}:{}: has no id or no result; remove the line", path.string(), number));
        at = end + 1;
        stored.whole_bytes = at;
    }
    return stored;
}

PointStore::PointStore(const fs::path& directory, const Json& header, FormerPoints former)
    : path_(points_path(directory))
{
    make_writable_directory(directory);
    const auto fail = [&](const std::string& reason) {
        if (file_ >= 0) ::close(file_);
        throw Error(fmt::format("{}: {}", path_.string(), reason));
    };
    const auto refused = [] {
        return fmt::format("cannot be written ({}); choose another directory", std::strerror(errno));
    };
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (file_ < 0) fail(refused());
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) fail("another nuno is writing there; run this again when it is done");
    try {
        take_former(directory, header, former);
    } catch (const Error&) {
        ::close(file_);
        throw;
    }
    if (::ftruncate(file_, static_cast<off_t>(stored_.whole_bytes)) != 0) fail(refused());
    const bool is_new = stored_.header.is_null();
    stored_.header = header;
    resumed_ = stored_.results.size();
    if (is_new) write_line(header);
}

void PointStore::take_former(const fs::path& directory, const Json& header, FormerPoints former)
{
    if (former == FormerPoints::drop) return;
    try {
        StoredPoints found = read_points(directory);
        if (!found.header.is_null()) require_same(found.header, header, directory);
        stored_ = std::move(found);
    } catch (const Error&) {
        if (former == FormerPoints::keep) throw;
        dropped_others_ = true;
    }
}

PointStore::~PointStore() { ::close(file_); }

void PointStore::write_line(const Json& object)
{
    const std::string line = object.dump() + "\n";
    std::size_t done = 0;
    while (done < line.size()) {
        const ssize_t written = ::write(file_, line.data() + done, line.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0)
            throw Error(
                fmt::format("{}: cannot be written ({}); make room and run the same command again: what is there "
                            "stays",
                            path_.string(), std::strerror(errno)));
        done += static_cast<std::size_t>(written);
    }
}

void PointStore::add(const std::string& id, const Json& result)
{
    write_line({{"id", id}, {"result", result}});
    stored_.results[id] = result;
}

void PointStore::add_missing(const std::map<std::string, Json>& results)
{
    for (const auto& [id, result] : results)
        if (holds(id)) require_equal(id, stored_.results.at(id), result, path_.parent_path());
    for (const auto& [id, result] : results)
        if (!holds(id)) add(id, result);
}

StoredPoints joined_points(const std::vector<fs::path>& directories)
{
    StoredPoints all;
    for (const fs::path& directory : directories) {
        const StoredPoints part = read_points(directory);
        if (part.header.is_null()) throw Error(directory.string() + ": has no points; run its part of the sweep first");
        if (all.header.is_null()) all.header = part.header;
        require_same(part.header, all.header, directory);
        for (const auto& [id, result] : part.results)
            require_equal(id, all.results.emplace(id, result).first->second, result, directory);
    }
    return all;
}

}  // namespace nuno
