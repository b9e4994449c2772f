// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two states of a results file during a run: the file that others see, whole at every moment, and NAME.part, on
// which the next flush works. core/results/results_writer.h says why.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/results/results_layout.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

/// Holds a file open, so that it can be distinguished from another one that takes its name, or its inode after removal.
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

    /// Adds samples and snapshots, at the end of a run its spectra and summary, and shows the result under the file's
    /// name. Throws Hdf5Error; then the file is as it was.
    void publish(const SampleBatch& samples, std::span<const FieldSnapshot> fields = {},
                 const std::vector<ResultsSpectrum>& spectra = {}, const Summary* summary = nullptr);

private:
    void checkOwned() const;
    Hdf5Group openPart();
    Hdf5Group createPart();
    void removePart();
    void show();

    std::filesystem::path file_;
    std::filesystem::path part_;
    ResultsHeader header_;
    std::vector<std::string> arrays_; // paths of those that grow
    HeldFile shown_;                  // at file_; none before the first state
    HeldFile next_;                   // at part_
};

} // namespace touchdown
