// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two states of a results file under way: the one that others see, whole at every moment, and NAME.part,
// the one that the next flush works on. See core/results/results_file.h for why.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "core/results/results_layout.h"

namespace touchdown {

/// Keeps hold of a file, so that it can be told from another one that takes its name (or, once it is gone, its inode).
class HeldFile {
public:
    HeldFile() = default;
    explicit HeldFile(const std::filesystem::path& path);
    ~HeldFile();
    HeldFile(HeldFile&& other) noexcept;
    HeldFile& operator=(HeldFile&& other) noexcept;

    explicit operator bool() const { return descriptor_ >= 0; }
    bool standsAt(const std::filesystem::path& path) const;

private:
    int descriptor_ = -1;
};

class ResultsExchange {
public:
    /// Creates NAME.part. Throws Hdf5Error.
    ResultsExchange(const std::filesystem::path& file, ResultsHeader header);
    /// Removes NAME.part.
    ~ResultsExchange();
    ResultsExchange(const ResultsExchange&) = delete;
    ResultsExchange& operator=(const ResultsExchange&) = delete;

    /// Adds samples and snapshots, and what ends a run, and shows the result under the file's name. Throws Hdf5Error;
    /// then the file is what it was before.
    void publish(const SampleBatch& samples, std::span<const FieldSnapshot> fields = {},
                 const std::vector<ResultsSpectrum>& spectra = {}, const Summary* summary = nullptr);

private:
    void checkOwned() const;
    Hdf5Handle openPart();
    Hdf5Handle createPart();
    void removePart();
    void show();

    std::filesystem::path file_;
    std::filesystem::path part_;
    ResultsHeader header_;
    HeldFile shown_; // at file_; none before the first state
    HeldFile next_;  // at part_
};

} // namespace touchdown
