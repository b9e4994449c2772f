// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two states of a results file during a run: the file that others see, whole at every moment, and a part beside it,
// on which the next flush works. core/results/results_writer.h says why.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/formats/output_file.h"
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
    /// Locks the file. If it is `live`, shows it at once, without samples, and at each publication; else when the
    /// summary is published. Throws std::exception; then the file is as it was.
    ResultsExchange(const std::filesystem::path& file, ResultsHeader header, bool live = true);
    ResultsExchange(const ResultsExchange&) = delete;
    ResultsExchange& operator=(const ResultsExchange&) = delete;

    /// Adds samples and snapshots, at the end of a run its spectra and summary. Throws std::exception; then the file is
    /// as it was.
    void publish(const SampleBatch& samples, std::span<const FieldSnapshot> fields = {},
                 const std::vector<ResultsSpectrum>& spectra = {}, const Summary* summary = nullptr);

private:
    Hdf5Group openPart();
    Hdf5Group createPart();
    void removePart();
    void show();

    PartFile part_;
    ResultsHeader header_;
    std::vector<std::string> arrays_; // paths of those that grow
    bool live_;
    bool hasPart_ = false;
    HeldFile shown_; // the file itself; none before the first state
};

} // namespace touchdown
