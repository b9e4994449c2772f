// SPDX-License-Identifier: GPL-3.0-or-later
//
// The time series of a run as CSV (RFC 4180): a header "time [s],flying_height [m],...", full precision, '.' as decimal
// point whatever the locale. A file appears whole when it is closed, or not at all (core/formats/output_file.h): a run
// that is killed leaves none, and an older file of the name as it was. A device or a pipe takes the samples while the
// run lasts; a pipe is waited for until a program reads it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/simulation/recording/quantity.h"

namespace touchdown {

/// Every call returns "" or the problem in one sentence.
class CsvWriter {
public:
    CsvWriter();
    ~CsvWriter();
    CsvWriter(CsvWriter&&) noexcept;
    CsvWriter& operator=(CsvWriter&&) noexcept;
    /// `goOn` returns false when the run is to stop: then a pipe that nobody reads is given up after a second.
    std::string open(const std::filesystem::path& file, const std::vector<Quantity>& quantities,
                     const std::function<bool()>& goOn = {});
    std::string append(const SampleBatch& batch);
    std::string close();

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace touchdown
