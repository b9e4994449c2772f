// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two states of a results file during a run: the file that others see, whole at every moment, and a part beside it,
// on which the next flush works. core/results/results_writer.h says why.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/output_file.h"
#include "core/results/results_checkpoint.h"
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

/// When others see a file for the first time; after that each publication is seen.
struct FirstSeen {
    enum class When : std::uint8_t {
        AtOnce,   // without samples
        FromTime, // with the first samples from `time` on, or when the run has completed; so what it continues stays
        AtEnd     // with the summary
    };
    When when = When::AtOnce;
    double time = 0.0; // [s]
};

class ResultsExchange {
public:
    /// Locks the file. Throws std::exception; then the file is as it was.
    ResultsExchange(const std::filesystem::path& file, ResultsHeader header, FirstSeen seen = {});
    ResultsExchange(const ResultsExchange&) = delete;
    ResultsExchange& operator=(const ResultsExchange&) = delete;

    /// Of the next publication, which has all that came before it.
    void keep(std::shared_ptr<const StoredCheckpoint> checkpoint) { checkpoints_.add(std::move(checkpoint)); }
    /// Adds samples and snapshots, at the end of a run its spectra and summary. Throws std::exception; then the file is
    /// as it was.
    void publish(const SampleBatch& samples, std::span<const FieldSnapshot> fields = {},
                 const std::vector<ResultsSpectrum>& spectra = {}, const Summary* summary = nullptr);
    /// Whether others see the file.
    bool isSeen() const { return bool(shown_); }

private:
    bool isToBeSeen(const Summary* summary) const;
    Hdf5Group openPart();
    Hdf5Group createPart();
    void removePart();
    void show();

    PartFile part_;
    ResultsHeader header_;
    std::vector<std::string> arrays_; // paths of those that grow
    ResultsCheckpoints checkpoints_;
    FirstSeen seen_;
    double reached_ = 0.0; // time of the newest sample [s]
    bool hasPart_ = false;
    HeldFile shown_; // the file itself; none before the first state
};

} // namespace touchdown
