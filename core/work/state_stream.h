// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state of a calculation as bytes, so that it can go on later in the same program on the same machine. A class
// names the parts of its state once, for both directions:
//
//   void pass(StateStream& stream) { stream(time_, velocity_, events_); }
//
// Numbers, enumerations and structures of them are their bytes; texts and lists have their length before them.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace touchdown {

/// Bytes that are not those of the state that is read.
class StateMisfit : public std::runtime_error {
public:
    StateMisfit() : std::runtime_error("it does not hold the state of this run") {}
};

class StateStream {
public:
    /// Writes.
    StateStream() = default;
    /// Reads bytes, which must last. Throws StateMisfit where they end too early.
    explicit StateStream(std::string_view bytes) : reads_(true), left_(bytes) {}

    bool reads() const { return reads_; }
    /// What was written.
    std::string take() { return std::move(written_); }
    /// The rest is not read.
    void skip() { left_ = {}; }
    /// After the last value that is read: throws StateMisfit unless all bytes are used.
    void end() const
    {
        if (!left_.empty()) throw StateMisfit();
    }

    template <class... Values>
    void operator()(Values&... values)
    {
        (one(values), ...);
    }
    /// Of what was read: throws StateMisfit unless it holds.
    static void require(bool holds)
    {
        if (!holds) throw StateMisfit();
    }
    /// A list whose length both sides know.
    template <class Value>
    void fixed(std::vector<Value>& list)
    {
        std::size_t count = list.size();
        one(count);
        if (count != list.size()) throw StateMisfit();
        each(list);
    }

private:
    template <class Value>
    void one(Value& value)
    {
        static_assert(!std::is_pointer_v<Value>);
        if constexpr (requires { value.pass(*this); })
            value.pass(*this);
        else if constexpr (requires { Value::SizeAtCompileTime; }) // of Eigen
            raw(value.data(), static_cast<std::size_t>(value.size()) * sizeof(typename Value::Scalar));
        else if constexpr (std::is_same_v<Value, bool>)
            flag(value);
        else if constexpr (requires { value.has_value(); })
            maybe(value);
        else if constexpr (std::is_trivially_copyable_v<Value>)
            raw(&value, sizeof value);
        else
            many(value);
    }
    template <class Value, std::size_t count>
    void many(std::array<Value, count>& values)
    {
        for (Value& value : values) one(value);
    }
    void flag(bool& value)
    {
        unsigned char byte = value ? 1 : 0;
        raw(&byte, 1);
        if (byte > 1) throw StateMisfit();
        value = byte == 1;
    }
    template <class Value>
    void maybe(std::optional<Value>& value)
    {
        bool exists = value.has_value();
        flag(exists);
        if (reads_ && exists) value.emplace();
        if (reads_ && !exists) value.reset();
        if (exists) one(*value);
    }
    template <class List>
    void many(List& list)
    {
        std::size_t count = list.size();
        one(count);
        if (reads_ && count > left_.size()) throw StateMisfit(); // each value takes a byte at least
        if (reads_) list.resize(count);
        each(list);
    }
    template <class List>
    void each(List& list)
    {
        using Value = typename List::value_type;
        if constexpr (std::is_trivially_copyable_v<Value>)
            raw(list.data(), list.size() * sizeof(Value));
        else
            for (Value& value : list) one(value);
    }
    void raw(void* value, std::size_t count)
    {
        if (!reads_) {
            written_.append(static_cast<const char*>(value), count);
            return;
        }
        if (count > left_.size()) throw StateMisfit();
        if (count > 0) std::memcpy(value, left_.data(), count);
        left_.remove_prefix(count);
    }

    bool reads_ = false;
    std::string written_;
    std::string_view left_; // to be read
};

} // namespace touchdown
