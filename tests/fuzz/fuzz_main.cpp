// SPDX-License-Identifier: GPL-3.0-or-later
//
// fuzz_readers READER [libFuzzer's options and folders]: draws inputs for one reader of tests/fuzz/fuzzed_readers.h.
// fuzz_readers names: prints the names of all readers.
// fuzz_readers seeds FOLDER: writes good inputs, in a folder for each reader.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/studies/reader_program.h"
#include "tests/fuzz/fuzzed_readers.h"

namespace {

const touchdown::fuzz::FuzzedReader* chosen = nullptr;

void writeSeeds(const std::filesystem::path& folder)
{
    for (const touchdown::fuzz::FuzzedReader& reader : touchdown::fuzz::readers()) {
        std::filesystem::create_directories(folder / reader.name);
        int number = 0;
        for (const std::string& seed : reader.seeds())
            std::ofstream(folder / reader.name / ("seed" + std::to_string(++number)), std::ios::binary) << seed;
    }
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    if (const auto code = touchdown::runReader(*argc, *argv)) std::exit(*code);
    const std::string_view word = *argc > 1 ? (*argv)[1] : "";
    const auto all = touchdown::fuzz::readers();
    if (word == "names") {
        for (const auto& reader : all) std::printf("%s\n", reader.name.data());
        std::exit(0);
    }
    if (word == "seeds" && *argc == 3) {
        writeSeeds((*argv)[2]);
        std::exit(0);
    }
    const auto found = std::ranges::find(all, word, &touchdown::fuzz::FuzzedReader::name);
    if (found == all.end()) {
        std::fprintf(stderr, "The first word names a reader, or is \"names\" or \"seeds\".\n");
        std::exit(2);
    }
    chosen = &*found;
    std::rotate(*argv + 1, *argv + 2, *argv + *argc);
    --*argc;
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    chosen->read({bytes, count});
    return 0;
}
