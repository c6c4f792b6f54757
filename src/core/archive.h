// The inner state of a run as bytes, written and read by the same calls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.h"

namespace nuno {

// Bytes are those of the machine; who keeps them says by what program they were written.
class Archive
{
  public:
    Archive() = default;  // to write
    explicit Archive(std::vector<std::byte> bytes) : bytes_(std::move(bytes)), reads_(true) {}

    bool reads() const { return reads_; }
    const std::vector<std::byte>& bytes() const { return bytes_; }

    // Each writes what it is given, or replaces it by what was written. Error where there is less, or more.
    template <class T>
    void value(T& value)
    {
        pass(std::as_writable_bytes(std::span(&value, 1)));
    }
    template <class T>
    void values(std::span<T> values)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        std::uint64_t count = values.size();
        value(count);
        if (count != values.size()) fail();
        pass(std::as_writable_bytes(values));
    }
    template <class T, class Allocator>
    void list(std::vector<T, Allocator>& list)
    {
        std::uint64_t count = list.size();
        value(count);
        if (reads_ && count > (bytes_.size() - at_) / sizeof(T)) fail();
        list.resize(static_cast<std::size_t>(count));
        pass(std::as_writable_bytes(std::span(list)));
    }
    // To call when all is read. Error where something is left.
    void finish() const
    {
        if (reads_ && at_ != bytes_.size()) fail();
    }

  private:
    void pass(std::span<std::byte> values)
    {
        if (!reads_) {
            bytes_.insert(bytes_.end(), values.begin(), values.end());
            return;
        }
        if (values.size() > bytes_.size() - at_) fail();
        if (!values.empty()) std::memcpy(values.data(), &bytes_[at_], values.size());
        at_ += values.size();
    }
    [[noreturn]] static void fail()
    {
        throw Error("what the method kept does not fit this scene; save it anew, or leave the scene as it was");
    }

    std::vector<std::byte> bytes_;
    std::size_t at_ = 0;
    bool reads_ = false;
};

}  // namespace nuno
