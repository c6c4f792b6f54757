// A file that appears whole or not at all, written piece by piece.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace nuno {

class WholeFile
{
  public:
    // Starts a temporary file beside `path`; what is no regular file (a device, a pipe) is written to directly. Every
    // call below gives an Error naming the path and the system's reason where the directory or the disk refuses.
    explicit WholeFile(std::filesystem::path path);
    // Removes what was not committed.
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    // All of the bytes or, with an Error, none of them.
    void append(std::span<const std::byte> bytes);
    void append_all_of(const WholeFile& other);
    // Writes over bytes that were appended.
    void rewrite(std::size_t offset, std::span<const std::byte> bytes);
    std::size_t size() const { return size_; }

    // Gives the file its name; nothing is written after it.
    void commit();

  private:
    [[noreturn]] void fail(const char* action) const;

    std::filesystem::path path_, target_, temporary_;
    int file_ = -1;
    std::size_t size_ = 0;
};

}  // namespace nuno
