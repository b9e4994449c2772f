// SPDX-License-Identifier: GPL-3.0-or-later
//
// The time series of a run as CSV (RFC 4180): a header "time [s],flying_height [m],...", full precision, '.' as decimal
// point whatever the locale. Written while the run lasts, so that a device or a pipe may take it.
#pragma once

#include <filesystem>
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
    std::string open(const std::filesystem::path& file, const std::vector<Quantity>& quantities);
    std::string append(const SampleBatch& batch);
    std::string close();

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace touchdown
