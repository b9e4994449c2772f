// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readers of other people's files, each as a function of bytes that a fuzzer draws. A reader may refuse what it
// gets; what it accepts, and what it says, is checked. A row of readers() is all that a new one needs.
//
// A broken rule ends the process, as a fault does that a sanitizer finds. The same functions run in the tests over what
// fuzzers found before, the files of tests/fuzz/findings (test_fuzzed_readers.cpp).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown::fuzz {

using Bytes = std::span<const std::uint8_t>;

struct FuzzedReader {
    std::string_view name;
    void (*read)(Bytes);
    std::vector<std::string> (*seeds)(); // good inputs to begin with
};
std::span<const FuzzedReader> readers();

/// Ends the process with the sentence unless the rule holds.
void mustHold(bool rule, std::string_view sentence);

/// HDF5 (fuzzed_hdf5.cpp): the bytes are changes of a good file, one after another.
void readSurfaceFile(Bytes changes);
void readRunFile(Bytes changes);
void readStateFile(Bytes changes);
void readStudyFile(Bytes changes);

} // namespace touchdown::fuzz
