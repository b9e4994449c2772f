// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values from one process of this program to another: numbers and structures of numbers as their bytes, texts and lists
// with their length before them. A structure with texts or lists has a function `pass` that names its members:
//
//   void pass(auto& stream, Passed<Quantity> auto& quantity) { stream(quantity.name, quantity.unit); }
//
// The same function writes and reads.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace touchdown {

template <class T>
concept PlainValue = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

/// A structure that is written, which is constant, or read.
template <class T, class Structure>
concept Passed = std::same_as<std::remove_const_t<T>, Structure>;

/// Writes values through `write(bytes, count)`.
class PassedOut {
public:
    using Write = std::function<void(const void*, std::size_t)>;
    explicit PassedOut(Write write) : write_(std::move(write)) {}

    template <class... Values>
    void operator()(const Values&... values)
    {
        (put(values), ...);
    }

private:
    void put(const PlainValue auto& value) { write_(&value, sizeof value); }
    void put(const std::string& text)
    {
        put(text.size());
        write_(text.data(), text.size());
    }
    template <class Value>
    void put(const std::vector<Value>& list)
    {
        put(list.size());
        if constexpr (PlainValue<Value>)
            write_(list.data(), list.size() * sizeof(Value));
        else
            for (const Value& value : list) put(value);
    }
    template <class Structure>
    requires(!PlainValue<Structure>) void put(const Structure& structure) { pass(*this, structure); }

    Write write_;
};

/// Reads them through `read(bytes, count)`, which throws where there are no more. A length is not believed: memory is
/// taken as the values come.
class PassedIn {
public:
    using Read = std::function<void(void*, std::size_t)>;
    explicit PassedIn(Read read) : read_(std::move(read)) {}

    template <class... Values>
    void operator()(Values&... values)
    {
        (get(values), ...);
    }

private:
    static constexpr std::size_t block = 1 << 20; // values

    void get(PlainValue auto& value) { read_(&value, sizeof value); }
    void get(std::string& text) { getMany(text); }
    template <class Value>
    void get(std::vector<Value>& list)
    {
        if constexpr (PlainValue<Value>) {
            getMany(list);
        } else {
            std::size_t count = 0;
            for (get(count); count > 0; --count) get(list.emplace_back());
        }
    }
    template <class Structure>
    requires(!PlainValue<Structure>) void get(Structure& structure) { pass(*this, structure); }

    void getMany(auto& values)
    {
        std::size_t count = 0;
        get(count);
        values.clear();
        while (values.size() < count) {
            const std::size_t begin = values.size(), more = std::min(count - begin, std::max(block, begin));
            values.resize(begin + more);
            read_(values.data() + begin, more * sizeof *values.data());
        }
    }

    Read read_;
};

} // namespace touchdown
