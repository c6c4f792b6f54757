// Files that are never left half-written, and where the program's own assets are.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace nuno {

// The whole of a text file. Error (naming the path) where it cannot be read.
std::string read_text(const std::filesystem::path& path);

// Writes under a temporary name beside `path`, then renames: a reader sees the old file or the whole new one. What is
// no regular file (a device, a pipe) is written to directly.
// Error (naming the path and the system's reason) where the directory or the disk refuses; the temporary file is
// removed.
void write_whole(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_whole(const std::filesystem::path& path, std::string_view text);

// Error where a file of that name can certainly not be written: for saying so before long work, not after it.
void check_can_write(const std::filesystem::path& path);

// Makes `directory` and its parents, and checks that a file can be made in it. Error where not.
void make_writable_directory(const std::filesystem::path& directory);

// The folder that holds shaders/ and assets/: $NUNO_ROOT where set, else ../share/nuno of where the program is, as it is
// installed, else the source tree that was built.
std::filesystem::path root_directory();

}  // namespace nuno
